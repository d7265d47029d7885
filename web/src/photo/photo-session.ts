/** The work on one photo: what is marked in it, and the layout that follows. */

import type { Engine, Point } from "../engine/index.ts";
import {
  addLandmark,
  confirmBall,
  emptyDraft,
  moveBall,
  moveLandmark,
  placeBall,
  removeBall,
  renameBall,
  suggestBalls,
  trayOf,
  type Draft,
  type MarkedBall,
} from "./photo-draft.ts";
import { calibrate, TAP_ERROR, type Calibration } from "./geometry/calibrate.ts";
import { landmarks, type Landmarks } from "./geometry/landmarks.ts";
import { layout, type Layout, type TableOfPhoto } from "./geometry/photo-layout.ts";
import { locate, type Estimate } from "./geometry/locate.ts";
import { contradicts, ENOUGH, fittingPreset, proportion } from "./geometry/proportion.ts";
import { bow } from "./geometry/lens.ts";
import { findBalls } from "./picture/find-balls.ts";
import type { Pixels } from "./picture/pixels.ts";
import { straightened } from "./picture/rails.ts";
import { refine, REFINED_ERROR } from "./picture/refine.ts";
import { relativeSize } from "./picture/ball-size.ts";

/** A ball's place may be this far outside the playing area, m: the depth of a pocket. */
const BEYOND = 0.12;

/** What a tap did. */
export type TapResult = "landmark" | "ball" | "no camera" | "off table" | "nothing left";

export interface Misproportion {
  readonly isLarge: boolean;
  /** Name of a table preset; null if none fits. */
  readonly preset: string | null;
}

export class Session {
  readonly #engine: Engine;
  readonly #pixels: Pixels;
  readonly #past: Draft[] = [];
  #table: TableOfPhoto;
  #landmarks: Landmarks | null;
  #tray: readonly string[];
  #draft: Draft;
  #calibration: Calibration | null = null;
  /** What the calibration was made of, and the distortion that the rails show; null if they show none. */
  #source: readonly unknown[] = [];
  #k1: number | null = null;
  #layout: Layout | null = null;

  constructor(engine: Engine, table: TableOfPhoto, pixels: Pixels) {
    this.#engine = engine;
    this.#pixels = pixels;
    this.#table = table;
    this.#landmarks = landmarks(table.geometry);
    this.#tray = trayOf(engine, table.geometry);
    this.#draft = emptyDraft(this.#tray);
    this.#compute();
  }

  get draft(): Draft {
    return this.#draft;
  }
  get table(): TableOfPhoto {
    return this.#table;
  }
  get tray(): readonly string[] {
    return this.#tray;
  }
  /** Null as long as there are fewer than four landmarks, or if no camera sees them so. */
  get calibration(): Calibration | null {
    return this.#calibration;
  }
  /** The valid layout of the balls so far; null if there is none. */
  get layout(): Layout | null {
    return this.#layout;
  }
  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  /** Median error of the balls so far, m; null without balls. */
  get accuracy(): number | null {
    const errors = this.#draft.balls.flatMap((ball) => this.#estimate(ball)?.error ?? []);
    return errors.sort((a, b) => a - b)[errors.length >> 1] ?? null;
  }

  /** Number of the balls that the page has found and the user has not confirmed. */
  get suggested(): number {
    return this.#draft.balls.filter(({ suggested }) => suggested).length;
  }

  /** How far the lens bends the rails, as a share of their length; null without a calibration. */
  get bow(): number | null {
    const size = this.#landmarks?.size;
    return this.#calibration && size ? bow(this.#calibration.camera, size) : null;
  }

  /**
   * Whether the balls look too large or too small for the table, and the preset that they fit; null if
   * their size is as expected or not known.
   */
  get misproportion(): Misproportion | null {
    const sizes = this.#draft.balls.flatMap(({ size }) => size ?? []).sort((a, b) => a - b);
    const size = sizes[sizes.length >> 1];
    if (size === undefined || sizes.length < ENOUGH || !contradicts(size)) return null;
    return { isLarge: size > 1, preset: fittingPreset(this.#engine, this.#table, size) };
  }

  /** Continues with another table; balls that it does not have are taken away. */
  changeTable(table: TableOfPhoto): void {
    const before = proportion(this.#table);
    this.#table = table;
    this.#landmarks = landmarks(table.geometry);
    this.#tray = trayOf(this.#engine, table.geometry);
    const change = before / proportion(table);
    const balls = this.#draft.balls
      .filter(({ id }) => this.#tray.includes(id))
      .map((ball) => ({ ...ball, size: ball.size && ball.size * change }));
    const next = this.#tray.find((id) => !balls.some((ball) => ball.id === id)) ?? null;
    this.#set({ ...this.#draft, balls, next });
    this.suggest();
  }

  /**
   * Marks the next landmark or places the next ball at a pixel.
   *
   * @param slack - How far the tap may be from what is meant, pixels, if it is less exact than a mouse.
   */
  tap(pixel: Point, slack = 0): TapResult {
    if (!this.#draft.marked) {
      const next = addLandmark(this.#draft, pixel);
      this.#set(next);
      this.suggest();
      return next.marked && !this.#calibration ? "no camera" : "landmark";
    }
    const id = this.#draft.next;
    if (id === null) return "nothing left";
    if (!this.#calibration) return "no camera";
    const found = this.#refined(id, pixel, slack);
    if (!this.#isOnTable(found)) return "off table";
    this.#set(placeBall(this.#draft, this.#tray, found));
    return "ball";
  }

  /** Continues with the balls although the middles are not marked. */
  finishLandmarks(): void {
    this.#set({ ...this.#draft, marked: true });
    this.suggest();
  }

  /**
   * Finds the balls, once all landmarks are marked and agree with the table. Balls that the user has placed or
   * confirmed are the user's: then nothing is found any more.
   */
  suggest(): void {
    const { marked, balls } = this.#draft;
    const calibration = this.#calibration;
    const size = this.#landmarks?.size;
    if (!marked || !calibration?.fits || !size || balls.some(({ suggested }) => !suggested)) return;
    const { geometry, radius } = this.#table;
    const searched = { size, radius, pockets: geometry.pockets };
    const found = findBalls(this.#pixels, calibration.camera, searched, this.#tray);
    if (found.length === 0 && balls.length === 0) return;
    const marks = found.map(({ id, pixel, size: seen }) => {
      return { id, pixel, refined: true, size: seen, suggested: true };
    });
    this.#set(suggestBalls(this.#draft, this.#tray, marks));
  }

  /** The user agrees with a ball that was found. */
  confirm(id: string): void {
    const isSuggested = this.#draft.balls.some((ball) => ball.id === id && ball.suggested);
    if (isSuggested) this.#set(confirmBall(this.#draft, id));
  }

  turn(): void {
    this.#set({ ...this.#draft, turned: !this.#draft.turned });
  }

  /** The ball that the next tap places. */
  choose(id: string): void {
    this.#draft = { ...this.#draft, next: id };
  }

  rename(from: string, to: string): void {
    this.#set(renameBall(this.#draft, from, to));
  }

  remove(id: string): void {
    this.#set(removeBall(this.#draft, id));
  }

  /** Moves a landmark. With `step`, undo takes this move back alone. */
  moveLandmark(index: number, pixel: Point, step: boolean): void {
    this.#set(moveLandmark(this.#draft, index, pixel), step);
  }

  /** Moves a ball to a pixel exactly; a place beside the table is ignored. */
  moveBall(id: string, pixel: Point, step: boolean): void {
    const ball = { id, pixel, refined: false, size: null, suggested: false };
    if (this.#isOnTable(ball)) this.#set(moveBall(this.#draft, ball), step);
  }

  undo(): void {
    const last = this.#past.pop();
    if (!last) return;
    const balls = last.balls.filter(({ id }) => this.#tray.includes(id));
    const next = last.next !== null && this.#tray.includes(last.next) ? last.next : null;
    this.#draft = { ...last, balls, next };
    this.#compute();
  }

  #set(draft: Draft, step = true): void {
    if (step) this.#past.push(this.#draft);
    this.#draft = draft;
    this.#compute();
  }

  #compute(): void {
    const { balls } = this.#draft;
    this.#calibrate();
    const found = balls.map((ball) => ({ id: ball.id, position: this.#estimate(ball)?.position }));
    const placed = found.flatMap(({ id, position }) => (position ? [{ id, position }] : []));
    this.#layout =
      placed.length === found.length ? layout(this.#engine, this.#table, placed) : null;
  }

  /** Calibrates the photo again, if its landmarks have changed; the rails help once all are marked. */
  #calibrate(): void {
    const { landmarks: taps, turned, marked } = this.#draft;
    const table = this.#landmarks;
    const source = [table, taps, turned, marked];
    if (source.every((part, k) => part === this.#source[k])) return;
    // Another table, and landmarks that are marked again, may show another distortion.
    if (table !== this.#source[0] || !marked) this.#k1 = null;
    this.#source = source;
    const { width, height } = this.#pixels;
    const found =
      table && taps.length >= 4 ? calibrate(table, taps, [width, height], turned) : null;
    this.#calibration = found;
    if (!table || !found || !marked) return;
    this.#calibration = straightened(found, table, taps, this.#pixels, this.#k1);
    this.#k1 = this.#calibration === found ? null : this.#calibration.camera.k1;
  }

  #estimate({ pixel, refined }: MarkedBall): Estimate | null {
    const deviation = refined ? REFINED_ERROR / this.#pixels.width : TAP_ERROR;
    return this.#calibration && locate(this.#calibration, pixel, this.#table.radius, deviation);
  }

  /** The ball at the centre of the outline that is near a tap, or at the tap. */
  #refined(id: string, tap: Point, slack: number): MarkedBall {
    const { camera } = this.#calibration!;
    const { radius } = this.#table;
    const center = refine(this.#pixels, camera, tap, { radius, slack });
    const size = center && relativeSize(this.#pixels, camera, center, radius);
    return { id, pixel: center ?? tap, refined: center !== null, size, suggested: false };
  }

  #isOnTable(ball: MarkedBall): boolean {
    const place = this.#estimate(ball)?.position;
    const size = this.#landmarks?.size;
    return (
      !!place && !!size && [0, 1].every((i) => place[i]! > -BEYOND && place[i]! < size[i]! + BEYOND)
    );
  }
}
