/** What the page shows of the aimed shot. */

import { type Guide, guideOf } from "./stored-game.ts";
import type { State } from "./store.ts";

/** A drill and a puzzle show as little as a game. */
export function shownGuide({ document, session }: Pick<State, "document" | "session">): Guide {
  return session.attempt ? "short" : guideOf(document.game);
}
