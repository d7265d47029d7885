/** The table: its preset and its dimensions. */

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
  const select = h(
    "select",
    { id: uniqueId("control") },
    own,
    ...presetOptions([...presets.keys()]),
  );
  select.addEventListener("change", () => {
    if (select.value === "" || !changeTable(store, engine, select.value)) show();
  });
  const back = h(
    "button",
    {
      type: "button",
      class: "button",
      onclick: () => {
        changeTable(store, engine, baseName());
      },
    },
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

  const changes = (): Values => {
    const { table } = store.document.shot;
    return typeof table === "string" ? { base: table } : table;
  };
  const baseName = (): string => {
    const { base } = changes();
    return typeof base === "string" ? engine.currentPresetName(base) : "";
  };
  const preset = () => presets.get(baseName());
  const showForm = mountParameters(form, store, engine.schema("shot"), {
    part: "table",
    now: () => tableValues(store.shot.geometry),
    base: () => {
      const geometry = preset();
      return geometry ? tableValues(geometry) : {};
    },
    changes,
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

  function show(): void {
    const { table } = store.document.shot;
    own.hidden = baseName() !== "";
    select.value = baseName();
    back.hidden = typeof table === "string" || baseName() === "";
    dimensions.hidden = !store.shot.geometry.dimensions;
    showForm();
  }
  store.subscribe((now, before) => {
    if (now.document.shot !== before.document.shot) show();
  });
  show();
}
