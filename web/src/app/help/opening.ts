/**
 * The first steps: two shots on the table, with a line beside Shoot that says what to do. A ball that is moved
 * makes them wait until it is back. They end when the user does something else, and do not come again by
 * themselves once they are done or skipped.
 */

import type { Trace } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { arc } from "../common/arc.ts";
import { h } from "../common/dom.ts";
import { hasFlag, setFlag } from "../common/flag.ts";
import type { Attempt } from "../document/document.ts";
import type { Store } from "../document/store.ts";
import { leave } from "../replay/replay-control.ts";
import { paragraph, t } from "../words/translate.ts";
import { isDone, type Lesson, LESSONS } from "./lessons.ts";

/** Name in the browser's storage under which it is kept that the first steps were seen. */
const SEEN = "carom-first-steps";

/** Time (ms) between the end of a replay and the next step: enough to see where the balls stopped. */
const PAUSE = 1200;

const COLOR = "#ffffff";

/** Whether the first steps were done or skipped in this browser. */
export function hasSeenOpening(): boolean {
  // A page in a frame may have no storage: its reader has come for something else.
  return hasFlag("localStorage", SEEN, true);
}

/**
 * @param shoot The button that plays the shot; the one that skips the steps is beside it.
 * @param begins Whether the page opens with the first step, whose shot is the present one.
 * @returns A function that begins the steps again.
 */
export function mountOpening(
  shoot: HTMLElement,
  store: Store,
  context: Context,
  begins: boolean,
): () => void {
  let step = -1;
  let attempt: Attempt | null = null;
  let judged: Trace | null = null;
  /** Whether the balls of the step were moved; Undo brings them back. */
  let waits = false;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const skip = h("button", { type: "button", class: "button", onclick: end }, t("steps.skip"));
  const region = h("section", { class: "steps", "aria-label": t("steps.title") }, skip);
  shoot.before(region);

  function show(): void {
    const isShown = step >= 0 && !waits;
    region.hidden = !isShown;
    // The button has the place of the chance.
    document.body.toggleAttribute("data-steps", isShown);
  }

  /** @param isSet Whether the page shows the shot of the lesson already. */
  function begin(next: number, said = "", isSet = false): void {
    const lesson = LESSONS[next]!;
    // The changes that follow are not the user's.
    step = -1;
    if (!isSet) {
      store.setSession({ attempt: null, lock: null });
      store.apply({ shot: lesson.shot, game: null }, t("steps.title"));
    }
    waits = false;
    attempt = attemptOf(lesson, said);
    store.setSession({ attempt, activity: "analyse" });
    step = next;
    show();
  }

  function end(): void {
    clearTimeout(timer);
    step = -1;
    waits = false;
    if (store.session.attempt === attempt) store.setSession({ attempt: null });
    attempt = null;
    setFlag("localStorage", SEEN, true);
    show();
    document.getElementById("table")?.focus();
  }

  /** Hides the step while its balls lie elsewhere, and shows it again when they are back. */
  function wait(now: boolean): void {
    if (now === waits) return;
    waits = now;
    store.setSession({ attempt: now ? null : attempt });
    show();
    if (now) context.announce(t("steps.wait"));
  }

  function judge(trace: Trace): void {
    const lesson = LESSONS[step]!;
    if (!isDone(lesson, trace)) {
      if (store.session.mode === "replay") leave(store);
      attempt = attemptOf(lesson, t("steps.again"));
      store.setSession({ attempt });
    } else if (step + 1 < LESSONS.length) {
      begin(step + 1, t("steps.well-done"));
    } else {
      if (store.session.mode === "replay") leave(store);
      end();
      context.announce(t("steps.end"));
    }
  }

  store.subscribe(({ session, document: now }, before) => {
    if (step < 0) return;
    const { trace, playing, time } = session.replay;
    const { mode } = session;
    const isOther =
      session.attempt !== (waits ? null : attempt) ||
      session.activity !== "analyse" ||
      now.game !== null;
    if (isOther && mode === "aim") {
      end();
      return;
    }
    if (mode === "aim") wait(now.shot.balls !== LESSONS[step]!.shot.balls);
    if (waits) return;
    if (!trace) {
      judged = null;
      clearTimeout(timer);
    } else if (!playing && time >= trace.duration && trace !== judged) {
      judged = trace;
      timer = setTimeout(() => {
        if (store.session.replay.trace === trace) judge(trace);
      }, PAUSE);
    } else if (playing && !before.session.replay.playing) {
      // Played again from its end.
      judged = null;
      clearTimeout(timer);
    }
  });
  if (begins) begin(0, "", true);
  show();
  return () => {
    begin(0);
  };
}

function attemptOf({ text, pocket, circle }: Lesson, said: string): Attempt {
  return {
    text: paragraph([said, t(text)]),
    areas: circle ? [{ outline: arc(circle.center, circle.radius), color: COLOR }] : [],
    pocket,
    errors: null,
    seed: 0,
  };
}
