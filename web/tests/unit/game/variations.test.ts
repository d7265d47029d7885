/** Shots of a game that are analysed, and their variations in records and links. */

import { expect, test } from "vitest";
import { CaromError, type FrameRecord } from "../../../src/engine/index.ts";
import { shoot, takeItFromHere } from "../../../src/app/aim/shoot.ts";
import { leave } from "../../../src/app/replay/replay-control.ts";
import type { Store } from "../../../src/app/document/store.ts";
import { withComment } from "../../../src/app/document/shot-tree.ts";
import { playShot } from "../../../src/app/game/game-actions.ts";
import { progressOf } from "../../../src/app/game/game-progress.ts";
import { atOnce } from "../../../src/app/common/slices.ts";
import { gameOfRecord, plainRecordOf, recordOf } from "../../../src/app/game/game-record.ts";
import {
  closeStudy,
  countVariations,
  isPlayed,
  openStudy,
} from "../../../src/app/game/variations.ts";
import { linkText, readLink } from "../../../src/app/share/address.ts";
import { begun, context as games, engine } from "./games.ts";

const context = { ...games, reducedMotion: () => true };

/** A game of nine-ball with two shots. */
function played(): Store {
  const store = begun("nine-ball", { skills: ["club", null] });
  for (const azimuth_deg of [90, 180]) {
    store.strike({ speed: 5, azimuth_deg }, "aim");
    playShot(store, context, () => undefined);
  }
  expect(store.document.game!.moves.length).toBe(2);
  return store;
}

/** Plays a shot of the analysis, and stays where it began. */
function tries(store: Store, azimuth_deg: number): void {
  store.strike({ azimuth_deg, speed: 3 }, "aim");
  shoot(store, context);
  leave(store);
}

/** The game with two variations of the first move, one of which goes on, and comments. */
async function analysed(): Promise<Store> {
  const store = played();
  await openStudy(store, engine, 0);
  const { tree } = store.document;
  store.apply({ tree: withComment(tree!, tree!.at!, "too hard}") }, "comment");
  tries(store, 95);
  tries(store, 85);
  shoot(store, context);
  takeItFromHere(store, context);
  shoot(store, context);
  leave(store);
  closeStudy(store, engine);
  return store;
}

test("the position before a shot opens with the shot that was played", async () => {
  const store = played();
  const { game } = store.document;
  const hash = progressOf(engine, game!).trace!.hash;
  expect(await openStudy(store, engine, 1)).toBe(true);
  const { study, tree, shot, game: none } = store.document;
  expect([none, study!.move, study!.game]).toEqual([null, 1, game]);
  expect(tree!.nodes.length).toBe(1);
  expect(isPlayed(engine, study!, tree!.nodes[0]!)).toBe(true);
  expect(engine.shot(shot).simulate().hash).toBe(hash);
});

test("the game comes back as it was, with the aim and the earlier shots of the analysis", async () => {
  const store = played();
  store.strike({ speed: 1.25 }, "aim");
  const before = store.document;
  await openStudy(store, engine, 0);
  closeStudy(store, engine);
  expect(store.document.game).toEqual({ ...before.game, variations: {} });
  expect(store.document.game!.moves).toBe(before.game!.moves);
  expect([store.document.shot, store.document.tree]).toEqual([before.shot, before.tree]);
  expect(store.document.study).toBeUndefined();
});

test("shots that are tried are variations of the move, and open again with it", async () => {
  const store = await analysed();
  const text = store.document.game!.variations![0]!;
  expect(countVariations(text)).toBe(3);
  await openStudy(store, engine, 0);
  const { tree, study } = store.document;
  expect(tree!.nodes.map(({ comment }) => comment)).toEqual(["too hard}", "", "", ""]);
  const azimuths = tree!.nodes.map(({ shot }) => shot.strike.azimuth_deg);
  expect(azimuths.slice(1)).toEqual([95, 85, 85]);
  expect(isPlayed(engine, study!, tree!.nodes[0]!)).toBe(true);
  expect(tree!.nodes.slice(1).some((node) => isPlayed(engine, study!, node))).toBe(false);
  closeStudy(store, engine);
  expect(store.document.game!.variations![0]).toBe(text);
});

test("undo goes back through the analysis to the game", async () => {
  const store = played();
  const { game } = store.document;
  await openStudy(store, engine, 0);
  tries(store, 95);
  closeStudy(store, engine);
  expect(store.document.game!.variations![0]).toBeDefined();
  store.undo(); // the return
  expect(store.document.study?.move).toBe(0);
  store.undo(); // the shot
  expect(store.document.tree!.nodes.length).toBe(1);
  store.undo(); // its aim
  store.undo(); // the position
  expect(store.document.game).toBe(game);
});

test("a record has the variations, replays to the bit, and opens with them", async () => {
  const { game } = (await analysed()).document;
  const record = JSON.parse(JSON.stringify(recordOf(engine, game!))) as FrameRecord;
  expect(record.moves[0]).toHaveProperty("variations", game!.variations![0]);
  const replayed = engine.replay(record);
  expect(replayed.state).toEqual(progressOf(engine, game!).frame.state);
  expect(replayed.record).toEqual(plainRecordOf(engine, game!));
  const back = atOnce(gameOfRecord(engine, record)).game!;
  expect(back.variations).toEqual(game!.variations);
  expect(recordOf(engine, back)).toEqual(record);
});

test("a record with variations that cannot be read is refused with the move's number", async () => {
  const record = recordOf(engine, (await analysed()).document.game!);
  const [first, second] = record.moves as [FrameRecord["moves"][0], FrameRecord["moves"][0]];
  for (const variations of ["[Carom", 3]) {
    const odd = { ...record, moves: [first, { ...second, variations }] } as FrameRecord;
    expect(() => atOnce(gameOfRecord(engine, odd))).toThrow(CaromError);
    expect(() => atOnce(gameOfRecord(engine, odd))).toThrow(/move 2/);
  }
});

test("a link has the variations, and an analysis that is under way", async () => {
  const store = await analysed();
  const link = () => atOnce(readLink(engine, linkText(store, engine)))!.document;
  expect(link().game!.variations).toEqual(store.document.game!.variations);
  await openStudy(store, engine, 1);
  tries(store, 12);
  const { study, tree, game } = link();
  expect(game).toBeNull();
  expect(study!.move).toBe(1);
  expect(study!.game.variations).toEqual(store.document.study!.game.variations);
  expect(tree!.nodes.length).toBe(2);
  // The opened link goes back to the same game.
  store.apply({ game: null, study, tree }, "link");
  closeStudy(store, engine);
  expect(countVariations(store.document.game!.variations![1])).toBe(1);
  expect(store.document.game!.moves.length).toBe(2);
});

test("a game that is opened ends the analysis of another one", async () => {
  const store = played();
  const { game } = store.document;
  await openStudy(store, engine, 0);
  store.apply({ game, shot: store.document.study!.shot }, "open");
  expect(store.document.study).toBeUndefined();
});

test("one undo takes back one shot of an analysis", async () => {
  const store = played();
  await openStudy(store, engine, 0);
  const before = store.document;
  shoot(store, context); // the played shot: it is in the tree already
  takeItFromHere(store, context);
  store.undo();
  expect(store.document).toEqual(before);
  store.strike({ speed: 2.5 }, "aim");
  const aimed = store.document;
  shoot(store, context);
  takeItFromHere(store, context);
  expect(store.document.tree!.nodes.length).toBe(2);
  store.undo();
  expect(store.document).toBe(aimed);
  store.redo();
  expect(store.document.tree!.nodes.length).toBe(2);
  expect(store.document.shot.balls).not.toEqual(aimed.shot.balls);
});

test("the variations do not open once the game has gone on", async () => {
  const store = await analysed();
  const opening = openStudy(store, engine, 0);
  store.strike({ speed: 4, azimuth_deg: 45 }, "aim");
  playShot(store, context, () => undefined);
  const { game } = store.document;
  expect(await opening).toBe(false);
  expect(store.document.game).toBe(game);
});
