/** Below the table: the predicted outcome of the shot, and the button that plays it. */

import type { Trace } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { focusWhileScrolling, h, icon, setText, shortened } from "../common/dom.ts";
import { shownGuide } from "../document/guide-extent.ts";
import { azimuthToBall, raiseTheCue } from "../document/strike-changes.ts";
import { azimuthOf } from "../document/strike-angles.ts";
import { wrongBall } from "../game/guide/foul-warning.ts";
import { guideText } from "../game/guide/guide-words.ts";
import { canAim } from "../game/awaited-turn.ts";
import type { Store } from "../document/store.ts";
import { playedName, obstruction, summary } from "../common/shot-words.ts";
import { isObjectBall } from "../pot/aim-with-snap.ts";
import { firstContact } from "../pot/first-contact.ts";
import { hitText, lockText } from "../pot/pot-words.ts";
import { drawFace, spokenOffset } from "./cue-ball-face.ts";
import { mountPower } from "./power-bar.ts";
import { shoot, takeItFromHere } from "./shoot.ts";
import { paragraph, t } from "../words/translate.ts";

/** Time (ms) without a change after which the outcome is read to screen readers. */
const REST = 600;

/** @param openAim Shows the panel with the tip and the other numbers of the strike. */
export function mountDock(
  root: HTMLElement,
  store: Store,
  context: Context,
  openAim: () => void,
): void {
  const text = h("p", { class: "outcome", id: "outcome" });
  const warning = h("p", { class: "warning" });
  const raise = () => raiseTheCue(store);
  const remedy = h("button", { type: "button", class: "button", onclick: raise }, t("aim.raise"));
  const button = shootButton(() => shoot(store, context));
  const spoken = h("p", { class: "unseen", role: "status", "aria-live": "polite" });
  const power = h("div", { class: "power" });
  mountPower(power, store, context);
  const said = h(
    "div",
    { class: "outcome-text" },
    text,
    h("div", { class: "row" }, warning, remedy),
  );
  focusWhileScrolling(said, text);
  root.append(
    said,
    h("div", { class: "strike" }, spinButton(store, openAim), power, button),
    spoken,
  );

  let timer: ReturnType<typeof setTimeout> | undefined;

  function show(): void {
    root.hidden = !canAim(store, context.engine);
    root.toggleAttribute("data-attempt", store.session.attempt !== null);
    if (store.session.mode !== "aim" || root.hidden) return;
    const { trace } = store.ghost;
    const obstacle = trace ? obstruction(trace.outcome) : null;
    const wrong = wrongBall(store, context.engine);
    const warnings = paragraph([wrong ?? "", obstacle ?? ""]);
    setText(text, outcomeText(store));
    setText(warning, warnings);
    warning.hidden = warnings === "";
    remedy.hidden = obstacle === null || trace?.outcome.least_elevation_deg === null;
    button.setAttribute("aria-disabled", String(trace === null));
    clearTimeout(timer);
    timer = setTimeout(() => {
      setText(spoken, paragraph([text.textContent, warnings]));
    }, REST);
  }
  // At most once per frame.
  store.subscribe((now, before) => {
    const isSame =
      now.document === before.document &&
      now.session.mode === before.session.mode &&
      now.session.orientation === before.session.orientation &&
      now.session.lock === before.session.lock &&
      now.session.selected === before.session.selected &&
      now.session.attempt === before.session.attempt;
    if (!isSame) context.loop.input(root, show);
  });
  show();
}

function outcomeText(store: Store): string {
  const { trace, error } = store.ghost;
  const said = trace ? predictionText(store, trace) : (error ?? "");
  return paragraph([store.session.attempt?.text ?? "", secondTap(store), said]);
}

/** What the shot will do, as far as the guide shows it. */
function predictionText(store: Store, trace: Trace): string {
  const { lock } = store.session;
  const guide = shownGuide(store);
  const contact = firstContact(trace);
  const aim = lock ? lockText(lock, contact) : "";
  const hit = !lock && contact ? hitText(contact) : "";
  if (guide === "full") return paragraph([aim, ...withHit(summary(trace), hit)]);
  return aim || guideText(trace, guide);
}

/** What a tap on a pocket does after one on a ball; empty if no ball is selected and aimed at. */
function secondTap(store: Store): string {
  const { selected, lock } = store.session;
  if (lock || !isObjectBall(store, selected) || store.shot.geometry.pockets.length === 0) return "";
  const isAimed = azimuthOf(store.document.shot.strike) === azimuthToBall(store, selected);
  return isAimed ? t("pot.tap-pocket", { ball: playedName(selected) }) : "";
}

/** The outcome, whose first sentence tells what is hit, with how it is hit. */
function withHit([first = "", ...rest]: readonly string[], hit: string): string[] {
  return [first, hit, ...rest];
}

function shootButton(onclick: () => void): HTMLButtonElement {
  const attributes = { type: "button", class: "button primary shoot", id: "shoot-button", onclick };
  return h("button", attributes, icon("M5 19L15 9M15 9l4-4M17 3l4 4"), t("aim.shoot"));
}

/** A small cue ball with the tip position; it opens the panel that changes it. */
function spinButton(store: Store, open: () => void): HTMLButtonElement {
  const { drawing, show } = drawFace();
  const button = h("button", { type: "button", class: "spin-button", onclick: open }, drawing);
  const follow = (): void => {
    const { side = 0, height = 0 } = store.document.shot.strike;
    show(store.shot.miscueLimit, [side, height]);
    button.setAttribute("aria-label", t("face.position", { offset: spokenOffset(side, height) }));
  };
  store.subscribe((now, before) => {
    if (now.document !== before.document) follow();
  });
  follow();
  return button;
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
