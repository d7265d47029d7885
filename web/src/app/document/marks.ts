/** The marks that are drawn on the table: a part of the shot, so that undo, links and files have them. */

import type { DrawnMark, GoalArea, MarkColor, Point } from "../../engine/index.ts";
import { round4 } from "../common/angles.ts";
import type { AimedShot } from "./aimed-shot.ts";

export const TOOLS = ["line", "arrow", "circle", "area", "label", "erase"] as const;
export type DrawTool = (typeof TOOLS)[number];

export const COLORS: readonly MarkColor[] = ["white", "yellow", "red", "blue"];

/** As the format allows (docs/formats.md). */
export const MOST_MARKS = 100;
export const LONGEST_LABEL = 40;

/** While the user draws. */
export interface Drawing {
  readonly tool: DrawTool;
  readonly color: MarkColor;
  /** The text of the next label. */
  readonly text: string;
  /** The place of the keyboard, m; null until it is moved. */
  readonly cursor: Point | null;
  /** The first place of a mark whose second one is awaited, m. */
  readonly start: Point | null;
}

export const FIRST_DRAWING: Drawing = {
  tool: "arrow",
  color: "yellow",
  text: "",
  cursor: null,
  start: null,
};

export function marksOf({ marks = [] }: Pick<AimedShot, "marks">): readonly DrawnMark[] {
  return marks;
}

/** The circles and areas of a list of marks, as areas in which a ball may stop. */
export function areasOfMarks(marks: readonly DrawnMark[]): GoalArea[] {
  return marks.flatMap((mark): GoalArea[] => {
    if (mark.kind === "circle") return [{ center: mark.center, radius: mark.radius }];
    return mark.kind === "area" ? [{ outline: mark.outline }] : [];
  });
}

/** A shot with other marks; without any it has no key for them. */
export function withMarks(shot: AimedShot, marks: readonly DrawnMark[]): AimedShot {
  if (marks.length > 0) return { ...shot, marks };
  const bare: { -readonly [K in keyof AimedShot]: AimedShot[K] } = { ...shot };
  delete bare.marks;
  return bare;
}

/**
 * The mark of a tool between two places, which are rounded to 0.1 mm; null if it has no size.
 *
 * @param tool Neither the label, which has one place, nor the eraser.
 */
export function markBetween(
  tool: Exclude<DrawTool, "label" | "erase">,
  color: MarkColor,
  first: Point,
  second: Point,
): DrawnMark | null {
  const [from, to] = [first, second].map(([x, y]): Point => [round4(x), round4(y)]) as [
    Point,
    Point,
  ];
  const size = round4(Math.hypot(to[0] - from[0], to[1] - from[1]));
  switch (tool) {
    case "line":
    case "arrow":
      return size > 0 ? { kind: tool, color, from, to } : null;
    case "circle":
      return size > 0 ? { kind: "circle", color, center: from, radius: size } : null;
    case "area": {
      const isFlat = from[0] === to[0] || from[1] === to[1];
      const outline: Point[] = [from, [to[0], from[1]], to, [from[0], to[1]]];
      return isFlat ? null : { kind: "area", color, outline };
    }
  }
}

/** Distance (m) of a place from the strokes of a mark. */
export function distanceTo(mark: DrawnMark, place: Point): number {
  switch (mark.kind) {
    case "line":
    case "arrow":
      return toSegment(place, mark.from, mark.to);
    case "circle": {
      const away = Math.hypot(place[0] - mark.center[0], place[1] - mark.center[1]);
      return Math.min(away, Math.abs(away - mark.radius));
    }
    case "area":
      return Math.min(
        ...mark.outline.map((corner, k) => toSegment(place, corner, mark.outline.at(k - 1)!)),
      );
    case "label":
      return Math.hypot(place[0] - mark.at[0], place[1] - mark.at[1]);
  }
}

function toSegment([x, y]: Point, [ax, ay]: Point, [bx, by]: Point): number {
  const [dx, dy] = [bx - ax, by - ay];
  const squared = dx * dx + dy * dy;
  const share = squared > 0 ? ((x - ax) * dx + (y - ay) * dy) / squared : 0;
  const on = Math.min(Math.max(share, 0), 1);
  return Math.hypot(x - ax - on * dx, y - ay - on * dy);
}
