/** The balls that can be placed, as buttons. */

import { look } from "../../viewer/index.ts";
import { ballText, fill, shortBallText, TEXTS } from "../texts.ts";
import { drawing, element } from "./element.ts";

export class Tray {
  readonly root: HTMLElement;
  readonly #choose: (id: string) => void;
  #ids: readonly string[] = [];
  /** The button that is in view. */
  #current: HTMLElement | null = null;

  constructor(choose: (id: string) => void) {
    this.#choose = choose;
    this.root = element("div", {
      class: "balls photo-tray",
      role: "radiogroup",
      "aria-label": TEXTS.tray,
    });
    this.root.addEventListener("keydown", (event) => this.#onKey(event));
  }

  /**
   * Updates the buttons. Those of the same balls stay: the dialog also shows itself between press and release
   * of a button, when the photo loses the focus, and a button that is replaced then gets no click.
   *
   * @param chosen - The ball that the next tap places, or that is selected.
   */
  show(ids: readonly string[], placed: ReadonlySet<string>, chosen: string | null): void {
    if (ids.join() !== this.#ids.join()) {
      const focused = this.root.contains(document.activeElement);
      this.root.replaceChildren(...ids.map((id, index) => this.#button(id, index)));
      if (focused) this.root.querySelector<HTMLElement>("button")?.focus();
    }
    this.#ids = ids;
    ids.forEach((id, index) => {
      const made = this.root.children[index]!;
      const isPlaced = placed.has(id);
      made.setAttribute("aria-checked", String(id === chosen));
      const name = ballText(id);
      made.setAttribute("aria-label", isPlaced ? fill(TEXTS.placed, { ball: name }) : name);
      made.toggleAttribute("data-placed", isPlaced);
      made.setAttribute("tabindex", id === (chosen ?? ids[0]) ? "0" : "-1");
    });
    const current = this.root.querySelector<HTMLElement>('[tabindex="0"]');
    if (!current || current === this.#current) return;
    this.#current = current;
    if (this.root.contains(document.activeElement)) current.focus();
    // The page itself must not scroll.
    const left = current.offsetLeft - this.root.offsetLeft;
    this.root.scrollLeft = left - this.root.clientWidth / 2;
  }

  #button(id: string, index: number): HTMLButtonElement {
    const attributes = { type: "button", class: "button chip", role: "radio" };
    const made = element("button", attributes, swatch(id, index), shortBallText(id));
    made.addEventListener("click", () => {
      this.#choose(id);
    });
    return made;
  }

  #onKey(event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
    if (step === undefined) return;
    const chosen = this.root.querySelector('[tabindex="0"]');
    const at = [...this.root.children].indexOf(chosen!);
    const count = this.#ids.length;
    const id = this.#ids[(at + step + count) % count];
    if (id !== undefined) this.#choose(id);
    event.preventDefault();
  }
}

function swatch(id: string, index: number): SVGSVGElement {
  const { body, striped } = look(id, index);
  const svg = drawing("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" });
  svg.append(drawing("circle", { cx: 8, cy: 8, r: 7, fill: striped ? "#f6f1e3" : body }));
  if (striped) {
    const d = "M1.9 4.6h12.2a7 7 0 0 1 0 6.8H1.9a7 7 0 0 1 0-6.8";
    svg.append(drawing("path", { d, fill: body }));
  }
  svg.append(drawing("circle", { cx: 8, cy: 8, r: 7, class: "rim" }));
  return svg;
}
