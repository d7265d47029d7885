/**
 * The shots that were played in an analysis, as a tree: a shot from the end of another one is its child, and
 * another shot from the same layout its sibling. Immutable.
 */

import type { BallEntry } from "../../engine/index.ts";
import type { AimedShot } from "./aimed-shot.ts";

/** A shot that was played, from the layout that it has. */
export interface TreeNode {
  readonly id: number;
  /** The shot from whose end it was played; null: it begins a tree of its own. */
  readonly parent: number | null;
  readonly shot: AimedShot;
  readonly comment: string;
}

export interface Tree {
  /** A parent comes before its children, and the main line before its variations. */
  readonly nodes: readonly TreeNode[];
  /** The shot that was played or visited last. */
  readonly at: number | null;
}

export const NO_TREE: Tree = { nodes: [], at: null };

/** The most shots of a tree. */
export const MOST_NODES = 500;

/** The longest comment, in characters. */
export const LONGEST_COMMENT = 1000;

export function nodeOf({ nodes }: Tree, id: number | null): TreeNode | null {
  return nodes.find((node) => node.id === id) ?? null;
}

export function childrenOf({ nodes }: Tree, id: number | null): readonly TreeNode[] {
  return nodes.filter(({ parent }) => parent === id);
}

/** The shots from the first one to this one. */
export function pathTo(tree: Tree, id: number | null): readonly TreeNode[] {
  const path: TreeNode[] = [];
  for (let node = nodeOf(tree, id); node; node = nodeOf(tree, node.parent)) path.unshift(node);
  return path;
}

/**
 * The tree with one more shot, which is visited. The same shot from the same place is not added twice.
 *
 * @param endOf The balls at the end of a shot; null if they cannot be played on.
 */
export function withShot(
  tree: Tree,
  shot: AimedShot,
  endOf: (shot: AimedShot) => readonly BallEntry[] | null,
): Tree {
  const parent = parentOf(tree, shot, endOf);
  const known = childrenOf(tree, parent).find((node) => same(node.shot, shot));
  if (known) return { ...tree, at: known.id };
  const id = Math.max(0, ...tree.nodes.map((node) => node.id)) + 1;
  return { nodes: [...tree.nodes, { id, parent, shot, comment: "" }], at: id };
}

/** The shot from whose end `shot` is played: searched from the visited one back to the first. */
function parentOf(
  tree: Tree,
  shot: AimedShot,
  endOf: (shot: AimedShot) => readonly BallEntry[] | null,
): number | null {
  for (const node of [...pathTo(tree, tree.at)].reverse()) {
    if (!same(setting(node.shot), setting(shot))) continue;
    if (same(endOf(node.shot), shot.balls)) return node.id;
    if (same(node.shot.balls, shot.balls)) return node.parent;
  }
  return null;
}

/** Whether two shots are played from the same position. */
export function startsFrom(a: AimedShot, b: AimedShot): boolean {
  return same(a.balls, b.balls) && same(setting(a), setting(b));
}

/** Everything of a shot but balls and strike, and what is drawn. */
function setting(shot: AimedShot): object {
  return { ...shot, balls: undefined, strike: undefined, marks: undefined };
}

function same(a: unknown, b: unknown): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

/** The tree without a shot and all that follow it. */
export function without(tree: Tree, id: number): Tree {
  const gone = new Set([id]);
  for (const { id: child, parent } of tree.nodes) {
    if (parent !== null && gone.has(parent)) gone.add(child);
  }
  const parent = nodeOf(tree, id)?.parent ?? null;
  const at = tree.at !== null && gone.has(tree.at) ? parent : tree.at;
  return { nodes: tree.nodes.filter((node) => !gone.has(node.id)), at };
}

export function withComment(tree: Tree, id: number, comment: string): Tree {
  const nodes = tree.nodes.map((node) => (node.id === id ? { ...node, comment } : node));
  return { ...tree, nodes };
}
