/** First steps, beside the table: short, to be dismissed, and kept nowhere but in this page. */

import { h, setText } from "../common/dom.ts";
import type { Store } from "../document/store.ts";

const STEPS: readonly string[] = [
  "Drag on the cloth to turn the cue. The lines show what will happen, all the way.",
  "Click the ball’s face for spin; set speed and elevation beside the table.",
  "Shoot, then scrub through the replay, or take it from where the balls end.",
  "Drag balls to move them. Undo takes back everything.",
];

/** @returns Shows the steps again. */
export function mountFirstUse(root: HTMLElement, store: Store, welcome: boolean): () => void {
  let step = 0;
  const text = h("p", {});
  const count = h("span", { class: "hint" });
  const next = h("button", { type: "button", class: "button" }, "Next");
  const skip = h("button", { type: "button", class: "button plain" }, "Skip");
  const card = h(
    "section",
    { class: "card", "aria-label": "First steps" },
    text,
    h("div", { class: "row" }, count, skip, next),
  );
  root.append(card);

  function show(): void {
    const last = step === STEPS.length - 1;
    setText(text, STEPS[step] ?? "");
    setText(count, `${step + 1} of ${STEPS.length}`);
    setText(next, last ? "Done" : "Next");
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
  // Who shoots has understood.
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
