/** The Replay tab: the selected ball's state, its plots, and the list of events. */

import "./replay-panel.css";
import { type Motion, MOTIONS, STRIDE, type BallInfo, type Trace } from "../../engine/types.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import { soundButton } from "./replay-sound.ts";
import type { Store } from "../document/store.ts";
import { Pace } from "./replay-clock.ts";
import { playsOn } from "../document/plays-on.ts";
import { mountEvents } from "./event-list.ts";
import { mountPlots } from "./ball-plots.ts";
import { length } from "./ball-samples.ts";
import type { Show } from "./replay-state.ts";
import { MOTION, POSITION, SPIN, VELOCITY } from "../../viewer/viewer-types.ts";
import { rpm } from "./replay-words.ts";
import { round, TIP } from "../common/units.ts";
import { ballName } from "../common/shot-words.ts";
import { capital, decimal, t } from "../words/translate.ts";

/** Moment of inertia of a solid ball over mass × radius². */
const INERTIA = 2 / 5;

export function mountState(root: HTMLElement, store: Store): void {
  const ball = h("select", { id: uniqueId("ball") });
  ball.addEventListener("change", () => store.setSession({ selected: ball.value }));
  root.append(
    h(
      "div",
      { class: "row" },
      h("label", { for: ball.id }, t("replay.ball")),
      ball,
      soundButton(store),
    ),
    h("div", { class: "state" }),
  );
  const more = h("details", { class: "more" }, h("summary", {}, t("replay.more")));
  const hash = h("code", { id: "hash" });
  const brief = mountBrief(root);
  const events = mountEvents(root, store);
  const parts: Show[] = [brief, events, mountNumbers(more), mountPlots(more, store)];
  more.append(h("p", { class: "hint" }, t("replay.hash"), hash));
  root.append(more);

  const pace = new Pace();
  store.subscribe(({ session }, { session: before }) => {
    const { trace, time } = session.replay;
    if (!trace || session === before) return;
    if (playsOn(session, before) && !pace.due()) return;
    const { balls } = trace.shot;
    if (trace !== before.replay.trace) {
      ball.replaceChildren(
        ...balls.map(({ id }) => h("option", { value: id }, capital(ballName(id)))),
      );
      setText(hash, trace.hash);
    }
    const index = selectedBall(trace, session.selected);
    ball.value = balls[index]!.id;
    for (const show of parts) show(trace, index, time);
  });
}

/** The index of the selected ball; by default of the struck ball, or the first. */
function selectedBall({ shot }: Trace, selected: string | null): number {
  const index = shot.balls.findIndex(({ id }) => id === selected);
  return index >= 0 ? index : (shot.struck ?? 0);
}

/** What players ask for: motion, speed and English. */
function mountBrief(root: HTMLElement): Show {
  const [list, value] = table();
  const motion = value(t("replay.motion"));
  const speed = value(t("replay.speed-now"));
  const english = value(t("replay.english-now"));
  root.append(list);
  const stateOf = reader();
  return (trace, index, time) => {
    const state = stateOf(trace, index, time);
    const v = length(state.velocity);
    setText(motion, t(`motion.${state.motion}`));
    setText(speed, `${decimal(v, 3)} m/s`);
    setText(english, englishText(trace.shot.balls[index]!, v, state.spin[2]!));
  };
}

/** Speed (m/s) below which English is not compared with the speed. */
const SLOW = 0.05;

/** English as the tips of the strike that gives it at the ball's speed: ω = 5 v b / (2 R²). */
function englishText({ radius }: BallInfo, speed: number, about: number): string {
  if (speed < SLOW) return "–";
  const tips = round((INERTIA * radius * about) / speed / TIP, 1);
  if (tips === 0) return t("replay.no-english");
  return t(tips > 0 ? "replay.tips-right" : "replay.tips-left", {
    tips: decimal(Math.abs(tips), 1),
  });
}

function mountNumbers(root: HTMLElement): Show {
  const [list, value] = table();
  const position = value(t("replay.position"));
  const energy = value(t("replay.energy"));
  root.append(list);
  const spin = mountSpin(root);
  const stateOf = reader();
  return (trace, index, time) => {
    const state = stateOf(trace, index, time);
    const [v, omega] = [length(state.velocity), length(state.spin)];
    setText(position, triple(state.position, 3));
    spin([...state.spin, omega]);
    setText(energy, `${decimal(1000 * kinetic(trace.shot.balls[index]!, v, omega), 1)} mJ`);
  };
}

/** A list of names and values, and a function that adds one. */
function table(): [HTMLElement, (name: string) => HTMLElement] {
  const list = h("dl", { class: "numbers" });
  const value = (name: string): HTMLElement => {
    const element = h("dd");
    list.append(h("dt", {}, name), element);
    return element;
  };
  return [list, value];
}

interface BallState {
  readonly position: Float64Array;
  readonly velocity: Float64Array;
  readonly spin: Float64Array;
  readonly motion: Motion;
}

/** A function that reads a ball's state; the arrays change with its next call. */
function reader(): (trace: Trace, ball: number, time: number) => BallState {
  let states = new Float64Array();
  return (trace, ball, time) => {
    const { balls } = trace.shot;
    if (states.length !== STRIDE * balls.length) states = new Float64Array(STRIDE * balls.length);
    trace.statesAt(time, states);
    const vector = (at: number) => states.subarray(STRIDE * ball + at, STRIDE * ball + at + 3);
    return {
      position: vector(POSITION),
      velocity: vector(VELOCITY),
      spin: vector(SPIN),
      motion: MOTIONS[states[STRIDE * ball + MOTION]!]!,
    };
  };
}

/** Kinetic energy, J. */
function kinetic({ mass, radius }: BallInfo, speed: number, spin: number): number {
  return 0.5 * mass * (speed ** 2 + INERTIA * (radius * spin) ** 2);
}

/** @returns A function that shows the spin about x, y and z and its magnitude, rad/s. */
function mountSpin(root: HTMLElement): (spin: readonly number[]) => void {
  const axes = [t("replay.about-x"), t("replay.about-y"), t("replay.about-z"), t("replay.total")];
  const cells = axes.map(() => [h("td"), h("td")] as const);
  const head = [t("replay.spin"), "rad/s", "rpm"].map((name) => h("th", { scope: "col" }, name));
  const rows = axes.map((axis, i) => h("tr", {}, h("th", { scope: "row" }, axis), ...cells[i]!));
  root.append(
    h("table", { class: "spin" }, h("thead", {}, h("tr", {}, ...head)), h("tbody", {}, ...rows)),
  );
  return (spin) =>
    cells.forEach(([radians, turns], i) => {
      setText(radians, decimal(spin[i]!, 1));
      setText(turns, decimal(rpm(spin[i]!), 0));
    });
}

function triple(v: Float64Array, digits: number): string {
  const [x = "", y = "", z = ""] = Array.from(v, (number) => decimal(number, digits));
  return t("replay.triple", { x, y, z });
}
