/** A form of parameters, one row each. Changed values are marked and can be reset. */

import { h, uniqueId } from "../common/dom.ts";
import {
  isChanged,
  label,
  parameters,
  QUANTITY,
  title,
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

  function set(path: readonly string[], value: unknown): boolean {
    const [own, now] = [subject.changes(), subject.now()];
    const written = writtenPath(now, path);
    const next =
      written.length < path.length ? valueAt(withValue(now, path, value), written) : value;
    const same = text(valueAt(subject.base(), written)) === text(next);
    return subject.write(same ? withoutValue(own, written) : withValue(own, written, next), path);
  }

  function show(): void {
    const now = subject.now();
    const found = parameters(schema, part, now);
    const key = JSON.stringify(found.map(({ path }) => path));
    if (key !== shown) {
      shown = key;
      root.replaceChildren(...groups(found));
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
          { open: subject.open.includes(key) },
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
      if (quantity === "") return same.map((parameter) => row(parameter));
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
      );
    });
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
      if (value === null) store.refuse(`${[part, ...path].join(".")}: write a number.`);
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
    const full = path.map(title).join(" ").toLowerCase();
    const back = h(
      "button",
      {
        type: "button",
        class: "button plain back",
        "aria-label": `Reset ${full}`,
        title: "Reset",
        onclick: reset,
      },
      "↺",
    );
    return h(
      "div",
      { class: "parameter" },
      h("label", { for: input.id }, label(parameter)),
      h(
        "div",
        { class: "row" },
        input,
        h("span", { class: "unit" }, unit === "degrees" ? "°" : unit),
        back,
      ),
      h("p", { class: hintAgain ? "hint unseen" : "hint", id: `${input.id}-hint` }, description),
    );
  }

  return show;
}

type Control = HTMLInputElement | HTMLSelectElement;

function control({ path, kind, choices }: Parameter): Control {
  const data = { "data-path": path.join(".") };
  if (kind === "number") return h("input", { type: "number", step: "any", ...data });
  return h("select", data, ...choices.map((name) => h("option", { value: name }, name)));
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
