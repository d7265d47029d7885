/** Keeps a drill or puzzle in progress while the page loads again. */

import type { Engine } from "../../engine/index.ts";
import { inSlices } from "../common/slices.ts";
import { readLink } from "../share/address.ts";
import { LinkError } from "../share/link.ts";
import { isReload } from "../share/reload.ts";
import { stateToFragment } from "../share/state.ts";
import type { Store } from "../document/store.ts";
import type { KeptPractice, Practice } from "./practice.ts";

/** Name in the storage of the tab. */
const KEPT = "carom-drill";

interface Stored {
  readonly kept: KeptPractice;
  /** The document before the drill, as a link. */
  readonly before: string | null;
}

/** Goes on with the drill of before the reload, and keeps it for the next one. */
export function mountKept(practice: Practice, store: Store, engine: Engine): void {
  void resume(practice, engine);
  addEventListener("pagehide", () => {
    const running = practice.keep();
    if (!running) return;
    const { kept, before: document } = running;
    const before = document && stateToFragment(document.shot, { ...store.state, document });
    try {
      sessionStorage.setItem(KEPT, JSON.stringify({ kept, before } satisfies Stored));
    } catch (error) {
      if (!(error instanceof DOMException)) throw error;
    }
  });
}

async function resume(practice: Practice, engine: Engine): Promise<void> {
  try {
    const text = sessionStorage.getItem(KEPT);
    sessionStorage.removeItem(KEPT);
    if (text === null || !isReload()) return;
    const { kept, before } = JSON.parse(text) as Stored;
    const link = before === null ? null : await inSlices(readLink(engine, before));
    practice.resume(kept, link?.document ?? null);
  } catch (error) {
    // Some frames have no storage, and a long game before the drill does not fit into a link.
    if (!(error instanceof DOMException || error instanceof LinkError)) throw error;
  }
}
