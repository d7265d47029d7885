/** Plays the embedded trace as soon as the page opens, then lets the user aim at the balls that remain. */

import type { Trace } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import type { Store } from "../document/store.ts";
import { replay } from "../replay/replay-control.ts";
import { takeItFromHere } from "./shoot.ts";

/** Time (ms) between the end of the replay and aiming. */
const REST = 1200;

/**
 * Plays `trace` once. At its end, or when the user clicks the table, the final positions become the
 * layout to aim at. Any other action of the user ends this: the page then behaves as usual.
 */
export function playThenAim(store: Store, context: Context, trace: Trace): void {
  // On small pages, as in a frame, the table needs the room of the panel.
  document.getElementById("panel")!.dataset.folded = "true";
  if (context.reducedMotion()) {
    replay(store, trace, trace.duration, false);
    return;
  }
  const table = document.getElementById("table")!;
  const finish = (): void => {
    stop();
    takeItFromHere(store, context);
  };
  let resting: ReturnType<typeof setTimeout> | undefined;
  replay(store, trace);
  const unsubscribe = store.subscribe(({ session }) => {
    const ended =
      session.replay.trace === trace &&
      !session.replay.playing &&
      session.replay.time >= trace.duration;
    if (ended) resting ??= setTimeout(finish, REST);
    else if (session.replay.trace !== trace || !session.replay.playing || resting !== undefined)
      stop();
  });
  function stop(): void {
    clearTimeout(resting);
    unsubscribe();
    table.removeEventListener("click", finish);
  }
  table.addEventListener("click", finish);
}
