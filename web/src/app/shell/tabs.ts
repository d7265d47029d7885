/** The panel's tabs. On a phone the panel is a sheet; a second tap on its tab, or its handle, collapses it. */

import { mountHandle, sideButton, FOLDED } from "./fold-controls.ts";
import { h } from "../common/dom.ts";
import { SHOWN } from "../common/shown.ts";
import type { State, Store } from "../document/store.ts";
import { t } from "../words/translate.ts";
import { isPresent, type Shown, type Tab, tabOfKey, TABS, tabsAfter } from "./tab-state.ts";

/** Screens on which the style makes the panel a sheet, as in style.css. */
const SHEET = "(max-width: 760px) and (min-height: 480px), (max-width: 639px)";

/** Screens whose table needs the room of the panel: sheets, and low windows. */
const CROWDED = `${SHEET}, (max-height: 479px)`;

/** @returns A function that shows the tab with this name. */
export function mountTabs(root: HTMLElement, store: Store): (name: Tab["name"]) => void {
  const tabs = new Tabs(root, store);
  root.addEventListener("keydown", (event) => {
    const next = tabOfKey(event.key, tabs.selected, store.state);
    if (!next) return;
    tabs.select(next);
    document.getElementById(`tab-${next}`)?.focus();
    event.preventDefault();
  });
  return (name) => tabs.select(name);
}

const isSheet = () => matchMedia(SHEET).matches;
const isCrowded = () => matchMedia(CROWDED).matches;

/** Whether the panel is at the side of the table and not folded. */
export function isBesideTable(): boolean {
  return !isSheet() && document.getElementById("panel")!.dataset.folded === undefined;
}

const bodyOf = ({ name }: Tab) => document.getElementById(`panel-${name}`)!;

class Tabs {
  readonly #panel: HTMLElement;
  readonly #store: Store;
  readonly #buttons = TABS.map((tab) => this.#button(tab));
  selected: Tab["name"] = "aim";
  /** What was shown before the replay. */
  #earlier: Shown = { tab: "aim", isFolded: false };

  constructor(root: HTMLElement, store: Store) {
    this.#panel = root.closest<HTMLElement>(".panel")!;
    this.#store = store;
    const fold = () => this.#fold(!this.#isFolded);
    root.append(...this.#buttons);
    root.before(sideButton(this.#panel, fold));
    mountHandle(document.getElementById("drawer")!, fold);
    store.subscribe((now, before) => this.#follow(now, before));
    this.#fold(isCrowded());
    this.#show();
  }

  select(name: Tab["name"]): void {
    this.selected = name;
    this.#fold(false);
    this.#show();
  }

  #follow(now: State, before: State): void {
    const [is, was] = [now.session, before.session];
    const isOther =
      is.activity !== was.activity ||
      is.mode !== was.mode ||
      // The settings are hidden once a game begins.
      now.document.game !== before.document.game;
    if (!isOther && is.attempt === was.attempt) return;
    const state = { tab: this.selected, isFolded: this.#isFolded, earlier: this.#earlier };
    const next = tabsAfter(state, now, before, isCrowded());
    this.selected = next.tab;
    this.#earlier = next.earlier;
    this.#fold(next.isFolded);
    if (isOther) this.#show();
  }

  #button(tab: Tab): HTMLButtonElement {
    const attributes = { type: "button", role: "tab", class: "tab", id: `tab-${tab.name}` };
    const controls = { "aria-controls": `panel-${tab.name}` };
    bodyOf(tab).setAttribute("role", "tabpanel");
    bodyOf(tab).setAttribute("aria-labelledby", attributes.id);
    const onclick = () => this.#click(tab);
    return h("button", { ...attributes, ...controls, onclick }, t(`tab.${tab.name}`));
  }

  #show(): void {
    TABS.forEach((tab, index) => {
      const on = tab.name === this.selected;
      const button = this.#buttons[index]!;
      button.hidden = !isPresent(tab, this.#store.state);
      button.setAttribute("aria-selected", String(on));
      button.tabIndex = on ? 0 : -1;
      bodyOf(tab).hidden = !on;
      if (on) bodyOf(tab).dispatchEvent(new Event(SHOWN));
    });
  }

  get #isFolded(): boolean {
    return this.#panel.dataset.folded !== undefined;
  }

  #fold(on: boolean): void {
    if (on === this.#isFolded) return;
    if (on) this.#panel.dataset.folded = "true";
    else delete this.#panel.dataset.folded;
    this.#panel.dispatchEvent(new Event(FOLDED));
  }

  #click(tab: Tab): void {
    if (tab.name !== this.selected || this.#isFolded) this.select(tab.name);
    else if (isSheet()) this.#fold(true);
  }
}
