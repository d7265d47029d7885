/** The study that is open. */

import type { StudyFile } from "../../engine/index.ts";

/** The study that is open, and the chapter that the table shows. */
export interface Lesson {
  readonly study: StudyFile;
  readonly chapter: number;
  /** Its id in the library; null: it is from a link or a file, and can only be read. */
  readonly id: string | null;
}
