import { button, h } from "../common/dom.ts";
import { download } from "../share/download.ts";
import { t } from "../words/translate.ts";

/** Kept entries that cannot be read: they can be saved as a file, and deleted by their ids. */
export function damagedAlert(
  entries: readonly unknown[],
  remove: (ids: readonly string[]) => Promise<void>,
): HTMLElement {
  const save = () => download(`${JSON.stringify(entries)}\n`, "carom-damaged.json");
  const ids = entries.map((entry) => (entry as { readonly id: string }).id);
  return h(
    "div",
    { role: "alert" },
    h("p", {}, t("kept.damaged", { count: entries.length })),
    h(
      "div",
      { class: "row" },
      button(t("kept.save-damaged"), save),
      button(t("kept.delete-damaged"), () => void remove(ids)),
    ),
  );
}
