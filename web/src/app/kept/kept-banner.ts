/** Over the table: what can be continued after the page was opened, and why nothing is kept. */

import "./kept-views.css";
import type { Context } from "../common/context.ts";
import { button, h } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { dateAndTime, t } from "../words/translate.ts";
import type { Work } from "./kept-work.ts";
import { workText } from "./kept-words.ts";
import type { WorkKeeper } from "./work-keeper.ts";

/** @param offers Whether to offer what can be continued: the page was opened without anything to show. */
export function mountKeptBanner(
  stage: HTMLElement,
  store: Store,
  context: Context,
  keeper: WorkKeeper,
  offers: boolean,
): void {
  const banner = h("section", {
    class: "kept-banner",
    id: "kept-banner",
    "aria-label": t("kept.offer"),
    hidden: true,
  });
  stage.append(banner);
  const close = (): void => {
    banner.hidden = true;
    banner.replaceChildren();
  };
  const closeButton = () => {
    const name = t("kept.close");
    const one = button("×", close, "plain");
    one.classList.add("close");
    one.setAttribute("aria-label", name);
    one.title = name;
    return one;
  };
  const say = (sentence: string): void => {
    banner.replaceChildren(h("p", { role: "alert" }, sentence), closeButton());
    banner.hidden = false;
  };
  const { storage } = keeper;
  storage.subscribe(() => {
    if (storage.fault) say(t(`kept.fault-${storage.fault}`));
  });
  if (storage.fault) say(t(`kept.fault-${storage.fault}`));
  if (!offers) return;
  const first = store.document;
  void keeper.works(1).then(({ works, damaged }) => {
    // Tests wait for this mark before they say that nothing is offered.
    performance.mark("carom:offers");
    // The user was faster.
    if (store.document !== first || !banner.hidden) return;
    if (damaged.length > 0) say(t("kept.damaged", { count: damaged.length }));
    if (works.length === 0) return;
    const row = (work: Work, k: number) =>
      continueButton(work, context, k === 0 ? "primary" : "", () => void keeper.open(work));
    banner.prepend(h("p", {}, t("kept.offer")), ...works.map(row));
    if (damaged.length === 0) banner.append(closeButton());
    banner.hidden = false;
    const end = store.subscribe((now, before) => {
      if (now.document === before.document) return;
      end();
      close();
    });
  });
}

/** A button that continues a work. */
export function continueButton(
  work: Work,
  { engine }: Pick<Context, "engine">,
  kind: string,
  onclick: () => void,
): HTMLElement {
  const what = workText(engine, work);
  const one = button("", onclick, `continue ${kind}`.trim());
  one.append(
    h("strong", {}, t("kept.continue")),
    h("span", {}, what),
    h("span", { class: "when" }, dateAndTime(new Date(work.changed))),
  );
  return one;
}
