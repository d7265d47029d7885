/** Undo and redo, announced to the user. */

import type { Context } from "../common/context.ts";
import type { Store } from "./store.ts";
import { t } from "../words/translate.ts";

export function undo(store: Store, context: Context): void {
  const change = store.undoLabel;
  if (change === null) context.announce(t("history.nothing-to-undo"));
  else if (store.undo()) context.announce(t("history.undone", { change }));
}

export function redo(store: Store, context: Context): void {
  const change = store.redoLabel;
  if (change === null) context.announce(t("history.nothing-to-redo"));
  else if (store.redo()) context.announce(t("history.redone", { change }));
}
