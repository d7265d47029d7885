/** The part of the Train tab that saves the progress as a file and adds one from a file. */

import { h } from "../common/dom.ts";
import { download } from "../share/download.ts";
import { t } from "../words/translate.ts";
import { button, type Trainer } from "./parts.ts";
import { DamagedProgress, dayOf, progressOfText, progressToText } from "./progress/progress.ts";

export function mountProgress(root: HTMLElement, trainer: Trainer): void {
  const { keeper } = trainer;
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
  const save = () =>
    download(progressToText(keeper.progress), `carom-progress-${dayOf(new Date())}.json`);
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
  if (damaged === null) return;
  const saveDamaged = () => download(damaged, "carom-progress-damaged.txt");
  root.append(
    h("p", { role: "alert" }, t("progress.damaged")),
    h("div", { class: "row" }, button("save-damaged", t("progress.save-damaged"), saveDamaged)),
  );
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
    const size = () => keeper.progress.results.length + keeper.progress.puzzles.length;
    const before = size();
    keeper.add(progressOfText(text));
    // The refusal of an earlier file would contradict this one.
    store.setSession({ refusal: null });
    context.announce(t("progress.imported", { count: size() - before }));
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
