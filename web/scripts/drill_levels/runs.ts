/** Attempts of several shots, played by the engine's player. */

import { CaromError, type Engine, type Noise, type ShotFile } from "../../src/engine/index.ts";
import type { PlannedPlay, Trace } from "../../src/engine/index.ts";
import type { RunGoal } from "../../src/app/train/drills/index.ts";
import { judge, restOf } from "../../src/app/train/drill-judge.ts";
import { layoutOf, type Setting } from "../../src/app/train/drill-layout.ts";
import { clothOf } from "../../src/app/train/drill-places.ts";

/** Simulated shots of a decision. */
const SIMULATIONS = 2000;

/** A drill's step that is a run. */
export type Run = Setting & { readonly step: { readonly goal: RunGoal } };

/** The share of attempts with 0, 1, 2 … balls. */
export function runChances(engine: Engine, run: Run, noise: Noise, attempts: number): number[] {
  const shares = Array.from({ length: run.step.goal.balls.length + 1 }, () => 0);
  for (let seed = 0; seed < attempts; seed += 1) {
    shares[attempt(engine, run, noise, seed)]! += 1 / attempts;
  }
  return shares;
}

/** Balls of one attempt. The cue ball begins where the drill sets it. */
function attempt(engine: Engine, run: Run, noise: Noise, seed: number): number {
  const { drill, step } = run;
  const { strike, ...start } = layoutOf(engine, run);
  let file: ShotFile = start;
  let left: readonly string[] = step.goal.balls;
  for (let shots = 0; ; shots += 1) {
    const play = decision(engine, run, file, left, noise, seed);
    const intended = play && { ball: strike.ball, ...angles(play) };
    const trace =
      intended && played(engine, { ...file, strike: intended }, noise, seed + 1000 * shots);
    if (!trace) return step.goal.balls.length - left.length;
    const verdict = judge(clothOf(engine, drill.table), step, trace, left);
    const gone = trace.outcome.pocketed.map(([ball]) => ball);
    const balls = file.balls
      .filter(({ id }) => !gone.includes(id))
      .map(({ id }) => ({ id, position: restOf(trace, id)! }));
    trace.free();
    if (verdict.fault || verdict.left.length === 0) return verdict.points;
    file = { ...file, balls };
    left = verdict.left;
  }
}

const angles = ({ strike }: PlannedPlay) => ({
  speed: strike.speed,
  azimuth_deg: (strike.azimuth * 180) / Math.PI,
  elevation_deg: (strike.elevation * 180) / Math.PI,
  side: strike.side,
  height: strike.height,
});

/** A variant of a shot; null if its strike cannot be played. */
function played(engine: Engine, file: ShotFile, noise: Noise, seed: number): Trace | null {
  try {
    const shot = engine.shot(file);
    const variant = shot.variant(noise, 0, { seed });
    const trace = variant.simulate();
    shot.free();
    return trace;
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}

/**
 * The player's shot, by the rules of snooker for a sequence, else of nine-ball. Where the order is free,
 * the balls are numbered in every order, and the best decision counts.
 */
function decision(
  engine: Engine,
  { drill, step }: Run,
  file: ShotFile,
  left: readonly string[],
  noise: Noise,
  seed: number,
): PlannedPlay | null {
  const { order, balls } = step.goal;
  if (order === "sequence") return chosen(engine, "snooker", file, noise, seed).play;
  const orders =
    order === "eight" && left.length > 2
      ? left.slice(0, -1).map((first) => [first, ...left.filter((ball) => ball !== first)])
      : [left];
  const numbers = ["7", "8", "9"].slice(3 - left.length);
  const decisions = orders.map((list) => {
    const renamed = file.balls.map((ball) => ({
      ...ball,
      id: ball.id === drill.cue ? ball.id : numbers[list.indexOf(ball.id)]!,
    }));
    return chosen(engine, "nine-ball", { ...file, balls: renamed }, noise, seed);
  });
  if (balls.length !== 3) throw new Error(`${drill.id}: a run without a sequence has three balls`);
  decisions.sort((a, b) => (b.win_chance ?? 0) - (a.win_chance ?? 0));
  return decisions[0]?.play ?? null;
}

function chosen(engine: Engine, game: string, file: ShotFile, noise: Noise, seed: number) {
  const shot = engine.shot(file);
  const frame = engine.frameOf(game, shot);
  const player = engine.player({ noise, simulations: SIMULATIONS, seed });
  try {
    return player.choose(frame);
  } finally {
    player.free();
    frame.free();
    shot.free();
  }
}
