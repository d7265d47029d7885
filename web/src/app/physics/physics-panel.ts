/**
 * The Physics tab: cloth, balls and rails as players name them; below them the preset and its parameters,
 * in the order of the shot file's schema.
 */

import type { CoefficientKey, Engine } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import type { AimedShot } from "../document/document.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import { nameOfPath } from "../common/parameter-names.ts";
import { presetLabel, presetOptions } from "../common/preset-names.ts";
import { mountParameters } from "../form/parameter-rows.ts";
import type { Values } from "../form/parameters.ts";
import type { Store } from "../document/store.ts";
import { round } from "../common/units.ts";
import { named, t } from "../words/translate.ts";
import {
  chosen,
  familyOf,
  NUMBERS,
  offered,
  TABLE_PARTS,
  type TablePart,
  USUAL,
  withChoice,
} from "./choices.ts";

/** Speed (m/s) and angle (rad) at which a coefficient becomes a number: a soft shot, half a right angle. */
const MIDDLE = { speed: 1, angle: Math.PI / 4 };

/** Digits of that number: measurements have fewer. */
const DIGITS = 4;

/** The list's value for the table's own physics. */
const TABLES_OWN = "";

export function mountPhysicsPanel(root: HTMLElement, store: Store, { engine }: Context): void {
  const source = new FilePhysics(store, engine);
  root.append(h("h2", {}, t("physics.title")));
  const showChoices = mountChoices(root, source);
  const numbers = h("details", {}, h("summary", {}, t("physics.numbers")));
  root.append(numbers);
  const showNumbers = mountNumbers(numbers, store, source);
  const show = () => {
    showChoices();
    showNumbers();
  };
  store.subscribe((now, before) => {
    if (now.document.shot !== before.document.shot) show();
  });
  show();
}

/** The physics of the present shot file, and the presets that it starts from. */
class FilePhysics {
  readonly #store: Store;
  readonly engine: Engine;

  constructor(store: Store, engine: Engine) {
    this.#store = store;
    this.engine = engine;
  }

  /** The file's own values. */
  get changes(): Values {
    const { physics } = this.#store.document.shot;
    return typeof physics === "object" ? physics : {};
  }

  /** The preset that the file names. */
  get named(): string {
    const { physics } = this.#store.document.shot;
    const name = typeof physics === "string" ? physics : this.changes.base;
    return typeof name === "string" ? this.engine.currentPresetName(name) : TABLES_OWN;
  }

  /** The table's preset. */
  get tables(): string {
    return this.#store.shot.geometry.physics ?? "pool";
  }

  /** The preset whose values the file's own replace. */
  get base(): string {
    return this.named || this.tables;
  }

  get baseValues(): Values {
    return this.engine.physics[this.base] ?? {};
  }

  get values(): Values {
    return this.#store.shot.physics;
  }

  /** Writes the physics, or none for the table's own. @returns Whether it was accepted. */
  write(physics: string | Values | undefined): boolean {
    const shot: { -readonly [K in keyof AimedShot]: AimedShot[K] } = {
      ...this.#store.document.shot,
    };
    if (physics === undefined) delete shot.physics;
    else shot.physics = physics;
    // A step of its own for undo, after that of a number that is being typed.
    this.#store.settle();
    return this.#store.apply({ shot }, t("change.physics"));
  }
}

/** The lists of conditions. @returns Shows the present ones. */
function mountChoices(root: HTMLElement, source: FilePhysics): () => void {
  const { physics: presets } = source.engine;
  const rows = TABLE_PARTS.map((part) => {
    const select = h("select", { id: uniqueId("condition") });
    select.addEventListener("change", () => {
      const { base, tables: own, values } = source;
      const choice = [part, select.value] as const;
      if (!source.write(withChoice(values, choice, { presets, base, own }))) show();
    });
    const label = h("label", { for: select.id }, t(`physics.${part}`));
    const row = h("div", { class: "labelled" }, label, select);
    return { part, select, row, numbers: option(NUMBERS, t("physics.own-numbers")) };
  });
  const hint = h("p", { class: "hint" });
  root.append(...rows.map(({ row }) => row), hint);
  let listed = "";

  function show(): void {
    const { base, tables, values } = source;
    const family = familyOf(base, presets);
    // New entries would close a list that the user has opened.
    const isListed = listed === `${family} ${tables}`;
    listed = `${family} ${tables}`;
    for (const { part, select, row, numbers } of rows) {
      const conditions = offered(part, family, presets);
      row.hidden = conditions.length === 0;
      if (!isListed) {
        const entry = (name: string) => option(name, label(part, name, family === tables));
        select.replaceChildren(...conditions.map(entry));
      }
      const present = chosen(part, values, { presets, base });
      // Own numbers cannot be chosen here.
      if (present === NUMBERS) select.append(numbers);
      else numbers.remove();
      select.value = present;
    }
    const some = rows.some(({ row }) => !row.hidden);
    setText(hint, t(some ? "physics.choices-hint" : "physics.no-choices"));
  }
  return show;
}

/** @param isTables Whether the table has the usual condition. */
function label(part: TablePart, condition: string, isTables: boolean): string {
  if (condition !== USUAL) return named("condition", condition) ?? condition;
  if (part === "balls") return t("physics.used-balls");
  return t(isTables ? "physics.as-the-table" : "physics.usual");
}

function option(value: string, text: string): HTMLOptionElement {
  return h("option", { value }, text);
}

/** The preset and its parameters. @returns Shows the present ones. */
function mountNumbers(root: HTMLElement, store: Store, source: FilePhysics): () => void {
  const { engine } = source;
  const preset = h("select", { id: uniqueId("preset") });
  const tablesOwn = option(TABLES_OWN, "");
  preset.append(tablesOwn, ...presetOptions(Object.keys(engine.physics)));
  preset.addEventListener("change", () => {
    if (!source.write(preset.value === TABLES_OWN ? undefined : preset.value)) show();
  });
  const form = h("div");
  root.append(
    h("div", { class: "labelled" }, h("label", { for: preset.id }, t("physics.preset")), preset),
    h("p", { class: "hint" }, t("layout.changed-hint")),
    form,
  );
  const showForm = mountParameters(form, store, engine.schema("shot"), {
    part: "physics",
    values: () => ({
      now: source.values,
      base: source.baseValues,
      changes: {
        ...source.changes,
        ...(source.named === TABLES_OWN ? {} : { base: source.named }),
      },
    }),
    write: (physics, path) =>
      store.apply(
        ({ shot }) => ({ shot: { ...shot, physics } }),
        t("change.parameter", { name: nameOfPath(path) }),
        `physics ${path.join(".")}`,
      ),
    coefficient: (key, argument) =>
      round(store.shot.coefficientAt(key as CoefficientKey, MIDDLE[argument]), DIGITS),
    open: ["cloth"],
  });

  function show(): void {
    setText(tablesOwn, t("physics.tables-own", { preset: presetLabel(source.tables) }));
    preset.value = source.named;
    showForm();
  }
  return show;
}
