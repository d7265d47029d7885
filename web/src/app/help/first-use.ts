/** The first steps: a short guide beside the table. The page stores nothing about it. */

import { h, setText } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";

const STEPS = ["steps.0", "steps.1", "steps.2", "steps.3"] as const;

/** @returns A function that shows the steps again. */
export function mountFirstUse(root: HTMLElement, store: Store, welcome: boolean): () => void {
  let step = 0;
  const text = h("p", {});
  const count = h("span", { class: "hint" });
  const next = h("button", { type: "button", class: "button" }, t("steps.next"));
  const skip = h("button", { type: "button", class: "button plain" }, t("steps.skip"));
  const card = h(
    "section",
    { class: "card", "aria-label": t("steps.title") },
    text,
    h("div", { class: "row" }, count, skip, next),
  );
  root.append(card);

  function show(): void {
    const last = step === STEPS.length - 1;
    const key = STEPS[step];
    setText(text, key ? t(key) : "");
    setText(count, t("steps.count", { step: step + 1, steps: STEPS.length }));
    setText(next, t(last ? "steps.done" : "steps.next"));
    skip.hidden = last;
    card.hidden = step >= STEPS.length;
  }
  next.addEventListener("click", () => {
    step += 1;
    show();
    if (card.hidden) document.getElementById("table")?.focus();
  });
  const dismiss = () => {
    step = STEPS.length;
    show();
  };
  skip.addEventListener("click", () => {
    dismiss();
    document.getElementById("table")?.focus();
  });
  // A user who shoots needs no guide.
  store.subscribe((now, before) => {
    if (now.session.mode !== before.session.mode) dismiss();
  });
  if (!welcome) step = STEPS.length;
  show();
  return () => {
    step = 0;
    show();
    next.focus();
  };
}
