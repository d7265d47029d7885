/** The keys of a lesson: PageDown and PageUp go to the next and the previous chapter. */

import type { Store } from "../document/store.ts";
import type { LessonRun } from "./lesson-run.ts";

const STEPS: Readonly<Record<string, number>> = { PageDown: 1, PageUp: -1 };

/** Elements that use these keys themselves. */
const OWN = "input, textarea, select, [role=slider], dialog";

export function mountLessonKeys(store: Store, run: LessonRun): void {
  addEventListener("keydown", (event) => {
    const step = STEPS[event.key];
    const { lesson } = run;
    if (step === undefined || !lesson || store.session.activity !== "library") return;
    if (event.defaultPrevented || (event.target as Element).closest(OWN)) return;
    run.go(lesson.chapter + step);
    event.preventDefault();
  });
}
