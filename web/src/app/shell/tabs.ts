/** The panel's tabs. On a phone the panel is a sheet; a second tap on its tab collapses it. */

import { h } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";

interface Tab {
  readonly name: "state" | "aim" | "layout" | "physics" | "game" | "whatif";
  /** Shown only during a replay. */
  readonly replay?: boolean;
  /** Shown only in free play: in a game its settings are fixed. */
  readonly free?: boolean;
  /** Hidden during a replay in free play: there is no room for six tabs. */
  readonly notInReplay?: boolean;
}

const TABS: readonly Tab[] = [
  { name: "state", replay: true },
  { name: "aim" },
  { name: "layout", free: true },
  { name: "physics", free: true },
  { name: "game", notInReplay: true },
  { name: "whatif" },
];

/** Screens on which the style makes the panel a sheet, as in style.css; a replay needs that room. */
const SHEET = "(max-width: 760px) and (min-height: 480px), (max-width: 639px)";

/** Index of the tab that a key leads to. */
const KEYS: Readonly<Record<string, (at: number, tabs: number) => number>> = {
  ArrowLeft: (at, tabs) => (at + tabs - 1) % tabs,
  ArrowRight: (at, tabs) => (at + 1) % tabs,
  Home: () => 0,
  End: (_, tabs) => tabs - 1,
};

export function mountTabs(root: HTMLElement, store: Store): void {
  const panel = root.closest<HTMLElement>(".panel")!;
  const body = (tab: Tab) => document.getElementById(`panel-${tab.name}`)!;
  let selected = "aim";
  const earlier = { tab: "aim", folded: false };

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

  const present = ({ replay, free, notInReplay }: Tab) => {
    const [replayed, playing] = [store.session.mode === "replay", store.document.game !== null];
    return !(replay && !replayed) && !(free && playing) && !(notInReplay && replayed && !playing);
  };

  function show(): void {
    TABS.forEach((tab, index) => {
      const on = tab.name === selected;
      const button = buttons[index]!;
      button.hidden = !present(tab);
      button.setAttribute("aria-selected", String(on));
      button.tabIndex = on ? 0 : -1;
      body(tab).hidden = !on;
    });
  }

  function select(name: string): void {
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
    if ((now.document.game === null) === (before.document.game === null)) return;
    if (now.document.game) earlier.tab = "game";
    if (now.session.mode === "aim") select("game");
    else show();
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
  show();
}
