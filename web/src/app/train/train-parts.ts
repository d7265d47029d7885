/** What the pages of the Train tab share. */

import type { Context } from "../common/context.ts";
import { h } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import type { Drill } from "./drills/index.ts";
import type { Draft } from "./own/draft.ts";
import type { Practice } from "./practice.ts";
import type { Keeper } from "./progress/progress-keeper.ts";

/** What the panel shows besides a drill in progress. */
export type Page =
  | { readonly kind: "overview" }
  | { readonly kind: "drill"; readonly drill: Drill }
  | { readonly kind: "sheet" }
  | { readonly kind: "own"; readonly draft: Draft };

/** What every page of the panel uses. */
export interface Trainer {
  readonly store: Store;
  readonly context: Context;
  readonly keeper: Keeper;
  readonly practice: Practice;
  /** Shows a page. */
  readonly go: (page: Page) => void;
}

/** The heading of a page, which takes the focus when the page changes. */
export function heading(text: string): HTMLElement {
  return h("h2", { tabindex: -1 }, text);
}

export function button(
  id: string,
  text: string,
  onclick: () => void,
  isPrimary = false,
): HTMLButtonElement {
  const attributes = { type: "button", class: isPrimary ? "button primary" : "button" };
  return h("button", { ...attributes, id, onclick }, text);
}
