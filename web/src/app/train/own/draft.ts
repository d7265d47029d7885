/** A drill that is being made. */

import type { DrillFile } from "../../../engine/index.ts";

export interface Draft {
  /** It may have no name and no step yet. */
  readonly file: DrillFile;
  /** The name under which it is kept; null of a new one. */
  readonly kept: string | null;
}

export function newDraft(): Draft {
  const file = { format: "carom-drill/1", name: "", table: "", attempts: 10, steps: [] } as const;
  return { file, kept: null };
}
