/** The shot from which a player starts to aim. */

import { CaromError, type BallEntry, type Engine, type Point } from "../../engine/index.ts";
import { azimuthTo } from "../common/angles.ts";
import type { AimedShot } from "../document/document.ts";
import { type Game, seedOf } from "../document/stored-game.ts";
import type { Progress } from "./game-progress.ts";
import { freePlace, handOf, layoutOf } from "./referee.ts";

/** Cue speed (m/s) of that shot, unless it is a break. */
const FIRST_SPEED = 2;

/** The present layout, aimed at the nearest ball on; for a break, the usual break shot. */
export function firstAim(engine: Engine, game: Game, progress: Progress): AimedShot {
  const { start, frame } = progress;
  const { request } = frame.state;
  const balls = withHand(progress);
  const cue = request.kind === "shot" ? request.cue_ball : start.balls[0]!.id;
  const struck = balls.find(({ id }) => id === cue) ?? balls[0]!;
  const opening = isBreak(progress) ? standardBreak(engine, game) : null;
  if (opening && sameBalls(opening.balls, balls))
    return { ...start, balls, strike: opening.strike };
  const on = request.kind === "shot" ? request.on : [];
  const target = nearest(struck, balls, on) ?? struck;
  const azimuth_deg = azimuthTo(flat(struck), flat(target));
  return { ...start, balls, strike: { ball: struck.id, speed: FIRST_SPEED, azimuth_deg } };
}

/** Whether the next shot breaks a rack. */
function isBreak({ steps }: Progress): boolean {
  return steps.every(({ move }) => !("play" in move)) || (steps.at(-1)?.ruling.racked ?? false);
}

function standardBreak(engine: Engine, { setup }: Game): AimedShot | null {
  const { table } = setup.options;
  const seed = seedOf(setup.options);
  if (setup.from || typeof table === "object") return null;
  try {
    const shot = engine.breakShot(setup.rules, { seed, ...(table !== undefined && { table }) });
    const file = shot.source;
    shot.free();
    return file.strike ? { ...file, strike: file.strike } : null;
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}

/** Whether cue ball and number of balls agree, so that the break shot fits this rack too. */
function sameBalls(a: readonly BallEntry[], b: readonly BallEntry[]): boolean {
  const [first, second] = [a[0], b[0]];
  if (!first || !second || a.length !== b.length) return false;
  return first.id === second.id && String(flat(first)) === String(flat(second));
}

/** The layout; a cue ball in hand that is off the table is placed where there is room. */
function withHand(progress: Progress): BallEntry[] {
  const balls = layoutOf(progress);
  const hand = handOf(progress);
  const entry = progress.start.balls.find(({ id }) => id === hand);
  if (!entry || balls.some(({ id }) => id === hand)) return balls;
  const position = freePlace(progress, entry.id);
  if (!position) return balls;
  const order = new Map(progress.start.balls.map(({ id }, index) => [id, index]));
  return [...balls, { ...entry, position }].sort((a, b) => order.get(a.id)! - order.get(b.id)!);
}

/** The nearest of the balls on; the nearest ball if none is on. */
function nearest(
  from: BallEntry,
  balls: readonly BallEntry[],
  on: readonly string[],
): BallEntry | undefined {
  const others = balls.filter((ball) => ball !== from);
  const allowed = others.filter(({ id }) => on.includes(id));
  const distance = ({ position: [x, y] }: BallEntry) =>
    Math.hypot(x - from.position[0], y - from.position[1]);
  return (allowed.length > 0 ? allowed : others).sort((a, b) => distance(a) - distance(b))[0];
}

function flat({ position: [x, y] }: BallEntry): Point {
  return [x, y];
}
