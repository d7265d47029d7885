/** The state of a drill or puzzle in progress. */

import type { DrillFile } from "../../engine/index.ts";
import type { AimedShot, Document } from "../document/document.ts";
import type { Drill } from "./drills/index.ts";
import type { Verdict } from "./drill-judge.ts";
import type { Deviation } from "./drill-layout.ts";
import { total } from "./drill-score.ts";
import type { Result } from "./progress/practice-progress.ts";
import type { PuzzleTask } from "./puzzle/puzzle-task.ts";

/** What is practised. */
export interface Running {
  readonly drill: Drill;
  readonly place: Result["place"];
  /** Name of the level whose errors the strikes have; null: none. */
  readonly errors: string | null;
  /** The puzzle, if it is one: it has no score, and ends when it is solved. */
  readonly puzzle: PuzzleTask | null;
  /** How many hints of the puzzle were taken, and whether its solution was shown. */
  readonly hints: number;
  readonly seen: boolean;
  /** Points of the attempts so far, as the score counts them. */
  readonly points: readonly number[];
  /** Shots of the present attempt so far, and the balls that its run still has to pot. */
  readonly shots: number;
  readonly left: readonly string[];
  /** How the last shot went; empty before the first. */
  readonly said: string;
  /** Set at the end. */
  readonly result: Result | null;
  readonly solved: boolean;
}

/** What belongs to a drill on the page's table. */
export interface OnPage {
  /** The document before the drill. */
  readonly before: Document;
  /** The layout of the present attempt. */
  set: AimedShot;
  seed: number;
  /** The verdict of the shot that is replayed, and where it leaves the balls. */
  verdict: Verdict | Deviation | null;
  next: AimedShot | null;
  /** Whether the replayed shot is a solution that the page shows: it does not count. */
  shown: boolean;
  /** The deviation of which the panel knows. */
  deviation: Deviation | null;
  timer: ReturnType<typeof setTimeout> | undefined;
}

/** What a reload of the page keeps of a drill or puzzle in progress: plain values. */
export interface KeptPractice {
  readonly running: Omit<Running, "drill" | "puzzle" | "hints" | "seen"> & {
    // Earlier versions did not have them.
    readonly hints?: number;
    readonly seen?: boolean;
    readonly drill: string;
    /** The file of a drill that the user has made. */
    readonly own?: DrillFile;
    readonly puzzle: { readonly id: string; readonly date: string | null } | null;
  };
  /** Null at a real table. */
  readonly page: Pick<OnPage, "set" | "seed"> | null;
  /** Whether the attempt was on the screen. */
  readonly shown: boolean;
}

/** The score of what is practised. */
export function scoreOf({ points }: Running): number {
  return total(points);
}
