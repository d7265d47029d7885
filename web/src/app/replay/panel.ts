/** The Replay tab: the selected ball's state, its plots, and the list of events. */

import "./panel.css";
import { MOTIONS, STRIDE, type BallInfo, type Trace } from "../../engine/types.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import { soundButton } from "./sound.ts";
import type { Store } from "../document/store.ts";
import { Pace } from "./clock.ts";
import { playsOn } from "./control.ts";
import { mountEvents } from "./events.ts";
import { mountPlots } from "./plots.ts";
import { length } from "./samples.ts";
import { MOTION, POSITION, type Show, SPIN, VELOCITY } from "./state.ts";
import { rpm } from "./words.ts";
import { decimal, t } from "../words/translate.ts";

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
  const parts: Show[] = [mountNumbers(root), mountPlots(root, store), mountEvents(root, store)];
  const hash = h("code", { id: "hash" });
  root.append(h("p", { class: "hint" }, t("replay.hash"), hash));

  const pace = new Pace();
  store.subscribe(({ session }, { session: before }) => {
    const { trace, time } = session;
    if (!trace || session === before) return;
    if (playsOn(session, before) && !pace.due()) return;
    const { balls } = trace.shot;
    if (trace !== before.trace) {
      ball.replaceChildren(...balls.map(({ id }) => h("option", { value: id }, id)));
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

function mountNumbers(root: HTMLElement): Show {
  const list = h("dl", { class: "numbers" });
  const value = (name: string): HTMLElement => {
    const element = h("dd");
    list.append(h("dt", {}, name), element);
    return element;
  };
  const motion = value(t("replay.motion"));
  const position = value(t("replay.position"));
  const speed = value(t("replay.speed-now"));
  const energy = value(t("replay.energy"));
  root.append(list);
  const spin = mountSpin(root);
  let states = new Float64Array();

  return (trace, index, time) => {
    const { balls } = trace.shot;
    if (states.length !== STRIDE * balls.length) states = new Float64Array(STRIDE * balls.length);
    trace.statesAt(time, states);
    const state = states.subarray(STRIDE * index, STRIDE * (index + 1));
    const vector = (at: number) => state.subarray(at, at + 3);
    const v = length(vector(VELOCITY));
    const omega = length(vector(SPIN));
    setText(motion, t(`motion.${MOTIONS[state[MOTION]!]!}`));
    setText(position, triple(vector(POSITION), 3));
    setText(speed, `${decimal(v, 3)} m/s`);
    spin([...vector(SPIN), omega]);
    setText(energy, `${decimal(1000 * kinetic(balls[index]!, v, omega), 1)} mJ`);
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
