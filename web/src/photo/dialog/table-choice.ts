/** The list of tables in the dialog. */

import type { Engine, ShotFile } from "../../engine/index.ts";
import { isDated } from "../dated-presets.ts";
import { tableText, TEXTS } from "../texts.ts";
import { element } from "./element.ts";

export class TableChoice {
  readonly root: HTMLElement;
  readonly #engine: Engine;
  readonly #select: HTMLSelectElement;
  readonly #present = element("option", { value: "" }, TEXTS.presentTable);

  constructor(engine: Engine, changed: () => void) {
    this.#engine = engine;
    const names = engine.tables.flatMap(({ name }) => (name && !isDated(name) ? [name] : []));
    this.#select = element(
      "select",
      { "aria-label": TEXTS.table },
      this.#present,
      ...names.map((name) => element("option", { value: name }, tableText(name))),
    );
    this.#select.addEventListener("change", changed);
    this.root = element("div", { class: "photo-table" }, this.#select);
  }

  /** Chooses the table of a shot. */
  show({ table }: ShotFile): void {
    const name = typeof table === "string" ? this.#engine.currentPresetName(table) : "";
    this.#select.value = name;
    const isPreset = this.#select.value === name && name !== "";
    this.#present.hidden = isPreset;
    if (!isPreset) this.#select.value = "";
  }

  /** A shot on the chosen table: the present one, or a ball in the middle of a preset. */
  shot(present: ShotFile): ShotFile {
    const name = this.#select.value;
    const size = this.#engine.tables.find((table) => table.name === name)?.size;
    const { table } = present;
    const isPresent = typeof table === "string" && this.#engine.currentPresetName(table) === name;
    if (!size || isPresent) return present;
    const ball = { id: "cue", position: [size[0] / 2, size[1] / 2] as const };
    return { format: "carom-shot/1", table: name, balls: [ball] };
  }
}
