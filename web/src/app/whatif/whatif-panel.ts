/** The What if tab: the effect of a player's execution errors on the shot. */

import "./whatif-panel.css";
import { CaromError, type Noise } from "../../engine/index.ts";
import { RAMP } from "../../viewer/index.ts";
import type { Context } from "../common/context.ts";
import { h, uniqueId } from "../common/dom.ts";
import { errorText } from "../common/refusals.ts";
import { mountField } from "../form/field.ts";
import { guideOf } from "../document/stored-game.ts";
import { canAim } from "../game/awaited-turn.ts";
import type { State, Store } from "../document/store.ts";
import { type VariantsProgress, Variants } from "./variants-client.ts";
import { CLING, presetOf, presetsOf, type Sigma, SIGMAS } from "./noise-presets.ts";
import { mountResult } from "./pocket-chances.ts";
import VariantsWorker from "./variants-worker.ts?worker&inline";
import { inSentence, t } from "../words/translate.ts";

/** Variants per change of the shot: the standard error of a chance of one half is then 1.6 %. */
const COUNT = 1000;

/** Paths of the struck ball that are drawn: more would cover each other. */
const PATHS = 60;

/** The largest whole number that JavaScript represents exactly. */
const LARGEST_SEED = Number.MAX_SAFE_INTEGER;

/** The largest seed that a click draws: short numbers are easy to pass on. */
const LARGEST_DRAWN_SEED = 9999;

export function mountWhatIf(root: HTMLElement, store: Store, context: Context): void {
  const on = h("input", { type: "checkbox", id: uniqueId("noise"), role: "switch" });
  on.addEventListener("change", () => {
    const level = context.engine.noisePresets[store.session.analysis.level];
    const noise = on.checked ? (level ?? context.engine.olympiad()) : null;
    store.apply({ noise }, t(on.checked ? "change.noise-on" : "change.noise-off"));
  });
  const intro = h("p", { class: "hint" }, t("whatif.intro", { count: COUNT }));
  const settings = h("div", { class: "settings" });
  const result = h("section", { "aria-label": t("whatif.result") });
  root.append(
    h("div", { class: "switch row" }, on, h("label", { for: on.id }, t("whatif.simulate"))),
    intro,
    result,
    settings,
  );
  mountSettings(settings, store, context);
  const show = mountResult(result);
  result.append(legend());

  const ask = mountVariants(store, context, show);
  const follow = (): void => {
    const { noise } = store.document;
    on.checked = noise !== null;
    settings.hidden = result.hidden = noise === null;
  };
  store.subscribe((now, before) => {
    follow();
    if (needsVariants(now, before)) ask();
  });
  follow();
  ask();
}

/** What the colours and the lines on the cloth mean. */
function legend(): HTMLElement {
  const bar = h("div", { class: "ramp" });
  const colors = RAMP.map((rgb) => `rgb(${rgb.join(" ")})`);
  bar.style.setProperty("--ramp", colors.join());
  return h(
    "div",
    { class: "legend", id: "whatif-legend" },
    h("p", { class: "hint" }, t("whatif.legend-stops")),
    bar,
    h("p", { class: "ends hint" }, h("span", {}, t("whatif.few")), h("span", {}, t("whatif.many"))),
    h("p", { class: "hint" }, t("whatif.legend-paths", { count: PATHS })),
  );
}

function needsVariants(now: State, before: State): boolean {
  return now.document !== before.document || now.session.mode !== before.session.mode;
}

/** @returns A function that requests variants of the present document, or cancels the request. */
function mountVariants(
  store: Store,
  { engine, viewer, loop }: Context,
  show: (progress: VariantsProgress | string | null, store: Store) => void,
): () => void {
  let variants: Variants | null = null;
  // At most once per frame.
  const draw = (progress: VariantsProgress): void => {
    loop.input(draw, () => {
      if (variants?.present !== progress) return;
      viewer.setFan(progress.tally.played(), progress.paths);
      show(progress, store);
    });
  };
  const clear = (words: string | null): void => {
    viewer.setFan(null);
    show(words, store);
    loop.invalidate();
  };
  return () => {
    const { noise, seed } = store.document;
    // A game with a short guide tells no chances.
    const open = guideOf(store.document.game) === "full";
    const wanted = noise && open && store.session.mode === "aim" && canAim(store, engine);
    if (!wanted) {
      variants?.cancel();
      if (!noise || variants) viewer.setFan(null);
      return;
    }
    variants ??= new Variants(new VariantsWorker(), engine, { progress: draw, refused: clear });
    variants.ask(store.shot, noise, seed, COUNT, PATHS);
  };
}

function mountSettings(root: HTMLElement, store: Store, context: Context): void {
  const known = presetsOf(context.engine);
  const groups = known.map(({ origin, presets }) =>
    h(
      "optgroup",
      { label: origin },
      ...presets.map(({ name }) => h("option", { value: name }, name)),
    ),
  );
  const preset = h(
    "select",
    { id: uniqueId("preset") },
    ...groups,
    h("option", { value: "", disabled: true }, t("whatif.own")),
  );
  preset.addEventListener("change", () => {
    const all = known.flatMap(({ presets }) => presets);
    const chosen = all.find(({ name }) => name === preset.value);
    if (chosen) store.apply({ noise: chosen.noise }, t("change.noise"));
  });
  root.append(
    h("h2", {}, t("whatif.size")),
    h("div", { class: "row" }, h("label", { for: preset.id }, t("whatif.like")), preset),
  );
  for (const sigma of SIGMAS) mountSigma(root, store, context, sigma);
  root.append(h("h2", {}, t("whatif.random")), seedRow(store));
  root.append(h("h2", {}, t("whatif.cling")));
  for (const number of CLING) mountSigma(root, store, context, number);
  store.subscribe(() => {
    const { noise } = store.document;
    preset.value = (noise && presetOf(noise, known)?.name) ?? "";
  });
}

function mountSigma(root: HTMLElement, store: Store, context: Context, sigma: Sigma): void {
  const { key, unit, spoken, scale, max, step } = sigma;
  const label = t(`sigma.${key}`);
  mountField(root, store, context, {
    label,
    unit,
    spoken: spoken === null ? "" : t(spoken),
    digits: 4,
    step,
    slider: { min: () => 0, max: () => max },
    read: () => (store.document.noise?.[key] ?? 0) / scale,
    write: (value, group) => {
      const noise: Noise = {
        ...(store.document.noise ?? context.engine.olympiad()),
        [key]: value * scale,
      };
      try {
        context.engine.checkNoise(noise);
      } catch (error) {
        if (!(error instanceof CaromError)) throw error;
        store.refuse(errorText(error));
        return false;
      }
      return store.apply({ noise }, t("change.sigma", { name: inSentence(label) }), group);
    },
  });
}

function seedRow(store: Store): HTMLElement {
  const seed = h("input", {
    type: "number",
    id: uniqueId("seed"),
    min: 0,
    max: LARGEST_SEED,
    step: 1,
  });
  seed.addEventListener("change", () => {
    const value = Number(seed.value);
    if (seed.value !== "" && Number.isInteger(value) && value >= 0 && value <= LARGEST_SEED) {
      store.apply({ seed: value }, t("change.seed"));
    } else {
      store.refuse(t("whatif.seed-range", { largest: LARGEST_SEED }));
      seed.value = String(store.document.seed);
    }
  });
  const draw = (): void => {
    store.apply({ seed: Math.floor(Math.random() * (LARGEST_DRAWN_SEED + 1)) }, t("change.seed"));
  };
  const follow = (): void => {
    seed.value = String(store.document.seed);
  };
  store.subscribe(follow);
  follow();
  return h(
    "div",
    {},
    h(
      "div",
      { class: "row" },
      h("label", { for: seed.id }, t("whatif.seed")),
      seed,
      h("button", { type: "button", class: "button", onclick: draw }, t("whatif.another")),
    ),
    h("p", { class: "hint" }, t("whatif.seed-hint")),
  );
}
