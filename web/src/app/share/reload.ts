/**
 * Keeps what the page shows while it loads again. The address is not enough: a page with an embedded
 * document opens that, and in a frame the address cannot be changed.
 */

import type { Engine } from "../../engine/index.ts";
import { hasFlag, setFlag } from "../common/flag.ts";
import type { Store } from "../document/store.ts";
import type { Slices } from "../common/slices.ts";
import { type LinkContents, readLink } from "./address.ts";
import { LinkError } from "./link.ts";
import { stateFromFragment, stateToFragment } from "./link-state.ts";

/** Names in the storage of the tab: the link, and that the page was silent. */
const KEPT = "carom-reload";
const SILENT = "carom-reload-silent";

/**
 * Stores document, view and time of the replay for the next load of the page.
 *
 * @throws {LinkError} They could not be opened again, because the game is too long.
 * @throws {DOMException} The browser stores nothing for this page.
 */
export function keepForReload(store: Store): void {
  // The document's own shot: that of a link has the elevation that the automatic one gives.
  const kept = stateToFragment(store.document.shot, store.state);
  stateFromFragment(kept);
  sessionStorage.setItem(KEPT, kept);
  // A link opens without sound, and the page stays silent when it is loaded again.
  setFlag("sessionStorage", SILENT, !store.session.replay.sound);
}

/** Whether what was kept had no sound. */
export function wasSilent(): boolean {
  return hasFlag("sessionStorage", SILENT, false);
}

/** Keeps the last changes when the page is loaded again: the address may not have them yet. */
export function mountReload(store: Store): void {
  addEventListener("pagehide", () => {
    try {
      keepForReload(store);
    } catch (error) {
      // Too long a game, or no storage: the address has what it can.
      if (!(error instanceof LinkError || error instanceof DOMException)) throw error;
    }
  });
}

/** Whether the page was loaded again, not opened at an address. */
export function isReload(): boolean {
  const [entry] = performance.getEntriesByType("navigation");
  return (entry as PerformanceNavigationTiming | undefined)?.type === "reload";
}

/**
 * Takes what was kept out of the storage; null if nothing was, or if another address was opened since.
 *
 * @throws {LinkError} It cannot be opened.
 */
export function* takeKept(engine: Engine): Slices<LinkContents | null> {
  let kept: string | null = null;
  try {
    kept = sessionStorage.getItem(KEPT);
    sessionStorage.removeItem(KEPT);
  } catch {
    // Some frames and browsers have no storage.
  }
  return kept === null || !isReload() ? null : yield* readLink(engine, kept);
}
