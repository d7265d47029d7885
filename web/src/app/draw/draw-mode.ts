/** Drawing begins and ends: meanwhile gestures on the table draw, and the bar below it has the tools. */

import { FIRST_DRAWING } from "../document/marks.ts";
import type { Store } from "../document/store.ts";

/** What was chosen last; a later drawing begins with it. */
let last = FIRST_DRAWING;

/** Whether the user can draw: on a position, not in a game, a replay or an attempt. */
export function canDraw({ session, document }: Pick<Store, "session" | "document">): boolean {
  const { activity, mode, attempt } = session;
  return activity === "analyse" && mode === "aim" && attempt === null && document.game === null;
}

export function beginDrawing(store: Store): void {
  if (canDraw(store)) store.setSession({ drawing: { ...last, cursor: null, start: null } });
}

export function endDrawing(store: Store): void {
  if (store.session.drawing) last = store.session.drawing;
  store.setSession({ drawing: null });
}

/** Ends the drawing when the page turns to something else. */
export function mountDrawMode(store: Store): void {
  store.subscribe(({ session }) => {
    if (session.drawing && !canDraw(store)) endDrawing(store);
  });
}
