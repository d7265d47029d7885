/** The table: its preset and its dimensions. */

import type { Engine, Geometry } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, uniqueId } from "../common/dom.ts";
import { nameOfPath } from "../common/parameter-names.ts";
import { presetOptions } from "../common/preset-names.ts";
import { changeTable } from "../document/layout-changes.ts";
import { mountParameters } from "../form/parameter-rows.ts";
import type { Values } from "../form/parameters.ts";
import type { Store } from "../document/store.ts";
import { tableValues, withMarkings } from "./table-form.ts";
import { t } from "../words/translate.ts";

/** Dimensions that also move the markings on the cloth. */
const SIZES = ["width", "length"];

export function mountTable(root: HTMLElement, store: Store, { engine }: Context): void {
  const presets = new Map(
    engine.tables.flatMap((table) => (table.name ? [[table.name, table]] : [])),
  );
  const own = h("option", { value: "" }, t("layout.own-table"));
  const options = presetOptions([...presets.keys()]);
  const select = h("select", { id: uniqueId("control") }, own, ...options);
  const reset = () => changeTable(store, engine, baseName());
  const back = h(
    "button",
    { type: "button", class: "button", onclick: reset },
    t("layout.reset-all"),
  );
  const form = h("div");
  const dimensions = h(
    "details",
    {},
    h("summary", {}, t("layout.dimensions")),
    h("p", { class: "hint" }, t("layout.changed-hint")),
    form,
    h("div", { class: "row" }, back),
  );
  root.append(
    h("h2", {}, t("layout.table")),
    h("div", { class: "labelled" }, h("label", { for: select.id }, t("layout.table")), select),
    dimensions,
  );
  const baseName = (): string => {
    const { base } = changesOf(store);
    return typeof base === "string" ? engine.currentPresetName(base) : "";
  };
  const showForm = mountForm(form, store, engine, () => presets.get(baseName()));

  function show(): void {
    const { table } = store.document.shot;
    own.hidden = baseName() !== "";
    select.value = baseName();
    back.hidden = typeof table === "string" || baseName() === "";
    dimensions.hidden = !store.shot.geometry.dimensions;
    showForm();
  }
  select.addEventListener("change", () => {
    if (select.value === "" || !changeTable(store, engine, select.value)) show();
  });
  store.subscribe((now, before) => {
    if (now.document.shot !== before.document.shot) show();
  });
  show();
}

/** The changes of the shot's table, with their `base`. */
function changesOf(store: Store): Values {
  const { table } = store.document.shot;
  return typeof table === "string" ? { base: table } : table;
}

/** @param preset The table that the changes start from. */
function mountForm(
  form: HTMLElement,
  store: Store,
  engine: Engine,
  preset: () => Geometry | undefined,
): () => void {
  return mountParameters(form, store, engine.schema("shot"), {
    part: "table",
    values: () => {
      const geometry = preset();
      const base = geometry ? tableValues(geometry) : {};
      return { now: tableValues(store.shot.geometry), base, changes: changesOf(store) };
    },
    write: (next, path) => {
      const { geometry } = store.shot;
      const whole = SIZES.includes(path[0]!) ? withMarkings(next, geometry, preset()) : next;
      const { base, ...rest } = whole;
      // Without changes the preset's name is enough.
      const table = typeof base === "string" && Object.keys(rest).length === 0 ? base : whole;
      const name = ["table", ...path].join(".");
      return store.apply(
        ({ shot }) => ({ shot: { ...shot, table } }),
        t("change.parameter", { name: nameOfPath(path) }),
        name,
      );
    },
    coefficient: null,
    open: [],
  });
}
