/** The help dialog: what the page can do, and all keys. */

import licenses from "../../../../LICENSE-THIRD-PARTY?raw";
import { h } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { KEYS } from "../input/keys.ts";
import { languageChoice } from "../shell/language.ts";
import { named, t } from "../words/translate.ts";

const TOPICS = [
  "pot",
  "aim",
  "strike",
  "ahead",
  "shoot",
  "move",
  "draw",
  "game",
  "keep",
  "else",
] as const;

/** @returns A function that opens the help. */
export function mountHelp(
  dialog: HTMLDialogElement,
  store: Store,
  showSteps: () => void,
): () => void {
  const close = () => {
    dialog.close();
  };
  const title = h("h2", { id: "help-title", tabindex: -1 }, t("help.title"));
  dialog.append(
    h(
      "div",
      { class: "head" },
      title,
      h("button", { type: "button", class: "button", onclick: close }, t("help.close")),
    ),
    languageChoice(store, close),
    h(
      "dl",
      { class: "ways" },
      ...TOPICS.flatMap((topic) => [
        h("dt", {}, t(`help.${topic}`)),
        h("dd", {}, t(`help.${topic}-text`)),
      ]),
    ),
    h("h2", {}, t("help.keys")),
    h("p", { class: "hint" }, t("help.keys-hint")),
    h(
      "dl",
      { class: "keys" },
      ...KEYS.flatMap(({ shown, help }) => [
        h("dt", {}, ...shown.map((key) => h("kbd", {}, named("keyname", key) ?? key))),
        h("dd", {}, t(help)),
      ]),
    ),
    h(
      "details",
      { class: "licenses" },
      h("summary", {}, t("help.software")),
      h("pre", { tabindex: 0, "aria-label": t("help.licenses") }, licenses),
    ),
    h(
      "div",
      { class: "row end" },
      h(
        "button",
        {
          type: "button",
          class: "button",
          onclick: () => {
            close();
            showSteps();
          },
        },
        t("help.steps"),
      ),
    ),
  );
  return () => {
    dialog.showModal();
    // Browsers ignore the attribute `autofocus` in a frame of another origin.
    title.focus();
  };
}
