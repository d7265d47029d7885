/** The tab of the tree: the shots that were played, their comments, and the curve of their chances. */

import { CaromError, type Engine } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, labelled, setText, uniqueId } from "../common/dom.ts";
import { changeUnpressed } from "../common/press.ts";
import { errorText } from "../common/refusals.ts";
import { playedName, pocketName } from "../common/shot-words.ts";
import { outcomeOf, treeEngine } from "../document/balls-after.ts";
import type { Store } from "../document/store.ts";
import {
  LONGEST_COMMENT,
  NO_TREE,
  nodeOf,
  type Tree,
  type TreeNode,
  withComment,
  without,
} from "../document/shot-tree.ts";
import { treeReading, treeToText } from "../document/tree-text.ts";
import { isPlayed } from "../game/variations.ts";
import { replay } from "../replay/replay-control.ts";
import { ChanceCurve, potIn } from "./chance-curve.ts";
import { type Row, rowsOf } from "./tree-rows.ts";
import { capital, t } from "../words/translate.ts";

/** What a shot of the tree did. */
function resultText(engine: Engine, { shot }: TreeNode): string {
  const outcome = outcomeOf(engine, shot);
  if (!outcome) return t("tree.unplayable");
  const pot = potIn(outcome, shot);
  const said = pot
    ? capital(t("lines.pot", { ball: playedName(pot[0]), pocket: pocketName(pot[1]) }))
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

interface Share {
  readonly copy: (text: string) => Promise<boolean>;
  readonly download: (text: string, name: string) => void;
}

export function mountTree(root: HTMLElement, store: Store, context: Context, share: Share): void {
  const panel = new TreePanel(root, store, context, share);
  store.subscribe((now, before) => {
    const [is, was] = [now.document, before.document];
    const isTurned = now.session.orientation !== before.session.orientation;
    if (is.tree !== was.tree || is.study !== was.study || isTurned) panel.show();
    else if (now.session.analysis.level !== before.session.analysis.level || is.noise !== was.noise)
      panel.curve.draw();
  });
  new MutationObserver(() => panel.curve.draw()).observe(root, { attributeFilter: ["hidden"] });
  panel.show();
}

class TreePanel {
  readonly #store: Store;
  readonly #context: Context;
  readonly #share: Share;
  readonly #title = h("h2");
  readonly #empty = h("p", { class: "hint" }, t("tree.empty"));
  readonly #list = h("ol", { class: "tree", "aria-label": t("tree.title") });
  readonly curve: ChanceCurve;
  /** The part about the visited shot. */
  readonly #own: HTMLElement;
  readonly #comment = h("textarea", {
    id: uniqueId("comment"),
    rows: 3,
    maxlength: LONGEST_COMMENT,
  });
  readonly #text = h("textarea", { id: uniqueId("tree-text"), rows: 5 });

  constructor(root: HTMLElement, store: Store, context: Context, share: Share) {
    this.#store = store;
    this.#context = context;
    this.#share = share;
    this.curve = new ChanceCurve(root, store, context.engine);
    this.#own = h(
      "section",
      { "aria-label": t("tree.shot") },
      labelled(t("tree.comment"), this.#comment),
      h(
        "div",
        { class: "row" },
        button("tree-replay", t("tree.replay"), () => this.#play()),
        button("tree-delete", t("tree.delete"), () => this.#remove()),
      ),
    );
    this.#comment.addEventListener("change", () => {
      const { at } = this.#tree;
      if (at === null) return;
      const tree = withComment(this.#tree, at, this.#comment.value);
      store.apply({ tree }, t("change.comment"));
    });
    root.append(this.#title, this.#empty, this.#list, this.curve.element, this.#own, this.#files());
  }

  get #tree(): Tree {
    return this.#store.document.tree ?? NO_TREE;
  }

  #files(): HTMLElement {
    const details = h(
      "details",
      {},
      h("summary", {}, t("tree.text")),
      labelled(t("tree.as-text"), this.#text),
      h(
        "div",
        { class: "row" },
        button("tree-open", t("tree.open"), () => void this.#openText()),
        button("tree-copy", t("tree.copy"), () => void this.#copy()),
        button("tree-download", t("tree.download"), () =>
          this.#share.download(treeToText(this.#tree), "tree.txt"),
        ),
      ),
    );
    details.addEventListener("toggle", () => {
      // A text that the user has put there stays.
      if (details.open && this.#text.value === "") this.#text.value = this.#asText();
    });
    return details;
  }

  /** The shots as text; empty without shots. */
  #asText(): string {
    return this.#tree.nodes.length > 0 ? treeToText(this.#tree) : "";
  }

  #visit({ id, shot }: TreeNode): void {
    this.#store.apply({ shot, game: null, tree: { ...this.#tree, at: id } }, t("change.visit"));
  }

  #play(): void {
    const node = nodeOf(this.#tree, this.#tree.at);
    if (!node) return;
    if (this.#store.document.shot !== node.shot) this.#visit(node);
    const { trace } = this.#store.ghost;
    const still = this.#context.reducedMotion();
    if (trace) replay(this.#store, trace, still ? trace.duration : 0, !still);
  }

  #remove(): void {
    const { at } = this.#tree;
    if (at === null) return;
    this.#store.apply({ tree: without(this.#tree, at) }, t("change.delete-shot"));
    this.#context.announce(t("tree.deleted"));
  }

  async #openText(): Promise<void> {
    const context = this.#context;
    try {
      if (await openTree(this.#store, context.engine, this.#text.value))
        context.announce(t("tree.opened"));
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      this.#store.refuse(errorText(error));
    }
  }

  async #copy(): Promise<void> {
    this.#text.value = treeToText(this.#tree);
    if (await this.#share.copy(this.#text.value)) this.#context.announce(t("tree.copied"));
    else this.#text.select();
  }

  /** The focus leaves the comment, which is then kept, while a shot of the list is pressed. */
  show(): void {
    changeUnpressed(this.#list, () => this.#showNow());
  }

  #showNow(): void {
    const { study } = this.#store.document;
    setText(this.#title, study ? t("tree.of-move", { number: study.move + 1 }) : t("tree.title"));
    const rows = rowsOf(this.#tree);
    const had = this.#list.contains(document.activeElement);
    this.#list.replaceChildren(...rows.map((row) => this.#item(row)));
    if (had) this.#list.querySelector<HTMLElement>("[aria-current]")?.focus();
    this.#empty.hidden = rows.length > 0;
    this.#list.hidden = rows.length === 0;
    const node = nodeOf(this.#tree, this.#tree.at);
    this.#own.hidden = node === null;
    if (document.activeElement !== this.#comment) this.#comment.value = node?.comment ?? "";
    this.curve.draw();
  }

  #item({ node, number, depth }: Row): HTMLElement {
    const { engine } = this.#context;
    const { study } = this.#store.document;
    const text = resultText(engine, node);
    const current = node.id === this.#tree.at ? "true" : undefined;
    const onclick = () => this.#visit(node);
    const item = h(
      "li",
      {},
      h(
        "button",
        { type: "button", class: "node", "aria-current": current, onclick },
        h("b", {}, `${number}. `),
        study && isPlayed(engine, study, node) ? t("tree.played", { text }) : text,
        node.comment ? h("span", { class: "hint" }, ` ${node.comment}`) : null,
      ),
    );
    item.style.setProperty("--depth", String(Math.min(depth, 6)));
    return item;
  }
}

function button(id: string, label: string, onclick: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "button", id, onclick }, label);
}
