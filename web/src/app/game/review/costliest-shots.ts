/** In the Game tab after a frame: the three shots that cost a person most. */

import { CaromError, type ShotFile } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { h, setText } from "../../common/dom.ts";
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
import { type Cost, costsOf } from "./shot-costs.ts";
import { t } from "../../words/translate.ts";

/** Shots that are listed, and the least loss of a listed one. */
const LISTED = 3;
const LEAST = 0.03;

/** Mounts the section; it is hidden until a frame is over. */
export function mountCostliest(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const text = h("p", { class: "hint", role: "status" });
  const cancel = button(t("costs.cancel"), () => stop(t("costs.cancelled")));
  const again = button(t("costs.find"), () => void find());
  const list = h("ol", { class: "costs" });
  root.append(h("h2", {}, t("costs.title")), text, h("div", { class: "row" }, cancel, again), list);
  /** The moves of the frame that is looked through; null: none. */
  let sought: Game["moves"] | null = null;
  let shown: Game["moves"] | null = null;
  /** Fills the list again. */
  let fill = (): void => undefined;

  function stop(why: string): void {
    sought = null;
    setText(text, why);
    cancel.hidden = true;
    again.hidden = false;
  }

  async function find(): Promise<void> {
    const { game } = store.document;
    const progress = standing(store, engine);
    if (!game || !progress) return;
    const { moves } = game;
    sought = shown = moves;
    fill = () => list.replaceChildren();
    fill();
    cancel.hidden = false;
    again.hidden = true;
    try {
      const thinker = await thinkerOf(engine);
      const costs = await costsOf(engine, game, progress, thinker, (done, all) => {
        if (sought === moves) setText(text, t("costs.looking", { done, all }));
        return sought === moves;
      });
      if (!costs || sought !== moves) return;
      const worst = costs.filter(({ before, after }) => before - after > LEAST).slice(0, LISTED);
      stop(worst.length > 0 ? t("costs.hint") : t("costs.none"));
      again.hidden = true;
      fill = () => list.replaceChildren(...worst.map((cost) => entry(game, cost)));
      changeUnpressed(list, fill);
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      if (sought === moves) stop(errorText(error));
    }
  }

  function entry({ setup }: Game, cost: Cost): HTMLElement {
    const { index, player, before, after } = cost;
    const position = positionOf(cost);
    return h(
      "li",
      {},
      t("costs.shot", {
        number: index + 1,
        name: setup.names[player],
        before: percent(before),
        after: percent(after),
      }),
      " ",
      t("costs.better", { play: position.said }),
      h(
        "div",
        { class: "row" },
        button(t("costs.open"), () => {
          void openStudy(store, engine, index, aimed(engine.withDatedNames(position.file)));
        }),
      ),
    );
  }

  /** The position before a shot, aimed at the better play. */
  function positionOf({ index, best }: Cost): { file: ShotFile; said: string } {
    const shot = standing(store, engine)!.steps[index]!.from.shot(best);
    const trace = shot.simulate();
    const { pocketed, cue_ball: cue, first_contact: first } = trace.outcome;
    const drop = pocketed.find(([ball]) => ball !== cue);
    const said = drop
      ? t("reason.pot", { ball: ballName(drop[0]), pocket: pocketName(drop[1]) })
      : first === null
        ? t("reason.safety")
        : t("reason.safety-off", { ball: ballName(first) });
    const file = shot.source;
    trace.free();
    shot.free();
    return { file, said };
  }

  const show = (): void => {
    const { game } = store.document;
    const progress = standing(store, engine);
    const over = progress?.frame.state.request.kind === "over";
    root.hidden = !game || !over || isForOne(engine, game.setup.rules);
    if (root.hidden || !game) sought = null;
    else if (store.session.mode === "aim" && shown !== game.moves) void find();
  };
  store.subscribe((now, before) => {
    if (now.document.game !== before.document.game || now.session.mode !== before.session.mode) {
      show();
    } else if (!root.hidden && now.session.orientation !== before.session.orientation)
      changeUnpressed(list, fill);
  });
  show();
}

function button(text: string, onclick: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "button", onclick }, text);
}
