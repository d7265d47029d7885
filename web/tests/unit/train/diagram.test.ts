/** The pictures of the drills: their numbers are free of everything else. */

import { describe, expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import { DRILLS } from "../../../src/app/train/drills/index.ts";
import type { Mark } from "../../../src/app/diagram/table-marks.ts";
import { marksOf } from "../../../src/app/train/diagram-marks.ts";

const engine = await load();

/** Sizes of the balls over those on the table: on a sheet, and in the panel. */
const ENLARGED = [1, 1.4, 1.6, 1.8];

/** The widest bold digits of common fonts, and their height, over the size of the font. */
const DIGIT = [0.7, 0.73] as const;

/** The least distance, mm on the table: a tenth of a millimetre on a sheet at 1 : 50. */
const LEAST = 5;

const LINES: Readonly<Record<string, number>> = {
  "diagram-zone": 9,
  "diagram-hand": 9,
  "diagram-ball": 5,
  "diagram-goal": 26,
  "diagram-pocket": 0,
  "diagram-spot": 0,
};

interface Box {
  readonly from: readonly [number, number];
  readonly to: readonly [number, number];
}

/** What a number covers: the baseline is 0.36 of the font below its place. */
function boxOf([, attributes, text]: Mark): Box {
  const [x, y, size] = ["x", "y", "font-size"].map((key) => Number(attributes[key])) as [
    number,
    number,
    number,
  ];
  const half = (DIGIT[0] * size * text!.length) / 2;
  const baseline = y + 0.36 * size;
  return { from: [x - half, baseline - DIGIT[1] * size], to: [x + half, baseline] };
}

/** Points along the edge and inside of a box, 3 mm apart. */
function pointsOf({ from, to }: Box): [number, number][] {
  const steps = (axis: 0 | 1) => {
    const count = Math.max(1, Math.ceil((to[axis] - from[axis]) / 3));
    return Array.from(
      { length: count + 1 },
      (_, k) => from[axis] + ((to[axis] - from[axis]) * k) / count,
    );
  };
  return steps(0).flatMap((x) => steps(1).map((y): [number, number] => [x, y]));
}

/** The distance of a point from the ink of a mark. */
function distance([x, y]: readonly [number, number], mark: Mark): number {
  const [tag, attributes] = mark;
  const name = String(attributes.class);
  const half = (LINES[name] ?? 0) / 2;
  const at = (key: string) => Number(attributes[key]);
  if (tag === "text") {
    const { from, to } = boxOf(mark);
    return Math.hypot(Math.max(from[0] - x, x - to[0], 0), Math.max(from[1] - y, y - to[1], 0));
  }
  if (tag === "circle") {
    const far = Math.hypot(x - at("cx"), y - at("cy")) - at("r");
    const isFilled = !["diagram-zone", "diagram-hand", "diagram-goal"].includes(name);
    return (isFilled ? Math.max(far, 0) : Math.abs(far)) - half;
  }
  // The line around a rectangle.
  const [left, top] = [at("x"), at("y")];
  const [right, bottom] = [left + at("width"), top + at("height")];
  const outside = Math.hypot(Math.max(left - x, x - right, 0), Math.max(top - y, y - bottom, 0));
  const inside = Math.min(x - left, right - x, y - top, bottom - y);
  return (inside > 0 ? inside : outside) - half;
}

describe.each(DRILLS.map((drill) => [drill.id, drill] as const))(
  "the diagram of %s",
  (_, drill) => {
    test.each(ENLARGED)("has free numbers with balls enlarged by %d", (enlarged) => {
      // Seen: on the sheet of the stop shot the number of the ball touched the circle.
      for (const [k, step] of drill.steps.entries()) {
        const marks = marksOf(engine, { drill, step, attempt: 0 }, { enlarged, numbered: true });
        const texts = marks.filter(([tag]) => tag === "text");
        const inked = marks.filter(
          ([tag, { class: name }]) =>
            tag === "text" || name === "diagram-cloth" || String(name) in LINES,
        );
        for (const text of texts.filter(([, { class: name }]) => name !== "diagram-number")) {
          for (const other of inked.filter((mark) => mark !== text && mark[0] !== "path")) {
            const least = Math.min(...pointsOf(boxOf(text)).map((point) => distance(point, other)));
            const what = `step ${k + 1}: ${text[2]} and ${JSON.stringify(other)}`;
            expect(least, what).toBeGreaterThan(LEAST);
          }
        }
      }
    });

    test("has the number of a ball nearest to this ball", () => {
      for (const step of drill.steps) {
        const marks = marksOf(engine, { drill, step, attempt: 0 }, { enlarged: 1, numbered: true });
        const balls = marks.filter(([, { class: name }]) => name === "diagram-ball");
        const ids = step.rack ? [] : Object.keys(step.balls);
        for (const [, attributes, text] of marks.filter(
          ([, { class: name }]) => name === "diagram-id",
        )) {
          const far = balls.map(([, ball]) =>
            Math.hypot(
              Number(ball.cx) - Number(attributes.x),
              Number(ball.cy) - Number(attributes.y),
            ),
          );
          expect(ids[far.indexOf(Math.min(...far))]).toBe(text);
        }
      }
    });
  },
);
