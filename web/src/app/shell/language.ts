/** The language of the page: the browser's, unless the user chose one. */

import { h } from "../common/dom.ts";
import { type Language, LANGUAGES } from "../words/catalogue.ts";
import { language, named, setLanguage, t } from "../words/translate.ts";

/** Name of the choice in the browser's storage. It is the only thing that the page stores. */
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

/** The control in the header. */
export function languageChoice(): HTMLElement {
  const names = Object.entries(LANGUAGES).map(([value, { name, tag }]) =>
    h("option", { value, lang: tag }, name),
  );
  const select = h("select", { "aria-label": t("page.language") }, ...names);
  select.value = language();
  select.addEventListener("change", () => {
    store(select.value);
    // The address has the document; it is written before the page leaves (share/address.ts).
    location.reload();
  });
  const short = h("span", { "aria-hidden": "true" }, LANGUAGES[language()].short);
  return h("span", { class: "button plain language", title: t("page.language") }, short, select);
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

function store(value: string): void {
  try {
    localStorage.setItem(STORED, value);
  } catch {
    // The page then stays in the browser's language.
  }
}

function isLanguage(value: string): value is Language {
  return Object.hasOwn(LANGUAGES, value);
}
