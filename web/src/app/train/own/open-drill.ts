/** Opens drills that come from outside: files, and links `#d=`. Nothing in them runs; the engine checks them. */

import { CaromError, type DrillFile } from "../../../engine/index.ts";
import { detailedText } from "../../common/refusals.ts";
import { DRILL_KEY, fromFragment, LinkError, toFragment } from "../../share/link.ts";
import { t } from "../../words/translate.ts";
import { drillOfFile } from "../drill-file.ts";
import type { Trainer } from "../train-parts.ts";

/** Whether a text is a drill file, damaged or not. */
export function isDrillText(text: string): boolean {
  return /^\s{0,20}\{\s{0,20}"format"\s{0,20}:\s{0,20}"carom-drill\//.test(text.slice(0, 200));
}

/** The fragment of a link to a drill. */
export function drillFragment(file: DrillFile): string {
  return toFragment(file, DRILL_KEY);
}

/** Keeps the drill of a file or of a link's data and shows it. One that is refused changes nothing. */
export function openDrill(trainer: Trainer, data: string | object): void {
  const { store, context, keeper, practice, go } = trainer;
  const { engine } = context;
  try {
    const file = engine.drill(data as DrillFile);
    const name = keeper.addDrill(file);
    practice.leave();
    store.setSession({ activity: "train", refusal: null });
    go({ kind: "drill", drill: drillOfFile(engine, { ...file, name }) });
    context.announce(t("own.opened", { name }));
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    store.refuse(t("own.refused", { why: detailedText(error) }));
  }
}

/** Opens the drill of the address, now and when another one is entered. */
export function mountDrillLinks(trainer: Trainer): void {
  const read = () => {
    const fragment = location.hash;
    if (!fragment.startsWith(DRILL_KEY)) return;
    try {
      openDrill(trainer, fromFragment(fragment, DRILL_KEY) as object);
    } catch (error) {
      if (!(error instanceof LinkError)) throw error;
      trainer.store.refuse(error.message);
    }
  };
  read();
  addEventListener("hashchange", read);
}
