import { expect, test } from "vitest";
import { load, type ShotFile } from "../../../src/engine/index.ts";
import { impactsOf } from "../../../src/sound/impacts.ts";
import { Schedule } from "../../../src/sound/schedule.ts";
import { loudness } from "../../../src/sound/voices.ts";

const engine = await load();

function heard(speed: number) {
  const file: ShotFile = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [
      { id: "cue", position: [0.9, 2.17] },
      { id: "1", position: [1.1, 2.37] },
    ],
    strike: { ball: "cue", speed, azimuth_deg: 45 },
  };
  return impactsOf(engine.shot(file).simulate());
}

test("a pot sounds as a tip, two balls and a pocket, in the order of time", () => {
  const impacts = heard(2);
  // The cue comes down, so the ball hops a little.
  const kinds = impacts.map(({ kind }) => kind).filter((kind) => kind !== "slate");
  expect(kinds.slice(0, 2)).toEqual(["tip", "ball"]);
  expect(kinds).toContain("pocket");
  const times = impacts.map(({ time }) => time);
  expect(times).toEqual([...times].sort((a, b) => a - b));
  // The pocket is at the top of an upright table, on the right of a lying one.
  expect(impacts.find(({ kind }) => kind === "pocket")!.pan).toBeGreaterThan(0.8);
});

test("an impact is as strong as the largest change of a ball's velocity", () => {
  const trace = engine.breakShot("nine-ball", { seed: 2 }).simulate();
  const events = trace.events.filter(({ type }) => type === "ball-collision");
  const changes = events.map(({ before, after }) =>
    Math.max(
      ...after.map(({ velocity }, k) =>
        Math.hypot(...velocity.map((v, axis) => v - before[k]!.velocity[axis]!)),
      ),
    ),
  );
  const strengths = impactsOf(trace).filter(({ kind }) => kind === "ball");
  expect(strengths.length).toBeGreaterThan(5);
  for (const { strength } of strengths) {
    expect(changes.some((change) => Math.abs(change - strength) < 1e-9)).toBe(true);
  }
});

test("a faster shot is louder, and nothing is louder than full", () => {
  const [soft, hard] = [heard(1), heard(5)];
  for (const kind of ["tip", "ball"] as const) {
    const level = (impacts: typeof soft) => loudness(impacts.find((i) => i.kind === kind)!);
    expect(level(hard)).toBeGreaterThan(2 * level(soft));
    expect(level(hard)).toBeLessThanOrEqual(1);
  }
});

test("every impact is handed out once, before it is due", () => {
  const impacts = heard(3);
  const schedule = new Schedule(impacts, 0);
  const found = [];
  const end = impacts.at(-1)!.time + 0.1;
  for (let time = 0; time < end; time += 0.03) {
    expect(schedule.follows(time)).toBe(true);
    for (const { impact, delay } of schedule.due({ time, rate: 1 })) {
      expect(time + delay).toBeCloseTo(Math.max(time, impact.time), 9);
      found.push(impact);
    }
  }
  expect(found).toEqual(impacts);
});

test("in slow motion the delays are longer, and a jump starts again", () => {
  const impacts = heard(3);
  const [first] = new Schedule(impacts, 0).due({ time: 0, rate: 0.1 });
  expect(first!.delay).toBe(0);
  const half = new Schedule(impacts, 0);
  const at = impacts[1]!.time - 0.02;
  half.due({ time: at - 0.1, rate: 0.1 });
  const [second] = half.due({ time: at, rate: 0.1 }).filter(({ impact }) => impact === impacts[1]);
  expect(second!.delay).toBeCloseTo(0.2, 6);
  expect([half.follows(at - 0.01), half.follows(at + 2)]).toEqual([false, false]);
  const after = impacts[1]!.time + 0.001;
  expect(new Schedule(impacts, after).due({ time: after, rate: 1 })).not.toContainEqual(
    expect.objectContaining({ impact: impacts[1] }),
  );
});
