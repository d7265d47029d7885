/** The Physics tab: the preset and its parameters, in the order of the shot file's schema. */

import type { CoefficientKey } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import type { AimedShot } from "../document/document.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import { nameOfPath } from "../common/parameter-names.ts";
import { presetLabel, presetOptions } from "../common/presets.ts";
import { mountParameters } from "../form/parameter-rows.ts";
import { merged, type Values } from "../form/parameters.ts";
import type { Store } from "../document/store.ts";
import { round } from "../common/units.ts";
import { t } from "../words/translate.ts";

/** Speed (m/s) and angle (rad) at which a coefficient becomes a number: a soft shot, half a right angle. */
const MIDDLE_SPEED = 1;
const MIDDLE_ANGLE = Math.PI / 4;

/** Digits of that number: measurements have fewer. */
const DIGITS = 4;

/** The list's value for the table's own physics. */
const TABLES_OWN = "";

export function mountPhysicsPanel(root: HTMLElement, store: Store, { engine }: Context): void {
  const preset = h("select", { id: uniqueId("preset") });
  const tablesOwn = h("option", { value: TABLES_OWN });
  preset.append(tablesOwn, ...presetOptions(Object.keys(engine.physics)));
  preset.addEventListener("change", () => {
    const next: { -readonly [K in keyof AimedShot]: AimedShot[K] } = { ...store.document.shot };
    if (preset.value === TABLES_OWN) delete next.physics;
    else next.physics = preset.value;
    if (!store.apply({ shot: next }, t("change.physics"))) show();
  });
  const form = h("div");
  root.append(
    h("h2", {}, t("physics.title")),
    h("div", { class: "labelled" }, h("label", { for: preset.id }, t("physics.preset")), preset),
    h("p", { class: "hint" }, t("layout.changed-hint")),
    form,
  );

  const own = (): Values => {
    const { physics } = store.document.shot;
    return typeof physics === "object" ? physics : {};
  };
  const baseName = () => {
    const { physics } = store.document.shot;
    if (typeof physics === "string") return engine.currentPresetName(physics);
    const { base } = own();
    return typeof base === "string" ? engine.currentPresetName(base) : TABLES_OWN;
  };
  const ownName = () => store.shot.geometry.physics ?? "pool";
  const base = (): Values => engine.physics[baseName() || ownName()] ?? {};
  const showForm = mountParameters(form, store, engine.schema("shot"), {
    part: "physics",
    now: () => merged(base(), own()),
    base,
    changes: () => ({ ...own(), ...(baseName() === TABLES_OWN ? {} : { base: baseName() }) }),
    write: (physics, path) =>
      store.apply(
        ({ shot }) => ({ shot: { ...shot, physics } }),
        t("change.parameter", { name: nameOfPath(path) }),
        `physics ${path.join(".")}`,
      ),
    coefficient: (key) => {
      const at = key === "cushion.friction" ? MIDDLE_ANGLE : MIDDLE_SPEED;
      return round(store.shot.coefficientAt(key as CoefficientKey, at), DIGITS);
    },
    open: ["cloth"],
  });

  function show(): void {
    setText(tablesOwn, t("physics.tables-own", { preset: presetLabel(ownName()) }));
    preset.value = baseName();
    showForm();
  }
  store.subscribe((now, before) => {
    if (now.document.shot !== before.document.shot) show();
  });
  show();
}
