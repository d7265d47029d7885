/**
 * The place where the cue ball stops, as a handle: dragged elsewhere, the strike is solved again with the
 * pot kept.
 */

import type { Engine, PocketName, Point, Trace } from "../../engine/index.ts";
import type { Area } from "../../viewer/index.ts";
import { STRIDE } from "../../engine/types.ts";
import type { Context } from "../common/context.ts";
import { arc } from "../common/arc.ts";
import { h } from "../common/dom.ts";
import { lockOf } from "../document/pot-lock.ts";
import type { Store } from "../document/store.ts";
import { automatic } from "../document/strike-angles.ts";
import { potOf } from "./chance-chip.ts";
import { Desk } from "./desk/desk-client.ts";
import DeskWorker from "./desk/desk-worker.ts?worker&inline";
import { shotOf } from "./aim-recommendation.ts";
import { noiseOf } from "./analysed-position.ts";
import { hidePreview, showAreas } from "./result-preview.ts";
import { centimetres } from "./analyse-words.ts";
import { t } from "../words/translate.ts";

const COLOR = "#8fe3ff";

/** Radius of the handle, ball radii. */
const HANDLE = 1.7;

/** Steps of the arrow keys, m. */
const STEP = 0.05;
const FINE_STEP = 0.01;

/** The handle of a trace, so that it is made once. */
const handles = new WeakMap<Trace, Area>();

const desks = new WeakMap<Engine, Desk>();

function deskOf(engine: Engine): Desk {
  let desk = desks.get(engine);
  if (!desk) desks.set(engine, (desk = new Desk(() => new DeskWorker(), engine)));
  return desk;
}

/** Where the cue ball stops, if that can be changed: in the analysis of a free layout, with a pot. */
export function stopOf(store: Store): Point | null {
  const { session, document } = store;
  if (session.activity !== "analyse" || session.mode !== "aim" || document.game) return null;
  const { trace } = store.ghost;
  const { struck, balls } = store.shot;
  if (!trace || struck === null || !potOf(store)) return null;
  const { pocketed, off_table: off } = trace.outcome;
  const { id } = balls[struck]!;
  if (off.includes(id) || pocketed.some(([ball]) => ball === id)) return null;
  const states = trace.statesAt(trace.duration);
  return [states[struck * STRIDE]!, states[struck * STRIDE + 1]!];
}

/** The ring around the place where the cue ball stops; the same object for the same simulation. */
export function stopHandle(store: Store): Area | null {
  const place = stopOf(store);
  const { trace } = store.ghost;
  if (!place || !trace) return null;
  let area = handles.get(trace);
  if (!area) handles.set(trace, (area = ring(store, place)));
  return area;
}

/** Shows the ring at another place. */
export function dragStop(store: Store, place: Point): void {
  showAreas(store, [ring(store, place)]);
}

/** Solves the strike so that the cue ball stops at `place`. */
export function dropStop(store: Store, context: Context, place: Point): void {
  const { engine } = context;
  const pot = potOf(store);
  if (!pot) return;
  const asked = store.document;
  context.announce(t("stop.solving"));
  const job = {
    kind: "leave",
    shot: store.shot.json(),
    ...pot,
    place,
    noise: noiseOf(engine, store.state),
  } as const;
  deskOf(engine).ask(job, {
    part: ({ aim }) => {
      if (store.document !== asked) return;
      hidePreview(store);
      if (!aim) {
        store.refuse(t("stop.no-pot"));
        return;
      }
      const next = shotOf(asked.shot, aim);
      const strike = store.shot.hasDefaultElevation ? automatic(next.strike) : next.strike;
      if (!store.apply({ shot: { ...next, strike } }, t("change.stop"))) return;
      lock(store, pot);
      const distance = centimetres(aim.distance);
      context.announce(aim.isReached ? t("stop.reached") : t("stop.not-reached", { distance }));
    },
    refused: (message) => {
      hidePreview(store);
      store.refuse(message);
    },
  });
}

function lock(store: Store, { ball, pocket }: { ball: string; pocket: PocketName }): void {
  const found = store.shot.potAim(ball, pocket, { near: true });
  if (found) store.setSession({ lock: lockOf(ball, pocket, found) });
}

function ring(store: Store, place: Point): Area {
  const radius = HANDLE * (store.shot.balls[store.shot.struck ?? 0]?.radius ?? 0);
  return { outline: arc(place, radius), color: COLOR };
}

/** The direction of an arrow key on the table as it is seen. */
const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** The part of the panel that moves the stopping place by keys. */
export function mountStop(root: HTMLElement, store: Store, context: Context): void {
  let place: Point | null = null;
  const button = h(
    "button",
    { type: "button", class: "button", id: "stop-keys", "aria-describedby": "stop-hint" },
    t("stop.move"),
  );
  button.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    const from = place ?? stopOf(store);
    if (!arrow || !from) return;
    event.preventDefault();
    place = clamped(store, moved(context, from, arrow, event.shiftKey ? FINE_STEP : STEP));
    dragStop(store, place);
  });
  button.addEventListener("click", () => {
    if (stopOf(store) === null) context.announce(t("stop.nothing"));
    else if (place) dropStop(store, context, place);
    else context.announce(t("stop.keys"));
    place = null;
  });
  button.addEventListener("blur", () => {
    if (!place) return;
    place = null;
    hidePreview(store);
  });
  root.append(
    h("h2", {}, t("stop.title")),
    h("div", { class: "row" }, button),
    h("p", { class: "hint", id: "stop-hint" }, t("stop.hint")),
  );
}

/** The place that is a step away in the direction of an arrow on the screen. */
function moved({ viewer }: Context, [x, y]: Point, [right, down]: Point, step: number): Point {
  const axes = [
    [step, 0],
    [0, step],
    [-step, 0],
    [0, -step],
  ] as const;
  const from = viewer.project(x, y, 0);
  const along = (by: Point): number => {
    const to = viewer.project(x + by[0], y + by[1], 0);
    return from && to ? (to[0] - from[0]) * right + (to[1] - from[1]) * down : 0;
  };
  const [best] = [...axes].sort((a, b) => along(b) - along(a));
  return [x + best![0], y + best![1]];
}

function clamped({ shot }: Store, [x, y]: Point): Point {
  const [width, length] = shot.geometry.size ?? [Infinity, Infinity];
  return [Math.min(Math.max(x, 0), width), Math.min(Math.max(y, 0), length)];
}
