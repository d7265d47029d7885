/**
 * Work that may take longer than a picture, cut into slices: a generator that yields after every shot that
 * the engine simulates. The page stays responsive when the slices run in tasks of their own.
 */

import { nextTask } from "../../engine/next-task.ts";

export type Slices<T> = Generator<undefined, T, undefined>;

/** Runs each slice in a task of its own. @param pause Resolves in the next task. */
export async function inSlices<T>(
  slices: Slices<T>,
  pause: () => Promise<void> = nextTask,
): Promise<T> {
  let slice = slices.next();
  while (!slice.done) {
    await pause();
    slice = slices.next();
  }
  return slice.value;
}

/** What the user has opened last. */
let latest: Slices<unknown> | null = null;

/** As `inSlices`, for what the user opens; null if the user has opened something else meanwhile. */
export async function inSlicesUnlessReplaced<T>(slices: Slices<T>): Promise<T | null> {
  latest = slices;
  let slice = slices.next();
  while (!slice.done) {
    await nextTask();
    if (latest !== slices) return null;
    slice = slices.next();
  }
  return slice.value;
}

/** Runs all slices at once. */
export function atOnce<T>(slices: Slices<T>): T {
  let slice = slices.next();
  while (!slice.done) slice = slices.next();
  return slice.value;
}
