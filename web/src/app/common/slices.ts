/**
 * Work that may take longer than a picture, cut into slices: a generator that yields after every shot that
 * the engine simulates. The page stays responsive when the slices run in tasks of their own.
 */

import { nextTask } from "../../engine/next-task.ts";

export type Slices<T> = Generator<undefined, T, undefined>;

/** Runs each slice in a task of its own. */
export async function inSlices<T>(slices: Slices<T>): Promise<T> {
  let slice = slices.next();
  while (!slice.done) {
    await nextTask();
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
