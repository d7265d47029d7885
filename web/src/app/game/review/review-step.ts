/** During a replay in a game: which shot is shown, and the way to the one before and after it. */

import type { Context } from "../../common/context.ts";
import { h, icon, setText } from "../../common/dom.ts";
import type { Store } from "../../document/store.ts";
import { standing } from "../awaited-turn.ts";
import { openStudy } from "../variations.ts";
import { isShot, neighbour, replayedMove, replayMove } from "./reviewed-shots.ts";
import { t } from "../../words/translate.ts";

export function mountStep(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const go = (step: 1 | -1) => {
    const progress = standing(store, engine);
    const index = replayedMove(store, engine);
    const next = progress && index !== null ? neighbour(progress, index, step) : null;
    if (next !== null) replayMove(store, engine, next, context.reducedMotion());
  };
  const button = (name: string, path: string, step: 1 | -1) =>
    h(
      "button",
      {
        type: "button",
        class: "button plain",
        "aria-label": name,
        title: name,
        onclick: () => go(step),
      },
      icon(path),
    );
  const back = button(t("review.previous"), "M15 5l-7 7 7 7", -1);
  const on = button(t("review.next"), "M9 5l7 7-7 7", 1);
  const text = h("span", { role: "status" });
  const study = h(
    "button",
    {
      type: "button",
      class: "button",
      onclick: () => {
        const index = replayedMove(store, engine);
        if (index !== null) void openStudy(store, engine, index);
      },
    },
    t("study.open"),
  );
  root.append(back, text, on, study);

  const show = (): void => {
    const progress = standing(store, engine);
    const index = store.session.mode === "replay" ? replayedMove(store, engine) : null;
    root.hidden = index === null || !progress;
    if (index === null || !progress) return;
    const shots = progress.steps.flatMap((step, k) => (isShot(step) ? [k] : []));
    const { player } = progress.steps[index]!;
    const name = store.document.game!.setup.names[player];
    setText(text, t("review.shot", { number: shots.indexOf(index) + 1, of: shots.length, name }));
    back.setAttribute("aria-disabled", String(neighbour(progress, index, -1) === null));
    on.setAttribute("aria-disabled", String(neighbour(progress, index, 1) === null));
  };
  store.subscribe((now, before) => {
    if (
      now.session.replay.trace !== before.session.replay.trace ||
      now.document.game !== before.document.game
    ) {
      show();
    }
  });
  show();
}
