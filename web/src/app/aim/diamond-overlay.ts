/** The overlay of a diamond system: its numbers at the diamonds, its target, and the engine's. */

import "./diamond-overlay.css";
import { CaromError, type DiamondReading, type Geometry, type Point } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, setText, svg } from "../common/dom.ts";
import { shownGuide } from "../document/guide-extent.ts";
import type { Store } from "../document/store.ts";
import { firstContactEvent } from "../pot/first-contact.ts";
import { readingInWords } from "../pot/diamond-words.ts";
import { decimal, t } from "../words/translate.ts";

/** Distance (m) of the numbers behind the sights, and before the cushion for those of a target. */
const BEHIND = 0.045;
const BEFORE = 0.14;

/** Radius of the marks, CSS pixels. */
const MARK = 7;

/** @param stage The part of the page with the table. */
export function mountDiamonds(stage: HTMLElement, store: Store, context: Context): void {
  const picture = svg("svg", { "aria-hidden": "true" });
  const text = h("p", { role: "status" });
  const root = h("div", { class: "diamonds", hidden: true }, picture, text);
  document.getElementById("table")!.after(root);
  let reading: DiamondReading | null = null;
  /** Where the table was in the picture when the overlay was drawn. */
  let drawn = "";

  /** Where a place at the height of the noses is on the stage; null if it is not in the picture. */
  const onStage = ([x, y]: Point): Point | null => {
    const at = context.viewer.project(x, y, store.shot.geometry.cushion_height);
    const area = stage.getBoundingClientRect();
    return at && [at[0] - area.left, at[1] - area.top];
  };

  function read(): void {
    const wanted = store.session.overlays.diamonds && store.session.mode === "aim";
    root.hidden = !wanted || shownGuide(store) !== "full";
    if (root.hidden) return;
    reading = readingNow(store, context);
    setText(text, reading ? readingInWords(reading) : t("diamonds.none"));
    drawn = "";
    requestAnimationFrame(follow);
  }

  /** Draws again when the camera or the window has moved the table. */
  function follow(): void {
    if (root.hidden) return;
    const { viewer } = context;
    const place = JSON.stringify([
      viewer.project(0, 0, 0),
      viewer.project(1, 1, 0),
      stage.clientWidth,
      stage.clientHeight,
    ]);
    if (place !== drawn) {
      drawn = place;
      picture.replaceChildren(...(reading ? shapes(reading, store.shot.geometry, onStage) : []));
    }
    if (!waiting) {
      waiting = true;
      requestAnimationFrame(() => {
        waiting = false;
        follow();
      });
    }
  }
  let waiting = false;

  store.subscribe((now, before) => {
    const { session } = now;
    const isSame =
      now.document === before.document &&
      session.overlays.diamonds === before.session.overlays.diamonds &&
      session.mode === before.session.mode &&
      session.attempt === before.session.attempt;
    if (!isSame) context.loop.input(root, read);
  });
}

/** The numbers, the line and the marks of a reading. @param on Where a place is in the picture. */
function shapes(
  { numbers, places }: DiamondReading,
  { size }: Geometry,
  on: (place: Point) => Point | null,
): SVGElement[] {
  const label = (at: Point, number: number, kind: string): SVGElement[] => {
    const place = on(at);
    if (!place) return [];
    const said = svg("text", { class: kind, x: place[0], y: place[1] });
    said.textContent = decimal(number, 1).replace(/[.,]0$/, "");
    return [said];
  };
  const ring = (at: Point | null, kind: string): SVGElement[] => {
    const place = at && on(at);
    return place ? [svg("circle", { class: kind, cx: place[0], cy: place[1], r: MARK })] : [];
  };
  const [from, over] = [on(places.from), on(places.over)];
  return [
    ...(from && over ? [svg("line", { x1: from[0], y1: from[1], x2: over[0], y2: over[1] })] : []),
    ...numbers.flatMap(({ at, number, scale }) =>
      label(aside(at, size!, scale === "line" ? BEHIND : -BEFORE), number, scale),
    ),
    ...ring(places.predicted, "predicted"),
    ...ring(places.actual, "actual"),
  ];
}

/** A place behind (or before, if negative) the line of sights. */
function aside([x, y]: Point, [width, length]: Point, by: number): Point {
  if (x < 0) return [x - by, y];
  if (x > width) return [x + by, y];
  return y < 0 ? [x, y - by] : y > length ? [x, y + by] : [x, y];
}

/** The present line: that of the cue ball alone after cushions, or of the object ball of a bank. */
function readingNow(store: Store, { engine }: Context): DiamondReading | null {
  const { trace } = store.ghost;
  const { struck } = store.shot;
  if (!trace || struck === null) return null;
  const contact = firstContactEvent(trace);
  const kicks = trace.outcome.rails_before_first_contact.length > 0;
  if (contact && !kicks) {
    const id = contact.event.balls[contact.other]!;
    const ball = trace.shot.balls.findIndex((one) => one.id === id);
    return trace.diamondReading(ball, trace.events.indexOf(contact.event));
  }
  const { shot } = store.document;
  const balls = shot.balls.filter(({ id }) => id === shot.strike.ball);
  try {
    const alone = engine.shot({ ...shot, balls });
    const path = alone.simulate();
    const reading = path.diamondReading(0);
    path.free();
    alone.free();
    return reading;
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    return null;
  }
}
