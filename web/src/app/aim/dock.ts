/** Below the table: the predicted outcome of the shot, and the button that plays it. */

import type { Context } from "../common/context.ts";
import { h, icon, setText, shortened } from "../common/dom.ts";
import { raiseTheCue } from "../document/strike.ts";
import { canAim } from "../game/play.ts";
import type { Store } from "../document/store.ts";
import { obstruction, summary } from "../common/words.ts";
import { firstContact } from "../pot/contact.ts";
import { lockText } from "../pot/words.ts";
import { shoot, takeItFromHere } from "./shoot.ts";
import { paragraph, t } from "../words/translate.ts";

/** Time (ms) without a change after which the outcome is read to screen readers. */
const REST = 600;

export function mountDock(root: HTMLElement, store: Store, context: Context): void {
  const text = h("p", { class: "outcome", id: "outcome" });
  const warning = h("p", { class: "warning" });
  const remedy = h(
    "button",
    { type: "button", class: "button", onclick: () => raiseTheCue(store) },
    t("aim.raise"),
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
    t("aim.shoot"),
  );
  const spoken = h("p", { class: "unseen", role: "status", "aria-live": "polite" });
  root.append(
    h("div", { class: "outcome-text" }, text, h("div", { class: "row" }, warning, remedy)),
    button,
    spoken,
  );

  let timer: ReturnType<typeof setTimeout> | undefined;

  function show(): void {
    root.hidden = !canAim(store, context.engine);
    if (store.session.mode !== "aim" || root.hidden) return;
    const { trace, error } = store.ghost;
    const { lock } = store.session;
    const aim = lock && trace ? lockText(lock, firstContact(trace)) : "";
    const obstacle = trace ? obstruction(trace.outcome) : null;
    setText(text, trace ? paragraph([aim, ...summary(trace)]) : (error ?? ""));
    setText(warning, obstacle ?? "");
    warning.hidden = obstacle === null;
    remedy.hidden = obstacle === null || trace?.outcome.least_elevation_deg === null;
    button.setAttribute("aria-disabled", String(trace === null));
    clearTimeout(timer);
    timer = setTimeout(() => {
      setText(spoken, paragraph([text.textContent, obstacle ?? ""]));
    }, REST);
  }
  // At most once per frame.
  store.subscribe((now, before) => {
    const isSame =
      now.document === before.document &&
      now.session.mode === before.session.mode &&
      now.session.lock === before.session.lock;
    if (!isSame) context.loop.input(root, show);
  });
  show();
}

/** The button that continues from the end of the replay, beside the one that ends the replay. */
export function mountTake(back: HTMLElement, store: Store, context: Context): void {
  const onclick = () => {
    takeItFromHere(store, context);
  };
  const name = t("aim.take");
  const attributes = { type: "button", class: "button", id: "take-it", "aria-label": name };
  const take = h("button", { ...attributes, onclick }, ...shortened(name, t("aim.take-short")));
  back.before(take);
  store.subscribe(({ document }) => {
    take.hidden = document.game !== null;
  });
}
