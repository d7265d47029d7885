/** Undo and redo, announced to the user. */

import type { Context } from "../common/context.ts";
import type { Store } from "./store.ts";

export function undo(store: Store, context: Context): void {
  const label = store.undoLabel;
  context.announce(store.undo() ? `Undone: ${label ?? ""}` : "There is nothing to undo.");
}

export function redo(store: Store, context: Context): void {
  const label = store.redoLabel;
  context.announce(store.redo() ? `Redone: ${label ?? ""}` : "There is nothing to redo.");
}
