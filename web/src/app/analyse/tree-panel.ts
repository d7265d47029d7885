/** The tab of the tree: the shots that were played, their comments, and the curve of their chances. */

import { CaromError, type Engine, type Outcome } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, setText, svg, uniqueId } from "../common/dom.ts";
import { changeUnpressed } from "../common/press.ts";
import { errorText } from "../common/refusals.ts";
import { ballName, pocketName } from "../common/shot-words.ts";
import { outcomeOf, treeEngine } from "../document/balls-after.ts";
import type { AimedShot } from "../document/document.ts";
import type { Store } from "../document/store.ts";
import {
  childrenOf,
  LONGEST_COMMENT,
  NO_TREE,
  nodeOf,
  pathTo,
  type Tree,
  type TreeNode,
  withComment,
  without,
} from "../document/shot-tree.ts";
import { treeReading, treeToText } from "../document/tree-text.ts";
import { isPlayed } from "../game/variations.ts";
import { replay } from "../replay/replay-control.ts";
import { Desk } from "./desk/desk-client.ts";
import DeskWorker from "./desk/desk-worker.ts?worker&inline";
import { noiseOf } from "./analysed-position.ts";
import { percent } from "./analyse-words.ts";
import { capital, list as inWords, t } from "../words/translate.ts";

/** Variants of a chance on the curve. */
const COUNT = 300;

/** Width and height of the curve, its own units. */
const WIDTH = 280;
const HEIGHT = 70;
const EDGE = 8;

/** The first object ball that a shot pots, and its pocket. */
function potIn(outcome: Outcome | null, { strike }: AimedShot) {
  return outcome?.pocketed.find(([ball]) => ball !== strike.ball) ?? null;
}

/** What a shot of the tree did. */
function resultText(engine: Engine, { shot }: TreeNode): string {
  const outcome = outcomeOf(engine, shot);
  if (!outcome) return t("tree.unplayable");
  const pot = potIn(outcome, shot);
  const said = pot
    ? capital(t("lines.pot", { ball: ballName(pot[0]), pocket: pocketName(pot[1]) }))
    : t("tree.nothing");
  return outcome.cue_ball_scratched ? t("tree.scratch", { text: said }) : said;
}

/** Shows a tree, a text that a file or a user gives. @throws CaromError if it cannot be read. */
export async function openTree(store: Store, engine: Engine, text: string): Promise<boolean> {
  const tree = await store.open(treeReading(text, treeEngine(engine)));
  if (!tree) return false;
  const node = nodeOf(tree, tree.at);
  return store.apply({ tree, game: null, ...(node && { shot: node.shot }) }, t("change.open-tree"));
}

/** The shots in the order of the list, with their numbers and the depth of their variation. */
interface Row {
  readonly node: TreeNode;
  readonly number: number;
  readonly depth: number;
}

export function rowsOf(tree: Tree): readonly Row[] {
  const rows: Row[] = [];
  const line = (nodes: readonly TreeNode[], number: number, depth: number): void => {
    const [main, ...others] = nodes;
    if (!main) return;
    rows.push({ node: main, number, depth });
    for (const other of others) line([other], number, depth + 1);
    line(childrenOf(tree, main.id), number + 1, depth);
  };
  for (const root of childrenOf(tree, null)) line([root], 1, 0);
  return rows;
}

/** The shots of the curve: those up to the visited one, and the main line from there. */
function curveOf(tree: Tree): readonly TreeNode[] {
  const nodes = [...pathTo(tree, tree.at)];
  for (let next = childrenOf(tree, tree.at)[0]; next; next = childrenOf(tree, next.id)[0])
    nodes.push(next);
  return tree.at === null ? [] : nodes;
}

export function mountTree(
  root: HTMLElement,
  store: Store,
  context: Context,
  share: {
    copy: (text: string) => Promise<boolean>;
    download: (text: string, name: string) => void;
  },
): void {
  const { engine } = context;
  const treeNow = () => store.document.tree ?? NO_TREE;
  const list = h("ol", { class: "tree", "aria-label": t("tree.title") });
  const empty = h("p", { class: "hint" }, t("tree.empty"));
  const curve = h("div", { class: "curve" });
  const comment = h("textarea", { id: uniqueId("comment"), rows: 3, maxlength: LONGEST_COMMENT });
  const button = (key: string, label: string, onclick: () => void) =>
    h("button", { type: "button", class: "button", id: key, onclick }, label);
  const own = h(
    "section",
    { "aria-label": t("tree.shot") },
    h("div", { class: "labelled" }, h("label", { for: comment.id }, t("tree.comment")), comment),
    h(
      "div",
      { class: "row" },
      button("tree-replay", t("tree.replay"), play),
      button("tree-delete", t("tree.delete"), remove),
    ),
  );
  const text = h("textarea", { id: uniqueId("tree-text"), rows: 5 });
  const files = h(
    "details",
    {},
    h("summary", {}, t("tree.text")),
    h("div", { class: "labelled" }, h("label", { for: text.id }, t("tree.as-text")), text),
    h(
      "div",
      { class: "row" },
      button("tree-open", t("tree.open"), () => void open()),
      button("tree-copy", t("tree.copy"), () => void copy()),
      button("tree-download", t("tree.download"), () =>
        share.download(treeToText(treeNow()), "tree.txt"),
      ),
    ),
  );
  const title = h("h2");
  root.append(title, empty, list, curve, own, files);

  function visit({ id, shot }: TreeNode): void {
    store.apply({ shot, game: null, tree: { ...treeNow(), at: id } }, t("change.visit"));
  }

  function play(): void {
    const node = nodeOf(treeNow(), treeNow().at);
    if (!node) return;
    if (store.document.shot !== node.shot) visit(node);
    const { trace } = store.ghost;
    const still = context.reducedMotion();
    if (trace) replay(store, trace, still ? trace.duration : 0, !still);
  }

  function remove(): void {
    const { at } = treeNow();
    if (at === null) return;
    store.apply({ tree: without(treeNow(), at) }, t("change.delete-shot"));
    context.announce(t("tree.deleted"));
  }

  comment.addEventListener("change", () => {
    const { at } = treeNow();
    if (at !== null)
      store.apply({ tree: withComment(treeNow(), at, comment.value) }, t("change.comment"));
  });

  async function open(): Promise<void> {
    try {
      if (await openTree(store, engine, text.value)) context.announce(t("tree.opened"));
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      store.refuse(errorText(error));
    }
  }

  async function copy(): Promise<void> {
    text.value = treeToText(treeNow());
    if (await share.copy(text.value)) context.announce(t("tree.copied"));
    else text.select();
  }

  /** The focus leaves the comment, which is then kept, while a shot of the list is pressed. */
  const show = (): void => changeUnpressed(list, showNow);

  function showNow(): void {
    const tree = treeNow();
    const { study } = store.document;
    setText(title, study ? t("tree.of-move", { number: study.move + 1 }) : t("tree.title"));
    const rows = rowsOf(tree);
    const had = list.contains(document.activeElement);
    list.replaceChildren(
      ...rows.map(({ node, number, depth }) => {
        const item = h("li", {});
        item.style.setProperty("--depth", String(Math.min(depth, 6)));
        item.append(
          h(
            "button",
            {
              type: "button",
              class: "node",
              "aria-current": node.id === tree.at ? "true" : undefined,
              onclick: () => visit(node),
            },
            h("b", {}, `${number}. `),
            study && isPlayed(engine, study, node)
              ? t("tree.played", { text: resultText(engine, node) })
              : resultText(engine, node),
            node.comment ? h("span", { class: "hint" }, ` ${node.comment}`) : null,
          ),
        );
        return item;
      }),
    );
    if (had) list.querySelector<HTMLElement>("[aria-current]")?.focus();
    empty.hidden = rows.length > 0;
    list.hidden = rows.length === 0;
    const node = nodeOf(tree, tree.at);
    own.hidden = node === null;
    if (document.activeElement !== comment) comment.value = node?.comment ?? "";
    drawCurve();
  }

  /** Counted chances by shot and level. */
  const chances = new WeakMap<AimedShot, Map<string, number>>();
  const desk = new Desk(() => new DeskWorker(), engine);

  function drawCurve(): void {
    const tree = treeNow();
    const nodes = root.hidden ? [] : curveOf(tree);
    const noise = noiseOf(engine, store.state);
    const key = JSON.stringify(noise);
    curve.hidden = nodes.length === 0;
    const known = nodes.map(({ shot }) =>
      potIn(outcomeOf(engine, shot), shot) ? (chances.get(shot)?.get(key) ?? null) : 0,
    );
    curve.replaceChildren(
      h("p", { class: "hint" }, t("tree.curve-title")),
      curvePicture(nodes, known, tree.at),
    );
    const missing = known.indexOf(null);
    const shot = nodes[missing]?.shot;
    if (!shot) {
      desk.cancel();
      return;
    }
    const [ball, pocket] = potIn(outcomeOf(engine, shot), shot)!;
    const of = { shot: JSON.stringify(shot), ball, pocket };
    desk.ask(
      { kind: "chance", noise, count: COUNT, of },
      {
        part: ({ met, count }) => {
          if (count < COUNT) return;
          const levels = chances.get(shot) ?? new Map<string, number>();
          chances.set(shot, levels.set(key, met / count));
        },
        done: drawCurve,
      },
    );
  }

  store.subscribe((now, before) => {
    const [is, was] = [now.document, before.document];
    const isTurned = now.session.orientation !== before.session.orientation;
    if (is.tree !== was.tree || is.study !== was.study || isTurned) show();
    else if (
      now.session.analysis.level !== before.session.analysis.level ||
      now.document.noise !== before.document.noise
    )
      drawCurve();
  });
  new MutationObserver(drawCurve).observe(root, { attributeFilter: ["hidden"] });
  setText(empty, t("tree.empty"));
  show();
}

/** The chances of the shots of a line, from left to right; a chance that is not known yet has no point. */
function curvePicture(
  nodes: readonly TreeNode[],
  chances: readonly (number | null)[],
  at: number | null,
): SVGSVGElement {
  const step = nodes.length > 1 ? (WIDTH - 2 * EDGE) / (nodes.length - 1) : 0;
  const points = chances.flatMap((chance, k) =>
    chance === null
      ? []
      : [{ x: EDGE + step * k, y: EDGE + (1 - chance) * (HEIGHT - 2 * EDGE), id: nodes[k]!.id }],
  );
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
    svg("line", {
      class: "axis",
      x1: EDGE,
      y1: HEIGHT - EDGE,
      x2: WIDTH - EDGE,
      y2: HEIGHT - EDGE,
    }),
    svg("line", { class: "axis", x1: EDGE, y1: EDGE, x2: WIDTH - EDGE, y2: EDGE }),
    svg("polyline", { points: points.map(({ x, y }) => `${x},${y}`).join(" ") }),
    ...points.map(({ x, y, id }) =>
      svg("circle", { cx: x, cy: y, r: id === at ? 6 : 4, class: id === at ? "here" : "there" }),
    ),
  );
}
