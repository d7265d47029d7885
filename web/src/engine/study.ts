/** The types of studies, `carom-study/1` (docs/studies.md). Lengths in m. */

import type { GoalCondition } from "./goal.ts";
import type { ShotFile, StrikeEntry } from "./types.ts";

export interface StudyFile {
  readonly format: "carom-study/1";
  readonly title: string;
  readonly author?: string;
  readonly language?: string;
  readonly chapters: readonly StudyChapter[];
}

export interface StudyChapter {
  readonly title: string;
  readonly text?: string;
  /** The position; with a strike if the chapter shows one. */
  readonly shot: ShotFile;
  readonly tree?: readonly StudyShot[];
  readonly task?: StudyTask;
}

export interface StudyShot {
  /** Index of the earlier shot from whose end it is played. Left out: the position of the chapter. */
  readonly after?: number;
  readonly strike: StrikeEntry;
  readonly comment?: string;
}

export interface StudyTask {
  readonly goal: readonly GoalCondition[];
  readonly solution?: StrikeEntry;
}

/** How a shot stands to a goal. */
export interface TaskVerdict {
  readonly met: boolean;
  readonly fault: "cue-ball-lost" | "condition" | null;
  /** Index of the first condition that it does not meet. */
  readonly condition: number | null;
  /** How far outside its area the ball stopped, m; null for other conditions. */
  readonly distance: number | null;
}
