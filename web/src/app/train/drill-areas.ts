/** The areas of a drill as the viewer marks them on the cloth. */

import type { Engine, Point } from "../../engine/index.ts";
import type { Area as MarkedArea } from "../../viewer/index.ts";
import { arc } from "../common/arc.ts";
import { goalPockets, isWhole, targetsOf } from "./diagram-marks.ts";
import type { Setting } from "./drill-layout.ts";
import { clothOf, type Region, regionOf } from "./drill-places.ts";

const HAND = "#ffe9a8";
const GOAL = "#ffd23f";
const TARGET = "#ffffff";

/** @param hand Whether the cue ball may be placed now. */
export function markedAreas(engine: Engine, { drill, step }: Setting, hand: boolean): MarkedArea[] {
  const cloth = clothOf(engine, drill.table);
  const marked = (area: Parameters<typeof regionOf>[1], color: string): MarkedArea => ({
    outline: outlineOf(regionOf(cloth, area, step.balls)),
    color,
  });
  return [
    ...(hand && step.hand && !isWhole(step.hand) ? [marked(step.hand, HAND)] : []),
    ...goalPockets(step).map((name) => {
      const { center, radius } = cloth.geometry.pockets.find((pocket) => pocket.name === name)!;
      return { outline: outlineOf({ kind: "disc", center, radius }), color: GOAL };
    }),
    ...(step.goal.kind === "shot" ? targetsOf(step.goal) : []).flatMap(({ area }) =>
      isWhole(area) ? [] : [marked(area, TARGET)],
    ),
  ];
}

function outlineOf(region: Region): Point[] {
  if (region.kind === "box") {
    const { from, to } = region;
    return [from, [to[0], from[1]], to, [from[0], to[1]]];
  }
  const { center, radius } = region;
  return region.kind === "disc" ? arc(center, radius) : arc(center, radius, Math.PI);
}
