/** In the Game tab after a frame: its graph, the three shots that cost a person most, and the review of every shot. */

import { CaromError, type Engine, type Outcome, type ShotFile } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { button, h, setText } from "../../common/dom.ts";
import { errorText } from "../../common/refusals.ts";
import { changeUnpressed } from "../../common/press.ts";
import { playedName, pocketName } from "../../common/shot-words.ts";
import { aimed } from "../../document/shot-file.ts";
import type { Game } from "../../document/stored-game.ts";
import type { Store } from "../../document/store.ts";
import { percent } from "../machine/machine-explanation.ts";
import { thinkerOf } from "../machine/machine-thinker.ts";
import { openStudy } from "../variations.ts";
import { isForOne } from "../game-words.ts";
import { standing } from "../awaited-turn.ts";
import { frameGraph } from "./frame-graph.ts";
import { replayMove } from "./reviewed-shots.ts";
import { type Cost, costsOf, gradeOf, worstOf } from "./shot-costs.ts";
import { t } from "../../words/translate.ts";

/** Mounts the section; it is hidden until a frame is over. */
export function mountCostliest(root: HTMLElement, store: Store, context: Context): void {
  const costliest = new Costliest(root, store, context);
  store.subscribe((now, before) => {
    if (now.document.game !== before.document.game || now.session.mode !== before.session.mode) {
      costliest.show();
    } else if (now.session.orientation !== before.session.orientation) costliest.showAgain();
  });
  costliest.show();
}

class Costliest {
  readonly #root: HTMLElement;
  readonly #store: Store;
  readonly #context: Context;
  readonly #engine: Engine;
  readonly #text = h("p", { class: "hint", role: "status" });
  readonly #cancel = button(t("costs.cancel"), () => this.#stop(t("costs.cancelled")));
  readonly #again = button(t("costs.find"), () => void this.#find());
  readonly #graph = h("div", { class: "chances" });
  readonly #list = h("ol", { class: "costs" });
  readonly #all = h("ol", { class: "costs" });
  readonly #others: HTMLElement;
  /** The moves of the frame that is looked through; null: none. */
  #sought: Game["moves"] | null = null;
  #shown: Game["moves"] | null = null;
  /** Fills the list again. */
  #fill = (): void => undefined;

  constructor(root: HTMLElement, store: Store, context: Context) {
    this.#root = root;
    this.#store = store;
    this.#context = context;
    this.#engine = context.engine;
    const buttons = h("div", { class: "row" }, this.#cancel, this.#again);
    this.#others = h("details", {}, h("summary", {}, t("costs.all")), this.#all);
    root.append(
      h("h2", {}, t("costs.title")),
      this.#graph,
      this.#text,
      buttons,
      this.#list,
      this.#others,
    );
  }

  show(): void {
    const { game } = this.#store.document;
    const progress = standing(this.#store, this.#engine);
    const over = progress?.frame.state.request.kind === "over";
    // A frame of a match has the chances of its players in place of advice.
    const isOne = game !== null && isForOne(this.#engine, game.setup.rules);
    this.#root.hidden = !game || !over || isOne || game.notes !== undefined;
    if (this.#root.hidden || !game) this.#sought = null;
    else if (this.#store.session.mode === "aim" && this.#shown !== game.moves) void this.#find();
  }

  /** Shows the list with the names of the pockets in the present picture. */
  showAgain(): void {
    if (!this.#root.hidden) changeUnpressed(this.#root, this.#fill);
  }

  #stop(why: string): void {
    this.#sought = null;
    setText(this.#text, why);
    this.#cancel.hidden = true;
    this.#again.hidden = false;
  }

  async #find(): Promise<void> {
    const { game } = this.#store.document;
    const progress = standing(this.#store, this.#engine);
    if (!game || !progress) return;
    const { moves } = game;
    this.#sought = this.#shown = moves;
    this.#fill = () => [this.#graph, this.#list, this.#all].forEach((one) => one.replaceChildren());
    this.#fill();
    this.#others.hidden = true;
    this.#cancel.hidden = false;
    this.#again.hidden = true;
    try {
      const thinker = await thinkerOf(this.#engine);
      const costs = await costsOf(this.#engine, game, progress, thinker, (done, all) => {
        if (this.#sought === moves) setText(this.#text, t("costs.looking", { done, all }));
        return this.#sought === moves;
      });
      if (costs && this.#sought === moves) this.#showCosts(game, costs);
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      if (this.#sought === moves) this.#stop(errorText(error));
    }
  }

  #showCosts(game: Game, costs: readonly Cost[]): void {
    const worst = worstOf(costs);
    this.#stop(worst.length > 0 ? t("costs.hint") : t("costs.none"));
    this.#again.hidden = true;
    this.#others.hidden = costs.length === 0;
    const { names } = game.setup;
    const graph = () =>
      frameGraph(
        names,
        costs,
        (cost) => textOf(names, cost),
        ({ index }) => this.#replay(index),
      );
    this.#fill = () => {
      this.#graph.replaceChildren(...(costs.length > 0 ? [graph()] : []));
      this.#list.replaceChildren(...worst.map((cost) => this.#entry(game, cost)));
      this.#all.replaceChildren(...costs.map((cost) => this.#entry(game, cost)));
    };
    changeUnpressed(this.#root, this.#fill);
  }

  #replay(index: number): void {
    replayMove(this.#store, this.#engine, index, this.#context.reducedMotion());
  }

  #entry({ setup }: Game, cost: Cost): HTMLElement {
    const { index } = cost;
    const { file, said } = this.#positionOf(cost);
    const open = () =>
      void openStudy(this.#store, this.#engine, index, aimed(this.#engine.withDatedNames(file)));
    return h(
      "li",
      { class: gradeOf(cost) },
      textOf(setup.names, cost),
      gradeOf(cost) === "good" ? "" : ` ${t("costs.better", { play: said })}`,
      h(
        "div",
        { class: "row" },
        button(t("costs.replay"), () => this.#replay(index)),
        button(t("costs.open"), open),
      ),
    );
  }

  /** The position before a shot, aimed at the better play. */
  #positionOf({ index, best }: Cost): { file: ShotFile; said: string } {
    const shot = standing(this.#store, this.#engine)!.steps[index]!.from.shot(best);
    const trace = shot.simulate();
    const said = playText(trace.outcome);
    const file = shot.source;
    trace.free();
    shot.free();
    return { file, said };
  }
}

/** A shot with the chances of its player. */
function textOf(names: readonly [string, string], { index, player, before, after }: Cost): string {
  const chances = { before: percent(before), after: percent(after) };
  return t("costs.shot", { number: index + 1, name: names[player], ...chances });
}

function playText({ pocketed, cue_ball: cue, first_contact: first }: Outcome): string {
  const drop = pocketed.find(([ball]) => ball !== cue);
  if (drop) return t("reason.pot", { ball: playedName(drop[0]), pocket: pocketName(drop[1]) });
  return first === null ? t("reason.safety") : t("reason.safety-off", { ball: playedName(first) });
}
