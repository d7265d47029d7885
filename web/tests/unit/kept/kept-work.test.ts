/** Works are packed and read back as they were; damaged ones are refused with the place of the fault. */

import { describe, expect, test } from "vitest";
import type { Work } from "../../../src/app/kept/kept-work.ts";
import { MOST_STEPS, packed, unpacked } from "../../../src/app/kept/kept-work.ts";
import { KeptFault } from "../../../src/app/kept/kept-fault.ts";
import { finishedOf, GAME_FORMAT } from "../../../src/app/kept/finished-game.ts";
import type { Setup } from "../../../src/app/document/stored-game.ts";
import type { Store } from "../../../src/app/document/store.ts";
import { withShot } from "../../../src/app/document/shot-tree.ts";
import { playMove } from "../../../src/app/game/game-actions.ts";
import { begun, context } from "../game/games.ts";

const idOf = () => "id of the game";

function workOf(store: Store, more: Partial<Work> = {}): Work {
  const changed = "2026-11-28T10:00:00.000Z";
  return {
    id: "a",
    kind: "game",
    changed,
    over: false,
    steps: store.steps,
    practice: null,
    ...more,
  };
}

/** A game with shots, aims, an undone shot, a tree, a film and a study. */
function played(): Store {
  const store = begun("nine-ball");
  for (const speed of [6, 2]) {
    playMove(store, context, { strike: { speed, azimuth: 1.6, elevation: 0, side: 0, height: 0 } });
    store.strike({ azimuth_deg: 33 }, "aim");
  }
  const { shot } = store.document;
  const film = { balls: shot.balls, track: [{ ball: "cue", samples: [[0, 0.5, 0.6] as const] }] };
  store.apply({ tree: withShot({ nodes: [], at: null }, shot, () => null), filmed: film }, "tree");
  const game = store.document.game!;
  const study = { game, move: 0, shot, tree: store.document.tree };
  store.apply({ game: null, study }, "study");
  store.undo();
  return store;
}

/** As the browser's database, and then a file, give it. */
const copied = (data: unknown): unknown => JSON.parse(JSON.stringify(structuredClone(data)));

test("a history comes back with every state, label and text", () => {
  const store = played();
  const work = workOf(store);
  const read = unpacked(copied(packed(work, idOf)), "work");
  expect(read).toEqual(work);
  const texts = ({ steps }: Work) => steps.steps.map(({ state }) => JSON.stringify(state.shot));
  expect(texts(read)).toEqual(texts(work));
  expect(read.steps.at).toBe(store.steps.steps.length - 2);
});

test("states share their parts again, so that undo need not play a game again", () => {
  const ids: [Setup, string][] = [];
  const { steps } = unpacked(copied(packed(workOf(played()), idOf)), "work", (setup, id) =>
    ids.push([setup, id]),
  ).steps;
  const games = new Set(steps.flatMap(({ state }) => state.game ?? []));
  const setups = new Set([...games].map(({ setup }) => setup));
  expect(games.size).toBe(3);
  expect([...setups]).toEqual([ids[0]![0]]);
  expect(ids).toHaveLength(1);
  expect(ids[0]![1]).toBe("id of the game");
});

test("a packed history is small, because it has each part a single time", () => {
  const store = begun("nine-ball");
  for (let k = 0; k < 300; k += 1) store.strike({ azimuth_deg: k / 10 }, "aim");
  const text = JSON.stringify(packed(workOf(store), idOf));
  expect(text.length).toBeLessThan(0.25 * JSON.stringify(store.steps).length);
});

test("of a long history the newest steps are kept", () => {
  const store = begun("nine-ball");
  for (let k = 0; k < MOST_STEPS + 10; k += 1) store.strike({ azimuth_deg: k / 10 }, `aim ${k}`);
  const { steps } = unpacked(copied(packed(workOf(store), idOf)), "work");
  expect(steps.steps).toHaveLength(MOST_STEPS);
  expect(steps.at).toBe(MOST_STEPS - 1);
  expect(steps.steps.at(-1)!.state.shot).toEqual(store.document.shot);
});

test("the store goes on with a history that was read", () => {
  const store = played();
  const { steps } = unpacked(copied(packed(workOf(store), idOf)), "work");
  const other = begun("eight-ball");
  expect(other.resume(steps)).toBe(true);
  expect(other.document).toEqual(store.document);
  expect([other.undoLabel, other.redoLabel]).toEqual(["tree", "study"]);
  while (store.undo()) expect(other.undo()).toBe(true);
  expect(other.undo()).toBe(false);
  expect(other.document).toEqual(store.document);
  while (store.redo()) expect(other.redo()).toBe(true);
  expect(other.document).toEqual(store.document);
});

test("a state that the engine refuses is passed over, with its reason", () => {
  const store = begun("nine-ball");
  store.strike({ speed: 3 }, "speed");
  const kept = copied(packed(workOf(store), idOf)) as { shots: { table: unknown }[] };
  const second = JSON.stringify(store.steps.steps[1]!.state.shot);
  kept.shots[0]!.table = "no such table";
  const other = begun("nine-ball");
  const { steps } = unpacked(kept, "work");
  expect(other.resume(steps)).toBe(true);
  while (other.undo());
  expect(other.session.refusal).not.toBeNull();
  expect(JSON.stringify(other.document.shot)).toBe(second);
});

describe("a damaged work is refused with the place of the fault", () => {
  type Data = Record<string, never> & {
    steps: Record<string, unknown>[];
    games: Record<string, unknown>[];
    setups: Record<string, unknown>[];
    shots: Record<string, unknown>[];
    trees: { nodes: number[]; at: unknown }[];
    nodes: Record<string, unknown>[];
    films: { track: { samples: unknown[] }[] }[];
  };
  const cases: [string, string, (data: Data) => void][] = [
    ["another format", "work.format", (data) => Object.assign(data, { format: "carom-work/2" })],
    ["an unknown key", "work.run", (data) => Object.assign(data, { run: "alert(1)" })],
    ["a missing key", "work.at", (data) => Reflect.deleteProperty(data, "at")],
    ["no present state", "work.at", (data) => Object.assign(data, { at: 99 })],
    ["a time", "work.changed", (data) => Object.assign(data, { changed: "yesterday" })],
    ["a kind", "work.kind", (data) => Object.assign(data, { kind: "match" })],
    ["no shot", "work.steps[1].shot", (data) => (data.steps[1]!.shot = 999)],
    ["a key of a step", "work.steps[0].more", (data) => (data.steps[0]!.more = 1)],
    ["a label", "work.steps[0].label", (data) => (data.steps[0]!.label = 5)],
    ["a noise", "work.steps[0].noise", (data) => (data.steps[0]!.noise = { speed: "x" })],
    ["a set-up", "work.setups[0].setup", (data) => (data.setups[0]!.setup = null)],
    ["names", "work.games[0]", (data) => (data.setups[0]!.setup = { rules: "nine-ball" })],
    ["moves", "work.games[1].moves[0]", (data) => (data.games[1]!.moves = [77])],
    ["a strike", "work.shots[0]", (data) => (data.shots[0]!.strike = "hard")],
    ["balls", "work.shots[0].balls", (data) => (data.shots[0]!.balls = [])],
    ["a parent", "work.trees[0].nodes[0]", (data) => (data.nodes[0]!.parent = 1)],
    ["the visited node", "work.trees[0].at", (data) => (data.trees[0]!.at = 5)],
    [
      "a sample",
      "work.films[0].track[0].samples[0]",
      (data) => (data.films[0]!.track[0]!.samples = [[0, 1]]),
    ],
    [
      "a practice",
      "work.practice.kept",
      (data) => Object.assign(data, { practice: { kept: {}, before: null } }),
    ],
  ];
  test.each(cases)("%s", (_, place, damage) => {
    const data = copied(packed(workOf(played()), idOf)) as Data;
    damage(data);
    const read = () => unpacked(data, "work");
    expect(read).toThrow(KeptFault);
    expect(read).toThrow(expect.objectContaining({ place }));
  });

  test("whatever value stands in whatever place", () => {
    const whole = packed(workOf(played()), idOf);
    for (const key of Object.keys(whole)) {
      for (const value of [null, 7, "text", [], [null], {}, [{}], [[]], true]) {
        const data = { ...(copied(whole) as object), [key]: value };
        try {
          unpacked(data, "work");
        } catch (error) {
          expect(error, `${key} = ${JSON.stringify(value)}`).toBeInstanceOf(KeptFault);
        }
      }
    }
  });
});

test("a finished game is read back, and a damaged one refused", () => {
  const { game } = played().steps.steps.at(-2)!.state;
  const entry = {
    format: GAME_FORMAT,
    id: "g",
    ended: "2026-11-28T10:00:00.000Z",
    game,
    winner: 0,
    scores: [1, 0],
  };
  expect(finishedOf(copied(entry), "game")).toEqual(entry);
  const made = { ...entry, engine: "carom 0.0.1" };
  expect(finishedOf(copied(made), "game")).toEqual(made);
  for (const [key, value] of [
    ["winner", 2],
    ["scores", [1]],
    ["scores", ["1", 0]],
    ["game", null],
    ["game", { setup: {} }],
    ["ended", "today"],
    ["engine", 1],
    ["more", 1],
  ] as const) {
    expect(() => finishedOf({ ...entry, [key]: value }, "game"), key).toThrow(KeptFault);
  }
});
