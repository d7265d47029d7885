/** Drills as files: from metres to the diamonds of the page's drills, and back. */

import type { DrillFile, Engine, GoalArea, Point } from "../../engine/index.ts";
import { round4 } from "../common/angles.ts";
import type { Area, Diamonds, Drill, Step } from "./drills/index.ts";
import { layoutOf } from "./drill-layout.ts";
import { type Cloth, clothOf, areaInMetres, goalInMetres, withAreas } from "./drill-places.ts";

/** Ids of drills that users have made begin with this. */
export const OWN = "own:";

/** Speed of the cue with which the aim begins if a file gives none, m/s. */
const SPEED = 1.6;

/** The drill of a file that the engine has read. */
export function drillOfFile(engine: Engine, file: DrillFile): Drill {
  const { name, text, table, cue = "cue", attempts, misses, order = "same" } = file;
  const cloth = clothOf(engine, table);
  return {
    id: `${OWN}${name}`,
    name,
    ...(text !== undefined && { text }),
    table,
    cue,
    attempts,
    ...(misses !== undefined && { misses }),
    order,
    steps: file.steps.map((step) => stepOf(cloth, step)),
    speed: file.steps[0]!.speed ?? SPEED,
  };
}

/** The step of a part of a file. */
export function stepOf(
  cloth: Cloth,
  { balls, hand, goal }: Omit<DrillFile["steps"][number], "speed">,
): Step {
  const area = (one: GoalArea) => inDiamonds(cloth, one);
  return {
    balls: Object.fromEntries(
      balls.map(({ id, position: [x, y] }) => [id, diamonds(cloth, [x, y])]),
    ),
    ...(hand && { hand: area(hand) }),
    goal: withAreas(goal, area),
  };
}

function diamonds({ diamond }: Cloth, [x, y]: Point): Diamonds {
  return [x / diamond[0], y / diamond[1]];
}

function inDiamonds(cloth: Cloth, area: GoalArea): Area {
  if ("marking" in area) return area;
  if ("center" in area) {
    return { center: diamonds(cloth, area.center), radius: area.radius / cloth.diamond[1] };
  }
  if ("outline" in area) {
    return { outline: area.outline.map((corner) => diamonds(cloth, corner)) };
  }
  return { from: diamonds(cloth, area.from), to: diamonds(cloth, area.to) };
}

/** The file of a drill; the drill must have no rack. */
export function fileOfDrill(engine: Engine, drill: Drill, name: string, text: string): DrillFile {
  const { table, cue, attempts, misses, order, speed } = drill;
  const cloth = clothOf(engine, table);
  return {
    format: "carom-drill/1",
    name,
    ...(text !== "" && { text }),
    table,
    cue,
    attempts,
    ...(misses !== undefined && { misses }),
    order,
    steps: drill.steps.map((step) => ({
      balls: layoutOf(engine, { drill, step, attempt: 0 }).balls,
      ...(step.hand && { hand: rounded(areaInMetres(cloth, step.hand, step.balls)) }),
      speed,
      goal: rounded(goalInMetres(cloth, step)),
    })),
  };
}

/** The same with lengths rounded to a tenth of a millimetre. */
function rounded<T>(value: T): T {
  if (typeof value === "number") return round4(value) as T;
  if (Array.isArray(value)) return value.map(rounded) as T;
  if (typeof value !== "object" || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, rounded(one)])) as T;
}
