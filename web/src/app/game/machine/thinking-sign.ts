/** The sign that a machine thinks, below the table, and its buttons. */

import type { Context } from "../../common/context.ts";
import { button, h, setText } from "../../common/dom.ts";
import type { Store } from "../../document/store.ts";
import { replay } from "../../replay/replay-control.ts";
import { playDecision } from "../game-actions.ts";
import { standing } from "../awaited-turn.ts";
import { prepareThinker, thinkerOf } from "./machine-thinker.ts";
import { Turns } from "./machine-turns.ts";
import { t } from "../../words/translate.ts";

/** Time (ms) of a decision after which the sign appears: most decisions take less. */
const PATIENCE = 300;

/** Lets the machines play. */
export function mountMachine(root: HTMLElement, store: Store, context: Context): void {
  const text = h("span");
  const stop = button(t("machine.stop"), () => turns.stop());
  stop.title = t("machine.stop-hint");
  const resume = button(t("machine.resume"), () => turns.resume());
  root.append(text, stop, resume);
  root.hidden = true;

  const turns = new Turns(store, context.engine, () => thinkerOf(context.engine), {
    play: (decision) =>
      playDecision(store, context, decision, (trace) => {
        if (!context.reducedMotion()) replay(store, trace);
      }),
    changed: () => {
      clearTimeout(timer);
      if (turns.waiting === "thinking") timer = setTimeout(show, PATIENCE);
      else show();
    },
  });
  let timer: ReturnType<typeof setTimeout> | undefined;

  function show(): void {
    const { waiting } = turns;
    const request = standing(store, context.engine)?.frame.state.request;
    // A pressed button that disappears gives its focus to the table.
    if (root.contains(document.activeElement)) document.getElementById("table")?.focus();
    const waits = waiting === "thinking" || waiting === "held";
    root.hidden = !waits || !request || request.kind === "over";
    if (root.hidden || !request || request.kind === "over") return;
    const name = store.document.game!.setup.names[request.player];
    setText(text, t(waiting === "thinking" ? "machine.thinks" : "machine.held", { name }));
    stop.hidden = waiting !== "thinking";
    resume.hidden = waiting !== "held";
  }
  // Who has read the ruling taps the table or the ruling; a tap on Undo must not let the machine play.
  for (const id of ["table", "game-bar"]) {
    document.getElementById(id)!.addEventListener("pointerdown", ({ target }) => {
      if (!(target as Element).closest("button, a, input, select")) turns.readOn();
    });
  }
  store.subscribe((now, before) => {
    if (now.session.activity === before.session.activity) return;
    if (now.session.activity === "play") prepareThinker(context.engine);
  });
  turns.consider();
}
