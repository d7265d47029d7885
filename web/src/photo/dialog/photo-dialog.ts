/** The dialog: a photo on the left or above, and beside it the hint, the tray and the layout so far. */

import type { Engine, Point, ShotFile } from "../../engine/index.ts";
import { CORNERS } from "../photo-draft.ts";
import { tableOf, type Equipment, type Layout } from "../geometry/photo-layout.ts";
import { outline } from "../picture/ball-outline.ts";
import { LEAST, readPhoto, type Photo } from "../picture/read-photo.ts";
import { Session } from "../photo-session.ts";
import { fill, TEXTS } from "../texts.ts";
import { button, element } from "./element.ts";
import { arrow, Handles, type Mark } from "./handles.ts";
import { hintText, proportionText } from "./hint-text.ts";
import { Loupe } from "./photo-loupe.ts";
import { drawOverlay } from "./overlay.ts";
import { preview } from "./layout-preview.ts";
import { Source } from "./source.ts";
import { Stage } from "./photo-stage.ts";
import { TableChoice } from "./table-choice.ts";
import { Tray } from "./ball-buttons.ts";

export interface PhotoOptions {
  readonly engine: Engine;
  /** The present shot; the photo is of its table unless the user chooses another one. */
  readonly table: () => ShotFile;
  /** Receives the layout and its table when the user accepts it. */
  readonly onLayout: (balls: Layout["balls"], equipment: Equipment) => void;
}

/** A pointer this near to a mark takes hold of it, CSS pixels: less where balls may lie beside it. */
const GRAB = 16;
const GRAB_AMONG_BALLS = 9;
/** A pointer that moves less has tapped, CSS pixels. */
const TAP = 5;
/** The tap of a finger may be this far from what is meant, CSS pixels, and a longer one looks closer. */
const FINGER = 6;
const LONG_MS = 400;

type Buttons = Readonly<Record<"four" | "undo" | "remove" | "turn" | "use", HTMLButtonElement>>;

/** A pointer on the photo. */
interface Gesture {
  readonly start: Point;
  /** The mark that it holds, and where the mark was. */
  readonly held: { readonly mark: Mark; readonly pixel: Point } | null;
  /** How far the tap may be from what is meant, pixels of the photo. */
  readonly slack: number;
  /** When it began, ms. */
  readonly began: number;
  pixel: Point;
  moved: boolean;
}

export class PhotoDialog {
  readonly root: HTMLDialogElement;
  readonly #options: PhotoOptions;
  readonly #stage: Stage;
  readonly #loupe = new Loupe();
  readonly #handles: Handles;
  readonly #tray: Tray;
  readonly #source: Source;
  readonly #tables: TableChoice;
  readonly #hint = element("p", { class: "photo-hint", "aria-live": "polite" });
  readonly #warning = element("p", { class: "photo-warning", role: "alert" });
  readonly #drawing = element("div", { class: "photo-drawing" });
  readonly #work: HTMLElement;
  readonly #buttons: Buttons;
  #photo: Photo | null = null;
  #session: Session | null = null;
  #gesture: Gesture | null = null;
  /** A placed ball whose name or place is being changed. */
  #selected: string | null = null;
  /** The keyboard's cross, pixels of the photo. */
  #cross: Point | null = null;
  /** The mark that arrow keys are moving: one step of the history. */
  #nudged: string | null = null;
  #message = "";

  constructor(options: PhotoOptions) {
    this.#options = options;
    this.#stage = new Stage(TEXTS.photo, this.#pointer(), () => this.#show());
    this.#handles = new Handles({
      nudge: (mark, step) => this.#nudge(mark, step),
      remove: (mark) => this.#removeMark(mark),
      confirm: (mark) => this.#confirm(mark),
      select: (mark) => this.#magnify(this.#pixelOf(mark), mark),
      blur: () => {
        if (this.#nudged?.includes("landmark")) this.#suggest();
        this.#nudged = null;
        this.#loupe.hide();
      },
    });
    this.#tray = new Tray((id) => this.#choose(id));
    this.#source = new Source((file) => void this.#open(file));
    this.#tables = new TableChoice(options.engine, () => this.#changeTable());
    this.#buttons = this.#createButtons();
    this.#work = this.#createWork();
    this.root = this.#createRoot();
    this.#listen();
  }

  /** Opens the dialog; a photo that was marked before is still there. */
  open(): void {
    this.#tables.show(this.#options.table());
    this.root.showModal();
    this.#changeTable();
    // The attribute `autofocus` would warn in a frame of another origin, before the dialog opens.
    this.#source.focus();
  }

  #createButtons(): Buttons {
    const act = (action: (session: Session) => void) => () => {
      if (this.#session) action(this.#session);
      this.#show();
    };
    return {
      four: button(
        TEXTS.four,
        "",
        act((session) => session.finishLandmarks()),
      ),
      undo: button(
        TEXTS.undo,
        "",
        act((session) => {
          this.#selected = null;
          session.undo();
        }),
      ),
      remove: button(TEXTS.remove, "", () => {
        if (this.#selected !== null) this.#removeMark({ ball: this.#selected });
      }),
      turn: button(
        TEXTS.turn,
        "",
        act((session) => session.turn()),
      ),
      use: button(TEXTS.use, "primary", () => this.#use()),
    };
  }

  #createWork(): HTMLElement {
    this.#stage.root.append(this.#handles.root, this.#loupe.root, this.#warning);
    const { four, undo, remove, turn, use } = this.#buttons;
    const side = element(
      "div",
      { class: "photo-side" },
      this.#hint,
      // One place for both, so that the photo keeps its size.
      element("div", { class: "photo-step" }, four, this.#tray.root),
      this.#drawing,
      element("div", { class: "row photo-actions" }, undo, remove, turn, this.#source.again, use),
    );
    return element("div", { class: "photo-work" }, this.#stage.root, side);
  }

  #createRoot(): HTMLDialogElement {
    const close = button(TEXTS.close, "plain", () => this.root.close());
    const title = element("h2", { id: "photo-title" }, TEXTS.title);
    const head = element("div", { class: "photo-head" }, title, this.#tables.root, close);
    return element(
      "dialog",
      { class: "photo-dialog", "aria-labelledby": title.id },
      head,
      this.#source.root,
      this.#work,
    );
  }

  #listen(): void {
    this.#source.listen(this.root);
    new ResizeObserver(() => this.#show()).observe(this.#stage.root);
    const { canvas } = this.#stage;
    canvas.addEventListener("keydown", (event) => this.#onKey(event));
    canvas.addEventListener("blur", () => {
      this.#cross = null;
      this.#loupe.hide();
      this.#show();
    });
    // The page has its own keys; they must not act on the table behind the dialog.
    this.root.addEventListener("keydown", (event) => {
      event.stopPropagation();
      const isUndo = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z";
      if (!isUndo) return;
      event.preventDefault();
      this.#buttons.undo.click();
    });
  }

  async #open(file: File): Promise<void> {
    const photo = await readPhoto(file);
    if (typeof photo === "string") {
      const size = (file.size / 1e6).toFixed(0);
      this.#message = fill(TEXTS[photo], { file: file.name, size, least: LEAST });
      this.#show();
      return;
    }
    this.#message = "";
    this.#photo = photo;
    this.#session = null;
    this.#selected = null;
    this.#changeTable();
    this.#stage.show(photo.canvas);
    this.#stage.canvas.focus();
  }

  /** Begins to work on the photo, or continues with the chosen table. */
  #changeTable(): void {
    const table = tableOf(this.#options.engine, this.#tables.shot(this.#options.table()));
    const hasRails = table.geometry.size !== null;
    if (!hasRails) this.#message = TEXTS.noRails;
    else if (this.#message === TEXTS.noRails) this.#message = "";
    if (this.#photo && hasRails) {
      if (this.#session) this.#session.changeTable(table);
      else this.#session = new Session(this.#options.engine, table, this.#photo.pixels);
    }
    this.#show();
  }

  #pointer() {
    return {
      start: (pixel: Point, isFinger: boolean) => {
        const slack = isFinger ? FINGER / this.#stage.scale : 0;
        const began = performance.now();
        const held = this.#near(pixel);
        this.#gesture = { start: pixel, held, slack, began, pixel, moved: false };
        this.#magnify(pixel, this.#gesture.held?.mark ?? null);
      },
      move: (pixel: Point) => {
        const gesture = this.#gesture;
        if (!gesture) return;
        const [x, y] = [pixel[0] - gesture.start[0], pixel[1] - gesture.start[1]];
        const first = !gesture.moved;
        gesture.moved ||= Math.hypot(x, y) * this.#stage.scale > TAP;
        gesture.pixel = pixel;
        const { held, moved } = gesture;
        if (!held) this.#magnify(pixel, null);
        if (!held || !moved) return;
        const at: Point = [held.pixel[0] + x, held.pixel[1] + y];
        this.#move(held.mark, at, first);
        this.#magnify(at, held.mark);
      },
      end: () => {
        const gesture = this.#gesture;
        this.#gesture = null;
        this.#loupe.hide();
        if (!gesture) return;
        if (!gesture.held || !gesture.moved) this.#tap(gesture);
        else if ("landmark" in gesture.held.mark) this.#suggest();
      },
      cancel: () => {
        this.#gesture = null;
        this.#loupe.hide();
      },
    };
  }

  #tap({ pixel, held, slack, began, moved }: Gesture): void {
    const session = this.#session;
    if (!session) return;
    const ball = held && "ball" in held.mark ? held.mark.ball : null;
    if (ball !== null && this.#isInside(ball, pixel)) {
      this.#selected = ball;
      session.confirm(ball);
    } else {
      this.#selected = null;
      // Who holds and moves uses the magnifier.
      const isQuick = !moved && performance.now() - began < LONG_MS;
      this.#report(session.tap(pixel, isQuick ? slack : 0));
    }
    this.#show();
  }

  #report(result: ReturnType<Session["tap"]>): void {
    const messages = {
      "no camera": TEXTS.noCamera,
      "off table": TEXTS.offTable,
      "nothing left": TEXTS.all,
    };
    this.#message = result in messages ? messages[result as keyof typeof messages] : "";
  }

  /**
   * Whether a pixel is well inside a ball: touching balls must be tapped apart. One that the page has found is
   * confirmed by a tap anywhere on it.
   */
  #isInside(id: string, pixel: Point): boolean {
    const ball = this.#session?.draft.balls.find((one) => one.id === id);
    const points = ball && this.#outline(ball.pixel);
    if (!ball || !points || points.length === 0) return false;
    const size = Math.hypot(...points[0]!);
    return (
      Math.hypot(pixel[0] - ball.pixel[0], pixel[1] - ball.pixel[1]) <
      (ball.suggested ? 0.9 : 0.4) * size
    );
  }

  /** The nearest mark, if the pointer takes hold of it. */
  #near(pixel: Point): Gesture["held"] {
    const marks: { mark: Mark; pixel: Point }[] = [
      ...(this.#session?.draft.landmarks.map((at, landmark) => ({
        mark: { landmark },
        pixel: at,
      })) ?? []),
      ...(this.#session?.draft.balls.map(({ id, pixel: at }) => ({
        mark: { ball: id },
        pixel: at,
      })) ?? []),
    ];
    const away = ({ pixel: [x, y] }: { pixel: Point }) =>
      Math.hypot(x - pixel[0], y - pixel[1]) * this.#stage.scale;
    const nearest = marks.sort((a, b) => away(a) - away(b))[0];
    const reach = this.#session?.draft.marked ? GRAB_AMONG_BALLS : GRAB;
    return nearest && away(nearest) < reach ? nearest : null;
  }

  #move(mark: Mark, pixel: Point, step: boolean): void {
    if ("landmark" in mark) this.#session?.moveLandmark(mark.landmark, pixel, step);
    else {
      this.#selected = mark.ball;
      this.#session?.moveBall(mark.ball, pixel, step);
    }
    this.#message = "";
    this.#show();
  }

  #nudge(mark: Mark, [x, y]: Point): void {
    const pixel = this.#pixelOf(mark);
    if (!pixel) return;
    const name = JSON.stringify(mark);
    this.#move(mark, [pixel[0] + x, pixel[1] + y], this.#nudged !== name);
    this.#nudged = name;
    this.#magnify(this.#pixelOf(mark), mark);
  }

  /** Finds balls, after the points of the table have changed. */
  #suggest(): void {
    this.#session?.suggest();
    this.#show();
  }

  #confirm(mark: Mark): void {
    if (!("ball" in mark)) return;
    this.#session?.confirm(mark.ball);
    this.#selected = mark.ball;
    this.#show();
  }

  #removeMark(mark: Mark): void {
    // A table needs its landmarks: they are moved, or taken back by undo.
    if ("landmark" in mark) return;
    this.#session?.remove(mark.ball);
    this.#selected = null;
    this.#show();
    this.#stage.canvas.focus();
  }

  #pixelOf(mark: Mark): Point | null {
    const draft = this.#session?.draft;
    if ("landmark" in mark) return draft?.landmarks[mark.landmark] ?? null;
    return draft?.balls.find(({ id }) => id === mark.ball)?.pixel ?? null;
  }

  /** A ball of the tray: the next one, or the name of the selected one. */
  #choose(id: string): void {
    const session = this.#session;
    if (!session) return;
    if (this.#selected !== null) session.rename(this.#selected, id);
    else session.choose(id);
    this.#selected = null;
    this.#message = "";
    this.#show();
  }

  /** Keys on the photo: a cross that is moved, and set as a tap. */
  #onKey(event: KeyboardEvent): void {
    const session = this.#session;
    const photo = this.#photo;
    if (!session || !photo) return;
    const step = arrow(event);
    if (step) {
      const [x, y] = this.#cross ?? [photo.canvas.width / 2, photo.canvas.height / 2];
      this.#cross = [
        Math.max(0, Math.min(photo.canvas.width, x + 5 * step[0])),
        Math.max(0, Math.min(photo.canvas.height, y + 5 * step[1])),
      ];
      this.#magnify(this.#cross, null);
    } else if ((event.key === "Enter" || event.key === " ") && this.#cross) {
      this.#report(session.tap(this.#cross));
    } else return;
    event.preventDefault();
    this.#show();
  }

  #magnify(pixel: Point | null, mark: Mark | null): void {
    if (!pixel || !this.#photo) return;
    const isBall = mark ? "ball" in mark : this.#session?.draft.marked === true;
    const round = isBall ? this.#outline(pixel) : [];
    const { scale } = this.#stage;
    this.#loupe.show(this.#photo.canvas, { pixel, at: this.#stage.place(pixel), scale, round });
  }

  /** The outline of a ball at a pixel, relative to it. */
  #outline(pixel: Point): Point[] {
    const { calibration, table } = this.#session ?? {};
    if (!calibration || !table) return [];
    const points = outline(calibration.camera, pixel, table.radius) ?? [];
    return points.map(({ offset }) => offset);
  }

  #use(): void {
    const { layout, table } = this.#session ?? {};
    if (!layout || !table || layout.balls.length === 0) return;
    this.#options.onLayout(layout.balls, table.equipment);
    this.root.close();
  }

  #show(): void {
    const session = this.#session;
    this.#source.show(this.#photo !== null, this.#photo ? "" : this.#message);
    this.#work.hidden = !session;
    if (!session) return;
    const { draft, calibration, layout } = session;
    this.#hint.textContent = hintText(session);
    const misfit = calibration && !calibration.fits ? TEXTS.misfit : "";
    const lost = draft.balls.length > 0 && !layout ? TEXTS.noLayout : "";
    this.#warning.textContent = this.#message || misfit || lost || proportionText(session);
    const { four, undo, remove, turn, use } = this.#buttons;
    const corners = draft.landmarks.length;
    four.hidden = draft.marked || corners < CORNERS || !calibration;
    undo.disabled = !session.canUndo;
    remove.disabled = this.#selected === null;
    turn.disabled = !calibration;
    use.disabled = !layout || draft.balls.length === 0;
    this.#tray.root.hidden = !draft.marked;
    const placed = new Set(draft.balls.map(({ id }) => id));
    this.#tray.show(session.tray, placed, this.#selected ?? draft.next);
    const { geometry, radius } = session.table;
    const shown = layout ?? { balls: [], contacts: [] };
    this.#drawing.replaceChildren(preview(geometry, radius, shown));
    this.#handles.show(this.#stage, session);
    const context = this.#stage.draw();
    if (context) drawOverlay(context, this.#stage, session, this.#selected, this.#cross);
  }
}
