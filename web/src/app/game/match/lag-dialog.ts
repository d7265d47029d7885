/** The lag before a game: each player sets a speed, and the winner chooses who breaks. */

import type { Noise, Seat } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { h, setText, uniqueId } from "../../common/dom.ts";
import { lengthText } from "../../common/shot-words.ts";
import { type Game, machineOf } from "../../document/stored-game.ts";
import { machineNoise } from "../machine/machine-levels.ts";
import { bestLag, type Lag, LAG_SPEEDS, type LagTable, lagWinner, playLag } from "./lag.ts";
import { turned } from "./race.ts";
import { decimal, t } from "../../words/translate.ts";

/** @param begin Starts the game; the first player of its set-up breaks. */
export function openLag(game: Game, context: Context, begin: (game: Game) => void): void {
  const { engine } = context;
  const { setup } = game;
  const { seed = 0, table: chosen, physics } = setup.options;
  const table: LagTable = setup.from ?? {
    table: chosen ?? engine.usualTable(setup.rules),
    ...(physics !== undefined && { physics }),
  };
  /** Lags that were played again. */
  let repeated = 0;
  let lags: readonly Lag[] = [];

  const title = h("h2", { id: uniqueId("lag") }, t("lag.title"));
  const results = h("div", { role: "status", "aria-live": "polite" });
  const controls = h("div");
  const dialog = h("dialog", { class: "lag", "aria-labelledby": title.id });
  dialog.append(title, h("p", { class: "hint" }, t("lag.rule")), results, controls);
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);

  function noiseOf(player: Seat): Noise | null {
    const level = machineOf(setup, player);
    const skill = setup.skills[player];
    if (level !== null) return machineNoise(engine, level);
    return skill === null ? null : engine.noisePresets[skill]!;
  }

  function play(speed: number): void {
    const player = lags.length === 0 ? 0 : 1;
    const noise = noiseOf(player);
    const errors = noise && { noise, index: 2 * repeated + player, seed };
    const lag = playLag(engine, table, player, speed, errors);
    lags = [...lags, lag];
    const name = setup.names[player];
    const said =
      lag.distance === null
        ? t(`lag.${lag.fault!}`, { name })
        : t("lag.distance", { name, distance: lengthText(lag.distance) });
    results.append(h("p", {}, said));
    next();
  }

  function next(): void {
    const [first, second] = lags;
    if (first && second) decide(lagWinner([first, second]));
    else ask(first ? 1 : 0);
  }

  function ask(player: Seat): void {
    if (machineOf(setup, player) !== null) {
      play(bestLag(engine, table, player));
      return;
    }
    const [slow, fast] = LAG_SPEEDS;
    const speed = h("input", {
      type: "range",
      id: uniqueId("speed"),
      min: slow,
      max: fast,
      step: 0.01,
    });
    speed.value = String((slow + fast) / 2);
    const value = h("output", { class: "hint" });
    const show = (): void =>
      setText(value, t("lag.speed", { speed: decimal(Number(speed.value), 2) }));
    speed.addEventListener("input", show);
    show();
    const label = h("label", { for: speed.id }, t("lag.turn", { name: setup.names[player] }));
    const shoot = button(t("lag.play"), () => play(Number(speed.value)));
    controls.replaceChildren(
      h("div", { class: "labelled" }, label, speed, value),
      h("div", { class: "row end" }, shoot),
    );
    speed.focus();
  }

  function decide(winner: Seat | null): void {
    if (winner === null) {
      repeated += 1;
      lags = [];
      results.append(h("p", {}, t("lag.again")));
      next();
      return;
    }
    results.append(h("p", {}, h("strong", {}, t("lag.winner", { name: setup.names[winner] }))));
    const breaks = (breaker: Seat) => () => {
      dialog.close();
      begin(breaker === 0 ? game : turned(game));
    };
    const choices = machineOf(setup, winner) === null ? ([0, 1] as const) : [winner];
    const buttons = choices.map((player) =>
      button(t("lag.breaks", { name: setup.names[player] }), breaks(player)),
    );
    controls.replaceChildren(h("div", { class: "row end" }, ...buttons));
    buttons[0]!.focus();
  }

  dialog.showModal();
  next();
}

function button(text: string, onclick: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "button primary", onclick }, text);
}
