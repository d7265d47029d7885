/** The panel's tabs. On a phone the panel is a sheet; a second tap on its tab collapses it. */

import { h } from "../common/dom.ts";
import type { Activity } from "../document/document.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";

interface Tab {
  readonly name:
    "state" | "aim" | "lines" | "tree" | "layout" | "physics" | "game" | "whatif" | "train";
  /** The activities that have this tab. */
  readonly of: readonly Activity[];
  /** Shown only during a replay. */
  readonly replay?: boolean;
  /** Shown only while aiming: it shows nothing of a replay, whose tabs need the room. */
  readonly aim?: boolean;
  /** Shown only in free play: in a game its settings are fixed. */
  readonly free?: boolean;
}

const TABS: readonly Tab[] = [
  { name: "state", of: ["analyse", "play", "train"], replay: true },
  { name: "game", of: ["play"] },
  { name: "train", of: ["train"] },
  { name: "aim", of: ["analyse", "play", "train"] },
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
};

/** Screens on which the style makes the panel a sheet, as in style.css; a replay needs that room. */
const SHEET = "(max-width: 760px) and (min-height: 480px), (max-width: 639px)";

/** Index of the tab that a key leads to. */
const KEYS: Readonly<Record<string, (at: number, tabs: number) => number>> = {
  ArrowLeft: (at, tabs) => (at + tabs - 1) % tabs,
  ArrowRight: (at, tabs) => (at + 1) % tabs,
  Home: () => 0,
  End: (_, tabs) => tabs - 1,
};

/** Dispatched on a tab's panel whenever it may have become visible. */
const SHOWN = "carom:shown";

/** Mounts the content of a tab's panel when it is first shown. Most panels are not at the start. */
export function whenShown(panel: HTMLElement, mount: (panel: HTMLElement) => void): void {
  if (panel.hidden) panel.addEventListener(SHOWN, () => mount(panel), { once: true });
  else mount(panel);
}

/** @returns A function that shows the tab with this name. */
export function mountTabs(root: HTMLElement, store: Store): (name: Tab["name"]) => void {
  const panel = root.closest<HTMLElement>(".panel")!;
  const body = (tab: Tab) => document.getElementById(`panel-${tab.name}`)!;
  let selected: Tab["name"] = "aim";
  /** The tab before the replay, and whether the sheet was folded. */
  const earlier: { tab: Tab["name"]; folded: boolean } = { tab: "aim", folded: false };

  const buttons = TABS.map((tab) => {
    const attributes = { type: "button", role: "tab", class: "tab", id: `tab-${tab.name}` };
    const controls = { "aria-controls": `panel-${tab.name}` };
    body(tab).setAttribute("role", "tabpanel");
    body(tab).setAttribute("aria-labelledby", `tab-${tab.name}`);
    return h(
      "button",
      { ...attributes, ...controls, onclick: () => click(tab) },
      t(`tab.${tab.name}`),
    );
  });
  root.append(...buttons);

  const present = ({ of, replay, aim, free }: Tab) => {
    const { mode, activity } = store.session;
    if (!of.includes(activity)) return false;
    if (aim && mode === "replay") return false;
    return !(replay && mode !== "replay") && !(free && store.document.game !== null);
  };

  function show(): void {
    TABS.forEach((tab, index) => {
      const on = tab.name === selected;
      const button = buttons[index]!;
      button.hidden = !present(tab);
      button.setAttribute("aria-selected", String(on));
      button.tabIndex = on ? 0 : -1;
      body(tab).hidden = !on;
      if (on) body(tab).dispatchEvent(new Event(SHOWN));
    });
  }

  function select(name: Tab["name"]): void {
    selected = name;
    fold(false);
    show();
  }

  function fold(on: boolean): void {
    if (on) panel.dataset.folded = "true";
    else delete panel.dataset.folded;
  }

  function click(tab: Tab): void {
    if (tab.name !== selected || panel.dataset.folded) select(tab.name);
    else fold(true);
  }

  root.addEventListener("keydown", (event) => {
    const go = KEYS[event.key];
    if (!go) return;
    const tabs = TABS.filter(present);
    const at = tabs.findIndex((tab) => tab.name === selected);
    const next = tabs[go(at, tabs.length)]!;
    select(next.name);
    document.getElementById(`tab-${next.name}`)?.focus();
    event.preventDefault();
  });

  store.subscribe((now, before) => {
    const { activity } = now.session;
    if (activity === before.session.activity) {
      // The settings are hidden once a game begins.
      if (now.document.game !== before.document.game) show();
      if (now.document.game && !before.document.game) fold(matchMedia(SHEET).matches);
      return;
    }
    earlier.tab = FIRST[activity];
    if (now.session.mode === "replay") {
      show();
      return;
    }
    select(FIRST[activity]);
    // Analysis, and a game that begins, need the table more than the sheet.
    fold(matchMedia(SHEET).matches && (activity === "analyse" || now.document.game !== null));
  });
  store.subscribe((now, before) => {
    if (now.session.mode === before.session.mode) return;
    if (now.session.mode === "replay") {
      earlier.tab = selected;
      earlier.folded = panel.dataset.folded !== undefined;
      select("state");
      fold(matchMedia(SHEET).matches);
    } else {
      select(selected === "state" ? earlier.tab : selected);
      fold(earlier.folded);
    }
  });
  store.subscribe(({ session }, { session: before }) => {
    if ((session.attempt === null) === (before.attempt === null)) return;
    // An attempt needs the table more than the sheet; at the end the sheet has the result.
    const folded = session.attempt !== null && matchMedia(SHEET).matches;
    if (session.mode === "replay") earlier.folded = folded;
    else if (session.activity === "train") fold(folded);
  });
  fold(matchMedia(SHEET).matches);
  show();
  return select;
}
