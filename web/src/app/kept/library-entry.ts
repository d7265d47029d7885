/** An entry of the library: a named position, game or study in a folder, as the browser and a backup have it. */

import type { StudyFile } from "../../engine/index.ts";
import { check, entriesAt, textAt, timeAt } from "./kept-fault.ts";

export const ENTRY_FORMAT = "carom-entry/1";

export const ENTRY_KINDS = ["position", "game", "study"] as const;
export type EntryKind = (typeof ENTRY_KINDS)[number];

/** The longest name of an entry and of a folder, in characters. */
export const LONGEST_ENTRY_NAME = 100;

const LONGEST_ID = 200;
/** The longest text of a link: that of `share/link.ts` with its key. */
const LONGEST_LINK = 100_100;

interface Common {
  readonly format: typeof ENTRY_FORMAT;
  readonly id: string;
  readonly name: string;
  /** Empty: in no folder. */
  readonly folder: string;
  /** When it was changed last: ISO 8601, UTC, with milliseconds. */
  readonly changed: string;
}

/** A position with its shots and marks, or a game with all moves: the text of a link. */
export interface LinkEntry extends Common {
  readonly kind: "position" | "game";
  readonly link: string;
}

export interface StudyEntry extends Common {
  readonly kind: "study";
  readonly study: StudyFile;
}

export type LibraryEntry = LinkEntry | StudyEntry;

/**
 * The entry of plain values. The engine still has to check what is in it.
 *
 * @throws {KeptFault} It is damaged.
 */
export function entryOf(data: unknown, place: string): LibraryEntry {
  const own = ["format", "id", "name", "folder", "changed", "kind"];
  const kind = ENTRY_KINDS.find((name) => name === (data as { kind?: unknown } | null)?.kind);
  check(kind !== undefined, `${place}.kind`);
  const content = kind === "study" ? "study" : "link";
  const entries = entriesAt(data, place, [...own, content]);
  check(entries.format === ENTRY_FORMAT, `${place}.format`);
  const common = {
    format: ENTRY_FORMAT,
    id: textAt(entries.id, `${place}.id`, LONGEST_ID),
    name: textAt(entries.name, `${place}.name`, LONGEST_ENTRY_NAME),
    folder: textAt(entries.folder, `${place}.folder`, LONGEST_ENTRY_NAME),
    changed: timeAt(entries.changed, `${place}.changed`),
  } as const;
  if (kind !== "study") {
    return { ...common, kind, link: textAt(entries.link, `${place}.link`, LONGEST_LINK) };
  }
  const { study } = entries;
  check(typeof study === "object" && study !== null, `${place}.study`);
  check((study as { format?: unknown }).format === "carom-study/1", `${place}.study.format`);
  return { ...common, kind, study: study as StudyFile };
}
