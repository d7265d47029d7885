/** The tray beside the table: the balls that were pocketed in the frame. */

import type { Context } from "../../common/context.ts";
import { h } from "../../common/dom.ts";
import { swatch } from "../../common/swatch.ts";
import { playedNames } from "../../common/shot-words.ts";
import type { Store } from "../../document/store.ts";
import type { Progress } from "../game-progress.ts";
import { replayedMove } from "../review/reviewed-shots.ts";
import { standing } from "../awaited-turn.ts";
import { list, t } from "../../words/translate.ts";

/** The object balls off the table in a state of the frame, in the order of the rack. */
export function trayOf({ start }: Progress, lying: Readonly<Record<string, unknown>>): string[] {
  const cue = start.balls[0]?.id;
  return start.balls.map(({ id }) => id).filter((id) => id !== cue && !Object.hasOwn(lying, id));
}

/** What stands on a ball of the tray: the number that the table shows. Reds have none. */
export function trayLabel(id: string): string {
  return /^\d+$/.test(id) ? id : "";
}

export function mountTray(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const tray = h("div", { class: "tray", role: "img", hidden: true });
  root.append(tray);
  const show = (): void => {
    const progress = standing(store, engine);
    const watched = store.session.mode === "replay" ? replayedMove(store, engine) : null;
    // The tray does not tell the result of the shot that is replayed.
    const state = watched === null ? progress?.frame.state : progress?.steps[watched]?.before;
    const balls = progress && state ? trayOf(progress, state.balls) : [];
    tray.hidden = balls.length === 0;
    tray.setAttribute("aria-label", t("tray.balls", { balls: list(playedNames(balls)) }));
    tray.replaceChildren(
      ...balls.map((id, index) => {
        const label = h("span", {}, trayLabel(id));
        return h("span", { class: "potted" }, swatch(id, index), label);
      }),
    );
  };
  store.subscribe((now, before) => {
    if (
      now.document.game !== before.document.game ||
      now.session.replay.trace !== before.session.replay.trace
    ) {
      show();
    }
  });
  show();
}
