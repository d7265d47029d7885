/** The part of the panel that looks ahead: the zone for the next ball, and a plan of three balls. */

import type { BallInfo, DrawnMark, Engine } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, setText, svg, uniqueId } from "../common/dom.ts";
import { changeUnpressed } from "../common/press.ts";
import { ballName, playedName, pocketName } from "../common/shot-words.ts";
import type { Store } from "../document/store.ts";
import { Desk } from "./desk/desk-client.ts";
import type { Leg, PlanJob } from "./desk/desk-protocol.ts";
import { after, estimate, placeOf } from "./desk/desk-layout.ts";
import DeskWorker from "./desk/desk-worker.ts?worker&inline";
import { ellipseAround } from "./leave-picture.ts";
import { noiseOf, positionOf } from "./analysed-position.ts";
import { considered, ordersOf } from "./plan-orders.ts";
import { DASHES, planMarks } from "./plan-drawing.ts";
import { hidePreview, resultButton, showMarks, showShot } from "./result-preview.ts";
import { percent, planText, strikeText, zoneText } from "./analyse-words.ts";
import { capital, t } from "../words/translate.ts";

/** Time (ms) without a change after which the zone is computed again. */
const REST = 250;

/** Balls of a plan. */
const BALLS = 3;

/** How often a plan is played: the standard error of a chance of one half is then 6 %. */
const RUNS = 64;

const STOP = "#8fe3ff";

/** @param panel The tab: what it draws on the table goes with it. */
export function mountNext(
  root: HTMLElement,
  panel: HTMLElement,
  store: Store,
  context: Context,
): void {
  const zone = mountZone(root, panel, store, context);
  const planner = mountPlan(root, store, context);
  new MutationObserver(() => {
    zone.ask();
    if (panel.hidden) planner.draw(false);
  }).observe(panel, { attributeFilter: ["hidden"] });
}

function mountZone(root: HTMLElement, panel: HTMLElement, store: Store, context: Context): Zone {
  const ball = h("select", { id: uniqueId("next-ball") });
  const status = h("p", { class: "hint", id: "zone-status", role: "status" });
  root.append(
    h("h2", {}, t("next.title")),
    h("div", { class: "row" }, h("label", { for: ball.id }, t("next.ball")), ball),
    status,
  );
  const zone = new Zone(panel, ball, status, store, context.engine);
  const follow = (): void => {
    fill(ball, objectBalls(store), t("next.off"));
    zone.ask();
  };
  ball.addEventListener("change", () => zone.ask());
  store.subscribe((now, before) => {
    const isSame =
      now.document === before.document &&
      now.session.analysis.level === before.session.analysis.level &&
      now.session.activity === before.session.activity &&
      now.session.mode === before.session.mode;
    if (!isSame) follow();
  });
  follow();
  return zone;
}

/** The zone from which the chosen ball can be potted. */
class Zone {
  readonly #panel: HTMLElement;
  readonly #ball: HTMLSelectElement;
  readonly #status: HTMLElement;
  readonly #store: Store;
  readonly #engine: Engine;
  readonly #desk: Desk;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    panel: HTMLElement,
    ball: HTMLSelectElement,
    status: HTMLElement,
    store: Store,
    engine: Engine,
  ) {
    this.#panel = panel;
    this.#ball = ball;
    this.#status = status;
    this.#store = store;
    this.#engine = engine;
    this.#desk = new Desk(() => new DeskWorker(), engine);
  }

  /** Waits until the position rests, and then searches the zone. */
  ask(): void {
    clearTimeout(this.#timer);
    const { activity, mode, analysis } = this.#store.session;
    const isShown = this.#ball.value !== "" && activity === "analyse" && !this.#panel.hidden;
    if (isShown && mode !== "replay") {
      const next = this.#ball.value;
      this.#timer = setTimeout(() => this.#search(next), REST);
      return;
    }
    this.#desk.cancel();
    if (!isShown && analysis.zone) this.#store.setPart("analysis", { zone: null });
    if (!isShown) setText(this.#status, t("next.hint"));
  }

  #search(next: string): void {
    const { trace } = this.#store.ghost;
    const { shot } = this.#store.document;
    // The table on which the next ball is played.
    const left = (trace && after(shot, trace)) ?? shot;
    const file = placeOf(left, next) ? left : shot;
    const noise = noiseOf(this.#engine, this.#store.state);
    setText(this.#status, t("next.searching"));
    this.#desk.ask(
      { kind: "zone", shot: JSON.stringify(file), ball: next, noise },
      {
        part: ({ columns, rows, values, share }) => {
          // The colours show square roots, which are for counts: fourth powers make good places stand out.
          this.#store.setPart("analysis", {
            zone: { columns, rows, values: values.map((value) => value ** 4) },
          });
          if (share === 1) setText(this.#status, zoneText(next, Math.max(...values)));
        },
        refused: (message) => setText(this.#status, message),
      },
    );
  }
}

function mountPlan(root: HTMLElement, store: Store, context: Context): Planner {
  const planner = new Planner(root, store, context.engine);
  store.subscribe((now, before) => {
    const isSame =
      now.document.shot.balls === before.document.shot.balls &&
      now.document.game === before.document.game &&
      now.document.noise === before.document.noise &&
      now.session.analysis.level === before.session.analysis.level;
    if (!isSame) planner.follow();
    else if (now.session.orientation !== before.session.orientation) planner.showAgain();
    // Another aim hides it; a shot that is no longer pointed at gives it the table back.
    if (now.document !== before.document) planner.draw(false);
    else if (before.session.analysis.preview && !now.session.analysis.preview) planner.drawAgain();
  });
  planner.clear();
  return planner;
}

/** A plan that was found. */
interface Plan {
  readonly legs: readonly Leg[];
  readonly said: string;
  /** Game, errors and level for which it was made. */
  readonly settings: readonly unknown[];
  /** The balls of the positions to which it belongs: its own, and those of its shots. */
  readonly positions: ReadonlySet<unknown>;
}

/** The plan of some balls, and its settings. */
class Planner {
  readonly #store: Store;
  readonly #engine: Engine;
  readonly #desk: Desk;
  readonly #chosen = Array.from({ length: BALLS }, () =>
    h("select", { id: uniqueId("plan-ball") }),
  );
  readonly #rows = this.#chosen.map((select, k) =>
    h(
      "div",
      { class: "labelled" },
      h("label", { for: select.id }, t("plan.ball", { number: k + 1 })),
      select,
    ),
  );
  readonly #go = h("button", { type: "button", class: "button", id: "plan" }, t("plan.plan"));
  readonly #drawButton = h(
    "button",
    { type: "button", class: "button", id: "plan-draw", hidden: true, "aria-pressed": "false" },
    t("plan.draw"),
  );
  readonly #list = h("ol", { class: "lines", id: "plan-legs", "aria-label": t("plan.title") });
  readonly #status = h("p", {
    class: "hint",
    id: "plan-status",
    role: "status",
    "aria-live": "polite",
  });
  #shown: readonly Leg[] = [];
  #found: Plan | null = null;
  /** The marks of the plan while it is drawn on the table. */
  #drawn: readonly DrawnMark[] | null = null;

  constructor(root: HTMLElement, store: Store, engine: Engine) {
    this.#store = store;
    this.#engine = engine;
    this.#desk = new Desk(() => new DeskWorker(), engine);
    this.#go.addEventListener("click", () => this.#plan());
    this.#drawButton.addEventListener("click", () => this.draw(this.#drawn === null));
    root.append(
      h("h2", {}, t("plan.title")),
      h("div", { class: "thirds" }, ...this.#rows),
      h("div", { class: "row" }, this.#go, this.#drawButton),
      this.#list,
      this.#status,
    );
  }

  /** Follows a change: the plan stays while its shots are opened, and comes back with its position. */
  follow(): void {
    const found = this.#found;
    const isOfPlan =
      found !== null &&
      found.positions.has(this.#store.document.shot.balls) &&
      this.#settings().every((setting, k) => setting === found.settings[k]);
    this.clear();
    if (!isOfPlan) return;
    this.#show(found.legs);
    this.#drawButton.hidden = false;
    setText(this.#status, found.said);
  }

  /** Draws the shots of the plan from the present position on, in place of the aimed shot, or hides them. */
  draw(isWanted: boolean): void {
    const { balls } = this.#store.document.shot;
    const next = this.#shown.findIndex(({ shot }) => shot.balls === balls);
    const wasDrawn = this.#drawn !== null;
    this.#drawn = isWanted ? planMarks(this.#engine, this.#shown, Math.max(0, next)) : null;
    this.#drawButton.setAttribute("aria-pressed", String(isWanted));
    if (isWanted) this.drawAgain();
    else if (wasDrawn) hidePreview(this.#store);
  }

  drawAgain(): void {
    if (this.#drawn) showMarks(this.#store, this.#drawn);
  }

  #settings(): readonly unknown[] {
    const { document, session } = this.#store;
    return [document.game, document.noise, session.analysis.level];
  }

  clear(): void {
    this.#desk.cancel();
    this.draw(false);
    this.#drawButton.hidden = true;
    this.#show([]);
    setText(this.#status, t("plan.hint"));
    const balls = objectBalls(this.#store);
    this.#chosen.forEach((select) => fill(select, balls, t("plan.any")));
    this.#rows.forEach((row, k) => (row.hidden = k >= balls.length));
    this.#go.disabled = balls.length === 0;
  }

  /** Shows the plan as the picture now names its pockets. */
  showAgain(): void {
    this.#show(this.#shown);
  }

  #show(legs: readonly Leg[]): void {
    this.#shown = legs;
    changeUnpressed(this.#list, () =>
      this.#list.replaceChildren(
        ...legs.map((leg, k) => legItem(this.#store, this.#engine, leg, k)),
      ),
    );
  }

  #plan(): void {
    const job = this.#job();
    if (!job) {
      setText(this.#status, t("plan.no-order"));
      return;
    }
    this.draw(false);
    this.#drawButton.hidden = true;
    this.#show([]);
    setText(this.#status, t("plan.searching"));
    const { balls } = this.#store.document.shot;
    const settings = this.#settings();
    this.#desk.ask(job, {
      part: ({ legs, met, count }) => {
        if (legs.length !== this.#shown.length) this.#show(legs);
        if (count > 0) setText(this.#status, planText(legs.length, met, count));
      },
      done: () => {
        this.#list.dataset.done = "true";
        const legs = this.#shown;
        if (legs.length < job.length) setText(this.#status, t("plan.none"));
        const positions = new Set([balls, ...legs.map(({ shot }) => shot.balls)]);
        this.#found = { legs, said: this.#status.textContent, settings, positions };
        if (legs.length < job.length) return;
        this.#drawButton.hidden = false;
        this.draw(true);
      },
      refused: (message) => setText(this.#status, message),
    });
    delete this.#list.dataset.done;
  }

  #job(): PlanJob | null {
    const noise = noiseOf(this.#engine, this.#store.state);
    const { shot, document } = this.#store;
    const cue = placeOf(document.shot, document.shot.strike.ball);
    const all = objectBalls(this.#store);
    const wanted = this.#chosen.slice(0, all.length).map(({ value }) => value || null);
    const ease = (id: string) => {
      const at = placeOf(document.shot, id);
      return cue && at ? estimate(shot, cue, at, noise) : 0;
    };
    const rules = positionOf(this.#store, this.#engine)?.rules ?? null;
    const objective = rules === null ? null : this.#engine.gameFacts[rules]!.objective;
    const orders = ordersOf(considered(all, wanted, objective, ease), wanted, objective);
    const length = orders[0]?.length ?? 0;
    if (length === 0) return null;
    return { kind: "plan", shot: JSON.stringify(document.shot), orders, length, noise, runs: RUNS };
  }
}

function legItem(store: Store, engine: Engine, leg: Leg, index: number): HTMLElement {
  const { ball, pocket, strike, chance } = leg;
  const show = () => {
    const outline = ellipseAround(leg.stops);
    showShot(store, engine.shot(leg.shot), outline ? [{ outline, color: STOP }] : []);
  };
  const names = { ball: playedName(ball), pocket: pocketName(pocket) };
  return h(
    "li",
    {},
    resultButton(
      store,
      { take: () => store.apply({ shot: leg.shot }, t("change.plan", names)), show },
      h(
        "span",
        { class: "said" },
        h("strong", {}, capital(t("lines.pot", names))),
        h("span", { class: "hint" }, strikeText(strike)),
        h(
          "span",
          { class: "facts" },
          h("span", {}, `${t("lines.pot-chance")} `, h("b", {}, percent(chance))),
          dashSample(index),
        ),
      ),
    ),
  );
}

/** The line that a shot of the plan has on the table. */
function dashSample(index: number): SVGElement {
  const sample = svg("svg", { class: "plan-dash", viewBox: "0 0 44 6", "aria-hidden": "true" });
  const dash = DASHES[index % DASHES.length];
  const lengths = dash ? dash.map((length) => 100 * length).join(" ") : "none";
  sample.append(svg("path", { d: "M1 3h42", "stroke-dasharray": lengths }));
  return sample;
}

/** The balls of the layout that can be potted, by their ids. */
function objectBalls({ shot, document }: Store): readonly string[] {
  const balls: readonly BallInfo[] = shot.geometry.pockets.length > 0 ? shot.balls : [];
  return balls.map(({ id }) => id).filter((id) => id !== document.shot.strike.ball);
}

/** Fills a list with balls and an entry for none; a ball that is gone is no longer chosen. */
function fill(select: HTMLSelectElement, balls: readonly string[], none: string): void {
  const { value } = select;
  if (select.dataset.balls !== balls.join()) {
    select.dataset.balls = balls.join();
    select.replaceChildren(
      h("option", { value: "" }, none),
      ...balls.map((id) => h("option", { value: id }, capital(ballName(id)))),
    );
  }
  select.value = balls.includes(value) ? value : "";
}
