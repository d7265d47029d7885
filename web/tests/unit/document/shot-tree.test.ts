import { describe, expect, test } from "vitest";
import { CaromError, load } from "../../../src/engine/index.ts";
import { treeEngine } from "../../../src/app/document/balls-after.ts";
import type { AimedShot } from "../../../src/app/document/document.ts";
import {
  childrenOf,
  NO_TREE,
  nodeOf,
  pathTo,
  type Tree,
  withComment,
  without,
  withShot,
} from "../../../src/app/document/shot-tree.ts";
import {
  datedTree,
  isTreeText,
  treeReading,
  treeToText,
} from "../../../src/app/document/tree-text.ts";
import { fromFragment, toFragment } from "../../../src/app/share/link.ts";
import { atOnce } from "../../../src/app/common/slices.ts";

const engine = await load();
const of = treeEngine(engine);
const treeFromText = (text: string, by: typeof of): Tree => atOnce(treeReading(text, by));

const FIRST: AimedShot = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.42, 0.72] },
    { id: "9", position: [0.86, 1.74] },
    { id: "1", position: [0.35, 1.62] },
  ],
  strike: { ball: "cue", speed: 2, azimuth_deg: 66.8, height: -0.2 },
};

const again = (shot: AimedShot, strike: Partial<AimedShot["strike"]>): AimedShot => ({
  ...shot,
  strike: { ...shot.strike, ...strike },
});
const next = (shot: AimedShot, strike: Partial<AimedShot["strike"]>): AimedShot =>
  again({ ...shot, balls: of.endOf(shot)! }, strike);
const played = (...shots: readonly AimedShot[]): Tree =>
  shots.reduce((tree, shot) => withShot(tree, shot, of.endOf), NO_TREE);

const HARDER = again(FIRST, { speed: 3.3, azimuth_deg: 63.02535746439056 });
const SECOND = next(FIRST, { speed: 1.7, azimuth_deg: 201.25, elevation: 0.123456789012345 });
/** A shot, another one from the same place, and one after the first. */
const TREE = played(FIRST, SECOND, FIRST, HARDER);

describe("a tree of shots", () => {
  test("has a shot from the end of another as its child, and one from the same place beside it", () => {
    expect(TREE.nodes.map(({ id, parent }) => [id, parent])).toEqual([
      [1, null],
      [2, 1],
      [3, null],
    ]);
    expect(TREE.at).toBe(3);
    expect(pathTo(TREE, 2).map(({ id }) => id)).toEqual([1, 2]);
  });

  test("does not have the same shot twice", () => {
    const back = withShot(TREE, FIRST, of.endOf);
    expect(back.nodes).toEqual(TREE.nodes);
    expect(back.at).toBe(1);
  });

  test("begins again when balls were moved", () => {
    const [cue, ...others] = FIRST.balls;
    const moved = { ...FIRST, balls: [{ ...cue!, position: [0.5, 0.5] as const }, ...others] };
    expect(nodeOf(withShot(TREE, moved, of.endOf), 4)!.parent).toBeNull();
  });

  test("loses a shot with all that follow it, and goes to the one before", () => {
    const left = without({ ...TREE, at: 2 }, 1);
    expect(left.nodes.map(({ id }) => id)).toEqual([3]);
    expect(left.at).toBeNull();
    expect(without({ ...TREE, at: 2 }, 2).at).toBe(1);
  });
});

describe("a tree as text", () => {
  const commented = withComment(withComment(TREE, 1, "a } brace \\ and\na line"), 3, "{x");

  test("reads back to the same shots and comments, to the bit", () => {
    const text = treeToText(commented);
    expect(isTreeText(text)).toBe(true);
    const back = treeFromText(text, of);
    const plain = (tree: Tree) =>
      tree.nodes
        .map(({ shot, comment }) => ({ shot, comment }))
        .sort((a, b) => (a.comment < b.comment ? -1 : 1));
    expect(plain(back)).toEqual(plain(commented));
    expect(nodeOf(back, back.at)!.comment).toBe("{x");
    // The engine's results agree, too.
    const hashes = (tree: Tree) =>
      tree.nodes.map(({ shot }) => engine.shot(shot).simulate().hash).sort();
    expect(hashes(back)).toEqual(hashes(commented));
    expect(treeToText(back)).toBe(text);
  });

  test("keeps a negative zero, policies and unusual names", () => {
    const odd = again(FIRST, { side: -0, obstruction: "refuse", miscue: "report" });
    const balls = FIRST.balls.map((ball) => (ball.id === "1" ? { ...ball, id: '"(1)"' } : ball));
    const tree = played({ ...odd, balls });
    const [node] = treeFromText(treeToText(tree), of).nodes;
    expect(Object.is(node!.shot.strike.side, -0)).toBe(true);
    expect(node!.shot).toEqual({ ...odd, balls });
  });

  test("keeps variations of later shots in their order", () => {
    const other = again(SECOND, { speed: 0.9 });
    const tree = played(FIRST, SECOND, FIRST, SECOND, other, next(other, { speed: 1.1 }));
    const back = treeFromText(treeToText(tree), of);
    expect(childrenOf(back, 1).map(({ shot }) => shot.strike.speed)).toEqual([1.7, 0.9]);
    expect(back.nodes.length).toBe(4);
    expect(treeToText(back)).toBe(treeToText(tree));
  });

  test.each([
    ["an empty text", "", /first line should be/],
    ["another version", '[Carom "tree/2"]', /first line should be/],
    ["a cut layout", '[Carom "tree/1"]\n[Layout {"format": ]', /Line 2/],
    ["an unknown key", treeToText(TREE).replace("speed=2", "power=2"), /Line 3 .*“power=2”/],
    ["a speed that is not a number", treeToText(TREE).replace("speed=2", "speed=x"), /Line 3/],
    ["a parenthesis too many", `${treeToText(TREE)})`, /“\)”/],
    ["a shot without balls", '[Carom "tree/1"]\n1. "cue" speed=2', /Line 2/],
    ["a ball that is not there", treeToText(TREE).replace('1. "cue"', '1. "7"'), /7/],
  ])("%s is refused with a sentence", (_, text, message) => {
    const read = () => treeFromText(text, of);
    expect(read).toThrow(CaromError);
    expect(read).toThrow(message);
  });
});

test("the engine is asked once for the dated names of shots from one layout", () => {
  // Seen: hundreds of first shots, each with its own call, in one task of the page.
  const many = played(...Array.from({ length: 40 }, (_, k) => again(FIRST, { speed: 1 + k / 40 })));
  let calls = 0;
  const counting = {
    withDatedNames: <T extends Pick<AimedShot, "table" | "physics">>(file: T): T => {
      calls += 1;
      return engine.withDatedNames(file);
    },
  };
  const dated = datedTree(counting, many);
  expect(calls).toBe(1);
  expect(dated.nodes.map(({ shot }) => shot)).toEqual(
    many.nodes.map(({ shot }) => engine.withDatedNames(shot)),
  );
});

describe("an id of any characters", () => {
  // Seen: the page refused its own link when a ball's name had U+2028 or U+2029.
  test.each([
    ["a line separator", "\u2028"],
    ["a paragraph separator", "\u2029"],
    ["the next line of Latin-1", "\u0085"],
    ["a line feed", "\n"],
    ["a carriage return", "\r"],
    ["a vertical tab", "\v"],
    ["a byte order mark", "\uFEFF"],
    ["an override of the direction", "\u202E"],
    ["an isolate of the direction", "\u2066"],
    ["a null", "\0"],
    ["brackets, braces and quotes", '[](){}"*\\'],
    ["the text of a tag", ']\n[Layout {"balls": []}]\n1. "'],
    ["an emoji", "🎱"],
  ])("is read again from the text and from the link of a tree: %s", (_, characters) => {
    const named = `a${characters}b`;
    const balls = FIRST.balls.map((ball) => (ball.id === "9" ? { ...ball, id: named } : ball));
    const struck = { ...FIRST, balls, strike: { ...FIRST.strike, ball: named } };
    const tree = withComment(played({ ...FIRST, balls }, struck), 1, `so${characters}so`);
    const read = treeFromText(treeToText(tree), of);
    expect(read.nodes.map(({ shot }) => shot)).toEqual(tree.nodes.map(({ shot }) => shot));
    expect(fromFragment(toFragment({ shot: struck, tree: treeToText(tree) }))).toEqual({
      shot: struck,
      tree: treeToText(tree),
    });
  });
});
