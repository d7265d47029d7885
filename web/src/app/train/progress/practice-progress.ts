/** What a player has practised: results of drills and of the puzzles of the day. As a file, carom-progress/1. */

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

export interface Progress {
  readonly results: readonly Result[];
  readonly puzzles: readonly PuzzleResult[];
}

export const NOTHING: Progress = { results: [], puzzles: [] };

/** Largest numbers that a file may have: far beyond what a drill gives. */
const MOST_ATTEMPTS = 1000;
const MOST_POINTS = 1000;

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

export function progressToText(progress: Progress): string {
  return `${JSON.stringify(progressToData(progress))}\n`;
}

/** The progress as it is in a file. */
export function progressToData({ results, puzzles }: Progress): object {
  return { format: FORMAT, results, puzzles };
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
  };
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
