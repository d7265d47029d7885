/** Which tab of the panel is selected, and whether the panel is folded, as the session changes. */

import type { Activity, Document, Session } from "../document/document.ts";

export interface Tab {
  readonly name:
    | "state"
    | "aim"
    | "lines"
    | "tree"
    | "layout"
    | "physics"
    | "game"
    | "whatif"
    | "train"
    | "library";
  /** The activities that have this tab. */
  readonly of: readonly Activity[];
  /** Shown only during a replay. */
  readonly replay?: boolean;
  /** Shown only while aiming: it shows nothing of a replay, whose tabs need the room. */
  readonly aim?: boolean;
  /** Shown only in free play: in a game its settings are fixed. */
  readonly free?: boolean;
}

export const TABS: readonly Tab[] = [
  { name: "state", of: ["analyse", "play", "train", "library"], replay: true },
  { name: "game", of: ["play"] },
  { name: "train", of: ["train"] },
  { name: "library", of: ["library"] },
  { name: "aim", of: ["analyse", "play", "train", "library"] },
  { name: "lines", of: ["analyse"], aim: true },
  { name: "tree", of: ["analyse"], free: true, aim: true },
  { name: "layout", of: ["analyse"], free: true },
  { name: "physics", of: ["analyse"], free: true },
  { name: "whatif", of: ["analyse"] },
];

/** The tab that an activity begins with. */
const FIRST: Readonly<Record<Activity, Tab["name"]>> = {
  analyse: "aim",
  play: "game",
  train: "train",
  library: "library",
};

/** Index of the tab that a key leads to. */
const KEYS: Readonly<Record<string, (at: number, tabs: number) => number>> = {
  ArrowLeft: (at, tabs) => (at + tabs - 1) % tabs,
  ArrowRight: (at, tabs) => (at + 1) % tabs,
  Home: () => 0,
  End: (_, tabs) => tabs - 1,
};

/** The part of the page's state on which the tabs depend. */
export interface Situation {
  readonly session: Pick<Session, "activity" | "mode" | "attempt">;
  readonly document: Pick<Document, "game">;
}

export interface Shown {
  readonly tab: Tab["name"];
  readonly isFolded: boolean;
}

export interface TabState extends Shown {
  /** What is shown again after the replay. */
  readonly earlier: Shown;
}

export function isPresent({ of, replay, aim, free }: Tab, { session, document }: Situation) {
  const { mode, activity } = session;
  if (!of.includes(activity)) return false;
  if (aim && mode === "replay") return false;
  return !(replay && mode !== "replay") && !(free && document.game !== null);
}

/** The tab that a key leads to; null for other keys. */
export function tabOfKey(key: string, selected: Tab["name"], now: Situation): Tab["name"] | null {
  const tabs = TABS.filter((tab) => isPresent(tab, now));
  const at = tabs.findIndex(({ name }) => name === selected);
  const index = KEYS[key]?.(at, tabs.length);
  return index === undefined ? null : tabs[index]!.name;
}

/** @param isSheet Whether the panel takes room that the table needs: a sheet covers a part of it. */
export function tabsAfter(
  state: TabState,
  now: Situation,
  before: Situation,
  isSheet: boolean,
): TabState {
  let { tab, isFolded, earlier } = state;
  const { activity, mode, attempt } = now.session;
  const { game } = now.document;
  if (activity === before.session.activity) {
    // Every frame has a set-up of its own.
    const begins = game && game.setup !== before.document.game?.setup;
    if (begins || (game && !before.document.game)) isFolded ||= isSheet;
  } else {
    earlier = { ...earlier, tab: FIRST[activity] };
    if (mode === "aim") {
      tab = FIRST[activity];
      // Analysis, and a game that begins, need the table more than the sheet.
      isFolded = isSheet && (activity === "analyse" || game !== null);
    }
  }
  if (mode !== before.session.mode) {
    if (mode === "replay") {
      earlier = { tab, isFolded };
      // The text of a lesson goes on beside its replay.
      if (activity !== "library") tab = "state";
      isFolded ||= isSheet;
    } else {
      if (tab === "state") ({ tab } = earlier);
      ({ isFolded } = earlier);
    }
  }
  if ((attempt === null) !== (before.session.attempt === null)) {
    // An attempt needs the table more than the sheet; at the end the sheet has the result.
    const folded = attempt !== null && isSheet;
    if (mode === "replay") earlier = { ...earlier, isFolded: folded };
    else if (activity === "train") isFolded = folded;
  }
  return { tab, isFolded, earlier };
}
