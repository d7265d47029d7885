/** What the page opens with: the document embedded in it, or the link in its address, or a first shot. */

import { CaromError, type Engine, type ShotFile } from "../engine/index.ts";
import { playThenAim } from "./aim/autoplay.ts";
import type { Context } from "./common/context.ts";
import { errorText } from "./common/words.ts";
import { FIRST_VIEW, type Document, type View } from "./document/document.ts";
import { cannotOpen, documentOf, readFile } from "./document/file.ts";
import type { Store } from "./document/store.ts";
import { replay } from "./replay/control.ts";
import { readAddress, showTime } from "./share/address.ts";
import { LinkError } from "./share/link.ts";

export interface Start {
  readonly document: Document;
  readonly view: View;
  /** Whether to show the first steps: the page was opened without a document or a link. */
  readonly welcome: boolean;
  /** Runs once the page is mounted: shows a replay, or reports what could not be opened. */
  then(store: Store, context: Context): void;
}

/** The first shot: a cut into a corner pocket, with two more balls for the next shots. */
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

export function startOf(engine: Engine): Start {
  const first = documentOf(FIRST_SHOT);
  const element = document.getElementById("carom-document");
  const embedded = element?.textContent.trim() ?? "";
  const plays = element?.dataset.play !== undefined;
  if (embedded !== "") return fromEmbedded(engine, first, embedded, plays);
  return fromAddress(engine, first) ?? { ...showing(first), welcome: true };
}

/**
 * The document embedded in the page. It is the first one, so undo cannot leave it.
 *
 * @param plays Whether a trace plays at once; otherwise its replay waits at the start.
 */
function fromEmbedded(engine: Engine, first: Document, json: string, plays: boolean): Start {
  try {
    const { shot, trace } = readFile(engine, json);
    engine.shot(shot).free();
    return {
      ...showing({ ...first, shot }),
      then: (store, context) => {
        if (trace && plays) playThenAim(store, context, trace);
        else if (trace) replay(store, trace, 0, false);
      },
    };
  } catch (error) {
    if (!(error instanceof CaromError || error instanceof SyntaxError)) console.error(error);
    return refusing(first, cannotOpen(error));
  }
}

/** The link in the address; null if there is none. */
function fromAddress(engine: Engine, first: Document): Start | null {
  try {
    const contents = readAddress(engine);
    if (!contents) return null;
    const { document, view, time } = contents;
    const then = (store: Store) => {
      // A link may be opened anywhere.
      store.setSession({ sound: false });
      showTime(store, engine, time);
    };
    return { document, view, welcome: false, then };
  } catch (error) {
    if (error instanceof LinkError) return refusing(first, error.message);
    // Our own bug must not leave the user with an empty page.
    console.error(error);
    return refusing(first, `This link cannot be opened. ${errorText(error)}`);
  }
}

function showing(document: Document): Start {
  return { document, view: FIRST_VIEW, welcome: false, then: () => undefined };
}

function refusing(first: Document, message: string): Start {
  return { ...showing(first), then: (store) => store.refuse(message) };
}
