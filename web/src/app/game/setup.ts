/** The form that starts a game. */

import type { FrameOptions } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, uniqueId } from "../common/dom.ts";
import { gameName, levelName, presetLabel, presetOptions } from "../common/presets.ts";
import type { Store } from "../document/store.ts";
import { LONGEST_NAME, type Setup } from "../document/game.ts";
import { startGame } from "./play.ts";
import { isForOne } from "./words.ts";
import { t } from "../words/translate.ts";

/** Seeds drawn by a click are below this: short numbers are easy to pass on. */
const SEEDS = 10_000;

/** Games that end at a number of points. */
const WITH_GOAL = new Set(["straight-pool", "three-cushion"]);

/** Value of the list entry that starts from the balls on the page. */
const AS_THEY_LIE = "lie";

/** Value of the list entry for the page's table with its physics. */
const THIS_TABLE = "this";

export function mountSetup(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const rules = select(engine.ruleSets.map((name) => [name, gameName(name)]));
  const usual = h("option", { value: "" });
  const table = h("select", { id: uniqueId("table") }, usual);
  table.append(...presetOptions(engine.tables.flatMap(({ name }) => name ?? [])));
  table.append(h("option", { value: THIS_TABLE }, t("setup.this-table")));
  const seed = number(drawn(), 0);
  const goal = number(40, 1);
  const miss = h("input", { type: "checkbox", id: uniqueId("miss"), checked: true });
  const names = [0, 1].map((player) => name(player)) as [HTMLInputElement, HTMLInputElement];
  const levels = Object.keys(engine.noisePresets);
  const skills = [0, 1].map(() =>
    select([
      ["", t("setup.no-errors")],
      ...levels.map((level): [string, string] => [level, levelName(level)]),
    ]),
  ) as [HTMLSelectElement, HTMLSelectElement];

  const start = select([
    ["", t("setup.new-rack")],
    [AS_THEY_LIE, t("setup.as-they-lie")],
  ]);
  const tableRow = labelled(t("setup.table"), table);
  const seedRow = h("div", { class: "pair" }, labelled(t("setup.seed"), seed), shuffle());
  const goalRow = labelled(t("setup.points"), goal);
  const missRow = h("div", { class: "switch row" }, miss, label(miss, t("setup.miss")));
  const players = [0, 1].map((k) =>
    h(
      "div",
      { class: "pair player" },
      labelled(t("setup.player", { number: k + 1 }), names[k]!),
      labelled(t("setup.errors"), skills[k]!),
    ),
  );
  const begin = (): void => {
    const options = readOptions();
    const from = start.value === AS_THEY_LIE ? store.shot.file : null;
    if (options) startGame(store, context, { rules: rules.value, options, from, ...chosen() });
  };
  root.append(
    h("h2", {}, t("setup.title")),
    h("p", { class: "hint" }, t("setup.hint")),
    labelled(t("setup.game"), rules),
    labelled(t("setup.begin-with"), start),
    tableRow,
    seedRow,
    goalRow,
    missRow,
    h("h2", {}, t("setup.players")),
    ...players,
    h("p", { class: "hint" }, t("setup.errors-hint")),
    h("div", { class: "row end" }, primary(t("setup.start"), begin)),
  );

  function shuffle(): HTMLElement {
    const button = h("button", { type: "button", class: "button shuffle" }, t("setup.shuffle"));
    button.addEventListener("click", () => {
      seed.value = String(drawn());
    });
    return button;
  }

  function chosen(): Pick<Setup, "names" | "skills"> {
    const read = (k: 0 | 1) => names[k].value.trim() || t("setup.player", { number: k + 1 });
    const skill = (k: 0 | 1) => skills[k].value || null;
    return { names: [read(0), read(1)], skills: [skill(0), skill(1)] };
  }

  function readOptions(): FrameOptions | null {
    const [rack, points] = [whole(seed, 0), whole(goal, 1)];
    if (rack === null) store.refuse(t("field.not-a-seed"));
    else if (points === null) store.refuse(t("setup.points-refused"));
    if (rack === null || points === null) return null;
    return {
      ...tableOptions(),
      seed: rack,
      ...(WITH_GOAL.has(rules.value) && { points }),
      ...(rules.value === "snooker" && { miss: miss.checked }),
    };
  }

  function tableOptions(): Pick<FrameOptions, "table" | "physics"> {
    if (table.value === "" || start.value === AS_THEY_LIE) return {};
    if (table.value !== THIS_TABLE) return { table: table.value };
    const { table: own, physics } = store.document.shot;
    return { table: own, ...(physics !== undefined && { physics }) };
  }

  const show = (): void => {
    usual.textContent = t("setup.usual-table", {
      table: presetLabel(engine.usualTable(rules.value)),
    });
    goalRow.hidden = !WITH_GOAL.has(rules.value);
    tableRow.hidden = seedRow.hidden = start.value === AS_THEY_LIE;
    missRow.hidden = rules.value !== "snooker";
    players[1]!.hidden = isForOne(rules.value);
  };
  rules.addEventListener("change", show);
  start.addEventListener("change", show);
  rules.value = "nine-ball";
  show();
}

function drawn(): number {
  return Math.floor(Math.random() * SEEDS);
}

function select(options: readonly (readonly [value: string, text: string])[]): HTMLSelectElement {
  const items = options.map(([value, text]) => h("option", { value }, text));
  return h("select", { id: uniqueId("choose") }, ...items);
}

function number(value: number, min: number): HTMLInputElement {
  return h("input", { type: "number", id: uniqueId("number"), min, step: 1, value });
}

function name(player: number): HTMLInputElement {
  return h("input", {
    type: "text",
    id: uniqueId("name"),
    value: t("setup.player", { number: player + 1 }),
    maxlength: LONGEST_NAME,
    autocomplete: "off",
  });
}

function whole(input: HTMLInputElement, least: number): number | null {
  const value = Number(input.value);
  return input.value.trim() !== "" && Number.isSafeInteger(value) && value >= least ? value : null;
}

function label(control: HTMLElement, text: string): HTMLElement {
  return h("label", { for: control.id }, text);
}

function labelled(text: string, control: HTMLElement): HTMLElement {
  return h("div", { class: "labelled" }, label(control, text), control);
}

function primary(text: string, onclick: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "button primary", onclick }, text);
}
