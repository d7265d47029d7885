/** The list of the library: entries by folder, which are opened, renamed, moved, saved and deleted. */

import type { Context } from "../common/context.ts";
import { button, h, labelled, uniqueId } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { damagedAlert } from "../kept/damaged-alert.ts";
import type { Library, Shelf } from "../kept/library.ts";
import { type LibraryEntry, LONGEST_ENTRY_NAME } from "../kept/library-entry.ts";
import { download } from "../share/download.ts";
import { dateAndTime, t } from "../words/translate.ts";
import { exampleStudy } from "./example-study.ts";
import type { StudyShelf } from "./study-shelf.ts";

export class LibraryList {
  readonly element = h("section", { class: "library", id: "library-list" });
  readonly #store: Store;
  readonly #context: Context;
  readonly #shelf: StudyShelf;
  readonly #library: Library | null;
  readonly #folders = h("datalist", { id: "library-folders" });
  readonly #name = this.#field("library-name", "");
  readonly #folder = this.#field("library-folder", "", true);
  readonly #save: HTMLButtonElement;
  readonly #entries = h("div", { id: "library-entries" });
  readonly #deleted = h("p", { class: "row", role: "status", id: "library-deleted" });
  /** Counts readings, so that an earlier one that ends later is not shown. */
  #reading = 0;

  constructor(store: Store, context: Context, shelf: StudyShelf, library: Library | null) {
    this.#store = store;
    this.#context = context;
    this.#shelf = shelf;
    this.#library = library;
    this.#save = button("", () => void this.#add(), "primary");
    this.#save.id = "library-save";
    const study = button(t("library.new-study"), () => void this.#addStudy());
    study.id = "library-study";
    const example = button(t("library.example"), () => this.#openExample());
    example.id = "library-example";
    this.element.append(
      h("h2", { tabindex: -1 }, t("library.title")),
      h("p", { class: "hint" }, t("library.intro")),
      ...(library
        ? [
            labelled(t("library.name"), this.#name),
            labelled(t("library.folder"), this.#folder),
            this.#folders,
            h("div", { class: "row" }, this.#save, study),
            this.#deleted,
            this.#entries,
          ]
        : [h("p", {}, t("library.none-kept"))]),
      h("h3", {}, t("library.example-title")),
      h("div", { class: "row" }, example),
      h("p", { class: "hint" }, t("library.files")),
    );
    library?.subscribe(() => void this.show());
    library?.storage.subscribe(() => void this.show());
    document.addEventListener("visibilitychange", () => void this.show());
  }

  /** Reads the library again. */
  async show(): Promise<void> {
    const kind = this.#store.document.game ? "library.save-game" : "library.save-position";
    if (this.#save.textContent !== t(kind)) this.#save.textContent = t(kind);
    const isShown = this.#store.session.activity === "library" && !this.element.hidden;
    if (!this.#library || !isShown || document.visibilityState === "hidden") return;
    const reading = (this.#reading += 1);
    const shelf = await this.#library.list();
    // A form that is being filled stays.
    if (reading !== this.#reading || this.#entries.contains(document.activeElement)) return;
    this.#showEntries(shelf);
  }

  #showEntries({ entries, damaged }: Shelf): void {
    const { storage } = this.#library!;
    const folders = [...new Set(entries.map(({ folder }) => folder))];
    this.#folders.replaceChildren(
      ...folders.filter(Boolean).map((value) => h("option", { value })),
    );
    const parts: (HTMLElement | false)[] = [
      entries.length === 0 && h("p", { class: "hint" }, t("library.empty")),
      ...folders.flatMap((folder) => [
        folder !== "" && this.#heading(folder, entries),
        h("ul", {}, ...entries.filter((one) => one.folder === folder).map((e) => this.#item(e))),
      ]),
      damaged.length > 0 && damagedAlert(damaged, (ids) => this.#removeDamaged(ids)),
      storage.fault !== null && h("p", { role: "alert" }, t(`kept.fault-${storage.fault}`)),
    ];
    this.#entries.replaceChildren(...parts.filter((part) => part !== false));
  }

  #heading(folder: string, entries: readonly LibraryEntry[]): HTMLElement {
    const name = this.#field("folder-name", folder);
    const rename = async () => {
      const to = name.value.trim();
      this.#release();
      for (const entry of entries.filter((one) => one.folder === folder)) {
        await this.#library!.change({ ...entry, folder: to });
      }
    };
    return h(
      "details",
      { class: "folder" },
      h("summary", {}, h("h3", {}, folder)),
      labelled(t("library.folder"), name),
      h(
        "div",
        { class: "row" },
        button(t("library.rename-folder"), () => void rename()),
      ),
    );
  }

  #item(entry: LibraryEntry): HTMLElement {
    const open = button("", () => void this.#shelf.open(entry), "entry");
    open.append(
      h("strong", {}, entry.name),
      h("span", { class: "when" }, t(`library.kind-${entry.kind}`)),
      h("span", { class: "when" }, dateAndTime(new Date(entry.changed))),
    );
    const name = this.#field("entry-name", entry.name);
    const folder = this.#field("entry-folder", entry.folder, true);
    const change = async () => {
      const to = { ...entry, name: name.value.trim() || entry.name, folder: folder.value.trim() };
      this.#release();
      if (to.kind !== "study") await this.#library!.change(to);
      else await this.#library!.change({ ...to, study: { ...to.study, title: to.name } });
    };
    const remove = button(t("library.delete"), () => void this.#remove(entry));
    remove.setAttribute("aria-label", t("library.delete-of", { name: entry.name }));
    const save = entry.kind === "study" && this.#fileButton(entry);
    return h(
      "li",
      {},
      open,
      h(
        "details",
        {},
        h(
          "summary",
          { "aria-label": t("library.change-of", { name: entry.name }) },
          t("library.change"),
        ),
        labelled(t("library.name"), name),
        labelled(t("library.folder"), folder),
        h(
          "div",
          { class: "row" },
          button(t("library.apply"), () => void change()),
          save,
          remove,
        ),
      ),
    );
  }

  #fileButton({ study, name }: Extract<LibraryEntry, { kind: "study" }>): HTMLElement {
    return button(t("lesson.save-file"), () => download(this.#shelf.file(study), fileName(name)));
  }

  #field(stem: string, value: string, isFolder = false): HTMLInputElement {
    const field = h("input", { type: "text", id: uniqueId(stem), maxlength: LONGEST_ENTRY_NAME });
    field.value = value;
    if (isFolder) field.setAttribute("list", "library-folders");
    return field;
  }

  /** Lets the list be shown again although a field of it has the focus. */
  #release(): void {
    this.#name.focus({ preventScroll: true });
  }

  async #remove(entry: LibraryEntry): Promise<void> {
    this.#release();
    await this.#library!.remove(entry.id);
    const undo = button(t("library.undo"), () => {
      this.#deleted.replaceChildren();
      this.#release();
      void this.#library!.restore(entry);
    });
    undo.id = "library-undo";
    this.#deleted.replaceChildren(h("span", {}, t("library.deleted", { name: entry.name })), undo);
    undo.focus();
  }

  async #removeDamaged(ids: readonly string[]): Promise<void> {
    this.#release();
    for (const id of ids) await this.#library!.remove(id);
  }

  /** The name in the field, or else a usual one. */
  #title(usual: string): string {
    const name = this.#name.value.trim() || usual;
    this.#name.value = "";
    return name;
  }

  async #add(): Promise<void> {
    const isGame = this.#store.document.game !== null;
    const usual = t(isGame ? "library.kind-game" : "library.kind-position");
    await this.#shelf.addPosition(this.#title(usual), this.#folder.value.trim());
  }

  async #addStudy(): Promise<void> {
    await this.#shelf.addStudy(this.#title(t("library.kind-study")), this.#folder.value.trim());
  }

  #openExample(): void {
    this.#shelf.openReadOnly(exampleStudy(this.#context.engine));
  }
}

/** A file name from a title. */
export function fileName(title: string): string {
  const stem = title.replace(/[^\p{L}\p{N}]+/gu, "_").replace(/^_|_$/g, "");
  return `${stem === "" ? "study" : stem}.json`;
}
