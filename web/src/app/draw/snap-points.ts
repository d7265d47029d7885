/** The places to which drawn marks snap: balls, pockets, diamonds, and where the balls of the aimed shot meet. */

import type { Geometry, Point, Trace } from "../../engine/index.ts";
import { ballName, pocketName } from "../common/shot-words.ts";
import { shownGuide } from "../document/guide-extent.ts";
import type { Store } from "../document/store.ts";
import { MARK_HEIGHT } from "../../viewer/index.ts";
import { t } from "../words/translate.ts";

export interface SnapPoint {
  readonly at: Point;
  /** The place in words. */
  readonly name: string;
}

/** The contacts of the aimed shot that are snap points: more would lie everywhere. */
const CONTACTS = 8;

/** In the order in which the keyboard visits them. */
export function snapPoints(store: Store): readonly SnapPoint[] {
  const { balls, geometry } = store.shot;
  const trace = shownGuide(store) === "full" ? store.ghost.trace : null;
  return [
    ...balls.map(({ id, position: [x, y] }) => ({ at: [x, y] as const, name: ballName(id) })),
    ...contacts(trace),
    ...geometry.pockets.map(({ name, center }) => ({ at: center, name: pocketName(name) })),
    ...diamonds(geometry).map((at) => ({ at, name: t("draw.diamond") })),
  ];
}

/** The centres of the balls that move, where they meet others and cushions. */
function contacts(trace: Trace | null): SnapPoint[] {
  const met = trace?.events.filter(
    ({ type }) => type === "ball-collision" || type === "rail-collision",
  );
  return (met ?? []).slice(0, CONTACTS).flatMap(({ type, before }) =>
    before
      .filter(({ velocity }) => Math.hypot(...velocity) > 0)
      .map(({ position: [x, y] }) => ({
        at: [x, y] as const,
        name: t(type === "ball-collision" ? "draw.contact" : "draw.cushion"),
      })),
  );
}

/** The sights of the rails; corners have none, nor the middle of a long rail with a side pocket. */
function diamonds({ size, sights, pockets }: Geometry): Point[] {
  if (!size || !sights) return [];
  const [width, length] = size;
  const { along_length: long, along_width: short, setback } = sights;
  const steps = (count: number) => Array.from({ length: count - 1 }, (_, k) => (k + 1) / count);
  const isFree = (share: number) => pockets.length < 6 || share !== 0.5;
  return [
    ...steps(long)
      .filter(isFree)
      .flatMap((share): Point[] => [
        [-setback, share * length],
        [width + setback, share * length],
      ]),
    ...steps(short).flatMap((share): Point[] => [
      [share * width, -setback],
      [share * width, length + setback],
    ]),
  ];
}

/** The nearest snap point to a place of the page, within `reach` CSS pixels; null if there is none. */
export function snapAt(
  [x, y]: Point,
  points: readonly SnapPoint[],
  project: (x: number, y: number, z: number) => readonly [number, number] | null,
  reach: number,
): SnapPoint | null {
  let best: SnapPoint | null = null;
  let least = reach;
  for (const point of points) {
    const seen = project(...point.at, MARK_HEIGHT);
    const away = seen ? Math.hypot(seen[0] - x, seen[1] - y) : Infinity;
    if (away <= least) [best, least] = [point, away];
  }
  return best;
}
