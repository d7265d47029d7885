/** The Train tab: the drills and the puzzle of the day, a drill in detail, a drill in progress, the sheet. */

import "./train.css";
import type { Context } from "../common/context.ts";
import { h } from "../common/dom.ts";
import type { Opener } from "../share/open-files.ts";
import type { Store } from "../document/store.ts";
import { mountDetail } from "./drill-detail.ts";
import { mountOverview } from "./train-overview.ts";
import type { Page, Trainer } from "./train-parts.ts";
import { mountKept } from "./kept-practice.ts";
import { Practice } from "./practice.ts";
import { browserBox } from "./progress/earlier-progress.ts";
import { Keeper, type ProgressStorage } from "./progress/progress-keeper.ts";
import { mountOwnForm } from "./own/own-drill-form.ts";
import { isDrillText, mountDrillLinks, openDrill } from "./own/open-drill.ts";
import { mountRun } from "./practice-run.ts";
import { mountSheetForm } from "./sheet-form.ts";

/**
 * @param storage Where the progress is kept; null if the page keeps nothing.
 * @returns What is practised, the progress, and what opens the file of a drill.
 */
export function mountTrain(
  root: HTMLElement,
  store: Store,
  context: Context,
  storage: ProgressStorage | null,
): Pick<Trainer, "practice" | "keeper"> & { readonly openDrillFile: Opener } {
  const keeper = new Keeper(storage, browserBox());
  const practice = new Practice(store, context, keeper);
  let page: Page = { kind: "overview" };
  const trainer: Trainer = {
    store,
    context,
    keeper,
    practice,
    go: (to) => {
      page = to;
      show(true);
    },
  };
  let shown = "";

  /** @param moves Whether the focus goes to the top of the page. */
  function show(moves: boolean): void {
    const content = h("div", { class: "train" });
    const kind = practice.running ? "run" : page.kind;
    if (practice.running) mountRun(content, trainer, practice.running);
    else if (page.kind === "drill") mountDetail(content, trainer, page.drill);
    else if (page.kind === "sheet") mountSheetForm(content, trainer);
    else if (page.kind === "own") mountOwnForm(content, trainer, page.draft);
    else mountOverview(content, trainer);
    const focused = focusedId(root);
    root.replaceChildren(content);
    const isOther = kind !== shown;
    shown = kind;
    if (isOther) root.scrollTop = 0;
    const heading = root.querySelector<HTMLElement>("h2");
    if (focused !== null) (root.querySelector<HTMLElement>(`#${focused}`) ?? heading)?.focus();
    else if (moves) heading?.focus();
  }

  practice.subscribe(() => show(false));
  // The pictures of the drills take long: another tab does without them.
  keeper.subscribe(() => {
    if (!practice.running && store.session.activity === "train") show(false);
  });
  if (storage) shareWithTabs(keeper);
  store.subscribe((now, before) => {
    if (now.session.activity !== before.session.activity && now.session.activity === "train") {
      show(false);
    }
  });
  mountKept(practice, store, context.engine);
  if (store.session.activity === "train") show(false);
  // The drill of a link gets a name that no kept one has.
  void keeper.ready.then(() => mountDrillLinks(trainer));
  const openDrillFile: Opener = ({ text }) => {
    if (!isDrillText(text)) return null;
    openDrill(trainer, text);
    return Promise.resolve();
  };
  return { practice, keeper, openDrillFile };
}

/** Shows what another tab has stored, and tells the others what this one has. */
function shareWithTabs(keeper: Keeper): void {
  const channel = new BroadcastChannel("carom-progress");
  keeper.onStored = () => channel.postMessage(null);
  channel.addEventListener("message", () => void keeper.refresh());
}

/** The id of the element in a root that has the focus; "" if it has none, null without focus. */
function focusedId(root: HTMLElement): string | null {
  const { activeElement } = document;
  return activeElement && root.contains(activeElement) ? activeElement.id || "none" : null;
}
