/** Undo and redo, announced to the user. */

import type { Context } from "../common/context.ts";
import type { Store } from "./store.ts";
import { t } from "../words/translate.ts";

export function undo(store: Store, context: Context): void {
  const label = store.undoLabel;
  context.announce(
    store.undo() ? t("history.undone", { change: label ?? "" }) : t("history.nothing-to-undo"),
  );
}

export function redo(store: Store, context: Context): void {
  const label = store.redoLabel;
  context.announce(
    store.redo() ? t("history.redone", { change: label ?? "" }) : t("history.nothing-to-redo"),
  );
}
