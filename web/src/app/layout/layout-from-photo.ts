/** The layout from a photo as a step of the document. */

import type { PhotoOptions } from "../../photo/index.ts";
import type { Context } from "../common/context.ts";
import { aimed } from "../document/shot-file.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";

export function photoOptions(store: Store, { engine }: Context): PhotoOptions {
  return {
    engine,
    table: () => store.document.shot,
    onLayout: (balls, equipment) => {
      const shot = aimed({ format: "carom-shot/1", ...equipment, balls });
      store.apply({ shot, game: null }, t("change.photo"));
    },
  };
}
