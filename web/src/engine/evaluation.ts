/** The chances of a strike that a player intends. The data is that of Python's `Evaluation.to_dict`, key by key. */

import { json, known, numbers, text, whole } from "./arguments.ts";
import { onTables, type TableOptions } from "./drawn-tables.ts";
import { refuse } from "./error.ts";
import { checked } from "./handle.ts";
import { noiseJson } from "./noise.ts";
import * as wasm from "./pkg/carom_wasm.js";
import type { Chance, Perception } from "./player.ts";
import type { Call, Frame } from "./rules.ts";
import type { Geometry, Noise, PocketName, Point } from "./types.ts";

export interface EvaluateOptions extends TableOptions {
  /** Of the random numbers, a whole number. Default 0. */
  readonly seed?: number;
  /** Default: the player sees the balls exactly. */
  readonly perception?: Perception;
  /**
   * Half the width of the watched interval at which counting stops, checked after every 1024 variants.
   * Default: all variants are played.
   */
  readonly precision?: number;
  /**
   * The watched chance: a ball's id, a ball and a pocket, `"scratch"` or `"legal"`. Default: all that are
   * counted.
   */
  readonly watch?: string | readonly [ball: string, pocket: PocketName];
  /** The game in which the shot is played. The shot must be the one that `Frame.shot` gives. */
  readonly frame?: Frame;
  /** What the player announces to the frame. */
  readonly call?: Call;
  /** Confidence level of the intervals, in (0, 1). Default 0.95. */
  readonly level?: number;
}

/** A place of which a coordinate is null if no variant has one. */
type Place = Point | readonly [null, null];

/** How often variants had each result. Rows have the order of `Evaluation.balls`, columns that of `pockets`. */
export interface ResultCounts {
  /** Number of variants. */
  readonly n: number;
  /** Number of variants that could not be played, as with an obstructed cue. */
  readonly failed: number;
  /** In how many variants each ball fell into each pocket. */
  readonly potted: readonly (readonly number[])[];
  /** In how many variants each ball left the table. */
  readonly off_table: readonly number[];
  /** Number of legal variants, and of those after which the turn is kept; null without a frame. */
  readonly legal: number | null;
  readonly turn_kept: number | null;
}

/** The results of the variants of a strike. */
export interface Evaluation extends ResultCounts {
  /** The counts on each drawn table; empty without a posterior, or if it leaves nothing unknown. */
  readonly by_table: readonly ResultCounts[];
  /** Number of tables on which the variants were played. */
  readonly tables: number;
  readonly seed: number;
  readonly level: number;
  readonly balls: readonly string[];
  readonly pockets: readonly PocketName[];
  /** Index of the cue ball in `balls`. */
  readonly cue_ball: number;
  /** The error of the first variant that could not be played. */
  readonly first_failure: string | null;
  /** In how many variants each ball came to rest on the table, and where: mean (m) and covariance (m²). */
  readonly at_rest: readonly number[];
  readonly end_mean: readonly Place[];
  readonly end_covariance: readonly (readonly (readonly [number | null, number | null])[])[];
  /** The chances of all results that occurred, by name, such as `"9 into top-right"`. */
  readonly chances: Readonly<Record<string, Chance>>;
}

/** What the engine counts. */
type Counted = Omit<Evaluation, "tables" | "seed" | "level" | "balls" | "pockets" | "chances">;

/** The cue ball's places of all variants take 16 bytes each; WebAssembly has 4 GiB. */
const MOST_VARIANTS = 1e7;
const LEVEL = 0.95;

const OPTIONS = {
  seed: true,
  perception: true,
  precision: true,
  watch: true,
  frame: true,
  call: true,
  posterior: true,
  draws: true,
  level: true,
} as const;
const CALL = { kind: true, ball: true, into: true } as const;

/**
 * Plays variants of the strike of a shot and counts their results.
 *
 * @param frameOf The object of a frame in WebAssembly's memory.
 * @throws CaromError as `Shot.evaluate`.
 */
export function evaluate(
  shot: wasm.Shot,
  frameOf: (frame: Frame) => wasm.Frame,
  noise: Noise,
  n: number,
  options: EvaluateOptions,
): Evaluation {
  const given = known("options", options, OPTIONS);
  const { seed = 0, level = LEVEL, perception, precision, watch, frame, call } = given;
  const variants = whole("n", n, MOST_VARIANTS);
  if (variants === 0n) refuse("out-of-range", "n", "0 variants tell nothing", "give at least 1");
  const [start, most] = [whole("seed", seed), numbers("", { level }, ["level"])[0]!];
  const half = precision === undefined ? undefined : numbers("", { precision }, ["precision"])[0];
  if (watch !== undefined && precision === undefined) {
    refuse("conflict", "watch", "it has no effect without precision", "give precision too");
  }
  if (call !== undefined && frame === undefined) {
    refuse("missing", "call", "a call needs a game", "give frame too");
  }
  const seen = perception === undefined ? undefined : json(perception, "perception");
  const errors = noiseJson(noise);
  const { planned, drawn } = onTables(shot, given, Number(variants), seed);
  const question = checked(() => new wasm.Question(errors, seen, start, variants, most, half));
  try {
    if (watch !== undefined) {
      const [name, pocket] = typeof watch === "string" ? [watch] : watch;
      question.watch(text("watch", name), pocket);
    }
    if (frame !== undefined) {
      const position = frameOf(frame);
      if (given.posterior !== undefined && !planned.equals(shot)) {
        refuse(
          "mismatch",
          "frame",
          "its table and physics are not those of the posterior",
          "make it with the table and the physics of the posterior",
        );
      }
      const { kind = "nothing", ball, into } = call === undefined ? {} : known("call", call, CALL);
      checked(() => {
        question.referee(position, kind, ball, into);
      });
    }
    for (const one of drawn) question.push(one);
    const counted = JSON.parse(checked(() => planned.evaluate(question))) as Counted;
    return read(counted, planned, seed, level);
  } finally {
    question.free();
    for (const one of drawn) one.free();
    if (planned !== shot) planned.free();
  }
}

function read(counted: Counted, shot: wasm.Shot, seed: number, level: number): Evaluation {
  const geometry = JSON.parse(shot.geometry()) as Pick<Geometry, "pockets">;
  const [balls, pockets] = [shot.ids(), geometry.pockets.map(({ name }) => name)];
  const tables = Math.max(counted.by_table.length, 1);
  const named = chances(counted, balls, pockets, level);
  return { ...counted, tables, seed, level, balls, pockets, chances: named };
}

/** The chance of a result, from the number of variants in which it occurred. */
export function chanceOf(
  all: Pick<Evaluation, "by_table"> & ResultCounts,
  met: (counts: ResultCounts) => number,
  level: number,
): Chance {
  const rows = all.by_table.length > 0 ? all.by_table : [all];
  const pairs = Float64Array.from(rows.flatMap((counts) => [met(counts), counts.n]));
  return JSON.parse(checked(() => wasm.chanceOf(pairs, level))) as Chance;
}

/** The chances of all results that occurred; that of a scratch in any case. */
function chances(
  all: Counted,
  balls: readonly string[],
  pockets: readonly PocketName[],
  level: number,
): Record<string, Chance> {
  const { cue_ball } = all;
  const chance = (met: (counts: ResultCounts) => number) => chanceOf(all, met, level);
  const falls = ({ potted }: ResultCounts, row: number) => potted[row]!.reduce((a, b) => a + b, 0);
  const named: Record<string, Chance> = {};
  balls.forEach((ball, row) => {
    if (row === cue_ball) return;
    if (falls(all, row) > 0) named[`${ball} falls`] = chance((counts) => falls(counts, row));
    pockets.forEach((pocket, column) => {
      if (!all.potted[row]![column]) return;
      named[`${ball} into ${pocket}`] = chance((counts) => counts.potted[row]![column]!);
    });
  });
  if (pockets.length > 0) named.scratch = chance((counts) => falls(counts, cue_ball));
  balls.forEach((ball, row) => {
    if (!all.off_table[row]) return;
    named[`${ball} off the table`] = chance((counts) => counts.off_table[row]!);
  });
  if (all.legal !== null) {
    named.legal = chance((counts) => counts.legal ?? 0);
    named["turn kept"] = chance((counts) => counts.turn_kept ?? 0);
  }
  if (all.failed > 0) named["not to be played"] = chance((counts) => counts.failed);
  return named;
}
