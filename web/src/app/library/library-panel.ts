/** The Library tab: the list of what is kept, or the study that is open. */

import "./library.css";
import { CaromError } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { errorText } from "../common/refusals.ts";
import type { Store } from "../document/store.ts";
import type { Library } from "../kept/library.ts";
import type { Opener } from "../share/open-files.ts";
import { t } from "../words/translate.ts";
import { mountLessonKeys } from "./lesson-keys.ts";
import { LessonRun } from "./lesson-run.ts";
import { LessonView } from "./lesson-view.ts";
import { LibraryList } from "./library-list.ts";
import { StudyShelf } from "./study-shelf.ts";

/**
 * @param parts The library, null where the page keeps nothing; and what ends a drill.
 * @returns Opens files of studies.
 */
export function mountLibrary(
  root: HTMLElement,
  store: Store,
  context: Context,
  {
    library,
    leavePractice,
  }: { readonly library: Library | null; readonly leavePractice: () => void },
): Opener {
  const run = new LessonRun(store, context, leavePractice);
  const shelf = new StudyShelf(store, context, run, library);
  const list = new LibraryList(store, context, shelf, library);
  const view = new LessonView(store, context, run, shelf);
  const show = (): void => {
    const isLesson = run.lesson !== null;
    const isOther = view.element.hidden === isLesson;
    const hadFocus = root.contains(document.activeElement);
    list.element.hidden = isLesson;
    view.element.hidden = !isLesson;
    if (store.session.activity !== "library") return;
    if (isLesson) view.show();
    else void list.show();
    // The button that was pressed is hidden now.
    if (isOther && hadFocus) {
      root.querySelector<HTMLElement>(isLesson ? "#lesson h2" : "#library-list h2")?.focus();
    }
  };
  view.element.hidden = true;
  root.append(list.element, view.element);
  run.subscribe(show);
  shelf.subscribe(show);
  store.subscribe(({ session, document: now }, before) => {
    // A reload has opened it.
    const isNew = session.lesson !== before.session.lesson && session.lesson?.id != null;
    if (isNew && !shelf.isOwn) void shelf.findOwn();
    const isOther =
      session.activity !== before.session.activity ||
      session.lesson !== before.session.lesson ||
      session.mode !== before.session.mode ||
      session.orientation !== before.session.orientation ||
      now !== before.document;
    if (isOther) show();
  });
  mountLessonKeys(store, run);
  show();
  return ({ name, text }) => {
    if (!isStudyText(text)) return null;
    return Promise.resolve().then(() => {
      try {
        run.open(context.engine.study(text), null);
        context.announce(t("open.opened", { file: name }));
      } catch (error) {
        if (!(error instanceof CaromError)) throw error;
        store.refuse(t("library.refused", { file: name, why: errorText(error) }));
      }
    });
  };
}

/** Whether a text is the file of a study, damaged or not. */
export function isStudyText(text: string): boolean {
  if (!text.includes('"carom-study/')) return false;
  try {
    const file = JSON.parse(text) as { readonly format?: unknown } | null;
    return typeof file?.format === "string" && file.format.startsWith("carom-study/");
  } catch {
    return false;
  }
}
