/**
 * A plan of some balls in a row: for each its pocket, its stroke and where the cue ball should stop, and the
 * chance that all of them fall.
 *
 * The strokes are chosen by the chance of the pot, from its margin, times a geometric estimate of the next
 * pot from where the cue ball stops. The stated chances are counted: the whole plan is played with
 * the player's errors, and after every shot the next stroke is chosen again from where the balls really lie.
 */

import type { Engine, Noise, PocketName, Point, Strike } from "../../../engine/index.ts";
import { CaromError } from "../../../engine/error.ts";
import type { Leg, Parts, PlanJob } from "./desk-protocol.ts";
import {
  after,
  estimate,
  type Layout,
  placeOf,
  potLines,
  read,
  struck,
  within,
} from "./desk-layout.ts";

/** Strokes that are tried for a ball after which another one follows: speeds (m/s) and tip heights (ball radii). */
const SPEEDS = [1, 1.8, 3] as const;
const HEIGHTS = [-0.35, 0, 0.35] as const;
/** The stroke of the last ball. */
const LAST = [[1.8, 0]] as const;

/** Pockets that are tried for a ball, the easiest by geometry. */
const POCKETS = 2;

/** Variants that count the chance of one stroke and give its zone. */
const VARIANTS = 100;

/** A stroke that pots a ball, with the layout that it leaves. */
interface Stroke {
  readonly pocket: PocketName;
  readonly strike: Strike;
  readonly file: Layout;
  readonly next: Layout | null;
  readonly value: number;
}

export function* plan(engine: Engine, job: PlanJob): Generator<Parts["plan"]> {
  const { noise, runs } = job;
  const order: string[] = [];
  const legs: Leg[] = [];
  let layout: Layout | null = JSON.parse(job.shot) as Layout;
  for (let k = 0; k < job.length && layout; k++) {
    const found = chosen(engine, layout, job.orders, order, noise, job.length);
    if (!found) break;
    order.push(found.ball);
    legs.push(legOf(engine, found.ball, found.stroke, noise));
    layout = found.stroke.next;
    yield { legs: [...legs], met: 0, count: 0 };
  }
  if (legs.length < job.length) return;
  let met = 0;
  for (let run = 0; run < runs; run++) {
    if (isRunOut(engine, legs, order, noise, run)) met++;
    yield { legs, met, count: run + 1 };
  }
}

/** The next ball of the plan and its stroke; null if no ball can be potted. */
function chosen(
  engine: Engine,
  layout: Layout,
  orders: PlanJob["orders"],
  before: readonly string[],
  noise: Noise,
  length: number,
): { readonly ball: string; readonly stroke: Stroke } | null {
  const isLast = before.length === length - 1;
  const starts = orders.filter((order) => before.every((ball, k) => order[k] === ball));
  const pairs = new Map<string, { ball: string; next: string | null }>();
  for (const order of starts) {
    const ball = order[before.length]!;
    const next = isLast ? null : order[before.length + 1]!;
    pairs.set(`${ball} ${next}`, { ball, next });
  }
  let best: { ball: string; stroke: Stroke } | null = null;
  for (const { ball, next } of pairs.values()) {
    const stroke = bestStroke(engine, layout, ball, next, noise);
    if (stroke && stroke.value > (best?.stroke.value ?? 0)) best = { ball, stroke };
  }
  return best;
}

/** The stroke that pots `ball` with the best chance for `next`; null if none pots it. */
export function bestStroke(
  engine: Engine,
  file: Layout,
  ball: string,
  next: string | null,
  noise: Noise,
): Stroke | null {
  const [at, cue] = [placeOf(file, ball), placeOf(file, file.strike.ball)];
  const shot = read(engine, struck(file, {}));
  if (!shot || !at || !cue) return null;
  const lines = potLines(shot.geometry.pockets, cue, at, shot.balls[0]!.radius).slice(0, POCKETS);
  let best: Stroke | null = null;
  const strokes = next === null ? LAST : SPEEDS.flatMap((v) => HEIGHTS.map((h) => [v, h] as const));
  for (const { pocket, azimuth } of lines) {
    for (const [speed, height] of strokes) {
      const tried = read(engine, struck(file, { speed, azimuth, height }));
      const aim = tried?.potAim(ball, pocket, { near: true });
      if (tried && aim && !aim.losesCueBall) {
        const stroke = played(engine, file, aim.strike, {
          ball,
          pocket,
          next,
          noise,
          margin: aim.margin,
        });
        if (stroke && stroke.value > (best?.value ?? 0)) best = stroke;
      }
      tried?.free();
    }
  }
  shot.free();
  return best;
}

interface Wanted {
  readonly ball: string;
  readonly pocket: PocketName;
  readonly next: string | null;
  readonly noise: Noise;
  readonly margin: number;
}

/** What an exact strike leaves, and its value. */
function played(
  engine: Engine,
  file: Layout,
  strike: Strike,
  { pocket, next, noise, margin }: Wanted,
): Stroke | null {
  const layout = struck(file, strike);
  const shot = read(engine, layout);
  if (!shot) return null;
  const trace = shot.simulate();
  const left = after(layout, trace);
  trace.free();
  const cue = left && placeOf(left, left.strike.ball);
  const ball = left && next !== null ? placeOf(left, next) : null;
  const follows = next === null ? 1 : cue && ball ? estimate(shot, cue, ball, noise) : 0;
  shot.free();
  return {
    pocket,
    strike,
    file: layout,
    next: left,
    value: within(margin, noise.azimuth) * follows,
  };
}

/** A stroke with its counted chance, and where the cue ball stops when the ball falls. */
function legOf(engine: Engine, ball: string, stroke: Stroke, noise: Noise): Leg {
  const shot = engine.shot(stroke.file);
  const { balls, pocket, final_position: ends } = shot.vary(noise, VARIANTS);
  const index = shot.balls.findIndex(({ id }) => id === ball);
  const wanted = shot.geometry.pockets.findIndex(({ name }) => name === stroke.pocket);
  const cue = shot.struck!;
  const stops: Point[] = [];
  for (let k = 0; k < VARIANTS; k++) {
    if (pocket[k * balls + index] !== wanted || pocket[k * balls + cue]! >= 0) continue;
    const at = 3 * (k * balls + cue);
    stops.push([ends[at]!, ends[at + 1]!]);
  }
  shot.free();
  const { file, strike } = stroke;
  return {
    ball,
    pocket: stroke.pocket,
    strike,
    shot: file,
    chance: stops.length / VARIANTS,
    stops,
  };
}

/** Whether all balls of the plan fall in one run with errors. */
function isRunOut(
  engine: Engine,
  legs: readonly Leg[],
  order: readonly string[],
  noise: Noise,
  run: number,
): boolean {
  let file: Layout = legs[0]!.shot;
  for (const [k, ball] of order.entries()) {
    const stroke = k === 0 ? legs[0]! : bestStroke(engine, file, ball, order[k + 1] ?? null, noise);
    if (!stroke) return false;
    const left = drawn(engine, struck(file, stroke.strike), noise, run * order.length + k);
    if (!left || placeOf(left, ball)) return false;
    file = left;
  }
  return true;
}

/** The layout after a variant of a shot; null if the cue ball is lost, or the variant cannot be played. */
function drawn(engine: Engine, file: Layout, noise: Noise, index: number): Layout | null {
  const shot = read(engine, file);
  if (!shot) return null;
  try {
    const varied = shot.variant(noise, index);
    const trace = varied.simulate();
    const left = after(file, trace);
    trace.free();
    varied.free();
    return left;
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  } finally {
    shot.free();
  }
}
