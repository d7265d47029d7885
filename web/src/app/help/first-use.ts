/** The first steps: a short guide beside the table. The page stores nothing about it. */

import { h, setText } from "../common/dom.ts";
import type { Store } from "../document/store.ts";

const STEPS: readonly string[] = [
  "Drag on the cloth to turn the cue. The lines show the whole shot.",
  "Under Aim, click the ball for English, follow or draw; set speed and elevation below it.",
  "Press Shoot, then move through the replay, or continue from where the balls stop.",
  "Drag a ball to move it. Undo takes back every change.",
];

/** @returns A function that shows the steps again. */
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
