import { afterEach, expect, test, vi } from "vitest";
import { load } from "../../../src/engine/index.ts";
import { documentOf } from "../../../src/app/document/shot-file.ts";
import { Store } from "../../../src/app/document/store.ts";
import { azimuthOf } from "../../../src/app/document/strike-angles.ts";
import { aimWithSnap } from "../../../src/app/pot/aim-with-snap.ts";

const engine = await load();

const SHOT = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.5, 0.6] },
    { id: "1", position: [0.6, 1.6] },
  ],
  strike: { ball: "cue", speed: 2, azimuth_deg: 80 },
} as const;

const aimedAt = (store: Store) => azimuthOf(store.document.shot.strike);

/** What the engine does during a drag in steps of a quarter degree, each of them shown in a picture. */
function drag(store: Store, from: number, to: number) {
  const shots = Object.getPrototypeOf(store.shot) as typeof store.shot;
  const simulate = vi.spyOn(shots, "simulate");
  const read = vi.spyOn(shots, "withStrike");
  const seen = new Set<number>();
  let moves = 0;
  for (let azimuth = from; azimuth <= to; azimuth += 0.25, moves += 1) {
    aimWithSnap(store, azimuth, 1, "drag");
    expect(store.ghost.trace).not.toBeNull();
    seen.add(aimedAt(store));
  }
  return { moves, simulations: simulate.mock.calls.length, reads: read.mock.calls.length, seen };
}

afterEach(() => vi.restoreAllMocks());

test("a drag simulates each shown shot once, and one more where it clicks into a pot", () => {
  const store = new Store(engine, documentOf(SHOT));
  const { moves, simulations, reads, seen } = drag(store, 75, 95);
  const clicks = [...seen].filter((azimuth) => azimuth % 0.25 !== 0).length;
  expect(clicks).toBeGreaterThan(0);
  expect(simulations).toBeLessThanOrEqual(seen.size + clicks);
  expect(simulations).toBeLessThan(moves);
  expect(reads).toBe(simulations);
});

test("the cue stays in a pot within the zone, and leaves it where there is none", () => {
  const store = new Store(engine, documentOf(SHOT));
  const [pot] = [...drag(store, 75, 95).seen].filter((azimuth) => azimuth % 0.25 !== 0);
  for (const away of [0, 0.9, -0.9]) {
    aimWithSnap(store, pot! + away, 1, "drag");
    expect(store.session.lock?.solved).toBe(true);
    expect(aimedAt(store)).toBe(pot);
  }
  aimWithSnap(store, pot! + 0.2, 0, "drag");
  expect(aimedAt(store)).toBeCloseTo(pot! + 0.2, 3);
  expect(store.session.lock).toBeNull();
});
