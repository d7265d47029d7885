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
import type { Attempt, Session } from "../document/document.ts";
import type { State, Store } from "../document/store.ts";
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
  const steps = new FirstSteps(shoot, store, context);
  store.subscribe((now, before) => steps.follow(now, before));
  if (begins) steps.begin(0, "", true);
  return () => steps.begin(0);
}

class FirstSteps {
  readonly #store: Store;
  readonly #context: Context;
  readonly #region: HTMLElement;
  /** Index of the lesson; negative: none. */
  #step = -1;
  #attempt: Attempt | null = null;
  #judged: Trace | null = null;
  /** Whether the balls of the step were moved; Undo brings them back. */
  #waits = false;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(shoot: HTMLElement, store: Store, context: Context) {
    this.#store = store;
    this.#context = context;
    const onclick = () => this.#end();
    const skip = h("button", { type: "button", class: "button", onclick }, t("steps.skip"));
    this.#region = h("section", { class: "steps", "aria-label": t("steps.title") }, skip);
    shoot.before(this.#region);
    this.#show();
  }

  #show(): void {
    const isShown = this.#step >= 0 && !this.#waits;
    this.#region.hidden = !isShown;
    // The button has the place of the chance.
    document.body.toggleAttribute("data-steps", isShown);
  }

  /** @param isSet Whether the page shows the shot of the lesson already. */
  begin(next: number, said = "", isSet = false): void {
    const lesson = LESSONS[next]!;
    // The changes that follow are not the user's.
    this.#step = -1;
    if (!isSet) {
      this.#store.setSession({ attempt: null, lock: null });
      this.#store.apply({ shot: lesson.shot, game: null }, t("steps.title"));
    }
    this.#waits = false;
    this.#attempt = attemptOf(lesson, said);
    this.#store.setSession({ attempt: this.#attempt, activity: "analyse" });
    this.#step = next;
    this.#show();
  }

  #end(): void {
    clearTimeout(this.#timer);
    this.#step = -1;
    this.#waits = false;
    if (this.#store.session.attempt === this.#attempt) this.#store.setSession({ attempt: null });
    this.#attempt = null;
    setFlag("localStorage", SEEN, true);
    this.#show();
    document.getElementById("table")?.focus();
  }

  /** Hides the step while its balls lie elsewhere, and shows it again when they are back. */
  #wait(now: boolean): void {
    if (now === this.#waits) return;
    this.#waits = now;
    this.#store.setSession({ attempt: now ? null : this.#attempt });
    this.#show();
    if (now) this.#context.announce(t("steps.wait"));
  }

  #judge(trace: Trace): void {
    const lesson = LESSONS[this.#step]!;
    const isRight = isDone(lesson, trace);
    if (isRight && this.#step + 1 < LESSONS.length) {
      this.begin(this.#step + 1, t("steps.well-done"));
      return;
    }
    if (this.#store.session.mode === "replay") leave(this.#store);
    if (isRight) {
      this.#end();
      this.#context.announce(t("steps.end"));
    } else {
      this.#attempt = attemptOf(lesson, t("steps.again"));
      this.#store.setSession({ attempt: this.#attempt });
    }
  }

  follow({ session, document: now }: State, before: State): void {
    if (this.#step < 0) return;
    if (session.mode === "aim") {
      const isOther =
        session.attempt !== (this.#waits ? null : this.#attempt) ||
        session.activity !== "analyse" ||
        now.game !== null;
      if (isOther) {
        this.#end();
        return;
      }
      this.#wait(now.shot.balls !== LESSONS[this.#step]!.shot.balls);
    }
    if (!this.#waits) this.#followReplay(session.replay, before.session.replay);
  }

  /** Judges a shot some time after its replay has ended. */
  #followReplay({ trace, playing, time }: Session["replay"], before: Session["replay"]): void {
    if (trace && !playing && time >= trace.duration && trace !== this.#judged) {
      this.#judged = trace;
      this.#timer = setTimeout(() => {
        if (this.#store.session.replay.trace === trace) this.#judge(trace);
      }, PAUSE);
    } else if (!trace || (playing && !before.playing)) {
      // Also when it is played again from its end.
      this.#judged = null;
      clearTimeout(this.#timer);
    }
  }
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
