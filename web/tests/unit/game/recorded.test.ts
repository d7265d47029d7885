import { expect, test } from "vitest";
import { CaromError, load } from "../../../src/engine/index.ts";
import { atOnce } from "../../../src/app/common/slices.ts";
import { recordOf as frameRecordOf } from "../../../src/app/game/game-record.ts";
import {
  chanceSteps,
  stepLines,
  EDGE,
  WIDTH,
} from "../../../src/app/game/recorded/chance-steps.ts";
import { strikesAt } from "../../../src/app/game/recorded/intended-shots.ts";
import { gameOfMatch, isMatchText, namesOf } from "../../../src/app/game/recorded/match-game.ts";
import { LONGEST_NAME } from "../../../src/app/document/stored-game.ts";
import { stateFromFragment, stateToFragment } from "../../../src/app/share/link-state.ts";
import { FIRST_SESSION, FIRST_VIEW } from "../../../src/app/document/document.ts";
import { recordOf } from "./matches.ts";

const engine = await load();

const opened = (text: string, frame = 0) =>
  atOnce(gameOfMatch(engine, engine.matchRecord(text), frame)).game!;

const placeOf = (call: () => unknown): string => {
  try {
    call();
  } catch (error) {
    if (error instanceof CaromError) return error.place;
    throw error;
  }
  return "nothing was refused";
};

test("the text of a record of a match is known by its first line", () => {
  expect(isMatchText(recordOf(engine))).toBe(true);
  expect(isMatchText('{"format": "carom-frame/1", "of": "carom-match/1"}')).toBe(false);
  expect(isMatchText("carom-match/1")).toBe(false);
});

test("a record of a match that goes on has its frames and settings", () => {
  const record = engine.matchRecord(recordOf(engine));
  expect(record.isFinished).toBe(false);
  expect(record.header.game).toBe("nine-ball");
  expect(record.frames.map(({ frame, shots }) => [frame, shots])).toEqual([
    [0, 1],
    [1, 1],
  ]);
  expect(record.frames[1]!.seats).toEqual([1, 0]);
  record.free();
  expect(() => record.game(0)).toThrow("freed");
});

test("a frame of a match opens as a game with the executed shots and the players of its seats", () => {
  const game = opened(recordOf(engine), 1);
  expect(game.moves.map((move) => Object.keys(move)[0])).toEqual(["play", "concede"]);
  expect(game.setup.names[1]).toBe("carom:2000");
  expect(game.setup.names.every((name) => name.length <= LONGEST_NAME)).toBe(true);
  expect(game.setup.options.seed).toBe("9e3779b97f4a7c15");
  const strikes = strikesAt(game, 0)!;
  expect(strikes.intended.speed).toBe(8);
  expect(strikes.executed.speed).toBe(8.1);
  expect(strikesAt(game, 1)).toBeNull();
  expect(game.notes!.moves[0]!.refused).toBe("play: there is none");
  // The game is a frame of its own: its record opens elsewhere.
  expect(engine.replay(frameRecordOf(engine, game)).state.request.kind).toBe("over");
});

test("two players of one name get different names", () => {
  const players = [{ name: "carom" }, { name: "carom" }] as const;
  expect(namesOf({ players })).toEqual(["carom (A)", "carom (B)"]);
});

test("a shot that ends differently is refused with its place", () => {
  const text = recordOf(engine, "0123456789abcdef");
  expect(placeOf(() => opened(text))).toBe("frame 0, moves[0].trace");
});

test("damaged records are refused with line and key", () => {
  const text = recordOf(engine);
  const read = (changed: string) => placeOf(() => engine.matchRecord(changed));
  expect(read(text.replace("carom-match/1", "carom-match/2"))).toBe("line 1, format");
  expect(read(text.replace('"pairs"', '"peers"'))).toBe("line 1, peers");
  expect(read(text.replace('"seats":[1,0]', '"seats":[0,1]'))).toBe("line 3, seats");
  expect(read(text.replace('"simulations":50,"rounds"', '"shots":50,"rounds"'))).toMatch(/^line 2/);
  expect(placeOf(() => engine.matchRecord(text).game(7))).toBe("frame");
});

test("the curve of chances is split into decisions and luck, for the first player", () => {
  const { notes } = opened(recordOf(engine));
  const steps = chanceSteps(notes!);
  expect(steps.map(({ by, from, to }) => [by, from, to])).toEqual([
    ["decision", 0.5, 0.6],
    ["luck", 0.6, 0.4],
  ]);
  const lines = stepLines(steps);
  expect(lines[0]!.x1).toBe(EDGE);
  expect(lines.at(-1)!.x2).toBe(WIDTH - EDGE);
  expect(lines[0]!.y2).toBe(lines[1]!.y1);
  // Without measured luck the players' own chances are shown.
  const own = notes!.moves.map(({ seat, index, chance }) => ({
    seat,
    ...(index !== undefined && { index }),
    ...(chance !== undefined && { chance }),
  }));
  const expected = chanceSteps({ ...notes!, moves: own });
  expect(expected[0]).toEqual({ index: 0, by: "both", from: 0.5, to: 0.5 });
  expect(chanceSteps({ ...notes!, moves: [] })).toEqual([]);
});

test("a link keeps what a match has beside its game", () => {
  const record = engine.matchRecord(recordOf(engine));
  const { game, shot } = atOnce(gameOfMatch(engine, record, 0));
  const document = { shot, noise: null, seed: 0, game };
  const state = { document, view: FIRST_VIEW, session: FIRST_SESSION };
  const read = stateFromFragment(stateToFragment(shot, state))!;
  expect(read.game!.notes).toEqual(game!.notes);
  const broken = { ...game!, notes: { ...game!.notes!, moves: [{ seat: 2 }] } } as never;
  const changed = { ...state, document: { ...document, game: broken } };
  expect(() => stateFromFragment(stateToFragment(shot, changed))).toThrow();
});
