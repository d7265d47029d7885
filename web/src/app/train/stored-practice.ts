/** What a reload keeps of a drill or puzzle, as text, and back. */

import type { KeptPractice } from "./practice.ts";

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
    (page === null || isPage(page))
  );
}

function isPuzzle(data: unknown): boolean {
  if (!isRecord(data) || !isRecord(data.drill) || typeof data.date !== "string") return false;
  return isList(data.drill.steps, (step) => isRecord(step) && isRecord(step.balls));
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
