/** The lag before a game: each player sets a speed, and the winner chooses who breaks. */

import type { Seat } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { h, setText, uniqueId } from "../../common/dom.ts";
import { lengthText } from "../../common/shot-words.ts";
import { type Game, machineOf } from "../../document/stored-game.ts";
import { bestLag, type Lag, LAG_SPEEDS, type LagTable, playLag } from "./lag.ts";
import { FIRST_TURN, lagErrors, lagging, lagTable, turnsAfter } from "./lag-turns.ts";
import { turned } from "./race.ts";
import { decimal, t } from "../../words/translate.ts";

/** @param begin Starts the game; the first player of its set-up breaks. */
export function openLag(game: Game, context: Context, begin: (game: Game) => void): void {
  new LagDialog(game, context, begin).open();
}

class LagDialog {
  readonly #game: Game;
  readonly #engine: Context["engine"];
  readonly #begin: (game: Game) => void;
  readonly #table: LagTable;
  readonly #results = h("div", { role: "status", "aria-live": "polite" });
  readonly #controls = h("div");
  readonly #dialog: HTMLDialogElement;
  #turns = FIRST_TURN;

  constructor(game: Game, { engine }: Context, begin: (game: Game) => void) {
    this.#game = game;
    this.#engine = engine;
    this.#begin = begin;
    this.#table = lagTable(engine, game.setup);
    const title = h("h2", { id: uniqueId("lag") }, t("lag.title"));
    this.#dialog = h(
      "dialog",
      { class: "lag", "aria-labelledby": title.id, onclose: () => this.#dialog.remove() },
      title,
      h("p", { class: "hint" }, t("lag.rule")),
      this.#results,
      this.#controls,
    );
  }

  open(): void {
    document.body.append(this.#dialog);
    this.#dialog.showModal();
    this.#ask(0);
  }

  /** Lets a person choose the speed; a machine plays at once. */
  #ask(player: Seat): void {
    const { setup } = this.#game;
    if (machineOf(setup, player) !== null) {
      this.#play(player, bestLag(this.#engine, this.#table, player));
      return;
    }
    const [min, max] = LAG_SPEEDS;
    const speed = h("input", { type: "range", id: uniqueId("speed"), min, max, step: 0.01 });
    speed.value = String((min + max) / 2);
    const value = h("output", { class: "hint" });
    const show = (): void =>
      setText(value, t("lag.speed", { speed: decimal(Number(speed.value), 2) }));
    speed.addEventListener("input", show);
    show();
    const label = h("label", { for: speed.id }, t("lag.turn", { name: setup.names[player] }));
    const shoot = button(t("lag.play"), () => this.#play(player, Number(speed.value)));
    this.#controls.replaceChildren(
      h("div", { class: "labelled" }, label, speed, value),
      h("div", { class: "row end" }, shoot),
    );
    speed.focus();
  }

  #play(player: Seat, speed: number): void {
    const { setup } = this.#game;
    const errors = lagErrors(this.#engine, setup, this.#turns, player);
    const lag = playLag(this.#engine, this.#table, player, speed, errors);
    this.#say(lagText(lag, setup.names[player]));
    const { turns, winner } = turnsAfter(this.#turns, lag);
    if (turns.repeated > this.#turns.repeated) this.#say(t("lag.again"));
    this.#turns = turns;
    const next = lagging(turns);
    if (next !== null) this.#ask(next);
    else if (winner !== null) this.#chooseBreaker(winner);
  }

  #chooseBreaker(winner: Seat): void {
    const { setup } = this.#game;
    this.#say(h("strong", {}, t("lag.winner", { name: setup.names[winner] })));
    const breaks = (breaker: Seat) => () => {
      this.#dialog.close();
      this.#begin(breaker === 0 ? this.#game : turned(this.#game));
    };
    const choices = machineOf(setup, winner) === null ? ([0, 1] as const) : [winner];
    const buttons = choices.map((player) =>
      button(t("lag.breaks", { name: setup.names[player] }), breaks(player)),
    );
    this.#controls.replaceChildren(h("div", { class: "row end" }, ...buttons));
    buttons[0]!.focus();
  }

  #say(said: string | HTMLElement): void {
    this.#results.append(h("p", {}, said));
  }
}

function lagText({ distance, fault }: Lag, name: string): string {
  if (distance === null) return t(`lag.${fault!}`, { name });
  return t("lag.distance", { name, distance: lengthText(distance) });
}

function button(text: string, onclick: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "button primary", onclick }, text);
}
