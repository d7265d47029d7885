/** The progress as entries of the browser's database: each result, puzzle, attempt and own drill is one of its own. */

import type { DrillFile } from "../../../engine/index.ts";
import { freshId } from "../../common/fresh-id.ts";
import {
  DamagedProgress,
  FORMAT,
  merged,
  NOTHING,
  type Progress,
  progressOfData,
  sameDrill,
} from "./practice-progress.ts";

const KINDS = ["results", "puzzles", "attempts", "drills"] as const;
type Kind = (typeof KINDS)[number];

/**
 * An entry of a kind; or a text that could not be read. The id of what cannot change is made from its value, so that
 * two tabs store it once; the id of a drill begins with the time of its making.
 */
export type ProgressEntry =
  | { readonly id: string; readonly kind: Kind; readonly value: object }
  | { readonly id: string; readonly kind: "damaged"; readonly text: string };

/** The entries of a progress. */
export function entriesOf(
  progress: Progress,
  drillId: (drill: DrillFile) => string = newDrillId,
): ProgressEntry[] {
  return KINDS.flatMap((kind) =>
    progress[kind].map((value) => {
      const id = kind === "drills" ? drillId(value as DrillFile) : JSON.stringify(value);
      return { id: `${kind} ${id}`, kind, value };
    }),
  );
}

function newDrillId(): string {
  return `${new Date().toISOString()} ${freshId()}`;
}

/** What is stored. */
export interface StoredProgress {
  readonly progress: Progress;
  /** What cannot be read, as text; null if there is nothing. */
  readonly damaged: string | null;
}

/** What the stored entries mean. */
export function progressOfEntries(entries: Iterable<unknown>): StoredProgress {
  const damaged: string[] = [];
  const lists: Record<Kind, object[]> = { results: [], puzzles: [], attempts: [], drills: [] };
  for (const entry of entries) {
    const kind = readableKind(entry);
    if (kind) lists[kind].push((entry as { readonly value: object }).value);
    else damaged.push(textOf(entry));
  }
  const progress = merged(NOTHING, progressOfData({ format: FORMAT, ...lists }));
  return { progress, damaged: damaged.length > 0 ? damaged.join("\n") : null };
}

/** The kind of an entry; null if it cannot be read. */
function readableKind(entry: unknown): Kind | null {
  const { kind: name, value } = entry as { readonly kind?: unknown; readonly value?: unknown };
  const kind = KINDS.find((one) => one === name);
  if (!kind) return null;
  try {
    progressOfData({ format: FORMAT, results: [], puzzles: [], [kind]: [value] });
    return kind;
  } catch (error) {
    if (error instanceof DamagedProgress) return null;
    throw error;
  }
}

function textOf(entry: unknown): string {
  const { text } = entry as { readonly text?: unknown };
  return typeof text === "string" ? text : JSON.stringify(entry);
}

/** The ids of the entries that are this drill, whatever the number after its name. */
export function idsOfDrill(entries: Iterable<ProgressEntry>, drill: DrillFile): string[] {
  return [...entries].flatMap((entry) => {
    const isIt = entry.kind === "drills" && sameDrill([entry.value as DrillFile], drill);
    return isIt ? [entry.id] : [];
  });
}
