/** What the page opens with: the document inside it, else its address, else a first shot. */

import { CaromError, type Engine, type ShotFile } from "../engine/index.ts";
import { documentOf, held, notOpened, replay } from "./actions.ts";
import { FIRST_VIEW, type Document, type View } from "./document.ts";
import { referee } from "./game/referee.ts";
import { openedByAddress, showInstant } from "./share/address.ts";
import { LinkError } from "./share/link.ts";
import type { Store } from "./store.ts";

export interface Opened {
  readonly document: Document;
  readonly view: View;
  /** Nothing was asked for: somebody may be here for the first time. */
  readonly welcome: boolean;
  /** What is left to do once the page stands: to open a trace, or to say what cannot be opened. */
  then(store: Store): void;
}

/** The first shot: a cut into the corner, with the way of the cue ball to think about. */
const FIRST_SHOT: ShotFile = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.42, 0.72] },
    { id: "9", position: [0.86, 1.74] },
    { id: "1", position: [0.35, 1.62] },
    { id: "3", position: [0.98, 0.9] },
  ],
  strike: { ball: "cue", speed: 2, azimuth_deg: 66.8, height: -0.2 },
};

export function opened(engine: Engine): Opened {
  const first = documentOf(FIRST_SHOT);
  const inside = document.getElementById("carom-document")?.textContent.trim() ?? "";
  if (inside !== "") return openedInside(engine, first, inside);
  return openedByLink(engine, first) ?? { ...nothing(first), welcome: true };
}

/** What stands in the page itself: nothing comes before it that undo could lead to. */
function openedInside(engine: Engine, first: Document, json: string): Opened {
  try {
    const { shot, trace } = held(engine, json);
    engine.shot(shot).free();
    return {
      ...nothing({ ...first, shot }),
      then: (store) => {
        if (trace) replay(store, trace, 0, false);
      },
    };
  } catch (error) {
    return { ...nothing(first), then: (store) => store.refuse(notOpened(error)) };
  }
}

function nothing(first: Document): Opened {
  return { document: first, view: FIRST_VIEW, welcome: false, then: () => undefined };
}

/** What the address carries; null if nothing. A link that cannot be opened is refused in words. */
function openedByLink(engine: Engine, first: Document): Opened | null {
  try {
    const link = openedByAddress();
    if (!link) return null;
    const { document, view, time } = link;
    referee(engine).shot(document.shot, document.game).free();
    return { document, view, welcome: false, then: (store) => showInstant(store, engine, time) };
  } catch (error) {
    if (!(error instanceof LinkError || error instanceof CaromError)) throw error;
    const { message } = error;
    return { ...nothing(first), then: (store) => store.refuse(message) };
  }
}
