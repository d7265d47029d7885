/** In the Game tab after a frame: the three shots that cost a person most. */

import { CaromError, type Engine, type Outcome, type ShotFile } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { button, h, setText } from "../../common/dom.ts";
import { errorText } from "../../common/refusals.ts";
import { changeUnpressed } from "../../common/press.ts";
import { ballName, pocketName } from "../../common/shot-words.ts";
import { aimed } from "../../document/shot-file.ts";
import type { Game } from "../../document/stored-game.ts";
import type { Store } from "../../document/store.ts";
import { percent } from "../machine/machine-explanation.ts";
import { thinkerOf } from "../machine/machine-thinker.ts";
import { openStudy } from "../variations.ts";
import { isForOne } from "../game-words.ts";
import { standing } from "../awaited-turn.ts";
import { type Cost, costsOf, worstOf } from "./shot-costs.ts";
import { t } from "../../words/translate.ts";

/** Mounts the section; it is hidden until a frame is over. */
export function mountCostliest(root: HTMLElement, store: Store, context: Context): void {
  const costliest = new Costliest(root, store, context.engine);
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
  readonly #engine: Engine;
  readonly #text = h("p", { class: "hint", role: "status" });
  readonly #cancel = button(t("costs.cancel"), () => this.#stop(t("costs.cancelled")));
  readonly #again = button(t("costs.find"), () => void this.#find());
  readonly #list = h("ol", { class: "costs" });
  /** The moves of the frame that is looked through; null: none. */
  #sought: Game["moves"] | null = null;
  #shown: Game["moves"] | null = null;
  /** Fills the list again. */
  #fill = (): void => undefined;

  constructor(root: HTMLElement, store: Store, engine: Engine) {
    this.#root = root;
    this.#store = store;
    this.#engine = engine;
    const buttons = h("div", { class: "row" }, this.#cancel, this.#again);
    root.append(h("h2", {}, t("costs.title")), this.#text, buttons, this.#list);
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
    if (!this.#root.hidden) changeUnpressed(this.#list, this.#fill);
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
    this.#fill = () => this.#list.replaceChildren();
    this.#fill();
    this.#cancel.hidden = false;
    this.#again.hidden = true;
    try {
      const thinker = await thinkerOf(this.#engine);
      const costs = await costsOf(this.#engine, game, progress, thinker, (done, all) => {
        if (this.#sought === moves) setText(this.#text, t("costs.looking", { done, all }));
        return this.#sought === moves;
      });
      if (costs && this.#sought === moves) this.#showWorst(game, worstOf(costs));
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      if (this.#sought === moves) this.#stop(errorText(error));
    }
  }

  #showWorst(game: Game, worst: readonly Cost[]): void {
    this.#stop(worst.length > 0 ? t("costs.hint") : t("costs.none"));
    this.#again.hidden = true;
    this.#fill = () => this.#list.replaceChildren(...worst.map((cost) => this.#entry(game, cost)));
    changeUnpressed(this.#list, this.#fill);
  }

  #entry({ setup }: Game, cost: Cost): HTMLElement {
    const { index, player, before, after } = cost;
    const { file, said } = this.#positionOf(cost);
    const chances = { before: percent(before), after: percent(after) };
    const open = () =>
      void openStudy(this.#store, this.#engine, index, aimed(this.#engine.withDatedNames(file)));
    return h(
      "li",
      {},
      t("costs.shot", { number: index + 1, name: setup.names[player], ...chances }),
      " ",
      t("costs.better", { play: said }),
      h("div", { class: "row" }, button(t("costs.open"), open)),
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

function playText({ pocketed, cue_ball: cue, first_contact: first }: Outcome): string {
  const drop = pocketed.find(([ball]) => ball !== cue);
  if (drop) return t("reason.pot", { ball: ballName(drop[0]), pocket: pocketName(drop[1]) });
  return first === null ? t("reason.safety") : t("reason.safety-off", { ball: ballName(first) });
}
