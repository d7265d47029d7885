/** Where a photo comes from: a button, a drop or the clipboard. */

import { TEXTS } from "../texts.ts";
import { button, element } from "./element.ts";

export class Source {
  /** What is shown without a photo. */
  readonly root: HTMLElement;
  /** The button for another photo. */
  readonly again: HTMLButtonElement;
  readonly #open: (file: File) => void;
  readonly #first: HTMLButtonElement;
  readonly #message = element("p", { class: "photo-warning", role: "alert" });

  constructor(open: (file: File) => void) {
    this.#open = open;
    const input = element("input", {
      type: "file",
      accept: "image/*",
      hidden: true,
      "aria-label": TEXTS.file,
    });
    input.addEventListener("change", () => {
      const file = input.files?.[0];
      input.value = ""; // The same file can be chosen again.
      if (file) open(file);
    });
    const choose = () => {
      input.click();
    };
    this.again = button(TEXTS.another, "", choose);
    this.#first = button(TEXTS.choose, "primary", choose);
    this.root = element(
      "div",
      { class: "photo-source" },
      element("p", {}, TEXTS.drop),
      this.#first,
      input,
      element("p", { class: "hint" }, TEXTS.privacy),
      this.#message,
    );
  }

  show(hasPhoto: boolean, message: string): void {
    this.root.hidden = hasPhoto;
    this.#message.textContent = message;
  }

  /** Focuses the button that chooses a file, if it is shown. */
  focus(): void {
    if (!this.root.hidden) this.#first.focus();
  }

  /** Takes files that are dropped on the dialog or pasted. The page behind it opens shots. */
  listen(dialog: HTMLElement): void {
    for (const name of ["dragover", "drop"] as const) {
      dialog.addEventListener(name, (event) => {
        event.preventDefault();
        event.stopPropagation();
        const file = name === "drop" ? event.dataTransfer?.files[0] : undefined;
        if (file) this.#open(file);
      });
    }
    dialog.addEventListener("paste", (event) => {
      const file = event.clipboardData?.files[0];
      if (file) this.#open(file);
    });
  }
}
