import { expect, test } from "vitest";
import { bestLag, lagWinner, playLag } from "../../../src/app/game/match/lag.ts";
import { engine } from "./games.ts";

const TABLE = { table: "wpa-9ft" };

const lag = (speed: number, player: 0 | 1 = 0) => playLag(engine, TABLE, player, speed, null);

test("a lag that is too soft does not reach the foot cushion, and too hard a one meets it twice", () => {
  expect(lag(0.5)).toEqual({ distance: null, fault: "foot" });
  expect(lag(10)).toEqual({ distance: null, fault: "foot" });
});

test("the best lag stops within 10 cm of the head cushion, on both sides alike", () => {
  const speed = bestLag(engine, TABLE, 0);
  const { distance, fault } = lag(speed);
  expect(fault).toBeNull();
  expect(distance).toBeLessThan(0.1);
  expect(distance).toBeGreaterThanOrEqual(0);
  expect(lag(speed, 1).distance).toBeCloseTo(distance!, 9);
});

test("errors that turn the ball aside make a bad lag", () => {
  const club = engine.noisePresets.club!;
  const noise = { ...club, azimuth: 0.2 };
  const faults = Array.from({ length: 20 }, (_, index) =>
    playLag(engine, TABLE, 0, 1.8, { noise, index, seed: 1 }),
  ).map(({ fault }) => fault);
  expect(faults).toContain("side");
  expect(faults).toContain("crossed");
});

test("the nearer ball wins, a bad lag never does, and equal ones are played again", () => {
  const at = (distance: number | null) =>
    ({ distance, fault: distance === null ? "side" : null }) as const;
  expect(lagWinner([at(0.2), at(0.3)])).toBe(0);
  expect(lagWinner([at(0.2), at(0.1)])).toBe(1);
  expect(lagWinner([at(null), at(0.9)])).toBe(1);
  expect(lagWinner([at(0.9), at(null)])).toBe(0);
  expect(lagWinner([at(null), at(null)])).toBeNull();
  expect(lagWinner([at(0.2), at(0.2)])).toBeNull();
});
