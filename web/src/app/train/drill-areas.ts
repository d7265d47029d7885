/** The areas of a drill as the viewer marks them on the cloth. */

import type { Engine } from "../../engine/index.ts";
import type { Area as MarkedArea } from "../../viewer/index.ts";
import { arc } from "../common/arc.ts";
import { outlineOf } from "../common/area-outline.ts";
import { goalPockets, isWhole, targetsOf } from "./diagram-marks.ts";
import type { Setting } from "./drill-layout.ts";
import { areaInMetres, clothOf } from "./drill-places.ts";
import type { Area } from "./drills/index.ts";

const HAND = "#ffe9a8";
const GOAL = "#ffd23f";
const TARGET = "#ffffff";

/** @param hand Whether the cue ball may be placed now. */
export function markedAreas(engine: Engine, { drill, step }: Setting, hand: boolean): MarkedArea[] {
  const cloth = clothOf(engine, drill.table);
  const marked = (area: Area, color: string): MarkedArea => ({
    outline: outlineOf(areaInMetres(cloth, area, step.balls), cloth.geometry),
    color,
  });
  return [
    ...(hand && step.hand && !isWhole(step.hand) ? [marked(step.hand, HAND)] : []),
    ...goalPockets(step).map((name) => {
      const { center, radius } = cloth.geometry.pockets.find((pocket) => pocket.name === name)!;
      return { outline: arc(center, radius), color: GOAL };
    }),
    ...(step.goal.kind === "shot" ? targetsOf(step.goal) : []).flatMap(({ area }) =>
      isWhole(area) ? [] : [marked(area, TARGET)],
    ),
  ];
}
