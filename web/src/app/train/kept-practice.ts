/** Keeps a drill or puzzle in progress while the page loads again. */

import type { Engine } from "../../engine/index.ts";
import { inSlices } from "../common/slices.ts";
import { readLink } from "../share/address.ts";
import { LinkError } from "../share/link.ts";
import { isReload } from "../share/reload.ts";
import { stateToFragment } from "../share/link-state.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";
import type { Practice } from "./practice.ts";
import { practiceOfText, type StoredPractice } from "./stored-practice.ts";

/** Name in the storage of the tab. */
const KEPT = "carom-drill";

/** Goes on with the drill of before the reload, and keeps it for the next one. */
export function mountKept(practice: Practice, store: Store, engine: Engine): void {
  void resume(practice, store, engine);
  addEventListener("pagehide", () => {
    const running = practice.keep();
    if (!running) return;
    const { kept, before: document } = running;
    const before = document && stateToFragment(document.shot, { ...store.state, document });
    try {
      sessionStorage.setItem(KEPT, JSON.stringify({ kept, before } satisfies StoredPractice));
    } catch (error) {
      if (!(error instanceof DOMException)) throw error;
    }
  });
}

async function resume(practice: Practice, store: Store, engine: Engine): Promise<void> {
  try {
    const text = sessionStorage.getItem(KEPT);
    sessionStorage.removeItem(KEPT);
    if (text === null || !isReload()) return;
    const stored = practiceOfText(text);
    if (!stored) {
      store.refuse(t("train.damaged"));
      return;
    }
    const { kept, before } = stored;
    const link = before === null ? null : await inSlices(readLink(engine, before));
    practice.resume(kept, link?.document ?? null);
  } catch (error) {
    // Some frames have no storage, and a long game before the drill does not fit into a link.
    if (!(error instanceof DOMException || error instanceof LinkError)) throw error;
  }
}
