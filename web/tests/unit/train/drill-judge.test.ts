import { describe, expect, test } from "vitest";
import { load, type ShotFile, type StrikeEntry, type Trace } from "../../../src/engine/index.ts";
import type { Condition, RunGoal, Step, Zone } from "../../../src/app/train/drills/index.ts";
import { judge, mostPoints, type Verdict } from "../../../src/app/train/drill-judge.ts";
import { clothOf, pointOf } from "../../../src/app/train/drill-places.ts";

const engine = await load();
const cloth = clothOf(engine, "wpa-9ft");
const DIAMOND = 2.54 / 8;

type Places = Readonly<Record<string, readonly [number, number]>>;
type Strike = Partial<Omit<StrikeEntry, "ball">>;

/** A shot with balls at places in diamonds. */
function traceOf(places: Places, strike: Strike, table = "wpa-9ft"): Trace {
  const { size } = clothOf(engine, table);
  const balls = Object.entries(places).map(([id, [x, y]]) => ({
    id,
    position: [(x * size[0]) / 4, (y * size[1]) / 8] as const,
  }));
  const struck: StrikeEntry = {
    ball: "cue" in places ? "cue" : "white",
    speed: 2,
    azimuth_deg: 90,
    ...strike,
  };
  const file: ShotFile = { format: "carom-shot/1", table, balls, strike: struck };
  return engine.shot(file).simulate();
}

function judged(trace: Trace, needs: readonly Condition[], zones?: readonly Zone[]): Verdict {
  const step: Step = { balls: {}, goal: { kind: "shot", needs, ...(zones && { zones }) } };
  return judge(cloth, step, trace);
}

/** A straight shot of the 1 into the top right corner pocket, with a tip height. */
const straight = (height: number, speed = 2) =>
  traceOf({ cue: [2, 6], "1": [3, 7] }, { azimuth_deg: 45, height, speed });

const POT: Condition = { kind: "pot", ball: "1", pocket: "top-right" };
const within = (center: readonly [number, number], radius: number): Condition => ({
  kind: "stop",
  area: { center, radius },
});

describe("a shot", () => {
  test("makes a point if it meets all conditions", () => {
    const verdict = judged(straight(-0.3), [
      POT,
      { kind: "first", ball: "1" },
      { kind: "pot-any" },
    ]);
    expect(verdict).toEqual({ points: 1, fault: null, left: [] });
  });

  test("fails by the first condition that it does not meet", () => {
    const other: Condition = { kind: "pot", ball: "1", pocket: "left" };
    const { points, fault } = judged(straight(-0.3), [POT, other, { kind: "kick", cushions: 1 }]);
    expect(points).toBe(0);
    expect(fault).toMatchObject({ kind: "condition", condition: other });
  });

  test("fails if the cue ball is lost, whatever else it does", () => {
    const trace = straight(0.5, 3);
    expect(trace.outcome.cue_ball_scratched).toBe(true);
    expect(judged(trace, [POT]).fault).toEqual({ kind: "scratch" });
  });

  test("that stops outside of its circle has the distance in metres", () => {
    const trace = traceOf({ cue: [1, 3] }, { azimuth_deg: 0, speed: 0.5 });
    const [x] = trace.statesAt(trace.duration);
    const { fault } = judged(trace, [within([1, 3], 0.2)]);
    expect(fault).toMatchObject({ kind: "condition" });
    expect((fault as { distance: number }).distance).toBeCloseTo(x! - 1.2 * DIAMOND, 9);
    expect(judged(trace, [within([x! / DIAMOND, 3], 0.01)]).fault).toBeNull();
  });

  test("gets the points of the smallest zone around its end, and none beyond the largest", () => {
    const trace = traceOf({ cue: [1, 3] }, { azimuth_deg: 0, speed: 0.5 });
    const [x] = trace.statesAt(trace.duration);
    const end = x! / DIAMOND;
    const zone = (at: number, radius: number, points: number): Zone => ({
      area: { center: [at, 3], radius },
      points,
    });
    expect(judged(trace, [], [zone(end, 0.1, 3), zone(end, 0.5, 1)]).points).toBe(3);
    expect(judged(trace, [], [zone(end + 0.3, 0.1, 3), zone(end, 0.5, 1)]).points).toBe(1);
    const far = judged(trace, [], [zone(end + 1, 0.1, 3), zone(end + 1, 0.5, 1)]);
    expect(far.points).toBe(0);
    expect((far.fault as { distance: number }).distance).toBeCloseTo(0.5 * DIAMOND, 9);
  });
});

describe("cushions", () => {
  test("count before the first ball for a kick", () => {
    // Off the right rail, at one of these angles.
    const kick = Array.from({ length: 60 }, (_, k) =>
      traceOf({ cue: [2, 2.5], "9": [2, 5.5] }, { azimuth_deg: 35 + 0.5 * k, speed: 2.5 }),
    ).find(({ outcome }) => outcome.first_contact === "9")!;
    const direct = traceOf({ cue: [2, 2], "9": [2, 6] }, { azimuth_deg: 90 });
    const needs: Condition[] = [
      { kind: "kick", cushions: 1 },
      { kind: "first", ball: "9" },
    ];
    expect(kick).toBeDefined();
    expect(judged(kick, needs).fault).toBeNull();
    expect(judged(direct, needs).fault).toMatchObject({ condition: needs[0] });
  });

  test("count for a ball without the jaws of the pockets", () => {
    const bank = traceOf({ cue: [1, 4.6], "1": [3, 5] }, { azimuth_deg: 11, speed: 2 });
    const hits = bank.events.filter(
      (event) => event.type === "rail-collision" && event.balls[0] === "1" && event.part === "nose",
    ).length;
    expect(hits).toBeGreaterThan(0);
    const least = (cushions: number): Condition => ({ kind: "cushions", ball: "1", cushions });
    expect(judged(bank, [least(hits)]).fault).toBeNull();
    expect(judged(bank, [least(hits + 1)]).fault).not.toBeNull();
    expect(judged(straight(-0.3), [{ ...POT }, least(1)]).fault).not.toBeNull();
  });

  test("count before the second ball of a carom", () => {
    const step = (cushions: number): Step => ({
      balls: {},
      goal: { kind: "shot", needs: [{ kind: "carom", cushions }] },
    });
    const carom = clothOf(engine, "carom-10ft");
    const verdict = (trace: Trace, cushions: number) => judge(carom, step(cushions), trace).fault;
    // A half-ball hit from the red to the yellow, without a cushion.
    const places: Places = { white: [1, 2], red: [1, 4], yellow: [2.2, 5.2] };
    const traces = Array.from({ length: 60 }, (_, k) =>
      traceOf(places, { azimuth_deg: 88 + 0.1 * k, speed: 2 }, "carom-10ft"),
    );
    const made = traces.find((trace) => verdict(trace, 0) === null);
    expect(made).toBeDefined();
    expect(verdict(made!, 3)).not.toBeNull();
    const missed = traceOf(places, { azimuth_deg: 270, speed: 0.5 }, "carom-10ft");
    expect(verdict(missed, 0)).not.toBeNull();
  });
});

test("a ball is hidden if another one covers every line to it", () => {
  const hidden: Condition = { kind: "hidden", ball: "9" };
  const soft = { azimuth_deg: 270, speed: 0.1 };
  const covered = traceOf({ cue: [2, 2], "8": [2, 2.6], "9": [2, 5] }, soft);
  expect(judged(covered, [hidden]).fault).toBeNull();
  const aside = traceOf({ cue: [2, 2], "8": [2.25, 2.6], "9": [2, 5] }, soft);
  expect(judged(aside, [hidden]).fault).not.toBeNull();
  const open = traceOf({ cue: [2, 2], "8": [1, 2.6], "9": [2, 5] }, soft);
  expect(judged(open, [hidden]).fault).not.toBeNull();
});

describe("a run", () => {
  const run = (order: RunGoal["order"], balls: readonly string[]): Step => ({
    balls: {},
    goal: { kind: "run", balls, order },
  });
  const ofRun = (step: Step, trace: Trace, left: readonly string[]) =>
    judge(cloth, step, trace, left);
  /** The 1 falls; the 2 and the 8 lie far away. */
  const pot = (more: Places = { "2": [0.5, 2], "8": [3.5, 2] }) =>
    traceOf({ cue: [2, 6], "1": [3, 7], ...more }, { azimuth_deg: 45, height: -0.3 });

  test("goes on after a pot, and ends with the last ball", () => {
    const step = run("eight", ["1", "2", "8"]);
    expect(mostPoints(step)).toBe(3);
    expect(ofRun(step, pot(), ["1", "2", "8"])).toEqual({
      points: 1,
      fault: null,
      left: ["2", "8"],
    });
    expect(ofRun(step, pot(), ["1", "8"])).toEqual({ points: 2, fault: null, left: ["8"] });
    const last = run("eight", ["8", "2", "1"]);
    expect(ofRun(last, pot({}), ["1"])).toEqual({ points: 3, fault: null, left: [] });
  });

  test("ends with a miss, and keeps the balls before it", () => {
    const step = run("rotation", ["7", "1", "9"]);
    const miss = traceOf(
      { cue: [2, 6], "1": [3, 7], "9": [1, 1] },
      { azimuth_deg: 45, speed: 0.2 },
    );
    expect(ofRun(step, miss, ["1", "9"])).toMatchObject({ points: 1, left: [] });
    expect(ofRun(step, miss, ["1", "9"]).fault).not.toBeNull();
  });

  test("must begin with the lowest ball where there is an order", () => {
    for (const order of ["rotation", "sequence"] as const) {
      const { fault, points } = ofRun(run(order, ["2", "1", "8"]), pot(), ["2", "1", "8"]);
      expect([fault, points]).toEqual([{ kind: "wrong-first", ball: "2" }, 0]);
    }
    const eight = run("eight", ["2", "8", "1"]);
    expect(ofRun(eight, pot(), ["2", "8", "1"]).fault).toMatchObject({ kind: "wrong-first" });
  });

  test("ends with the last ball of a rotation whenever it falls, but not of the other orders", () => {
    // The cue ball drives the 2 into the 1, which falls.
    const places: Places = { cue: [1.6, 5.6], "2": [2.5, 6.5], "1": [3, 7] };
    const combination = Array.from({ length: 40 }, (_, k) =>
      traceOf(places, { azimuth_deg: 44 + 0.05 * k, speed: 2.2, height: -0.2 }),
    ).find(
      ({ outcome }) =>
        outcome.pocketed.map(([ball]) => ball).join() === "1" && outcome.first_contact === "2",
    );
    expect(combination).toBeDefined();
    const verdict = (order: RunGoal["order"]) =>
      ofRun(run(order, ["2", "8", "1"]), combination!, ["2", "8", "1"]);
    expect(verdict("rotation")).toEqual({ points: 3, fault: null, left: [] });
    expect(verdict("sequence").fault).toEqual({ kind: "wrong-ball", ball: "1" });
    expect(verdict("eight").fault).toEqual({ kind: "wrong-ball", ball: "1" });
  });
});

describe("a place", () => {
  test("of the markings is where the table has the spot", () => {
    const snooker = clothOf(engine, "snooker-12ft");
    expect(pointOf(snooker, { spot: "blue" }, {})).toEqual([0.889, 1.7845]);
    expect(() => pointOf(cloth, { spot: "blue" }, {})).toThrow(/no spot blue/);
  });

  test("behind a ball lies on the line of the pot, turned by the cut", () => {
    const balls = { "1": [3, 7] as const };
    const place = { ball: "1", pocket: "top-right", back: 2 } as const;
    const [x, y] = pointOf(cloth, place, balls);
    const { center } = cloth.geometry.pockets.find(({ name }) => name === "top-right")!;
    const one = [3 * DIAMOND, 7 * DIAMOND] as const;
    expect(Math.atan2(one[1] - y, one[0] - x)).toBeCloseTo(
      Math.atan2(center[1] - one[1], center[0] - one[0]),
      12,
    );
    expect(Math.hypot(one[0] - x, one[1] - y)).toBeCloseTo(2 * DIAMOND + 2 * cloth.radius, 12);
    const [u, v] = pointOf(cloth, { ...place, cut_deg: 90 }, balls);
    const [gx, gy] = pointOf(cloth, { ...place, back: 0 }, balls);
    expect((u - gx) * (x - gx) + (v - gy) * (y - gy)).toBeCloseTo(0, 12);
  });

  test("is outside of the D above the baulk line", () => {
    const outside = (y: number) =>
      engine.areaDistance({ marking: "d" }, "snooker-12ft", [0.889, y]);
    expect(outside(0.6)).toBe(0);
    expect(outside(0.747)).toBeCloseTo(0.01, 9);
    expect(outside(0.4)).toBeCloseTo(0.737 - 0.292 - 0.4, 9);
  });
});
