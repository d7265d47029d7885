/** The drills that the user has made or opened: their list, and what one can do with one of them. */

import { CaromError, type DrillFile } from "../../../engine/index.ts";
import { h } from "../../common/dom.ts";
import { copy } from "../../share/clipboard.ts";
import { download } from "../../share/download.ts";
import { t } from "../../words/translate.ts";
import { drillOfFile, fileOfDrill } from "../drill-file.ts";
import type { Drill } from "../drills/index.ts";
import { button, type Trainer } from "../train-parts.ts";
import { drillName, goalText } from "../train-words.ts";
import { newDraft } from "./draft.ts";
import { drillFragment, openDrill } from "./open-drill.ts";

/** @param card The card of a drill. */
export function mountOwnDrills(
  root: HTMLElement,
  trainer: Trainer,
  card: (drill: Drill) => HTMLElement,
): void {
  const { store, go } = trainer;
  const input = h("input", {
    type: "file",
    accept: ".json,application/json",
    hidden: true,
    id: "own-file",
    "aria-label": t("own.open"),
  });
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    input.value = ""; // the same file can be chosen again
    if (!file) return;
    file.text().then(
      (text) => openDrill(trainer, text),
      () => store.refuse(t("open.unreadable", { file: file.name })),
    );
  });
  const drills = ownDrills(trainer);
  root.append(
    h("h2", {}, t("own.many")),
    h("p", { class: "hint" }, t("own.hint")),
    ...(drills.length > 0
      ? [h("ul", { class: "drill-list" }, ...drills.map((drill) => h("li", {}, card(drill))))]
      : []),
    h(
      "div",
      { class: "row" },
      button("own-new", t("own.new"), () => go({ kind: "own", draft: newDraft() })),
      button("own-open", t("own.open"), () => input.click()),
      input,
    ),
  );
}

/** Those that this version of the engine reads: what was kept may be of another one. */
export function ownDrills({ context, keeper }: Pick<Trainer, "context" | "keeper">): Drill[] {
  const { engine } = context;
  return keeper.progress.drills.flatMap((file) => {
    try {
      return [drillOfFile(engine, engine.drill(file))];
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      return [];
    }
  });
}

/** What one can do with a drill besides playing it: save and share it, and change one's own. */
export function drillActions(trainer: Trainer, drill: Drill): HTMLElement {
  const { store, context, keeper, go } = trainer;
  const own = keeper.progress.drills.find(({ name }) => name === drill.name);
  const file = own ?? fileOf(trainer, drill);
  const row = h("div", { class: "row" });
  if (file) {
    const save = () =>
      download(
        `${JSON.stringify(file, null, 1)}\n`,
        `${file.name.replace(/[^\p{L}\p{N}]+/gu, "-")}.json`,
      );
    const link = async () => {
      const address = location.href.replace(/#.*$/s, "") + drillFragment(file);
      if (await copy(address)) context.announce(t("own.link-copied"));
      else store.refuse(t("own.no-clipboard"));
    };
    row.append(
      button("own-download", t("own.download"), save),
      button("own-link", t("own.link"), () => void link()),
    );
  }
  if (own) {
    row.append(
      button("own-edit", t("own.edit"), () =>
        go({ kind: "own", draft: { file: own, kept: own.name } }),
      ),
      deletion(trainer, own, row),
    );
  }
  return row;
}

/** The button that deletes a drill: a second press confirms it. */
function deletion({ keeper, context, go }: Trainer, { name }: DrillFile, row: HTMLElement) {
  return button("own-delete", t("own.delete"), () => {
    const confirm = button("own-confirm", t("own.confirm-delete", { name }), () => {
      keeper.deleteDrill(name);
      go({ kind: "overview" });
      context.announce(t("own.deleted", { name }));
    });
    confirm.classList.add("danger");
    const keep = button("own-keep", t("progress.keep"), () => go({ kind: "overview" }));
    row.replaceChildren(confirm, keep);
    keep.focus();
  });
}

/** A built-in drill as a file; null of one with a rack, which files do not have. */
function fileOf({ context }: Trainer, drill: Drill): DrillFile | null {
  if (drill.steps.some(({ rack }) => rack !== undefined)) return null;
  const [step] = drill.steps;
  const text = goalText({ drill: { ...drill, steps: [step!] }, step: step!, attempt: 0 });
  return fileOfDrill(context.engine, drill, drillName(drill), text);
}
