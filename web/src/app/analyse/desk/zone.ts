/** From where on the table a ball is potted how often: the zone for the cue ball. */

import type { Engine, PocketName, Point, Shot } from "../../../engine/index.ts";
import { ON_TABLE } from "../../../engine/types.ts";
import type { Parts, ZoneJob } from "./desk-protocol.ts";
import { type Layout, placeOf, potLines, read, struck } from "./desk-layout.ts";

/** Cells across the table; twice as many along it. They are about 10 cm wide. */
export const COLUMNS = 12;

/** Variants of the pot from a cell: a standard error of 10 % is invisible beside the smoothing. */
const VARIANTS = 24;

/** Speed of the cue, m/s: a usual stroke. */
const SPEED = 2;

/** Pockets that are tried from a cell, the easiest by geometry. */
const POCKETS = 2;

export function* zone(engine: Engine, job: ZoneJob): Generator<Parts["zone"]> {
  const file = JSON.parse(job.shot) as Layout;
  const base = read(engine, file);
  const size = base?.geometry.size;
  const ball = placeOf(file, job.ball);
  if (!base || !size || !ball) return;
  const rows = 2 * COLUMNS;
  const values = new Float32Array(COLUMNS * rows);
  // Every third row first, so that the whole zone is soon visible.
  const order = [0, 1, 2].flatMap((from) =>
    Array.from({ length: Math.ceil((rows - from) / 3) }, (_, k) => from + 3 * k),
  );
  let done = 0;
  for (const row of order) {
    for (let column = 0; column < COLUMNS; column++) {
      const place: Point = [((column + 0.5) * size[0]) / COLUMNS, ((row + 0.5) * size[1]) / rows];
      values[row * COLUMNS + column] = chanceFrom(engine, base, file, place, ball, job);
    }
    done++;
    yield { columns: COLUMNS, rows, values: values.slice(), share: done / rows };
  }
  base.free();
}

/** The chance of the best pot with the cue ball at `place`; 0 where it has no room. */
function chanceFrom(
  engine: Engine,
  base: Shot,
  file: Layout,
  place: Point,
  ball: Point,
  { ball: id, noise }: ZoneJob,
): number {
  const { radius } = base.balls[0]!;
  const lines = potLines(base.geometry.pockets, place, ball, radius).slice(0, POCKETS);
  const cue = file.strike.ball;
  const balls = file.balls.map((entry) =>
    entry.id === cue ? { ...entry, position: place } : entry,
  );
  const chances = lines.map(({ pocket, azimuth }) => {
    const shot = read(engine, struck({ ...file, balls }, { speed: SPEED, azimuth }));
    if (!shot) return 0;
    const aim = shot.potAim(id, pocket, { near: true });
    const aimed = aim && shot.withStrike(aim.strike);
    const chance = aimed ? share(aimed, id, pocket, noise) : 0;
    aimed?.free();
    shot.free();
    return chance;
  });
  return Math.max(0, ...chances);
}

/** The share of variants in which the ball falls into the pocket and the cue ball stays. */
function share(shot: Shot, id: string, name: PocketName, noise: ZoneJob["noise"]): number {
  const { balls, pocket } = shot.vary(noise, VARIANTS);
  const ball = shot.balls.findIndex((other) => other.id === id);
  const wanted = shot.geometry.pockets.findIndex((other) => other.name === name);
  let met = 0;
  for (let k = 0; k < VARIANTS; k++) {
    const falls = pocket[k * balls + ball] === wanted;
    if (falls && pocket[k * balls + shot.struck!] === ON_TABLE) met++;
  }
  return met / VARIANTS;
}
