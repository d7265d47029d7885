/** What a reload keeps of a drill or puzzle, as text, and back. */

import type { KeptPractice } from "./practice-state.ts";

export interface StoredPractice {
  readonly kept: KeptPractice;
  /** The document before the drill, as a link. */
  readonly before: string | null;
}

/** Null if the text is damaged. */
export function practiceOfText(text: string): StoredPractice | null {
  try {
    const data: unknown = JSON.parse(text);
    return isStored(data) ? data : null;
  } catch (error) {
    if (error instanceof SyntaxError) return null;
    throw error;
  }
}

function isStored(data: unknown): data is StoredPractice {
  if (!isRecord(data)) return false;
  const { before } = data;
  return (before === null || typeof before === "string") && practiceOf(data.kept) !== null;
}

/** The practice of plain values; null if they are damaged. */
export function practiceOf(data: unknown): KeptPractice | null {
  return isPractice(data) ? data : null;
}

function isPractice(data: unknown): data is KeptPractice {
  if (!isRecord(data)) return false;
  const { running, page } = data;
  return (
    isRecord(running) &&
    typeof running.drill === "string" &&
    (running.place === "page" || running.place === "table") &&
    typeof running.said === "string" &&
    Number.isSafeInteger(running.shots) &&
    isList(running.points, Number.isFinite) &&
    isList(running.left, (ball) => typeof ball === "string") &&
    (running.result === null || isRecord(running.result)) &&
    (running.puzzle === null || isPuzzle(running.puzzle)) &&
    (running.hints === undefined || Number.isSafeInteger(running.hints)) &&
    (running.seen === undefined || typeof running.seen === "boolean") &&
    (page === null || isPage(page))
  );
}

/** The name of a puzzle; or a whole one, as earlier versions kept it, which is not resumed. */
function isPuzzle(data: unknown): boolean {
  if (!isRecord(data) || !(data.date === null || typeof data.date === "string")) return false;
  const { id, drill } = data;
  return typeof id === "string" || (isRecord(drill) && isList(drill.steps, isRecord));
}

function isPage(data: unknown): boolean {
  if (!isRecord(data) || !isRecord(data.set) || !Number.isSafeInteger(data.seed)) return false;
  return isList(data.set.balls, isRecord) && isRecord(data.set.strike);
}

function isList(data: unknown, isOne: (one: unknown) => boolean): boolean {
  return Array.isArray(data) && data.every(isOne);
}

function isRecord(data: unknown): data is Record<string, unknown> {
  return typeof data === "object" && data !== null && !Array.isArray(data);
}
