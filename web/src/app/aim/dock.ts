/** Below the table: what would happen, and the button that makes it happen. */

import type { Context } from "../common/context.ts";
import { h, icon, setText, shortened } from "../common/dom.ts";
import { raiseTheCue } from "../document/strike.ts";
import { canAim } from "../game/play.ts";
import type { Store } from "../document/store.ts";
import { obstruction, summary } from "../common/words.ts";
import { shoot, takeItFromHere } from "./shoot.ts";

/** Screen readers are told once the aim has rested this long (ms), not at every pixel of a drag. */
const QUIET = 600;

export function mountDock(root: HTMLElement, store: Store, context: Context): void {
  const text = h("p", { class: "outcome", id: "outcome" });
  const warning = h("p", { class: "warning" });
  const remedy = h(
    "button",
    { type: "button", class: "button", onclick: () => raiseTheCue(store) },
    "Raise the cue",
  );
  const button = h(
    "button",
    {
      type: "button",
      class: "button primary shoot",
      id: "shoot-button",
      onclick: () => shoot(store, context),
    },
    icon("M5 19L15 9M15 9l4-4M17 3l4 4"),
    "Shoot",
  );
  const aloud = h("p", { class: "unseen", role: "status", "aria-live": "polite" });
  root.append(
    h("div", { class: "told" }, text, h("div", { class: "row" }, warning, remedy)),
    button,
    aloud,
  );

  let timer: ReturnType<typeof setTimeout> | undefined;

  function show(): void {
    root.hidden = !canAim(store, context.engine);
    if (store.session.mode !== "aim" || root.hidden) return;
    const { trace, error } = store.ghost;
    const obstacle = trace ? obstruction(trace.outcome) : null;
    setText(text, trace ? summary(trace).join(" ") : (error ?? ""));
    setText(warning, obstacle ?? "");
    warning.hidden = obstacle === null;
    remedy.hidden = obstacle === null || trace?.outcome.least_elevation_deg === null;
    button.setAttribute("aria-disabled", String(trace === null));
    clearTimeout(timer);
    timer = setTimeout(() => {
      setText(aloud, [text.textContent, obstacle].filter(Boolean).join(" "));
    }, QUIET);
  }
  // Once per frame, however many changes there were.
  store.subscribe((now, before) => {
    if (now.document === before.document && now.session.mode === before.session.mode) return;
    context.loop.input(root, show);
  });
  show();
}

/** The way on from a replay, beside the way back. */
export function mountTake(back: HTMLElement, store: Store, context: Context): void {
  const onclick = () => {
    takeItFromHere(store, context);
  };
  const name = "Take it from here";
  const attributes = { type: "button", class: "button", id: "take-it", "aria-label": name };
  const take = h("button", { ...attributes, onclick }, ...shortened(name, "From here"));
  back.before(take);
  store.subscribe(({ document }) => {
    take.hidden = document.game !== null;
  });
}
