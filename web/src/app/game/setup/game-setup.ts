/** The form that starts a game. */

import type { FrameOptions, GameFacts } from "../../../engine/index.ts";
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
  new GameSetup(root, store, context).show();
}

class GameSetup {
  readonly #store: Store;
  readonly #context: Context;
  readonly #rules: HTMLSelectElement;
  readonly #usual = h("option", { value: "" });
  readonly #table = h("select", { id: uniqueId("table") }, this.#usual);
  readonly #seed = number(drawn(), 0);
  readonly #goal = number(40, 1);
  readonly #miss = h("input", { type: "checkbox", id: uniqueId("miss"), checked: true });
  readonly #start = select([
    ["", t("setup.new-rack")],
    [AS_THEY_LIE, t("setup.as-they-lie")],
  ]);
  readonly #guide = select(GUIDES.map((name) => [name, t(`guide.${name}`)]));
  readonly #tableRow = labelled(t("setup.table"), this.#table);
  readonly #seedRow = h(
    "div",
    { class: "pair" },
    labelled(t("setup.seed"), this.#seed),
    shuffle(this.#seed),
  );
  readonly #goalRow = labelled(t("setup.points"), this.#goal);
  readonly #missRow = h(
    "div",
    { class: "switch row" },
    this.#miss,
    label(this.#miss, t("setup.miss")),
  );
  readonly #players: ReturnType<typeof mountPlayers>;
  readonly #match: ReturnType<typeof mountMatch>;

  constructor(root: HTMLElement, store: Store, context: Context) {
    const { engine } = context;
    this.#store = store;
    this.#context = context;
    this.#rules = select(engine.games.map((name) => [name, gameName(name)]));
    this.#rules.value = "nine-ball";
    this.#table.append(...presetOptions(engine.tables.flatMap(({ name }) => name ?? [])));
    this.#table.append(h("option", { value: THIS_TABLE }, t("setup.this-table")));
    const seats = h("div");
    this.#players = mountPlayers(seats, context);
    this.#guide.value = "short";
    this.#match = mountMatch(engine);
    const rack = h("details", {}, h("summary", {}, t("setup.rack")));
    rack.append(labelled(t("setup.begin-with"), this.#start), this.#tableRow, this.#seedRow);
    root.append(
      h("h2", {}, t("setup.title")),
      h("p", { class: "hint" }, t("setup.hint")),
      labelled(t("setup.game"), this.#rules),
      this.#goalRow,
      this.#missRow,
      seats,
      labelled(t("guide.label"), this.#guide),
      this.#match.root,
      rack,
      h(
        "div",
        { class: "row end pinned" },
        primary(t("setup.start"), () => this.#begin()),
      ),
    );
    for (const list of [this.#rules, this.#start])
      list.addEventListener("change", () => this.show());
  }

  get #facts(): GameFacts {
    return this.#context.engine.gameFacts[this.#rules.value]!;
  }

  get #isAsTheyLie(): boolean {
    return this.#start.value === AS_THEY_LIE;
  }

  show(): void {
    const table = presetLabel(this.#context.engine.usualTable(this.#rules.value));
    this.#usual.textContent = t("setup.usual-table", { table });
    this.#goalRow.hidden = this.#facts.scoring !== "target";
    this.#tableRow.hidden = this.#seedRow.hidden = this.#isAsTheyLie;
    this.#missRow.hidden = !this.#facts.miss;
    this.#players.show(this.#rules.value);
    this.#match.show(this.#rules.value);
  }

  #begin(): void {
    const options = this.#readOptions();
    if (!options) return;
    const terms = this.#match.read();
    if (terms === null) {
      this.#store.refuse(t("race.refused", { most: LONGEST_RACE }));
      return;
    }
    const { setup: players, here } = this.#players.read();
    const setup = {
      rules: this.#rules.value,
      options,
      from: this.#isAsTheyLie ? this.#store.shot.file : null,
      ...players,
      guide: GUIDES.find((name) => name === this.#guide.value)!,
      ...terms,
    };
    // A friend at another page cannot lag at the same time.
    if (!this.#match.lags() || here !== undefined) {
      startGame(this.#store, this.#context, setup, here);
      return;
    }
    openLag(newGame(setup), this.#context, (game) => {
      startReady(this.#store, this.#context, game);
    });
  }

  /** The options of the frame; null if a number of the form is none. */
  #readOptions(): FrameOptions | null {
    const [seed, points] = [whole(this.#seed, 0), whole(this.#goal, 1)];
    if (seed === null) this.#store.refuse(t("field.not-a-seed"));
    else if (points === null) this.#store.refuse(t("setup.points-refused"));
    if (seed === null || points === null) return null;
    return {
      ...this.#tableOptions(),
      seed,
      ...(this.#facts.scoring === "target" && { points }),
      ...(this.#facts.miss && { miss: this.#miss.checked }),
    };
  }

  #tableOptions(): Pick<FrameOptions, "table" | "physics"> {
    const chosen = this.#table.value;
    if (chosen === "" || this.#isAsTheyLie) return {};
    if (chosen !== THIS_TABLE) return { table: chosen };
    const { table, physics } = this.#store.document.shot;
    return { table, ...(physics !== undefined && { physics }) };
  }
}

/** A button that draws another seed. */
function shuffle(seed: HTMLInputElement): HTMLElement {
  const onclick = () => {
    seed.value = String(drawn());
  };
  const attributes = { type: "button", class: "button shuffle", onclick };
  return h("button", attributes, t("setup.shuffle"));
}

function drawn(): number {
  return Math.floor(Math.random() * SEEDS);
}

function primary(text: string, onclick: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "button primary", onclick }, text);
}
