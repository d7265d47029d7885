/**
 * The plays of an analysis, ranked again on the tables that may be the true one: with the same numbers as in
 * Python, whose `player/on_tables.py` says why.
 */

import { checkTables, onTables, type TableOptions } from "./drawn-tables.ts";
import { refuse } from "./error.ts";
import { chanceOf, evaluate, type Evaluation } from "./evaluation.ts";
import type * as wasm from "./pkg/carom_wasm.js";
import type { Analysis, Chance, Perception, Recommendation } from "./player.ts";
import type { Frame } from "./rules.ts";
import type { Noise, Shot } from "./types.ts";

/** What the counts need. */
export interface Counting {
  /** The object of a frame, or of a shot, in WebAssembly's memory. */
  readonly frame: (frame: Frame) => wasm.Frame;
  readonly shot: (shot: Shot) => wasm.Shot;
  readonly tables: TableOptions;
  readonly noise: Noise;
  readonly perception: Perception | undefined;
  readonly seed: number;
}

/** Plays of a search that are ranked again, if no more are asked for. */
export const MOST_RANKED = 8;
/** Variants of a play in either count, if there are not more tables. */
const VARIANTS = 1024;
/** The seeds of the two counts are that of the search plus these numbers. */
const RANKING = 0x5241_4e4b;
const STATED = 0x5354_4154;
const LEVEL = 0.95;
/** Width of half a 95 % interval in standard errors. */
const HALF_WIDTH = 1.959964;

/**
 * Rejects what `rankedOnTables` would reject, before a search is spent.
 *
 * @throws CaromError if the posterior is none, or the table of the frame is not the learned one.
 */
export function checkTable(frame: wasm.Frame, tables: TableOptions): void {
  checkTables(tables);
  const base = frame.base();
  try {
    const { planned, drawn } = onTables(base, tables, Math.max(VARIANTS, tables.draws ?? 0), 0);
    const isLearned = planned.equals(base);
    for (const one of drawn) one.free();
    if (planned !== base) planned.free();
    if (isLearned) return;
  } finally {
    base.free();
  }
  refuse(
    "mismatch",
    "frame",
    "its table and physics are not those of the posterior",
    "make it with the table and the physics of the posterior",
  );
}

/** The `count` best plays of an analysis over drawn tables, the best first. */
export function rankedOnTables(
  analysis: Analysis,
  frame: Frame,
  counting: Counting,
  count: number,
): Analysis {
  const { tables, noise, perception, seed } = counting;
  const n = Math.max(VARIANTS, tables.draws ?? 0);
  const counted = ({ play }: Recommendation, own: number): Evaluation => {
    const shot = frame.shot(play);
    try {
      return evaluate(counting.shot(shot), counting.frame, noise, n, {
        ...tables,
        seed: seed + own,
        frame,
        ...(perception && { perception }),
        ...(play.call && { call: play.call }),
      });
    } finally {
      shot.free();
    }
  };
  const listed = analysis.plays.map((play) => {
    const found = withBothValues(play, analysis.plays);
    return { play: found, win: win(found, keptIn(counted(found, RANKING))) };
  });
  listed.sort((a, b) => b.win - a.win);
  const plays = listed.slice(0, count).map(({ play }) => stated(play, counted(play, STATED)));
  const played = n * (listed.length + plays.length);
  return { ...analysis, plays, simulations: analysis.simulations + played };
}

type Valued = Recommendation & { readonly win_if_kept: number; readonly win_if_missed: number };

/** The play with a value of a kept and of a missed turn, also where no sample had one. */
function withBothValues(play: Recommendation, plays: readonly Recommendation[]): Valued {
  const other = 1 - play.win_chance;
  return {
    ...play,
    win_if_missed:
      play.win_if_missed ??
      mean(
        plays.map((one) => one.win_if_missed),
        other,
      ),
    win_if_kept:
      play.win_if_kept ??
      mean(
        plays.map((one) => one.win_if_kept),
        other,
      ),
  };
}

function mean(values: readonly (number | null)[], usual: number): number {
  const found = values.filter((value) => value !== null);
  return found.length > 0 ? found.reduce((sum, value) => sum + value, 0) / found.length : usual;
}

function keptIn(found: Evaluation): Chance {
  return chanceOf(found, (counts) => counts.turn_kept ?? 0, LEVEL);
}

function win({ win_if_kept, win_if_missed }: Valued, { probability }: Chance): number {
  return probability * win_if_kept + (1 - probability) * win_if_missed;
}

/** The play with the chances that were counted on drawn tables. */
function stated(play: Valued, found: Evaluation): Recommendation {
  const kept = keptIn(found);
  const halfWidth = (kept.high - kept.low) / 2;
  const ofTables = (Math.abs(play.win_if_kept - play.win_if_missed) * halfWidth) / HALF_WIDTH;
  const ball = found.cue_ball;
  const covariance = found.end_covariance[ball]!;
  const [xx, yy] = [covariance[0]![0], covariance[1]![1]];
  return {
    ...play,
    win_chance: win(play, kept),
    error: Math.sqrt(play.error * play.error + ofTables * ofTables),
    samples: found.n,
    kept,
    foul: chanceOf(found, (counts) => counts.n - (counts.legal ?? 0), LEVEL),
    leave: {
      count: found.at_rest[ball]!,
      mean: found.end_mean[ball]!,
      covariance,
      spread: xx === null || yy === null ? null : Math.sqrt(xx + yy),
    },
  };
}
