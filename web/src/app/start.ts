/**
 * What the page opens with: what it showed before it loaded again, or the document embedded in it, or the
 * link in its address, or a first shot.
 */

import { CaromError, type Engine, type ShotFile } from "../engine/index.ts";
import { playThenAim } from "./aim/autoplay.ts";
import type { Context } from "./common/context.ts";
import { errorText } from "./common/refusals.ts";
import { inSlices, type Slices } from "./common/slices.ts";
import { treeEngine } from "./document/balls-after.ts";
import { FIRST_VIEW, type Document, type View } from "./document/document.ts";
import { positionOf } from "./document/lesson.ts";
import { cannotOpen, documentOf, readFile } from "./document/shot-file.ts";
import type { Store } from "./document/store.ts";
import { isMatchText } from "./game/recorded/match-game.ts";
import { openMatch } from "./game/recorded/match-list.ts";
import { LESSONS } from "./help/lessons.ts";
import { hasSeenOpening } from "./help/opening.ts";
import { isStudyText } from "./library/library-panel.ts";
import { replay } from "./replay/replay-control.ts";
import { type LinkContents, readAddress, showTime } from "./share/address.ts";
import { LinkError } from "./share/link.ts";
import { isReload, takeKept, wasSilent } from "./share/reload.ts";
import { t } from "./words/translate.ts";

export interface Start {
  readonly document: Document;
  readonly view: View;
  /** Whether to begin with the first steps: the page was opened for the first time, without a document. */
  readonly welcome: boolean;
  /** Whether the page was opened at its plain address, so that it can offer what was kept. */
  readonly isPlain: boolean;
  /**
   * What the page shows after it was loaded again: "whole", the document of before without its history;
   * "lost", another one. Null: it was not loaded again.
   */
  readonly reload: "whole" | "lost" | null;
  /** Runs once the page is mounted: shows a replay, or reports what could not be opened. */
  begin(store: Store, context: Context): void;
}

/** The first shot without the first steps: their first one, aimed at the pocket. */
const FIRST_SHOT: ShotFile = {
  ...LESSONS[0]!.shot,
  strike: { ball: "cue", speed: 2, azimuth_deg: 66.8, height: -0.2 },
};

/** A start without what a reload tells. */
type Shown = Omit<Start, "reload">;

export async function startOf(engine: Engine): Promise<Start> {
  const kept = await fromLink(engine, documentOf(FIRST_SHOT), takeKept);
  if (kept) return { ...kept, reload: "whole" };
  return { ...(await firstOf(engine)), reload: isReload() ? "lost" : null };
}

async function firstOf(engine: Engine): Promise<Shown> {
  const first = documentOf(FIRST_SHOT);
  const element = document.getElementById("carom-document");
  const embedded = element?.textContent.trim() ?? "";
  const plays = element?.dataset.play !== undefined;
  if (isMatchText(embedded)) return ofMatch(first, embedded);
  if (isStudyText(embedded)) return ofStudy(engine, first, embedded);
  if (embedded !== "") return fromEmbedded(engine, first, embedded, plays);
  const linked = await fromLink(engine, first, readAddress);
  if (linked) return linked;
  if (hasSeenOpening()) return { ...showing(first), isPlain: true };
  return { ...showing(documentOf(LESSONS[0]!.shot)), welcome: true, isPlain: true };
}

/**
 * The document embedded in the page. It is the first one, so undo cannot leave it.
 *
 * @param plays Whether a trace plays at once; otherwise its replay waits at the start.
 */
function fromEmbedded(engine: Engine, first: Document, json: string, plays: boolean): Shown {
  try {
    const { shot, trace, filmed } = readFile(engine, json);
    engine.shot(shot).free();
    return {
      ...showing({ ...first, shot, filmed }),
      begin: (store, context) => {
        if (trace && plays) playThenAim(store, context, trace);
        else if (trace) replay(store, trace, 0, false);
      },
    };
  } catch (error) {
    if (!(error instanceof CaromError || error instanceof SyntaxError)) console.error(error);
    return refusing(first, cannotOpen(error, json));
  }
}

/** The study that is embedded in the page, at its first chapter. */
function ofStudy(engine: Engine, first: Document, text: string): Shown {
  try {
    const study = engine.study(text);
    const position = positionOf(study.chapters[0]!, treeEngine(engine).endOf);
    const begin = (store: Store) => {
      store.setSession({ lesson: { study, chapter: 0, id: null }, activity: "library" });
    };
    return { ...showing({ ...first, ...position }), begin };
  } catch (error) {
    if (!(error instanceof CaromError)) console.error(error);
    return refusing(first, cannotOpen(error, text));
  }
}

/** Opens the match that is embedded in the page, once the page is mounted. */
function ofMatch(first: Document, text: string): Shown {
  const begin = (store: Store, context: Context) => {
    void openMatch(store, context, text).catch((error: unknown) => {
      if (!(error instanceof CaromError)) console.error(error);
      store.refuse(cannotOpen(error, ""));
    });
  };
  return { ...showing(first), begin };
}

/** The link that `read` finds; null if there is none. */
async function fromLink(
  engine: Engine,
  first: Document,
  read: (engine: Engine) => Slices<LinkContents | null>,
): Promise<Shown | null> {
  try {
    const contents = await inSlices(read(engine));
    if (!contents) return null;
    const { document, view, time, lesson } = contents;
    const begin = (store: Store) => {
      if (lesson) store.setSession({ lesson, activity: "library" });
      // A link may be opened anywhere; what was kept was here before.
      if (read === readAddress || wasSilent()) store.setPart("replay", { sound: false });
      showTime(store, engine, time);
    };
    return { document, view, welcome: false, isPlain: false, begin };
  } catch (error) {
    if (error instanceof LinkError) return refusing(first, error.message);
    // Our own bug must not leave the user with an empty page.
    console.error(error);
    return refusing(first, t("link.refused", { why: errorText(error) }));
  }
}

function showing(document: Document): Shown {
  return {
    document,
    view: FIRST_VIEW,
    welcome: false,
    isPlain: false,
    begin: () => undefined,
  };
}

function refusing(first: Document, message: string): Shown {
  return { ...showing(first), begin: (store) => store.refuse(message) };
}
