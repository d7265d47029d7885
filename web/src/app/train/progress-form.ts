/** The part of the Train tab that saves the progress as a file, adds one from a file, and deletes it. */

import { h } from "../common/dom.ts";
import { download } from "../share/download.ts";
import { t } from "../words/translate.ts";
import { button, type Trainer } from "./train-parts.ts";
import {
  DamagedProgress,
  dayOf,
  type Progress,
  progressOfText,
  progressToText,
} from "./progress/practice-progress.ts";

export function mountProgress(root: HTMLElement, trainer: Trainer): void {
  const { keeper, context } = trainer;
  const { damaged } = keeper;
  const input = h("input", {
    type: "file",
    accept: ".json,application/json",
    hidden: true,
    id: "progress-file",
    "aria-label": t("progress.import"),
  });
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    input.value = ""; // the same file can be chosen again
    if (file) void addFile(file, trainer);
  });
  const save = () => {
    const text = progressToText(keeper.progress, context.engine.version);
    download(text, `carom-progress-${dayOf(new Date())}.json`);
  };
  root.append(
    h("h2", {}, t("progress.title")),
    h("p", { class: "hint" }, t(keeper.isKept ? "progress.kept" : "progress.not-kept")),
    h(
      "div",
      { class: "row" },
      button("save-progress", t("progress.export"), save),
      button("add-progress", t("progress.import"), () => input.click()),
      input,
    ),
  );
  if (sizeOf(keeper.progress) > 0) mountDeletion(root, trainer);
  if (damaged === null) return;
  const saveDamaged = () => download(damaged, "carom-progress-damaged.txt");
  root.append(
    h("p", { role: "alert" }, t("progress.damaged")),
    h("div", { class: "row" }, button("save-damaged", t("progress.save-damaged"), saveDamaged)),
  );
}

/** The button that deletes the progress: a second press confirms it. */
function mountDeletion(root: HTMLElement, { keeper, context }: Trainer): void {
  const row = h("div", { class: "row" });
  const ask = button("delete-progress", t("progress.delete"), () => {
    const count = sizeOf(keeper.progress);
    const confirm = button("confirm-delete", t("progress.confirm-delete", { count }), () => {
      keeper.clear();
      context.announce(t("progress.deleted", { count }));
    });
    confirm.classList.add("danger");
    const keep = button("keep-progress", t("progress.keep"), () => {
      row.replaceChildren(ask);
      ask.focus();
    });
    row.replaceChildren(confirm, keep);
    keep.focus();
  });
  row.append(ask);
  root.append(row);
}

function sizeOf({ results, puzzles, attempts, drills }: Progress): number {
  return results.length + puzzles.length + attempts.length + drills.length;
}

async function addFile(file: File, { store, context, keeper }: Trainer): Promise<void> {
  let text: string;
  try {
    text = await file.text();
  } catch {
    store.refuse(t("progress.unreadable", { file: file.name }));
    return;
  }
  try {
    const before = sizeOf(keeper.progress);
    await keeper.add(progressOfText(text));
    // The refusal of an earlier file would contradict this one.
    store.setSession({ refusal: null });
    context.announce(t("progress.imported", { count: sizeOf(keeper.progress) - before }));
  } catch (error) {
    if (!(error instanceof DamagedProgress)) throw error;
    store.refuse(refusalOf(error, file.name));
  }
}

function refusalOf({ fault, place }: DamagedProgress, file: string): string {
  if (fault === "json") return t("progress.not-json", { file });
  if (fault === "format") return t("progress.other-format", { file });
  return t("progress.wrong-value", { file, place });
}
