import { expect, test } from "vitest";
import { CaromError, type FrameRecord, load } from "../../../src/engine/index.ts";
import { atOnce } from "../../../src/app/common/slices.ts";
import { gameOfRecord, recordOf } from "../../../src/app/game/game-record.ts";
import { progressOf } from "../../../src/app/game/game-progress.ts";
import { gameProgram } from "../../../src/app/share/python.ts";

const engine = await load();

function frame() {
  const played = engine.frame("nine-ball", { seed: 5 });
  const strike = { speed: 9, azimuth: Math.PI / 2, side: 0, height: 0 };
  played.play({ strike });
  played.concede();
  return played;
}

test("the record of a frame opens as a game with the same moves and the same end", () => {
  const own = frame();
  const { game } = atOnce(gameOfRecord(engine, own.record));
  expect(game!.moves).toEqual(own.record.moves);
  expect(progressOf(engine, game!).frame.state).toEqual(own.state);
  expect(recordOf(engine, game!)).toEqual(own.record);
});

test("a record from the balls of a shot opens, too", () => {
  const balls = [
    { id: "cue", position: [0.4, 0.5] as const },
    { id: "9", position: [0.8, 1.5] as const },
  ];
  const shot = engine.shot({ format: "carom-shot/1", table: "wpa-9ft", balls });
  const own = engine.frameOf("nine-ball", shot);
  const { game } = atOnce(gameOfRecord(engine, own.record));
  expect(recordOf(engine, game!)).toEqual(own.record);
});

test("a record whose move is not allowed is refused with the move's number", () => {
  const { record } = frame();
  const open = () => atOnce(gameOfRecord(engine, { ...record, moves: [{ choice: "rebreak" }] }));
  expect(open).toThrow(CaromError);
  expect(open).toThrow(/^Move 1 of this game: /);
});

test.each([
  [{ moves: null }, /^The game in this file is damaged/],
  [{ setup: undefined }, /^The game in this file is damaged/],
  [{ moves: [5] }, /^Move 1 of this game: /],
  [{ moves: [{ play: {} }] }, /^Move 1 of this game: /],
])("a damaged record is refused in words for players: %j", (change, words) => {
  const { record } = frame();
  expect(() =>
    atOnce(gameOfRecord(engine, { ...record, ...change } as unknown as FrameRecord)),
  ).toThrow(words);
});

test("the program of a game has its record", () => {
  const program = gameProgram(frame().record);
  expect(program).toContain("carom.Frame.replay({");
  expect(program).toContain('"concede": True');
});
