/** A tree of shots as a list of rows, and a line of it as a curve of chances. */

import { childrenOf, pathTo, type Tree, type TreeNode } from "../document/shot-tree.ts";

/** A shot in the order of the list, with its number and the depth of its variation. */
export interface Row {
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
export function curveOf(tree: Tree): readonly TreeNode[] {
  const nodes = [...pathTo(tree, tree.at)];
  for (let next = childrenOf(tree, tree.at)[0]; next; next = childrenOf(tree, next.id)[0])
    nodes.push(next);
  return tree.at === null ? [] : nodes;
}

/** Width and height of the curve, and the free edge around it, its own units. */
export const WIDTH = 280;
export const HEIGHT = 70;
export const EDGE = 8;

/** The points of chances from left to right; a chance that is not known yet has no point. */
export function curvePoints(
  nodes: readonly TreeNode[],
  chances: readonly (number | null)[],
): { readonly x: number; readonly y: number; readonly id: number }[] {
  const step = nodes.length > 1 ? (WIDTH - 2 * EDGE) / (nodes.length - 1) : 0;
  return nodes.flatMap(({ id }, k) => {
    const chance = chances[k] ?? null;
    return chance === null
      ? []
      : [{ x: EDGE + step * k, y: EDGE + (1 - chance) * (HEIGHT - 2 * EDGE), id }];
  });
}
