/** Puts every part of the page on its place. */

import type { Context } from "./context.ts";
import type { Store } from "./store.ts";
import { mountTabs } from "./tabs.ts";

/** The mount point with this id in index.html. */
function place(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`index.html has no element "${id}"`);
  return element;
}

// Mount points of the parts with folders of their own, each mountX(root, store, context):
// replay/: "timeline" in the dock, "panel-state"; whatif/: "panel-whatif"; share/: "share".
export function mountPage(store: Store, context: Context): void {
  context.loop.invalidate();
  mountTabs(place("tabs"), store);
}
