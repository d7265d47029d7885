/** The form that starts a game. */

import type { FrameOptions } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { h, uniqueId } from "../../common/dom.ts";
import { gameName, presetLabel, presetOptions } from "../../common/preset-names.ts";
import { GUIDES, newGame } from "../../document/stored-game.ts";
import type { Store } from "../../document/store.ts";
import { openLag } from "../match/lag-dialog.ts";
import { startGame, startReady } from "../game-actions.ts";
import { t } from "../../words/translate.ts";
import { label, labelled, number, select, whole } from "./setup-controls.ts";
import { LONGEST_RACE } from "../match/race.ts";
import { mountMatch } from "./match-setup.ts";
import { mountPlayers } from "./players-setup.ts";

/** Seeds drawn by a click are below this: short numbers are easy to pass on. */
const SEEDS = 10_000;

/** Value of the list entry that starts from the balls on the page. */
const AS_THEY_LIE = "lie";

/** Value of the list entry for the page's table with its physics. */
const THIS_TABLE = "this";

export function mountSetup(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const rules = select(engine.games.map((name) => [name, gameName(name)]));
  const usual = h("option", { value: "" });
  const table = h("select", { id: uniqueId("table") }, usual);
  table.append(...presetOptions(engine.tables.flatMap(({ name }) => name ?? [])));
  table.append(h("option", { value: THIS_TABLE }, t("setup.this-table")));
  const seed = number(drawn(), 0);
  const goal = number(engine.defaultTerms.points, 1);
  const miss = h("input", {
    type: "checkbox",
    id: uniqueId("miss"),
    checked: engine.defaultTerms.miss,
  });
  const start = select([
    ["", t("setup.new-rack")],
    [AS_THEY_LIE, t("setup.as-they-lie")],
  ]);
  const tableRow = labelled(t("setup.table"), table);
  const seedRow = h("div", { class: "pair" }, labelled(t("setup.seed"), seed), shuffle());
  const goalRow = labelled(t("setup.points"), goal);
  const missRow = h("div", { class: "switch row" }, miss, label(miss, t("setup.miss")));
  const seats = h("div");
  const players = mountPlayers(seats, context);
  const guide = select(GUIDES.map((name) => [name, t(`guide.${name}`)]));
  guide.value = "short";
  const match = mountMatch(engine);
  const begin = (): void => {
    const options = readOptions();
    const from = start.value === AS_THEY_LIE ? store.shot.file : null;
    if (!options) return;
    const shown = GUIDES.find((name) => name === guide.value)!;
    const people = players.read();
    const terms = match.read();
    if (terms === null) {
      store.refuse(t("race.refused", { most: LONGEST_RACE }));
      return;
    }
    const own = { ...people.setup, guide: shown, ...terms };
    const setup = { rules: rules.value, options, from, ...own };
    // A friend at another page cannot lag at the same time.
    if (!match.lags() || people.here !== undefined) {
      startGame(store, context, setup, people.here);
      return;
    }
    openLag(newGame(setup), context, (game) => {
      startReady(store, context, game);
    });
  };
  const rack = h("details", {}, h("summary", {}, t("setup.rack")));
  rack.append(labelled(t("setup.begin-with"), start), tableRow, seedRow);
  root.append(
    h("h2", {}, t("setup.title")),
    h("p", { class: "hint" }, t("setup.hint")),
    labelled(t("setup.game"), rules),
    goalRow,
    missRow,
    seats,
    labelled(t("guide.label"), guide),
    match.root,
    rack,
    h("div", { class: "row end pinned" }, primary(t("setup.start"), begin)),
  );

  function shuffle(): HTMLElement {
    const button = h("button", { type: "button", class: "button shuffle" }, t("setup.shuffle"));
    button.addEventListener("click", () => {
      seed.value = String(drawn());
    });
    return button;
  }

  const facts = () => engine.gameFacts[rules.value]!;

  function readOptions(): FrameOptions | null {
    const [rack, points] = [whole(seed, 0), whole(goal, 1)];
    if (rack === null) store.refuse(t("field.not-a-seed"));
    else if (points === null) store.refuse(t("setup.points-refused"));
    if (rack === null || points === null) return null;
    return {
      ...tableOptions(),
      seed: rack,
      ...(facts().scoring === "target" && { points }),
      ...(facts().miss && { miss: miss.checked }),
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
    goalRow.hidden = facts().scoring !== "target";
    tableRow.hidden = seedRow.hidden = start.value === AS_THEY_LIE;
    missRow.hidden = !facts().miss;
    players.show(rules.value);
    match.show(rules.value);
  };
  rules.addEventListener("change", show);
  start.addEventListener("change", show);
  rules.value = "nine-ball";
  show();
}

function drawn(): number {
  return Math.floor(Math.random() * SEEDS);
}

function primary(text: string, onclick: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "button primary", onclick }, text);
}
