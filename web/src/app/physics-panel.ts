/** Physics presets, and every parameter of theirs: the form follows the shot file's schema. */

import type { Context } from "./context.ts";
import type { AimedShot } from "./document.ts";
import { h, uniqueId } from "./dom.ts";
import {
  merged,
  parameters,
  title,
  valueAt,
  withoutValue,
  withValue,
  type Parameter,
  type Values,
} from "./physics-form.ts";
import type { Store } from "./store.ts";

/** What the table's own physics is called in the list. */
const TABLES_OWN = "";

export function mountPhysicsPanel(root: HTMLElement, store: Store, { engine }: Context): void {
  const schema = engine.schema("shot");
  const preset = h("select", { id: uniqueId("preset") });
  preset.append(
    h("option", { value: TABLES_OWN }, "The table’s own"),
    ...Object.keys(engine.physics).map((name) => h("option", { value: name }, title(name))),
  );
  preset.addEventListener("change", () => {
    const next: { -readonly [K in keyof AimedShot]: AimedShot[K] } = { ...store.document.shot };
    if (preset.value === TABLES_OWN) delete next.physics;
    else next.physics = preset.value;
    if (!store.apply({ shot: next }, "change the physics")) show();
  });
  const form = h("div");
  root.append(
    h("h2", {}, "Physics"),
    h("div", { class: "labelled" }, h("label", { for: preset.id }, "Preset"), preset),
    h("p", { class: "hint" }, "A changed value is marked, and can be put back."),
    form,
  );

  const changes = (): Values => {
    const { physics } = store.document.shot;
    return typeof physics === "object" ? physics : {};
  };
  const baseName = () => {
    const { physics } = store.document.shot;
    if (typeof physics === "string") return physics;
    const { base } = changes();
    return typeof base === "string" ? base : TABLES_OWN;
  };
  const base = (): Values =>
    engine.physics[baseName() || (store.shot.geometry.physics ?? "pool")] ?? {};

  function set(path: readonly string[], value: unknown): boolean {
    const same = valueAt(base(), path) === value;
    const named: Values = baseName() === TABLES_OWN ? {} : { base: baseName() };
    const own = { ...changes(), ...named };
    const next = same ? withoutValue(own, path) : withValue(own, path, value);
    return store.apply(
      ({ shot }) => ({ shot: { ...shot, physics: next } }),
      `change ${path.join(".")}`,
      `physics ${path.join(".")}`,
    );
  }

  let shown = "";
  function show(): void {
    preset.value = baseName();
    const now = merged(base(), changes());
    const found = parameters(schema, now);
    const key = JSON.stringify(found.map(({ path }) => path));
    if (key !== shown) {
      shown = key;
      form.replaceChildren(...groups(found));
    }
    for (const input of form.querySelectorAll<HTMLInputElement | HTMLSelectElement>(
      "[data-path]",
    )) {
      const path = input.dataset.path!.split(".");
      const value = String(valueAt(now, path));
      if (
        input.value !== value &&
        (input !== document.activeElement || input.tagName === "SELECT")
      ) {
        input.value = value;
      }
      const changed = valueAt(changes(), path) !== undefined;
      input.closest(".parameter")!.toggleAttribute("data-changed", changed);
    }
  }

  function groups(found: readonly Parameter[]): HTMLElement[] {
    const keys = [...new Set(found.map(({ path }) => path[0]!))];
    return keys.map((key) => {
      const inside = found.filter(({ path }) => path[0] === key);
      return h(
        "details",
        { open: key === "cloth" },
        h("summary", {}, title(key)),
        ...inside.map((parameter) => row(parameter)),
      );
    });
  }

  function row({ path, kind, choices, description, unit }: Parameter): HTMLElement {
    const id = uniqueId("parameter");
    const data = { id, "data-path": path.join("."), "aria-describedby": `${id}-hint` };
    const input =
      kind === "choice"
        ? h("select", data, ...choices.map((name) => h("option", { value: name }, name)))
        : h("input", { type: "number", step: "any", ...data });
    const refused = () => input.setAttribute("aria-invalid", "true");
    const accepted = () => input.removeAttribute("aria-invalid");
    input.addEventListener("change", () => {
      const number = input.value.trim() === "" ? NaN : Number(input.value);
      if (kind === "number" && Number.isNaN(number)) {
        store.refuse(`${path.join(".")}: write a number.`);
        refused();
      } else if (set(path, kind === "choice" ? input.value : number)) accepted();
      else refused();
    });
    input.addEventListener("blur", () => {
      accepted();
      store.settle();
      show();
    });
    const name = path.length > 1 ? path.slice(1).map(title).join(", ") : title(path[0]!);
    const back = h(
      "button",
      {
        type: "button",
        class: "button plain back",
        "aria-label": `Put back ${title(path.join(" "))}`,
        title: "Put back",
        onclick: () => {
          set(path, valueAt(base(), path));
          store.settle();
        },
      },
      "↺",
    );
    return h(
      "div",
      { class: "parameter" },
      h("label", { for: id }, name),
      h("div", { class: "row" }, input, h("span", { class: "unit" }, unit), back),
      h("p", { class: "hint", id: `${id}-hint` }, description),
    );
  }

  store.subscribe((now, before) => {
    if (now.document.shot !== before.document.shot) show();
  });
  show();
}
