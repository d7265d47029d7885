/** The curve of the chances of a line of shots. The chances are counted one after the other. */

import type { Engine, Outcome } from "../../engine/index.ts";
import { h, svg } from "../common/dom.ts";
import { outcomeOf } from "../document/balls-after.ts";
import type { AimedShot } from "../document/document.ts";
import { NO_TREE, type TreeNode } from "../document/shot-tree.ts";
import type { Store } from "../document/store.ts";
import { noiseOf } from "./analysed-position.ts";
import { percent } from "./analyse-words.ts";
import { Desk } from "./desk/desk-client.ts";
import DeskWorker from "./desk/desk-worker.ts?worker&inline";
import { curveOf, curvePoints, EDGE, HEIGHT, WIDTH } from "./tree-rows.ts";
import { list as inWords, t } from "../words/translate.ts";

/** Variants of a chance on the curve. */
const COUNT = 300;

/** The first object ball that a shot pots, and its pocket. */
export function potIn(outcome: Outcome | null, { strike }: AimedShot) {
  return outcome?.pocketed.find(([ball]) => ball !== strike.ball) ?? null;
}

export class ChanceCurve {
  readonly element = h("div", { class: "curve" });
  readonly #tab: HTMLElement;
  readonly #store: Store;
  readonly #engine: Engine;
  readonly #desk: Desk;
  /** Counted chances by shot and level. */
  readonly #chances = new WeakMap<AimedShot, Map<string, number>>();

  /** @param tab The curve is drawn, and its chances counted, while it is shown. */
  constructor(tab: HTMLElement, store: Store, engine: Engine) {
    this.#tab = tab;
    this.#store = store;
    this.#engine = engine;
    this.#desk = new Desk(() => new DeskWorker(), engine);
  }

  draw(): void {
    const tree = this.#store.document.tree ?? NO_TREE;
    const nodes = this.#tab.hidden ? [] : curveOf(tree);
    const noise = noiseOf(this.#engine, this.#store.state);
    const key = JSON.stringify(noise);
    this.element.hidden = nodes.length === 0;
    const known = nodes.map(({ shot }) =>
      this.#potOf(shot) ? (this.#chances.get(shot)?.get(key) ?? null) : 0,
    );
    this.element.replaceChildren(
      h("p", { class: "hint" }, t("tree.curve-title")),
      picture(nodes, known, tree.at),
    );
    const shot = nodes[known.indexOf(null)]?.shot;
    if (!shot) {
      this.#desk.cancel();
      return;
    }
    const [ball, pocket] = this.#potOf(shot)!;
    const of = { shot: JSON.stringify(shot), ball, pocket };
    this.#desk.ask(
      { kind: "chance", noise, count: COUNT, of },
      {
        part: ({ met, count }) => {
          if (count < COUNT) return;
          const levels = this.#chances.get(shot) ?? new Map<string, number>();
          this.#chances.set(shot, levels.set(key, met / count));
        },
        done: () => this.draw(),
      },
    );
  }

  #potOf(shot: AimedShot) {
    return potIn(outcomeOf(this.#engine, shot), shot);
  }
}

/** The chances of the shots of a line, from left to right; a chance that is not known yet has no point. */
function picture(
  nodes: readonly TreeNode[],
  chances: readonly (number | null)[],
  at: number | null,
): SVGSVGElement {
  const points = curvePoints(nodes, chances);
  const said = chances.map((chance, k) =>
    t("tree.chance", {
      number: k + 1,
      chance: chance === null ? t("chance.unknown") : percent(chance),
    }),
  );
  return svg(
    "svg",
    {
      viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
      role: "img",
      "aria-label": t("tree.curve", { chances: inWords(said) }),
    },
    ...[HEIGHT - EDGE, EDGE].map((y) =>
      svg("line", { class: "axis", x1: EDGE, y1: y, x2: WIDTH - EDGE, y2: y }),
    ),
    svg("polyline", { points: points.map(({ x, y }) => `${x},${y}`).join(" ") }),
    ...points.map(({ x, y, id }) =>
      svg("circle", { cx: x, cy: y, r: id === at ? 6 : 4, class: id === at ? "here" : "there" }),
    ),
  );
}
