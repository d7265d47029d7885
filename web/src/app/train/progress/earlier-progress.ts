/** The progress that earlier versions of the page kept as one text in `localStorage`. */

import { entriesOf, type ProgressEntry } from "./progress-entries.ts";
import { DamagedProgress, progressOfText } from "./practice-progress.ts";

/** Its name, and those of texts that could not be read: with 1, 2, and so on. */
const STORED = "carom-progress";
const DAMAGED = "carom-progress-damaged-";

/** The part of the browser's storage that is used. */
export type Box = Pick<Storage, "getItem" | "removeItem">;

export interface EarlierProgress {
  readonly entries: readonly ProgressEntry[];
  /** Deletes it where it was, once it is kept elsewhere. */
  readonly forget: () => void;
}

/** Null if there is none. Two tabs that read it make the same entries. */
export function earlierProgress(box: Box | null): EarlierProgress | null {
  const names = [STORED];
  const entries: ProgressEntry[] = [];
  try {
    const text = box?.getItem(STORED);
    if (typeof text === "string") entries.push(...read(text));
    for (let number = 1; ; number += 1) {
      const damaged = box?.getItem(`${DAMAGED}${number}`);
      if (typeof damaged !== "string") break;
      const name = `${DAMAGED}${number}`;
      names.push(name);
      entries.push(unreadable(name, damaged));
    }
  } catch (error) {
    // Some frames have no storage.
    if (!(error instanceof DOMException)) throw error;
  }
  if (entries.length === 0) return null;
  return {
    entries,
    forget: () => {
      for (const name of names) box?.removeItem(name);
    },
  };
}

function read(text: string): ProgressEntry[] {
  try {
    return entriesOf(progressOfText(text), ({ name }) => name);
  } catch (error) {
    if (error instanceof DamagedProgress) return [unreadable(STORED, text)];
    throw error;
  }
}

function unreadable(name: string, text: string): ProgressEntry {
  return { id: `damaged ${name}`, kind: "damaged", text };
}

/** The browser's storage; null where a page may not use it. */
export function browserBox(): Box | null {
  try {
    return localStorage;
  } catch {
    // Some frames and browsers have no storage.
    return null;
  }
}
