/** A shot on the tables that agree with what was learned about one. */

import { object, whole } from "./arguments.ts";
import { CaromError, moved, refuse } from "./error.ts";
import { checked } from "./handle.ts";
import * as wasm from "./pkg/carom_wasm.js";
import type { ShotFile } from "./types.ts";

/** A table that may be the true one, as a shot file has it. */
export interface PossibleTable {
  readonly table: ShotFile["table"];
  readonly physics: NonNullable<ShotFile["physics"]>;
}

/** What is known about a table: the file that `carom learn table` writes, parsed. */
export interface TablePosterior extends PossibleTable {
  /** Tables that may be the true one, equally likely. */
  readonly draws: readonly PossibleTable[];
}

export interface TableOptions {
  /**
   * What is known about the table. The shot is planned on the learned table in place of its own, and its
   * variants are played in turn on tables that may be the true one.
   */
  readonly posterior?: TablePosterior;
  /** Number of these tables, from 2 to 1000. Default 32. */
  readonly draws?: number;
}

/** A shot on the learned table and on drawn ones. Without a posterior it is the shot itself. */
interface PlannedShot {
  readonly planned: wasm.Shot;
  readonly drawn: readonly wasm.Shot[];
}

const USUAL_DRAWS = 32;
const MOST_DRAWS = 1000;
/** Balls that overlap each other or a cushion by at most this on a drawn table are moved apart, m. */
const REPAIRED = 0.005;
const NO_ROOM: readonly string[] = ["overlap", "in-cushion"];
const REMEDY = "write the file with carom learn table, or with Posterior.save of Python";

/**
 * The shot on the learned table, and on the drawn ones. Those on which balls overlap by more than 5 mm are
 * left out; at least half of the tables, and two, must remain.
 *
 * @param n Number of variants, of which every table needs one.
 * @param seed Number of the question: other questions take other tables of the list, around it.
 * @throws CaromError if the posterior is none or has too few tables, or balls have no room on most of them.
 */
export function onTables(
  shot: wasm.Shot,
  { posterior, draws = USUAL_DRAWS }: TableOptions,
  n: number,
  seed: number,
): PlannedShot {
  const count = Number(whole("draws", draws, MOST_DRAWS));
  if (count < 2) refuse("out-of-range", "draws", `${count} is out of range`, "give 2 to 1000");
  if (posterior === undefined) return { planned: shot, drawn: [] };
  const tables = tablesOf(posterior, count, seed);
  if (n < count) {
    const fault = `${n} variants are fewer than ${count} drawn tables`;
    refuse("out-of-range", "n", fault, "give more variants, or fewer draws");
  }
  const planned = onto(shot, posterior, "posterior", shot.hasDefaultElevation());
  const drawn: wasm.Shot[] = [];
  let refused: CaromError | undefined;
  try {
    tables.forEach((table, index) => {
      try {
        drawn.push(onto(shot, table, `draws[${index}]`, true));
      } catch (error) {
        if (!(error instanceof CaromError) || !NO_ROOM.includes(error.kind)) throw error;
        refused ??= error;
      }
    });
    // A few draws are far out; if most have no room, the posterior is of another table.
    if (refused && drawn.length < Math.max(2, count / 2)) throw refused;
  } catch (error) {
    for (const one of [planned, ...drawn]) one.free();
    throw error;
  }
  return { planned, drawn };
}

/** @throws CaromError if the posterior is none, or its tables are fewer than `count`. */
export function checkTables({ posterior, draws = USUAL_DRAWS }: TableOptions): void {
  if (posterior !== undefined) tablesOf(posterior, Number(whole("draws", draws, MOST_DRAWS)), 0);
}

/** The tables from number seed·count on, around the list. */
function tablesOf(posterior: TablePosterior, count: number, seed: number): PossibleTable[] {
  const given = object("posterior", posterior) as Partial<TablePosterior>;
  for (const key of ["table", "physics", "draws"] as const) {
    if (given[key] === undefined) {
      refuse("missing", `posterior.${key}`, "the key is missing", REMEDY);
    }
  }
  const { draws } = posterior;
  if (!Array.isArray(draws)) {
    refuse("wrong-type", "posterior.draws", "it is not a list of tables", REMEDY);
  }
  const size = draws.length;
  if (count > size) {
    refuse(
      "out-of-range",
      "draws",
      `${count} tables are more than the ${size} of the file`,
      "give fewer draws, or write the file with Posterior.save(path, draws=...) of Python",
    );
  }
  const first = Number((BigInt(seed) * BigInt(count)) % BigInt(size));
  return Array.from({ length: count }, (_, index) => {
    const place = (first + index) % size;
    const one = object(`posterior.draws[${place}]`, draws[place]) as Partial<PossibleTable>;
    if (one.table === undefined || one.physics === undefined) {
      const fault = "it has no table and physics";
      refuse("wrong-type", `posterior.draws[${place}]`, fault, REMEDY);
    }
    return one as PossibleTable;
  });
}

/** The shot with another table and physics, at the default elevation there or at its own. */
function onto(
  shot: wasm.Shot,
  { table, physics }: PossibleTable,
  place: string,
  atDefault: boolean,
): wasm.Shot {
  const file = JSON.parse(shot.toJson(!atDefault, false)) as ShotFile;
  const { strike } = file;
  if (strike && atDefault) {
    for (const key of ["elevation", "elevation_deg"]) Reflect.deleteProperty(strike, key);
  }
  try {
    return checked(() => {
      const lying = JSON.stringify({ table, physics, balls: file.balls });
      const { balls } = JSON.parse(wasm.repairedFile(lying, REPAIRED)) as ShotFile;
      return wasm.Shot.fromJson(JSON.stringify({ ...file, table, physics, balls }));
    });
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    throw moved(error, `${place}: ${error.place}`);
  }
}
