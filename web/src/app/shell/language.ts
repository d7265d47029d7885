/** The language of the page: the browser's, unless the user chose one. */

import { h } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { LinkError } from "../share/link.ts";
import { keepForReload } from "../share/reload.ts";
import { type Language, LANGUAGES } from "../words/catalogue.ts";
import { language, named, setLanguage, t } from "../words/translate.ts";

/** Name of the choice in the browser's storage. */
const STORED = "carom-language";

/** Chooses the language, and translates the texts of index.html. Called before anything is mounted. */
export function applyLanguage(): void {
  setLanguage(chosen() ?? preferred(navigator.languages));
  document.documentElement.lang = LANGUAGES[language()].tag;
  for (const element of document.querySelectorAll<HTMLElement>("[data-text]"))
    element.textContent = named("page", element.dataset.text!);
  for (const element of document.querySelectorAll<HTMLElement>("[data-label]"))
    element.ariaLabel = named("page", element.dataset.label!);
  for (const element of document.querySelectorAll<HTMLElement>("[data-role-text]"))
    element.setAttribute("aria-roledescription", named("page", element.dataset.roleText!) ?? "");
}

/** The first language of a browser's list that the page has; English if it has none of them. */
export function preferred(wanted: readonly string[]): Language {
  return wanted.map((tag) => tag.split("-")[0]!.toLowerCase()).find(isLanguage) ?? "en";
}

/**
 * The choice of the language. The page loads again, because every part of it has texts.
 *
 * @param close Uncovers the message that the language cannot be changed.
 */
export function languageChoice(store: Store, close: () => void): HTMLElement {
  const names = Object.entries(LANGUAGES).map(([value, { name, tag }]) =>
    h("option", { value, lang: tag }, name),
  );
  const select = h("select", { id: "language" }, ...names);
  select.value = language();
  select.addEventListener("change", () => {
    const wanted = select.value;
    select.value = language();
    try {
      keepForReload(store);
      localStorage.setItem(STORED, wanted);
    } catch (error) {
      close();
      store.refuse(error instanceof LinkError ? error.message : t("language.not-stored"));
      return;
    }
    location.reload();
  });
  return h(
    "div",
    { class: "languages" },
    h("label", { for: select.id }, t("language.label")),
    " ",
    select,
    h("p", { class: "hint" }, t("language.hint")),
  );
}

function chosen(): Language | null {
  try {
    const stored = localStorage.getItem(STORED) ?? "";
    return isLanguage(stored) ? stored : null;
  } catch {
    // Some frames and browsers have no storage.
    return null;
  }
}

function isLanguage(value: string): value is Language {
  return Object.hasOwn(LANGUAGES, value);
}
