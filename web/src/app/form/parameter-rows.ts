/** A form of parameters, one row each. Changed values are marked and can be reset. */

import { h, uniqueId } from "../common/dom.ts";
import { nameOfPath, title } from "../common/parameter-names.ts";
import { type Coefficient, inKind, type Kind, kindLabel, kinds } from "./kinds.ts";
import {
  label,
  type Parameter,
  parameters,
  type Part,
  quantitySchema,
  valueAt,
  type Values,
  writtenPath,
} from "./parameters.ts";
import {
  changesWith,
  type FormValues,
  grouped,
  type Quantity,
  rowKind,
  rowValue,
  valueOf,
} from "./row-values.ts";
import type { Store } from "../document/store.ts";
import { capital, named, t } from "../words/translate.ts";

/** The values that a form shows and changes. */
export interface Subject {
  readonly part: Part;
  readonly values: () => FormValues;
  /** Writes the changes to the shot file. @returns Whether they were accepted. */
  readonly write: (changes: Values, path: readonly string[]) => boolean;
  /** The engine's coefficient of a quantity at a middle speed or angle; null if none depends on them. */
  readonly coefficient: Coefficient | null;
  /** Keys of the groups that are open at first. */
  readonly open: readonly string[];
}

/** @returns A function that updates the form to the present values. */
export function mountParameters(
  root: HTMLElement,
  store: Store,
  schema: object,
  subject: Subject,
): () => void {
  const form = new ParameterForm(root, store, schema, subject);
  return () => form.show();
}

class ParameterForm {
  readonly #root: HTMLElement;
  readonly #store: Store;
  readonly #schema: object;
  readonly #subject: Subject;
  /** The paths and kinds of the rows that are shown. */
  #shown = "";
  /** Whether a group is open, by its key: it stays so when its rows change. */
  readonly #open = new Map<string, boolean>();
  /** Whether the rows are being replaced: a focused field that is removed loses the focus, and shows again. */
  #isReplacing = false;

  constructor(root: HTMLElement, store: Store, schema: object, subject: Subject) {
    this.#root = root;
    this.#store = store;
    this.#schema = schema;
    this.#subject = subject;
  }

  #set(path: readonly string[], value: unknown): boolean {
    return this.#subject.write(changesWith(this.#subject.values(), path, value), path);
  }

  show(): void {
    if (this.#isReplacing) return;
    const values = this.#subject.values();
    const found = parameters(this.#schema, this.#subject.part, values.now);
    this.#showRows(found);
    for (const { path } of found) {
      const input = this.#root.querySelector<Control>(`[data-path="${path.join(".")}"]`)!;
      const [value, isChanged] = rowValue(values, path);
      // Do not overwrite a number while the user types it.
      if (
        input.value !== value &&
        (input !== document.activeElement || input.tagName === "SELECT")
      ) {
        input.value = value;
      }
      mark(input, isChanged);
    }
    for (const select of this.#root.querySelectorAll<HTMLSelectElement>("select[data-kind]")) {
      const [kind, isChanged] = rowKind(values, select.dataset.kind!.split("."));
      select.value = kind ?? "";
      mark(select, isChanged);
    }
  }

  /** Replaces the rows if there are other parameters than before. */
  #showRows(found: readonly Parameter[]): void {
    const key = JSON.stringify(found.map(({ path, kind }) => [path, kind]));
    if (key === this.#shown) return;
    this.#shown = key;
    for (const group of this.#root.querySelectorAll<HTMLDetailsElement>("details[data-group]"))
      this.#open.set(group.dataset.group!, group.open);
    this.#isReplacing = true;
    this.#root.replaceChildren(...this.#groups(found));
    this.#isReplacing = false;
  }

  /** Single values first, then one collapsible group per object. */
  #groups(found: readonly Parameter[]): HTMLElement[] {
    const { single, groups } = grouped(found);
    return [
      ...single.map((parameter) => this.#row(parameter)),
      ...groups.map(([key, quantities]) =>
        h(
          "details",
          { open: this.#open.get(key) ?? this.#subject.open.includes(key), "data-group": key },
          h("summary", {}, title(key)),
          ...quantities.flatMap((quantity) => this.#quantity(quantity)),
        ),
      ),
    ];
  }

  /** The rows of a quantity. Those of a fit or of a list are below its name and formula. */
  #quantity({ path, hint, rows }: Quantity): HTMLElement | HTMLElement[] {
    const control = this.#kindRow(path);
    const shown = rows.map(({ parameter, isHintRepeated }) => this.#row(parameter, isHintRepeated));
    if (hint === "" && !control) return shown;
    const key = title(path.at(-1)!);
    const group = { class: "quantity", role: "group" };
    if (hint === "") return h("div", { ...group, "aria-label": key }, ...shown, control);
    const name = h("h3", { id: uniqueId("quantity") }, key);
    const below = [h("p", { class: "hint" }, hint), ...shown, control];
    return h("div", { ...group, "aria-labelledby": name.id }, name, ...below);
  }

  /** The control that chooses between a number and numbers by speed; null if there is no choice. */
  #kindRow(path: readonly string[]): HTMLElement | null {
    const { coefficient, part, values } = this.#subject;
    const quantity = quantitySchema(this.#schema, part, path);
    const choices = kinds(quantity, valueAt(values().now, path));
    if (!coefficient || !quantity || choices.length === 0) return null;
    const options = choices.map((kind) => h("option", { value: kind }, kindLabel(quantity, kind)));
    const id = uniqueId("kind");
    const select = h("select", { id, "data-kind": path.join(".") }, ...options);
    select.addEventListener("change", () => {
      const kind = select.value as Kind;
      this.#writeKind(path, inKind([path, quantity], kind, values(), coefficient));
    });
    const label = t("parameter.reset-kind", { name: nameOfPath(path) });
    const reset = () => this.#writeKind(path, valueAt(values().base, path));
    return h(
      "div",
      { class: "parameter" },
      h("label", { for: id }, t("physics.given")),
      h("div", { class: "row" }, select, back(label, reset)),
    );
  }

  #writeKind(path: readonly string[], value: unknown): void {
    // A step of its own for undo, after that of a number that is being typed.
    this.#store.settle();
    this.#set(path, value);
    this.#store.settle();
    this.show();
    // The rows of the group are new ones.
    this.#root.querySelector<HTMLSelectElement>(`[data-kind="${path.join(".")}"]`)?.focus();
  }

  #row(parameter: Parameter, isHintRepeated = false): HTMLElement {
    const { path, description, unit } = parameter;
    const input = this.#input(parameter);
    const reset = () => {
      const { now, base } = this.#subject.values();
      const written = writtenPath(now, path);
      this.#set(written, valueAt(base, written));
      this.#store.settle();
    };
    const id = `${input.id}-hint`;
    return h(
      "div",
      { class: "parameter" },
      h("label", { for: input.id }, label(parameter)),
      h(
        "div",
        { class: "row" },
        input,
        h("span", { class: "unit" }, unit === "deg" ? "°" : unit),
        back(t("parameter.reset-named", { name: nameOfPath(path) }), reset),
      ),
      // A repeated hint is not shown, but read aloud.
      h("p", { class: isHintRepeated ? "hint unseen" : "hint", id }, description),
    );
  }

  /** The field of a parameter. It is invalid until it loses the focus if its value is refused. */
  #input(parameter: Parameter): Control {
    const { path } = parameter;
    const input = control(parameter);
    input.id = uniqueId("parameter");
    input.setAttribute("aria-describedby", `${input.id}-hint`);
    const setRefused = (is: boolean) => input.setAttribute("aria-invalid", String(is));
    input.addEventListener("change", () => {
      const value = valueOf(parameter, input.value);
      if (value === null)
        this.#store.refuse(t("field.not-a-number", { name: capital(nameOfPath(path)) }));
      setRefused(value === null || !this.#set(path, value));
    });
    input.addEventListener("blur", () => {
      setRefused(false);
      this.#store.settle();
      this.show();
    });
    return input;
  }
}

/** Marks the row of a field as changed. */
function mark(field: Control, isChanged: boolean): void {
  field.closest(".parameter")!.toggleAttribute("data-changed", isChanged);
}

/** A button that resets a value. */
function back(label: string, onclick: () => void): HTMLElement {
  return h(
    "button",
    {
      type: "button",
      class: "button plain back",
      "aria-label": label,
      title: t("parameter.reset"),
      onclick,
    },
    "↺",
  );
}

type Control = HTMLInputElement | HTMLSelectElement;

function control({ path, kind, choices }: Parameter): Control {
  const data = { "data-path": path.join(".") };
  if (kind === "number") return h("input", { type: "number", step: "any", ...data });
  return h(
    "select",
    data,
    ...choices.map((name) => h("option", { value: name }, choiceLabel(name))),
  );
}

/** A choice in words; a model named after its paper has its author and year. */
function choiceLabel(name: string): string {
  return named("choice-of", name) ?? capital(name.replaceAll("-", " "));
}
