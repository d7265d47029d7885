/** The address bar: it follows the work, and a link that is put into it is opened. */

import type { Engine } from "../../engine/types.ts";
import { aimed, replay } from "../actions.ts";
import type { Context } from "../context.ts";
import type { Document, View } from "../document.ts";
import { standing } from "../game/play.ts";
import type { Store } from "../store.ts";
import { LinkError } from "./link.ts";
import { type Shared, stateFromFragment, stateToFragment } from "./state.ts";

/**
 * How long (ms) the work must rest before the address follows: browsers allow no more than about
 * a hundred changes in half a minute.
 */
const REST = 400;

/** What the page is opened with. */
export interface Opened {
  readonly document: Document;
  readonly view: View;
  /** Time of the replay (s) that the link shows; null if it shows none. */
  readonly time: number | null;
}

/**
 * What the page's address carries; null if nothing.
 *
 * @throws {LinkError} It is damaged, or of another version.
 */
export function openedByAddress(): Opened | null {
  const shared = stateFromFragment(location.hash);
  return shared && open(shared);
}

function open({ shot, noise, seed, game, view, time }: Shared): Opened {
  return { document: { shot: aimed(shot), noise, seed, game }, view, time };
}

/** The page's address with its present state; null where it has none that others can open. */
export function link(store: Store): string | null {
  if (location.protocol === "about:") return null;
  return location.href.replace(/#.*$/s, "") + stateToFragment(store.shot.file, store.state);
}

/** Keeps the address in step with the work, from the first change on: until then it may be broken. */
export function mountAddress(store: Store, context: Context): void {
  let resting: ReturnType<typeof setTimeout> | undefined;
  const write = (): void => {
    clearTimeout(resting);
    resting = undefined;
    const aiming = { ...store.state, session: { ...store.session, mode: "aim" as const } };
    try {
      // Replaced, not pushed: "back" leaves the page, as one expects; undo is the page's own.
      history.replaceState(null, "", stateToFragment(store.shot.file, aiming));
    } catch {
      // Inside a notebook or another page there is no address to keep.
    }
  };
  store.subscribe((now, before) => {
    if (now.document === before.document && now.view === before.view) return;
    clearTimeout(resting);
    resting = setTimeout(write, REST);
  });
  addEventListener("pagehide", () => {
    if (resting !== undefined) write();
  });
  addEventListener("hashchange", () => {
    clearTimeout(resting);
    resting = undefined;
    try {
      const opened = openedByAddress();
      if (opened) show(store, context, opened);
    } catch (error) {
      if (!(error instanceof LinkError)) throw error;
      store.refuse(error.message);
    }
  });
}

/** Opens what a link brought while the page is open already: undo takes it back. */
function show(store: Store, context: Context, { document, view, time }: Opened): void {
  if (!store.apply(document, "open a link")) return;
  store.setView(view);
  showInstant(store, context.engine, time);
  context.announce("The link is opened. Undo brings back what was here.");
}

/** Shows the instant of the replay that a link was made at. */
export function showInstant(store: Store, engine: Engine, time: number | null): void {
  // In a game it is the last shot that was watched.
  const trace = store.document.game ? standing(store, engine)?.trace : store.ghost.trace;
  if (time !== null && trace) replay(store, trace, Math.min(time, trace.duration), false);
}
