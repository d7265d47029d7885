/** A layout that the engine accepts, from balls whose places are known to some millimetres. */

import {
  CaromError,
  type BallEntry,
  type Engine,
  type Geometry,
  type Point,
  type ShotFile,
} from "../../engine/index.ts";
import { bed, settle, type Contact } from "./settle.ts";

/** The table of a shot file and its physics. */
export type Equipment = Pick<ShotFile, "table" | "physics">;

/** The table of a photo. */
export interface TableOfPhoto {
  readonly equipment: Equipment;
  readonly geometry: Geometry;
  /** Of its balls, m. */
  readonly radius: number;
}

/** A ball in a photo. */
export interface FoundBall {
  readonly id: string;
  /** m. */
  readonly position: Point;
}

export interface Layout {
  readonly balls: readonly BallEntry[];
  /** Their indices refer to `balls`. */
  readonly contacts: readonly Contact[];
}

/** A ball over a hole or in a rail is moved towards the middle of the table by this step, m. */
const STEP = 0.001;

/** The shot file of a layout. */
export function shotFile(equipment: Equipment, balls: readonly BallEntry[]): ShotFile {
  const { table, physics } = equipment;
  return { format: "carom-shot/1", table, balls, ...(physics !== undefined && { physics }) };
}

/** The valid layout nearest to the found balls; null if no such layout is found, as for too many balls. */
export function layout(
  engine: Engine,
  table: TableOfPhoto,
  found: readonly FoundBall[],
): Layout | null {
  if (found.length === 0) return { balls: [], contacts: [] };
  const { geometry, radius } = table;
  if (!geometry.size) return null;
  const middle: Point = [geometry.size[0] / 2, geometry.size[1] / 2];
  const accepted = (id: string, position: Point) =>
    accepts(engine, shotFile(table.equipment, [{ id, position }]));
  const on = bed(geometry, radius);
  const first = settle(
    found.map(({ position }) => position),
    on,
  );
  const inside = found.map(({ id }, k) =>
    moved(first.positions[k]!, middle, (place) => accepted(id, place)),
  );
  if (!inside.every((place) => place !== null)) return null;
  const { positions, contacts } = settle(inside, on);
  const balls = found.map(({ id }, k) => ({ id, position: positions[k]! }));
  return accepts(engine, shotFile(table.equipment, balls)) ? { balls, contacts } : null;
}

/** The table of a shot file that the engine accepts, and the radius of its balls. */
export function tableOf(engine: Engine, { table, physics, balls }: ShotFile): TableOfPhoto {
  const equipment = { table, ...(physics !== undefined && { physics }) };
  const { id, position } = balls[0]!;
  const shot = engine.shot(shotFile(equipment, [{ id, position: [position[0], position[1]] }]));
  const { geometry, balls: read } = shot;
  shot.free();
  return { equipment, geometry, radius: read[0]!.radius };
}

/** The first place on the way to `middle` that is accepted; null if there is none. */
function moved(from: Point, middle: Point, accepted: (place: Point) => boolean): Point | null {
  const way = Math.hypot(middle[0] - from[0], middle[1] - from[1]);
  for (let gone = 0; gone <= way; gone += STEP) {
    const share = way > 0 ? gone / way : 0;
    const place: Point = [
      from[0] + share * (middle[0] - from[0]),
      from[1] + share * (middle[1] - from[1]),
    ];
    if (accepted(place)) return place;
  }
  return null;
}

function accepts(engine: Engine, file: ShotFile): boolean {
  try {
    engine.shot(file).free();
    return true;
  } catch (error) {
    if (error instanceof CaromError) return false;
    throw error;
  }
}
