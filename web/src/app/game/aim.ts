/** The shot with which a player begins to aim. */

import { CaromError, type BallEntry, type Engine, type Point } from "../../engine/index.ts";
import { azimuthTo } from "../common/angles.ts";
import type { AimedShot } from "../document/document.ts";
import type { Game } from "../document/game.ts";
import type { Progress } from "./progress.ts";
import { freePlace, handOf, layoutOf } from "./referee.ts";

/** A speed (m/s) to begin with. */
const USUAL_SPEED = 2;

/** The layout as it lies, aimed at a ball that is on; a break as one usually breaks. */
export function firstAim(engine: Engine, game: Game, progress: Progress): AimedShot {
  const { start, frame } = progress;
  const { request } = frame.state;
  const balls = withHand(progress);
  const cue = request.kind === "shot" ? request.cue_ball : start.balls[0]!.id;
  const struck = balls.find(({ id }) => id === cue) ?? balls[0]!;
  const opening = isBreak(progress) ? usualBreak(engine, game) : null;
  if (opening && sameBalls(opening.balls, balls))
    return { ...start, balls, strike: opening.strike };
  const on = request.kind === "shot" ? request.on : [];
  const target = nearest(struck, balls, on) ?? struck;
  const azimuth_deg = azimuthTo(flat(struck), flat(target));
  return { ...start, balls, strike: { ball: struck.id, speed: USUAL_SPEED, azimuth_deg } };
}

/** Whether the balls lie as they were racked. */
function isBreak({ steps }: Progress): boolean {
  return steps.every(({ move }) => !("play" in move)) || (steps.at(-1)?.ruling.racked ?? false);
}

function usualBreak(engine: Engine, { setup }: Game): AimedShot | null {
  const { table, seed = 0 } = setup.options;
  if (setup.from || typeof table === "object" || !engine.games.includes(setup.rules)) return null;
  try {
    const shot = engine.breakShot(setup.rules, { seed, ...(table !== undefined && { table }) });
    const { file } = shot;
    shot.free();
    return file.strike ? { ...file, strike: file.strike } : null;
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}

/** Whether the struck ball and the number of balls agree: another rack is broken like the first. */
function sameBalls(a: readonly BallEntry[], b: readonly BallEntry[]): boolean {
  const [first, second] = [a[0], b[0]];
  if (!first || !second || a.length !== b.length) return false;
  return first.id === second.id && String(flat(first)) === String(flat(second));
}

/** The layout, with a cue ball in hand that is down put where there is room. */
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

/** The nearest ball to aim at: of those that are on, if any. */
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
