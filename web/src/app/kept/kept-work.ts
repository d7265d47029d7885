/** A work that is kept: a game, an analysis or a drill with all that undo and redo can restore. */

import type { Document } from "../document/document.ts";
import type { Step, Steps } from "../document/history.ts";
import type { Setup } from "../document/stored-game.ts";
import type { KeptPractice } from "../train/practice-state.ts";
import { practiceOf } from "../train/stored-practice.ts";
import { type KeptDocument, type KeptParts, Packer, PARTS, Unpacker } from "./kept-documents.ts";
import { check, entriesAt, listAt, textAt, timeAt, wholeAt } from "./kept-fault.ts";

export const WORK_FORMAT = "carom-work/1";

export type Kind = "game" | "analysis" | "drill";
export const KINDS: readonly Kind[] = ["game", "analysis", "drill"];

/** The most steps of a history that are kept, undo and redo together. */
export const MOST_STEPS = 2000;

const LONGEST_ID = 200;
const LONGEST_LABEL = 1000;

export interface Work {
  readonly id: string;
  readonly kind: Kind;
  /** When it was changed last: ISO 8601, UTC, with milliseconds. */
  readonly changed: string;
  /** Whether it has come to its end, so that there is nothing to continue. */
  readonly over: boolean;
  readonly steps: Steps<Document>;
  /** The drill, and the document before it; null of another kind. */
  readonly practice: { readonly kept: KeptPractice; readonly before: Document | null } | null;
}

type KeptStep = KeptDocument & { readonly label: string };

/** A work as plain values: in the browser's storage, and in a file. */
export interface KeptWork extends KeptParts {
  readonly format: typeof WORK_FORMAT;
  readonly id: string;
  readonly kind: Kind;
  readonly changed: string;
  readonly over: boolean;
  readonly at: number;
  readonly steps: readonly KeptStep[];
  readonly practice: { readonly kept: KeptPractice; readonly before: KeptDocument | null } | null;
}

/** @param idOf The id of the game with a set-up. */
export function packed(work: Work, idOf: (setup: Setup) => string): KeptWork {
  const { steps, at } = newest(work.steps);
  const { id, kind, changed, over, practice } = work;
  const packer = new Packer(idOf);
  const kept = {
    format: WORK_FORMAT,
    id,
    kind,
    changed,
    over,
    at,
    steps: steps.map(({ state, label }) => ({ ...packer.document(state), label })),
    practice: practice && {
      kept: practice.kept,
      before: practice.before && packer.document(practice.before),
    },
  } as const;
  return { ...kept, ...packer.parts };
}

/** A history without its oldest steps if it has too many, and the present state. */
function newest({ steps, at }: Steps<Document>): Steps<Document> {
  const from = Math.min(Math.max(0, steps.length - MOST_STEPS), at);
  return { steps: steps.slice(from, from + MOST_STEPS), at: at - from };
}

/**
 * The work of plain values. Its structure is checked; the engine still has to check its states.
 *
 * @param seen Called with each set-up and the id of its game.
 * @throws {KeptFault} It is damaged.
 */
export function unpacked(
  data: unknown,
  place: string,
  seen: (setup: Setup, id: string) => void = () => undefined,
): Work {
  const own = ["format", "id", "kind", "changed", "over", "at", "steps", "practice"];
  const entries = entriesAt(data, place, [...own, ...PARTS]);
  check(entries.format === WORK_FORMAT, `${place}.format`);
  const kind = KINDS.find((name) => name === entries.kind);
  check(kind !== undefined, `${place}.kind`);
  check(typeof entries.over === "boolean", `${place}.over`);
  const parts = new Unpacker(entries, place, seen);
  const steps = listAt(entries.steps, `${place}.steps`, MOST_STEPS, (item, at): Step<Document> => {
    const state = parts.document(item, at, ["label"]);
    return { state, label: textAt((item as KeptStep).label, `${at}.label`, LONGEST_LABEL) };
  });
  return {
    id: textAt(entries.id, `${place}.id`, LONGEST_ID),
    kind,
    changed: timeAt(entries.changed, `${place}.changed`),
    over: entries.over,
    steps: { steps, at: wholeAt(entries.at, `${place}.at`, 0, steps.length - 1) },
    practice: practiceAt(entries.practice, `${place}.practice`, parts),
  };
}

function practiceAt(data: unknown, place: string, parts: Unpacker): Work["practice"] {
  if (data === null) return null;
  const { kept, before } = entriesAt(data, place, ["kept", "before"]);
  const read = practiceOf(kept);
  check(read !== null, `${place}.kept`);
  return { kept: read, before: before === null ? null : parts.document(before, `${place}.before`) };
}
