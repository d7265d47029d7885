/** A form of parameters, one row each. Changed values are marked and can be reset. */

import { h, uniqueId } from "../common/dom.ts";
import { nameOfPath, title } from "../common/parameter-names.ts";
import {
  type Coefficient,
  inKind,
  type Kind,
  kindLabel,
  kindOf,
  kinds,
  quantityOf,
} from "./kinds.ts";
import {
  isChanged,
  label,
  parameters,
  QUANTITY,
  quantitySchema,
  valueAt,
  withoutValue,
  withValue,
  writtenPath,
  type Parameter,
  type Part,
  type Values,
} from "./parameters.ts";
import type { Store } from "../document/store.ts";
import { round } from "../common/units.ts";
import { capital, named, t } from "../words/translate.ts";

/** The values that a form shows and changes. */
export interface Subject {
  readonly part: Part;
  /** The present values, and those of the preset that the changes start from. */
  readonly now: () => Values;
  readonly base: () => Values;
  /** The changes in the shot file, with their `base`. */
  readonly changes: () => Values;
  /** Writes the changes to the shot file. @returns Whether they were accepted. */
  readonly write: (changes: Values, path: readonly string[]) => boolean;
  /** The engine's coefficient of a quantity at a middle speed or angle; null if none depends on them. */
  readonly coefficient: Coefficient | null;
  /** Keys of the groups that are open at first. */
  readonly open: readonly string[];
}

/** Decimals shown: lengths to a micrometre, without the rounding errors of binary fractions. */
const DIGITS = 6;

/** @returns A function that updates the form to the present values. */
export function mountParameters(
  root: HTMLElement,
  store: Store,
  schema: object,
  subject: Subject,
): () => void {
  const { part } = subject;
  let shown = "";
  /** Whether a group is open, by its key: it stays so when its rows change. */
  const open = new Map<string, boolean>();
  /** Whether the rows are being replaced: a focused field that is removed loses the focus, and shows again. */
  let isReplacing = false;

  function set(path: readonly string[], value: unknown): boolean {
    const [own, now] = [subject.changes(), subject.now()];
    const written = writtenPath(now, path);
    const next =
      written.length < path.length ? valueAt(withValue(now, path, value), written) : value;
    const same = text(valueAt(subject.base(), written)) === text(next);
    return subject.write(same ? withoutValue(own, written) : withValue(own, written, next), path);
  }

  function show(): void {
    if (isReplacing) return;
    const now = subject.now();
    const found = parameters(schema, part, now);
    const key = JSON.stringify(found.map(({ path, kind }) => [path, kind]));
    if (key !== shown) {
      shown = key;
      for (const group of root.querySelectorAll<HTMLDetailsElement>("details[data-group]"))
        open.set(group.dataset.group!, group.open);
      isReplacing = true;
      root.replaceChildren(...groups(found));
      isReplacing = false;
    }
    const [base, changes] = [subject.base(), subject.changes()];
    for (const { path } of found) {
      const input = root.querySelector<Control>(`[data-path="${path.join(".")}"]`)!;
      const value = text(valueAt(now, path));
      // Do not overwrite a number while the user types it.
      if (
        input.value !== value &&
        (input !== document.activeElement || input.tagName === "SELECT")
      ) {
        input.value = value;
      }
      const row = input.closest(".parameter")!;
      row.toggleAttribute("data-changed", isChanged(changes, base, path));
    }
    for (const select of root.querySelectorAll<HTMLSelectElement>("select[data-kind]")) {
      const path = select.dataset.kind!.split(".");
      const [kind, usual] = [kindOf(valueAt(now, path)), kindOf(valueAt(base, path))];
      select.value = kind ?? "";
      select.closest(".parameter")!.toggleAttribute("data-changed", kind !== usual);
    }
  }

  /** Single values first, then one collapsible group per object. */
  function groups(found: readonly Parameter[]): HTMLElement[] {
    const single = found.filter(({ path }) => path.length === 1);
    const keys = [
      ...new Set(found.filter(({ path }) => path.length > 1).map(({ path }) => path[0]!)),
    ];
    return [
      ...single.map((parameter) => row(parameter)),
      ...keys.map((key) =>
        h(
          "details",
          { open: open.get(key) ?? subject.open.includes(key), "data-group": key },
          h("summary", {}, title(key)),
          ...entries(found.filter(({ path }) => path.length > 1 && path[0] === key)),
        ),
      ),
    ];
  }

  /** The rows of a group. Those of a fit or of a list are below its name and formula. */
  function entries(found: readonly Parameter[]): HTMLElement[] {
    return [...new Set(found.map(({ path }) => path[QUANTITY - 1]!))].flatMap((key) => {
      const same = found.filter(({ path }) => path[QUANTITY - 1] === key);
      const { quantity } = same[0]!;
      const path = quantityOf(same[0]!);
      const control = kindRow(path);
      if (quantity === "") {
        const only = same.map((parameter) => row(parameter));
        if (!control) return only;
        const group = { class: "quantity", role: "group", "aria-label": title(key) };
        return h("div", group, ...only, control);
      }
      // The bands of a list have the same hints: they are shown once, and read aloud for each.
      const shown = new Set<string>();
      const rows = same.map((parameter) => {
        const again = shown.has(parameter.description);
        shown.add(parameter.description);
        return row(parameter, again);
      });
      const name = h("h3", { id: uniqueId("quantity") }, title(key));
      return h(
        "div",
        { class: "quantity", role: "group", "aria-labelledby": name.id },
        name,
        h("p", { class: "hint" }, quantity),
        ...rows,
        control,
      );
    });
  }

  /** The control that chooses between a number and numbers by speed; null if there is no choice. */
  function kindRow(path: readonly string[]): HTMLElement | null {
    const { coefficient } = subject;
    const quantity = quantitySchema(schema, part, path);
    const choices = kinds(quantity, valueAt(subject.now(), path));
    if (!coefficient || !quantity || choices.length === 0) return null;
    const options = choices.map((kind) => h("option", { value: kind }, kindLabel(quantity, kind)));
    const id = uniqueId("kind");
    const select = h("select", { id, "data-kind": path.join(".") }, ...options);
    const write = (value: unknown) => {
      // A step of its own for undo, after that of a number that is being typed.
      store.settle();
      set(path, value);
      store.settle();
      show();
      // The rows of the group are new ones.
      root.querySelector<HTMLSelectElement>(`[data-kind="${path.join(".")}"]`)?.focus();
    };
    select.addEventListener("change", () => {
      const values = { now: subject.now(), base: subject.base() };
      write(inKind([path, quantity], select.value as Kind, values, coefficient));
    });
    const label = t("parameter.reset-kind", { name: nameOfPath(path) });
    const reset = () => {
      write(valueAt(subject.base(), path));
    };
    return h(
      "div",
      { class: "parameter" },
      h("label", { for: id }, t("physics.given")),
      h("div", { class: "row" }, select, back(label, reset)),
    );
  }

  function row(parameter: Parameter, hintAgain = false): HTMLElement {
    const { path, description, unit } = parameter;
    const input = control(parameter);
    input.id = uniqueId("parameter");
    input.setAttribute("aria-describedby", `${input.id}-hint`);
    const refused = (is: boolean) => {
      input.setAttribute("aria-invalid", String(is));
    };
    input.addEventListener("change", () => {
      const value = valueOf(parameter, input.value);
      if (value === null)
        store.refuse(t("field.not-a-number", { name: capital(nameOfPath(path)) }));
      refused(value === null || !set(path, value));
    });
    input.addEventListener("blur", () => {
      refused(false);
      store.settle();
      show();
    });
    const reset = () => {
      const written = writtenPath(subject.now(), path);
      set(written, valueAt(subject.base(), written));
      store.settle();
    };
    const name = nameOfPath(path);
    return h(
      "div",
      { class: "parameter" },
      h("label", { for: input.id }, label(parameter)),
      h(
        "div",
        { class: "row" },
        input,
        h("span", { class: "unit" }, unit === "deg" ? "°" : unit),
        back(t("parameter.reset-named", { name }), reset),
      ),
      h("p", { class: hintAgain ? "hint unseen" : "hint", id: `${input.id}-hint` }, description),
    );
  }

  return show;
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

/** The value for the file; null if the text is not a number. */
function valueOf({ kind }: Parameter, written: string): string | number | null {
  if (kind === "choice") return written;
  const number = written.trim() === "" ? NaN : Number(written);
  return Number.isNaN(number) ? null : number;
}

/** A value of the file as text. */
function text(value: unknown): string {
  if (typeof value === "number") return String(round(value, DIGITS));
  if (value === undefined) return "";
  return typeof value === "string" ? value : JSON.stringify(value);
}
