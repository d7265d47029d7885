/**
 * The analysis of a shot of a game: its position opens on a free table, the shots that are tried there are
 * variations of the move, and the game comes back with them.
 */

import { CaromError, type Engine } from "../../engine/index.ts";
import { errorText, PageError } from "../common/refusals.ts";
import type { Slices } from "../common/slices.ts";
import { treeEngine } from "../document/balls-after.ts";
import type { AimedShot, Document, Study } from "../document/document.ts";
import { aimed } from "../document/shot-file.ts";
import type { Game, Variations } from "../document/stored-game.ts";
import type { Store } from "../document/store.ts";
import { childrenOf, NO_TREE, type Tree, type TreeNode, withShot } from "../document/shot-tree.ts";
import { datedTree, treeReading, treeToText } from "../document/tree-text.ts";
import { progressOf } from "./game-progress.ts";
import { t } from "../words/translate.ts";

/**
 * Opens the position before a shot of the game, with its variations. Hundreds of them take longer than a
 * picture, so they are read in slices; nothing opens if the game has changed meanwhile.
 *
 * @param aim A better shot from there; left out: the one that was played.
 * @returns Whether it is open.
 */
export async function openStudy(
  store: Store,
  engine: Engine,
  index: number,
  aim?: AimedShot,
): Promise<boolean> {
  const { game } = store.document;
  if (!game) return false;
  try {
    const played = playedShot(engine, game, index);
    const tree = await store.open(variationsOf(engine, game, index, played));
    const { shot: now, tree: earlier } = store.document;
    if (!tree || store.document.game !== game) return false;
    const free = withoutCling(aim ?? played);
    const study = { game, move: index, shot: now, tree: earlier };
    return store.apply({ game: null, shot: free, tree, study }, t("change.open-position"));
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    store.refuse(errorText(error));
    return false;
  }
}

/** Returns to the game of the analysed shot; its variations are kept with the move. */
export function closeStudy(store: Store, engine: Engine): void {
  const { study } = store.document;
  if (study) store.apply(ended(store.document, study, engine), t("change.close-position"));
}

/** What is tried may hit other balls than the contacts that cling in the played shot. */
function withoutCling(shot: AimedShot): AimedShot {
  const free: { -readonly [K in keyof AimedShot]: AimedShot[K] } = { ...shot };
  delete free.cling;
  return free;
}

function ended({ tree = NO_TREE }: Document, study: Study, engine: Engine): Partial<Document> {
  const { game, move, shot } = study;
  const others = Object.fromEntries(
    Object.entries(game.variations ?? {}).filter(([index]) => Number(index) !== move),
  );
  const played = playedShot(engine, game, move);
  const [only] = tree.nodes;
  const isEmpty =
    tree.nodes.length === 0 ||
    (tree.nodes.length === 1 && only!.comment === "" && isSame(only!.shot, played));
  const variations: Variations = isEmpty
    ? others
    : { ...others, [move]: treeToText({ ...datedTree(engine, tree), at: null }) };
  return { game: { ...game, variations }, shot, tree: study.tree, study: undefined };
}

/** Whether a shot of the tree is the one that was played in the game. */
export function isPlayed(
  engine: Engine,
  { game, move }: Study,
  { parent, shot }: TreeNode,
): boolean {
  return parent === null && isSame(shot, playedShot(engine, game, move));
}

/** How many shots other than the played one a move has. */
export function countVariations(text: string | undefined): number {
  // Each shot has its number at the start of a line or of a parenthesis.
  const shots = text?.match(/^(?:\( )?\d+\. "/gm)?.length ?? 0;
  return Math.max(0, shots - 1);
}

/** The shots of games that were played, by their moves. */
const known = new WeakMap<object, AimedShot>();

/** The shot of a move as it was played, from the position before it. Presets have dated names. */
function playedShot(engine: Engine, game: Game, index: number): AimedShot {
  const step = progressOf(engine, game).steps[index];
  if (!step || !("play" in step.move)) throw new PageError(t("study.no-shot"), "moves");
  let found = known.get(step);
  if (!found) {
    const shot = step.from.shot(step.move.play);
    known.set(step, (found = aimed(engine.withDatedNames(shot.source))));
    shot.free();
  }
  return found;
}

/** The tree of a move, at the shot that was played. */
function* variationsOf(engine: Engine, game: Game, index: number, played: AimedShot): Slices<Tree> {
  const text = game.variations?.[index];
  const tree = text === undefined ? NO_TREE : yield* treeReading(text, treeEngine(engine));
  const node = childrenOf(tree, null).find(({ shot }) => isSame(shot, played));
  if (node) return { ...tree, at: node.id };
  return withShot({ ...tree, at: null }, played, treeEngine(engine).endOf);
}

function isSame(a: AimedShot, b: AimedShot): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
