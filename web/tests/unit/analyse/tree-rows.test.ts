import { describe, expect, test } from "vitest";
import {
  curveOf,
  curvePoints,
  EDGE,
  HEIGHT,
  rowsOf,
  WIDTH,
} from "../../../src/app/analyse/tree-rows.ts";
import type { AimedShot } from "../../../src/app/document/document.ts";
import { NO_TREE, type Tree, type TreeNode } from "../../../src/app/document/shot-tree.ts";

const SHOT: AimedShot = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [{ id: "cue", position: [0.6, 0.6] }],
  strike: { ball: "cue", speed: 1, azimuth_deg: 90 },
};

const node = (id: number, parent: number | null): TreeNode => ({
  id,
  parent,
  shot: SHOT,
  comment: "",
});

/** 1 – 2 – 5, another second shot 3 with 4 after it, and a tree 6 of its own. */
const NODES = [node(1, null), node(2, 1), node(3, 1), node(4, 3), node(5, 2), node(6, null)];
const tree = (at: number | null): Tree => ({ nodes: NODES, at });

describe("the rows of a tree", () => {
  test("are none without shots", () => {
    expect(rowsOf(NO_TREE)).toEqual([]);
  });

  test("have a variation below the shot that it replaces, deeper and with the same number", () => {
    const rows = rowsOf(tree(null)).map((row) => [row.node.id, row.number, row.depth]);
    expect(rows).toEqual([
      [1, 1, 0],
      [2, 2, 0],
      [3, 2, 1],
      [4, 3, 1],
      [5, 3, 0],
      [6, 1, 0],
    ]);
  });
});

describe("the curve", () => {
  const ids = (at: number | null) => curveOf(tree(at)).map(({ id }) => id);

  test("has the shots up to the visited one, and the main line from there", () => {
    expect(ids(1)).toEqual([1, 2, 5]);
    expect(ids(5)).toEqual([1, 2, 5]);
    expect(ids(3)).toEqual([1, 3, 4]);
    expect(ids(6)).toEqual([6]);
  });

  test("is empty while no shot is visited", () => {
    expect(ids(null)).toEqual([]);
  });

  test("goes from edge to edge, a certain pot at the top", () => {
    const [first, , last] = curvePoints(curveOf(tree(1)), [1, 0.5, 0]);
    expect(first).toEqual({ x: EDGE, y: EDGE, id: 1 });
    expect(last).toEqual({ x: WIDTH - EDGE, y: HEIGHT - EDGE, id: 5 });
  });

  test("has no point at a chance that is not known yet, and leaves its place free", () => {
    const points = curvePoints(curveOf(tree(1)), [0.5, null, 0.5]);
    expect(points.map(({ id }) => id)).toEqual([1, 5]);
    expect(points[1]!.x).toBe(WIDTH - EDGE);
  });

  test("of one shot is a point at the edge", () => {
    expect(curvePoints(curveOf(tree(6)), [0])).toEqual([{ x: EDGE, y: HEIGHT - EDGE, id: 6 }]);
  });
});
