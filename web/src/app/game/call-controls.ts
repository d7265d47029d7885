/** The controls for calling a shot. */

import type { Call, ShotRequest } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { pocketName } from "../common/shot-words.ts";
import { announceCall, intendedCall, presentCall } from "./calling.ts";
import { askedShot } from "./awaited-turn.ts";
import { callInWords } from "./game-words.ts";
import { t } from "../words/translate.ts";

type Kind = ShotRequest["calls"][number];

/** Mounts the section; it is hidden if the game needs no call. */
export function mountCalls(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const kinds = h("div", { class: "row kinds", role: "group", "aria-label": t("call.group") });
  const [ball, ballLabel, ballRow] = labelledList("called-ball");
  const [pocket, pocketLabel, pocketRow] = labelledList("called-pocket");
  pocketLabel.textContent = t("call.called-pocket");
  const shown = h("button", { type: "button", class: "button" });
  const hint = h("p", { class: "hint" }, t("call.hint"));
  root.append(
    h("h2", {}, t("call.title")),
    kinds,
    h("div", { class: "pair halves" }, ballRow, pocketRow),
    h("div", { class: "row" }, shown),
    hint,
  );

  const write = () => {
    const asked = askedShot(store, engine);
    if (asked) announceCall(store, callOf(asked, ball.value, pocket.value));
  };
  ball.addEventListener("change", write);
  pocket.addEventListener("change", write);
  shown.addEventListener("click", () => {
    const call = intendedCall(store, engine);
    if (call) announceCall(store, call);
  });

  function say(kind: Kind): void {
    if (kind === "nothing") announceCall(store, null);
    else if (kind === "pocket") announceCall(store, intendedCall(store, engine) ?? { kind });
    else announceCall(store, { kind });
  }

  function show(): void {
    const asked = store.session.mode === "aim" ? askedShot(store, engine) : null;
    root.hidden = !asked || asked.calls.every((kind) => kind === "nothing");
    if (!asked || root.hidden) return;
    const call = presentCall(store, engine);
    const nominates = asked.calls.includes("on");
    kinds.hidden = nominates;
    setText(ballLabel, t(nominates ? "call.nominated-ball" : "call.called-ball"));
    showKinds(kinds, asked.calls, call?.kind ?? "nothing", say);
    ballRow.hidden = !nominates && call?.kind !== "pocket";
    pocketRow.hidden = call?.kind !== "pocket";
    hint.hidden = ballRow.hidden;
    fill(ball, ballsToCall(store, asked), call?.ball ?? "");
    const pockets = store.shot.geometry.pockets.map(({ name }) => name);
    fill(pocket, pockets, call?.into ?? "", pocketName);
    const suggested = intendedCall(store, engine);
    shown.hidden = !suggested || JSON.stringify(suggested) === JSON.stringify(call);
    if (suggested) setText(shown, t("call.from-aim", { call: callInWords(suggested) }));
  }

  store.subscribe((now, before) => {
    const isSame =
      now.document === before.document &&
      now.session.mode === before.session.mode &&
      now.session.orientation === before.session.orientation;
    if (isSame) return;
    context.loop.input(root, show);
  });
  show();
}

/** Shows the kinds of calls as buttons, one of them pressed. */
function showKinds(
  row: HTMLElement,
  kinds: readonly Kind[],
  now: Kind,
  say: (kind: Kind) => void,
): void {
  if (row.dataset.kinds !== kinds.join()) {
    row.dataset.kinds = kinds.join();
    row.replaceChildren(
      ...kinds.map((kind) => {
        const attributes = { type: "button", class: "button", "data-kind": kind };
        return h("button", { ...attributes, onclick: () => say(kind) }, t(`call.${kind}`));
      }),
    );
  }
  for (const button of row.querySelectorAll<HTMLElement>("button"))
    button.setAttribute("aria-pressed", String(button.dataset.kind === now));
}

/** A list with its label, in a row. */
function labelledList(stem: string): [HTMLSelectElement, HTMLLabelElement, HTMLElement] {
  const list = h("select", { id: uniqueId(stem) });
  const label = h("label", { for: list.id });
  return [list, label, h("div", { class: "labelled" }, label, list)];
}

/** The call that the two lists show. */
function callOf({ calls }: ShotRequest, ball: string, pocket: string): Call | null {
  if (calls.includes("on")) return ball ? { kind: "on", ball } : null;
  return {
    kind: "pocket",
    ...(ball && { ball }),
    ...(pocket && { into: pocket as NonNullable<Call["into"]> }),
  };
}

/** The balls that may be called or nominated. */
function ballsToCall(store: Store, { calls, on, cue_ball }: ShotRequest): readonly string[] {
  if (calls.includes("on")) return on;
  return store.shot.balls.map(({ id }) => id).filter((id) => id !== cue_ball);
}

/** Fills a list if its items have changed, and selects one. */
function fill<T extends string>(
  list: HTMLSelectElement,
  values: readonly T[],
  value: string,
  text: (value: T) => string = (same) => same,
): void {
  const key = JSON.stringify(values.map((item) => [item, text(item)]));
  if (list.dataset.values !== key) {
    list.dataset.values = key;
    const option = (item: T) => h("option", { value: item }, text(item));
    list.replaceChildren(h("option", { value: "" }, "–"), ...values.map(option));
  }
  list.value = value;
}
