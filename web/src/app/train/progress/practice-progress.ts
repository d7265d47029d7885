/** What a player has practised: results of drills and puzzles, and own drills. As a file, carom-progress/1. */

import type { DrillFile } from "../../../engine/index.ts";
import { total } from "../drill-score.ts";

export const FORMAT = "carom-progress/1";

/** A drill that was played to its end. */
export interface Result {
  /** Id of the drill. */
  readonly drill: string;
  /** When it ended: ISO 8601, UTC, with milliseconds. */
  readonly ended: string;
  /** On the page's table, or at a real one. */
  readonly place: "page" | "table";
  /** Points of every attempt, as the score counts them. */
  readonly points: readonly number[];
  /** Name of the level whose errors the page's strikes had; null without errors and at a real table. */
  readonly errors: string | null;
}

/** The puzzle of one day. */
export interface PuzzleResult {
  /** "2026-11-23", UTC. */
  readonly date: string;
  /** Shots until it was solved, or so far. */
  readonly tries: number;
  readonly solved: boolean;
}

/** A puzzle at its first shot or hint. */
export interface PuzzleAttempt {
  /** Its id, such as `cut-17`. */
  readonly puzzle: string;
  /** When: as `Result.ended`. */
  readonly time: string;
  /** Whether the first shot solved it, without help. */
  readonly made: boolean;
  /** Its difficulty. */
  readonly rating: number;
}

export interface Progress {
  readonly results: readonly Result[];
  /** The puzzles of the day. */
  readonly puzzles: readonly PuzzleResult[];
  readonly attempts: readonly PuzzleAttempt[];
  /** The drills that the user has made or opened, each under a name of its own. */
  readonly drills: readonly DrillFile[];
}

export const NOTHING: Progress = { results: [], puzzles: [], attempts: [], drills: [] };

/** Largest numbers that a file may have: far beyond what a drill gives. */
const MOST_ATTEMPTS = 1000;
const MOST_POINTS = 1000;
const MOST_RATING = 10_000;
/** Longest id of a puzzle, and name of a drill. */
const LONGEST_ID = 120;

/** A progress that cannot be read. */
export class DamagedProgress extends Error {
  /** What is wrong: not JSON, another file, or a wrong value. */
  readonly fault: "json" | "format" | "value";
  /** Where the wrong value is, such as `results[3].points`; empty otherwise. */
  readonly place: string;

  constructor(fault: DamagedProgress["fault"], place = "") {
    super(`${fault} ${place}`);
    this.fault = fault;
    this.place = place;
  }
}

/** @param engine Name and version of the engine. */
export function progressToText(progress: Progress, engine: string): string {
  const { format, ...rest } = progressToData(progress);
  return `${JSON.stringify({ format, engine, ...rest })}\n`;
}

/** The progress as it is in a file. */
export function progressToData(progress: Progress): Progress & { readonly format: typeof FORMAT } {
  return { format: FORMAT, ...progress };
}

/** @throws {DamagedProgress} */
export function progressOfText(text: string): Progress {
  return progressOfData(parsed(text));
}

/** @throws {DamagedProgress} */
export function progressOfData(file: unknown): Progress {
  if (!isObject(file) || file.format !== FORMAT) throw new DamagedProgress("format");
  return {
    results: listOf(file, "results").map((entry, k) => resultOf(entry, `results[${k}]`)),
    puzzles: listOf(file, "puzzles").map((entry, k) => puzzleOf(entry, `puzzles[${k}]`)),
    // Files of earlier versions do not have them.
    attempts: optionalOf(file, "attempts").map((entry, k) => attemptOf(entry, `attempts[${k}]`)),
    drills: optionalOf(file, "drills").map((entry, k) => drillOf(entry, `drills[${k}]`)),
  };
}

/** Everything of both, without duplicates, in the order of time. */
export function merged(a: Progress, b: Progress): Progress {
  const results = new Map([...a.results, ...b.results].map((one) => [identityOf(one), one]));
  const puzzles = new Map<string, PuzzleResult>();
  for (const one of [...a.puzzles, ...b.puzzles]) {
    const other = puzzles.get(one.date);
    puzzles.set(one.date, other ? better(one, other) : one);
  }
  return {
    results: [...results.values()].sort((x, y) => compare(x.ended, y.ended)),
    puzzles: [...puzzles.values()].sort((x, y) => compare(x.date, y.date)),
    attempts: unique([...a.attempts, ...b.attempts]).sort((x, y) => compare(x.time, y.time)),
    drills: b.drills.reduce(withDrill, a.drills),
  };
}

function unique<T>(list: readonly T[]): T[] {
  return [...new Map(list.map((one) => [JSON.stringify(one), one])).values()];
}

/** The drills with another one: under a name that is free, unless the same one is there. */
export function withDrill(drills: readonly DrillFile[], drill: DrillFile): readonly DrillFile[] {
  if (sameDrill(drills, drill)) return drills;
  const base = drill.name.replace(/ \(\d+\)$/, "");
  for (let number = 1; ; number += 1) {
    const name = number === 1 ? drill.name : `${base} (${number})`;
    if (drills.every((one) => one.name !== name)) return [...drills, { ...drill, name }];
  }
}

/** The drill with the same name, up to its number, and the same contents; undefined if there is none. */
export function sameDrill(drills: readonly DrillFile[], drill: DrillFile): DrillFile | undefined {
  const text = (one: DrillFile) =>
    JSON.stringify({ ...one, name: one.name.replace(/ \(\d+\)$/, "") });
  return drills.find((one) => text(one) === text(drill));
}

/** Two results are the same one if all their values are. */
function identityOf({ drill, ended, place, points, errors }: Result): string {
  return JSON.stringify([drill, ended, place, points, errors]);
}

/** The solved one of two results of a day; of two alike the one that counts more shots, if unsolved. */
function better(a: PuzzleResult, b: PuzzleResult): PuzzleResult {
  if (a.solved !== b.solved) return a.solved ? a : b;
  const fewer = a.tries < b.tries ? a : b;
  const more = fewer === a ? b : a;
  return a.solved ? fewer : more;
}

const compare = (a: string, b: string) => (a < b ? -1 : a > b ? 1 : 0);

/** Results of a drill, the oldest first. */
export function resultsOf({ results }: Progress, drill: string): readonly Result[] {
  return results.filter((result) => result.drill === drill);
}

/** The best score of a drill; null without results. */
export function bestOf(progress: Progress, drill: string): number | null {
  const scores = resultsOf(progress, drill).map(({ points }) => total(points));
  return scores.length === 0 ? null : Math.max(...scores);
}

/** Days in a row with a solved puzzle, up to today, or up to yesterday while today's is open. */
export function streakOf({ puzzles }: Progress, today: string): number {
  const solved = new Set(puzzles.filter((one) => one.solved).map(({ date }) => date));
  let day = solved.has(today) ? today : dayBefore(today);
  let days = 0;
  for (; solved.has(day); day = dayBefore(day)) days += 1;
  return days;
}

const DAY = 86_400_000;

function dayBefore(date: string): string {
  return dayOf(new Date(Date.parse(date) - DAY));
}

/** The day of a time, in UTC: "2026-11-23". */
export function dayOf(time: Date): string {
  return time.toISOString().slice(0, 10);
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    throw new DamagedProgress("json");
  }
}

type Entries = Readonly<Record<string, unknown>>;

function isObject(value: unknown): value is Entries {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function listOf(file: Entries, key: string): readonly unknown[] {
  const list = file[key];
  if (!Array.isArray(list)) throw new DamagedProgress("value", key);
  return list;
}

function optionalOf(file: Entries, key: string): readonly unknown[] {
  return Object.hasOwn(file, key) ? listOf(file, key) : [];
}

function attemptOf(entry: unknown, place: string): PuzzleAttempt {
  const { puzzle, time, made, rating } = objectAt(entry, place);
  check(typeof puzzle === "string" && puzzle.length <= LONGEST_ID, `${place}.puzzle`);
  check(typeof time === "string" && isTime(time), `${place}.time`);
  check(typeof made === "boolean", `${place}.made`);
  check(isCount(rating, MOST_RATING), `${place}.rating`);
  return { puzzle, time, made, rating };
}

/** A drill whose name is there; the engine checks the rest when it is opened. */
function drillOf(entry: unknown, place: string): DrillFile {
  const { name, format } = objectAt(entry, place);
  check(format === "carom-drill/1", `${place}.format`);
  check(typeof name === "string" && name !== "" && name.length <= LONGEST_ID, `${place}.name`);
  return entry as DrillFile;
}

function resultOf(entry: unknown, place: string): Result {
  const { drill, ended, place: where, points, errors } = objectAt(entry, place);
  check(typeof drill === "string" && drill !== "", `${place}.drill`);
  check(typeof ended === "string" && isTime(ended), `${place}.ended`);
  check(where === "page" || where === "table", `${place}.place`);
  check(isPoints(points), `${place}.points`);
  check(errors === null || typeof errors === "string", `${place}.errors`);
  return { drill, ended, place: where, points, errors };
}

function puzzleOf(entry: unknown, place: string): PuzzleResult {
  const { date, tries, solved } = objectAt(entry, place);
  check(typeof date === "string" && isTime(`${date}T00:00:00.000Z`), `${place}.date`);
  check(isCount(tries, Number.MAX_SAFE_INTEGER), `${place}.tries`);
  check(typeof solved === "boolean", `${place}.solved`);
  return { date, tries, solved };
}

function objectAt(entry: unknown, place: string): Entries {
  check(isObject(entry), place);
  return entry;
}

function check(isRight: boolean, place: string): asserts isRight {
  if (!isRight) throw new DamagedProgress("value", place);
}

/** Whether a text is a time as `Date.toISOString` writes it. */
function isTime(text: string): boolean {
  const time = Date.parse(text);
  return !Number.isNaN(time) && new Date(time).toISOString() === text;
}

function isPoints(value: unknown): value is number[] {
  return (
    Array.isArray(value) &&
    value.length > 0 &&
    value.length <= MOST_ATTEMPTS &&
    value.every((points) => isCount(points, MOST_POINTS))
  );
}

function isCount(value: unknown, most: number): value is number {
  return Number.isInteger(value) && (value as number) >= 0 && (value as number) <= most;
}
