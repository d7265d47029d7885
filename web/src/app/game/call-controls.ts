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
  const ball = h("select", { id: uniqueId("called-ball") });
  const pocket = h("select", { id: uniqueId("called-pocket") });
  const ballLabel = h("label", { for: ball.id });
  const ballRow = h("div", { class: "labelled" }, ballLabel, ball);
  const pocketLabel = h("label", { for: pocket.id }, t("call.called-pocket"));
  const pocketRow = h("div", { class: "labelled" }, pocketLabel, pocket);
  const shown = h("button", { type: "button", class: "button" });
  const hint = h("p", { class: "hint" }, t("call.hint"));
  root.append(
    h("h2", {}, t("call.title")),
    kinds,
    h("div", { class: "pair halves" }, ballRow, pocketRow),
    h("div", { class: "row" }, shown),
    hint,
  );

  ball.addEventListener("change", write);
  pocket.addEventListener("change", write);
  shown.addEventListener("click", () => {
    const call = intendedCall(store, engine);
    if (call) announceCall(store, call);
  });

  /** Writes the call that the two lists show. */
  function write(): void {
    const asked = askedShot(store, engine);
    if (!asked) return;
    if (asked.calls.includes("on")) {
      announceCall(store, ball.value ? { kind: "on", ball: ball.value } : null);
      return;
    }
    announceCall(store, {
      kind: "pocket",
      ...(ball.value && { ball: ball.value }),
      ...(pocket.value && { into: pocket.value as NonNullable<Call["into"]> }),
    });
  }

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
    showKinds(asked, call);
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

  function showKinds({ calls }: ShotRequest, call: Call | null): void {
    const now = call?.kind ?? "nothing";
    if (kinds.dataset.kinds !== calls.join()) {
      kinds.dataset.kinds = calls.join();
      const button = (kind: Kind) =>
        h(
          "button",
          { type: "button", class: "button", "data-kind": kind, onclick: () => say(kind) },
          t(`call.${kind}`),
        );
      kinds.replaceChildren(...calls.map(button));
    }
    for (const button of kinds.querySelectorAll<HTMLElement>("button")) {
      button.setAttribute("aria-pressed", String(button.dataset.kind === now));
    }
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
