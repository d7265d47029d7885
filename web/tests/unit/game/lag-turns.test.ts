import { expect, test } from "vitest";
import type { Lag } from "../../../src/app/game/match/lag.ts";
import {
  FIRST_TURN,
  lagErrors,
  lagging,
  lagTable,
  turnsAfter,
} from "../../../src/app/game/match/lag-turns.ts";
import { machineNoise } from "../../../src/app/game/machine/machine-levels.ts";
import { engine, setup, SHOT } from "./games.ts";

const stopsAt = (distance: number): Lag => ({ distance, fault: null });
const BAD: Lag = { distance: null, fault: "side" };

/** The turns after some lags, and the winner with the last one. */
function after(...lags: readonly Lag[]) {
  let result = turnsAfter(FIRST_TURN, lags[0]!);
  for (const lag of lags.slice(1)) result = turnsAfter(result.turns, lag);
  return { ...result, next: lagging(result.turns) };
}

test("the first player lags first, and the lag of the second one is awaited", () => {
  expect(lagging(FIRST_TURN)).toBe(0);
  expect(after(stopsAt(0.1))).toMatchObject({ next: 1, winner: null });
});

test("two lags decide who wins, and end the turns", () => {
  expect(after(stopsAt(0.1), stopsAt(0.2))).toMatchObject({ next: null, winner: 0 });
  expect(after(BAD, stopsAt(0.2))).toMatchObject({ next: null, winner: 1 });
});

test("two bad lags are played again from the first player, and then count no more", () => {
  expect(after(BAD, BAD)).toEqual({
    next: 0,
    winner: null,
    turns: { repeated: 1, lags: [] },
  });
  expect(after(BAD, BAD, stopsAt(0.3), stopsAt(0.2))).toMatchObject({ next: null, winner: 1 });
});

test("each lag of a player is another variant of the game's seed", () => {
  const own = setup("nine-ball", { skills: ["club", null] });
  const noise = engine.noisePresets.club!;
  expect(lagErrors(engine, own, FIRST_TURN, 0)).toEqual({ noise, index: 0, seed: 7 });
  const { turns } = after(BAD, BAD);
  expect(lagErrors(engine, own, turns, 0)?.index).toBe(2);
});

test("a person without a skill makes no errors, and a machine those of its level", () => {
  const own = setup("nine-ball", { machines: [null, "level-2"] });
  expect(lagErrors(engine, own, FIRST_TURN, 0)).toBeNull();
  const noise = machineNoise(engine, "level-2");
  expect(lagErrors(engine, own, after(BAD).turns, 1)).toEqual({ noise, index: 1, seed: 7 });
});

test("the table is that of the layout, else the chosen one, else the usual one of the game", () => {
  const table = (more: Parameters<typeof setup>[1]) => lagTable(engine, setup("snooker", more));
  expect(table({ from: SHOT, options: { table: "wpa-8ft" } }).table).toBe("wpa-9ft");
  expect(table({ options: { table: "wpa-8ft", physics: "snooker" } })).toEqual({
    table: "wpa-8ft",
    physics: "snooker",
  });
  expect(table({ options: {} })).toEqual({ table: engine.usualTable("snooker") });
});
