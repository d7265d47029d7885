/** The strikes with which a player of each level does best in one shot of a drill. */

import {
  CaromError,
  type Engine,
  type Noise,
  type Shot,
  type Strike,
} from "../../src/engine/index.ts";
import type { Condition } from "../../src/app/train/drills/index.ts";
import { judge, mostPoints } from "../../src/app/train/drill-judge.ts";
import type { Setting } from "../../src/app/train/drill-layout.ts";
import { layoutOf } from "../../src/app/train/drill-layout.ts";
import { clothOf } from "../../src/app/train/drill-places.ts";
import { randomOf } from "../../src/app/train/puzzle/seeded-random.ts";

/** Cue speeds that are tried, m/s, and heights and sides of the tip, in ball radii. */
const SPEEDS = Array.from({ length: 23 }, (_, k) => 0.6 * 1.1 ** k);
const HEIGHTS = [-0.5, -0.35, -0.2, -0.08, 0, 0.15, 0.3, 0.45];
const SIDES = [-0.35, 0, 0.35];
/** The same where the direction must be searched too. */
const FEW_SPEEDS = SPEEDS.filter((_, k) => k % 2 === 0);
const FEW_HEIGHTS = [-0.35, 0, 0.3];
/** Speeds of a break, m/s. */
const BREAKS = [7, 8, 9, 10, 11, 12];

/** Strikes that are kept after each round, and the variants with which the next one judges them. */
const ROUNDS = [
  { kept: 150, variants: 1 },
  { kept: 40, variants: 12 },
  { kept: 8, variants: 60 },
] as const;

/** Small changes that are tried of the best strike, and variants of each. */
const CHANGES = 20;
const CHANGE_VARIANTS = 60;

/** Variants that choose between the strikes of the levels. */
const CHOICE_VARIANTS = 200;

/** Mean points of an attempt with a strike and a noise, over the variants of a seed. */
export function worth(
  engine: Engine,
  setting: Setting,
  strike: Strike,
  noise: Noise,
  variants: number,
  seed: number,
): number {
  const shares = chancesOf(engine, setting, strike, noise, variants, seed);
  return shares.reduce((sum, share, points) => sum + share * points, 0);
}

/** The share of variants with 0, 1, 2 … points. */
export function chancesOf(
  engine: Engine,
  setting: Setting,
  strike: Strike,
  noise: Noise,
  variants: number,
  seed: number,
): number[] {
  const shares = Array.from({ length: mostPoints(setting.step) + 1 }, () => 0);
  // Every attempt of a break has a rack of its own.
  const racks = setting.step.rack ? variants : 1;
  for (let rack = 0; rack < racks; rack += 1) {
    const first = engine.shot(layoutOf(engine, { ...setting, attempt: rack }));
    const shot = first.withStrike(strike);
    for (let k = rack; k < variants; k += racks) {
      shares[pointsOf(engine, setting, () => shot.variant(noise, k, { seed }))]! += 1 / variants;
    }
    shot.free();
    first.free();
  }
  return shares;
}

/** Points of a shot; 0 if it cannot be played, as with a miscue. */
function pointsOf(engine: Engine, { drill, step }: Setting, variant: () => Shot): number {
  let shot: Shot | null = null;
  try {
    shot = variant();
    const trace = shot.simulate();
    const { points } = judge(clothOf(engine, drill.table), step, trace);
    trace.free();
    return points;
  } catch (error) {
    if (error instanceof CaromError) return 0;
    throw error;
  } finally {
    shot?.free();
  }
}

const EXACT: Noise = { speed: 0, azimuth: 0, elevation: 0, side_m: 0, height_m: 0 };

/**
 * The best strikes found for a step, the best first, judged with the errors `noise`.
 */
export function strikesOf(engine: Engine, setting: Setting, noise: Noise): readonly Strike[] {
  const random = randomOf(1);
  let strikes = candidates(engine, setting);
  for (const { kept, variants } of ROUNDS) {
    const errors = variants === 1 ? EXACT : noise;
    strikes = strikes
      .map((strike) => ({
        strike,
        // Strikes of equal worth in a random order, so that all kinds are kept.
        worth: worth(engine, setting, strike, errors, variants, 7) + 1e-6 * random(),
      }))
      .filter(({ worth }) => worth > 1e-3)
      .sort((a, b) => b.worth - a.worth)
      .slice(0, kept)
      .map(({ strike }) => strike);
  }
  return strikes;
}

/** The best of `strikes` for a noise, improved by small changes. */
export function refined(
  engine: Engine,
  setting: Setting,
  strikes: readonly Strike[],
  noise: Noise,
): Strike | null {
  const random = randomOf(2);
  let best: Strike | null = null;
  let most = -1;
  const offer = (strike: Strike) => {
    try {
      const found = worth(engine, setting, strike, noise, CHANGE_VARIANTS, 11);
      if (found > most) [best, most] = [strike, found];
    } catch {
      // The tip would miss the ball.
    }
  };
  for (const strike of strikes) offer(strike);
  const around = (): Strike | null =>
    best && {
      ...best,
      speed: best.speed * (1 + 0.12 * (random() - 0.5)),
      azimuth: best.azimuth + 0.012 * (random() - 0.5),
      height: best.height + 0.1 * (random() - 0.5),
    };
  for (let k = 0; k < CHANGES; k += 1) {
    const changed = around();
    if (changed) offer(changed);
  }
  return best;
}

/** The best of `strikes` for a noise, with variants that took no part in finding them. */
export function bestOf(
  engine: Engine,
  setting: Setting,
  strikes: readonly Strike[],
  noise: Noise,
): Strike | null {
  const valued = strikes.map((strike) => ({
    strike,
    worth: worth(engine, setting, strike, noise, CHOICE_VARIANTS, 5),
  }));
  valued.sort((a, b) => b.worth - a.worth);
  return valued[0]?.strike ?? null;
}

function candidates(engine: Engine, setting: Setting): Strike[] {
  const shot = engine.shot(layoutOf(engine, setting));
  try {
    if (setting.step.rack) {
      const { strike } = shot;
      return BREAKS.flatMap((speed) => HEIGHTS.map((height) => ({ ...strike!, speed, height })));
    }
    return directions(shot, setting);
  } finally {
    shot.free();
  }
}

/** Every speed and tip with each of the directions that can do it. */
function directions(shot: Shot, { drill, step }: Setting): Strike[] {
  const found: Strike[] = [];
  const needs: readonly Condition[] = step.goal.kind === "shot" ? step.goal.needs : [];
  const pot = needs.find((need) => need.kind === "pot");
  const banks = needs.some((need) => need.kind === "cushions" && need.ball !== drill.cue);
  const kicks = needs.some((need) => need.kind === "kick" || need.kind === "carom");
  const met = banks ? pot?.ball : needs.find((need) => need.kind === "first")?.ball;
  const window = met !== undefined && !kicks ? windowOf(shot, met) : null;
  const alone = shot.balls.length === 1;
  const turns = alone ? [Math.PI / 2] : grid(window);
  // Side matters only for where the cue ball goes.
  const sides = alone || needs.every(({ kind }) => kind === "pot") ? [0] : SIDES;
  const solves = pot !== undefined && !banks;
  for (const speed of solves || alone ? SPEEDS : FEW_SPEEDS) {
    for (const height of solves || alone ? HEIGHTS : FEW_HEIGHTS) {
      for (const side of sides) {
        if (Math.hypot(height, side) > shot.miscueLimit) continue;
        const { azimuth } = shot.strike!;
        const strike = { speed, height, side, azimuth };
        const aimed = shot.withStrike(strike);
        if (solves) {
          const aim = aimed.potAim(pot.ball, pot.pocket!);
          if (aim) found.push(aim.strike);
        } else {
          for (const turn of turns) found.push({ ...aimed.strike!, azimuth: turn });
        }
        aimed.free();
      }
    }
  }
  return found;
}

/** Directions (rad): the whole circle, or those of a window. */
function grid(window: readonly [number, number] | null): number[] {
  const [from, to] = window ?? [0, 2 * Math.PI];
  const count = window ? 60 : 720;
  return Array.from({ length: count }, (_, k) => from + ((to - from) * (k + 0.5)) / count);
}

/** Directions in which the cue ball meets a ball, if nothing is in the way. */
function windowOf({ balls, struck }: Shot, id: string): readonly [number, number] {
  const from = balls[struck!]!;
  const to = balls.find((ball) => ball.id === id)!;
  const [x, y] = [to.position[0] - from.position[0], to.position[1] - from.position[1]];
  const middle = Math.atan2(y, x);
  const half = Math.asin((from.radius + to.radius) / Math.hypot(x, y));
  return [middle - half, middle + half];
}
