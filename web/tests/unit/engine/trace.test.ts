import { describe, expect, test } from "vitest";
import {
  load,
  MOTIONS,
  STRIDE,
  type BallState,
  type ShotFile,
  type Trace,
} from "../../../src/engine/index.ts";
import initialised, { Trace as InnerTrace } from "../../../src/engine/pkg/carom_wasm.js";
import { GOLDENS, shotFile } from "./files.ts";

const engine = await load();
const simulated = (name: string): Trace => engine.shot(shotFile(name)).simulate();

/** Error of states between events, m: a few roundings of closed forms at times of a few seconds. */
const CLOSED_FORM_ROUNDING = 1e-12;

/** Ball `i` of what `statesAt` gave, as a trace file has it. */
function ball(states: Float64Array, i: number): Omit<BallState, "id"> {
  const row = [...states.subarray(STRIDE * i, STRIDE * (i + 1))];
  const vector = (from: number) => [row[from]!, row[from + 1]!, row[from + 2]!] as const;
  return {
    position: vector(0),
    velocity: vector(3),
    angular_velocity: vector(6),
    motion: MOTIONS[row[13]!]!,
  };
}

describe("statesAt", () => {
  test.each(Object.keys(GOLDENS))("gives %s's states after every event, to the bit", (name) => {
    const trace = simulated(name);
    const ids = trace.shot.balls.map((b) => b.id);
    const lastAt = (id: string, time: number) =>
      trace.events.findLast((e) => e.time === time && e.balls.includes(id));
    for (const event of trace.events) {
      const states = trace.statesAt(event.time);
      for (const id of event.balls) {
        const last = lastAt(id, event.time)!;
        const after = last.after[last.balls.indexOf(id)];
        expect({ id, ...ball(states, ids.indexOf(id)) }).toEqual(after);
      }
    }
  });

  test("moves a frozen ball from the strike on", () => {
    const frozen: ShotFile = {
      format: "carom-shot/1",
      table: "wpa-9ft",
      balls: [
        { id: "cue", position: [0.6, 0.6] },
        { id: "1", position: [0.6, 0.6 + 2 * 0.028575] },
      ],
      strike: { ball: "cue", speed: 2, azimuth_deg: 90, elevation_deg: 0, side: 0, height: 0 },
    };
    const trace = engine.shot(frozen).simulate();
    const strike = trace.events[0]!;
    expect(strike).toMatchObject({ type: "cue-strike", tip_contacts: 1, pushed: false });
    expect(trace.outcome.met_during_strike).toEqual(["1"]);
    const states = trace.statesAt(0);
    expect(strike.after.map(({ id }, i) => ({ id, ...ball(states, i) }))).toEqual(strike.after);
    expect(trace.statesAt(0.1)[STRIDE + 1]).toBeGreaterThan(states[STRIDE + 1]!);
  });

  test("writes into the given array and keeps no reference to it", () => {
    const trace = simulated("draw_shot");
    const out = new Float64Array(STRIDE * trace.shot.balls.length);
    expect(trace.statesAt(0.5, out)).toBe(out);
    const kept = trace.statesAt(0.5);
    trace.statesAt(1.5);
    engine.breakShot("snooker").simulate();
    expect(kept).toEqual(out);
    expect(() => trace.statesAt(0, new Float64Array(3))).toThrow(
      `out has 3 numbers; it needs ${out.length}`,
    );
  });

  test("turns a rolling ball by its distance over its radius", () => {
    const radius = 0.028575;
    const trace = engine
      .shot({
        format: "carom-shot/1",
        table: { cloth: "unbounded" },
        balls: [
          {
            id: "cue",
            position: [0, 0],
            velocity: [0, 1, 0],
            angular_velocity: [-1 / radius, 0, 0],
            radius,
          },
        ],
      })
      .simulate();
    for (let time = 0; time < trace.duration; time += 0.1) {
      const states = trace.statesAt(time);
      const half = states[1]! / radius / 2;
      const [x, y, z, w] = states.subarray(9, 13);
      expect(Math.abs(w! * Math.cos(half) - x! * Math.sin(half))).toBeCloseTo(1, 12);
      expect([Math.abs(y!), Math.abs(z!)]).toEqual([0, 0]);
    }
  });

  test("refuses times that are not numbers", () => {
    const trace = simulated("draw_shot");
    for (const time of ["0.5", true, null, [1], undefined]) {
      // @ts-expect-error not a number
      expect(() => trace.statesAt(time), String(time)).toThrow(/^time: found .*; write a number$/);
    }
  });

  test("refuses times before the strike", () => {
    const trace = simulated("draw_shot");
    expect(() => trace.statesAt(-1)).toThrow(
      "time: -1.0 s is out of range; give a finite time ≥ 0",
    );
    expect(() => trace.statesAt(NaN)).toThrow("time");
  });
});

describe("polyline", () => {
  test.each(["masse", "jump_shot", "nine_ball_break"])("lies on the exact paths of %s", (name) => {
    const trace = simulated(name);
    const tolerance = 1e-3;
    trace.shot.balls.forEach((_, i) => {
      const line = trace.polyline(i, tolerance);
      expect(line.length % 4).toBe(0);
      for (let p = 0; p + 4 < line.length; p += 4) {
        const [x, y, z, t, x1, y1, z1, t1] = line.subarray(p, p + 8);
        expect(t1).toBeGreaterThanOrEqual(t!);
        // A ball that falls into a pocket has two points at one time, the second one lower.
        if (t1 === t) continue;
        const at = (time: number) => trace.statesAt(time).subarray(STRIDE * i, STRIDE * i + 3);
        expect(distance(at(t!), [x!, y!, z!])).toBeLessThan(CLOSED_FORM_ROUNDING);
        const middle = at((t! + t1!) / 2);
        expect(offLine(middle, [x!, y!, z!], [x1!, y1!, z1!])).toBeLessThan(tolerance);
      }
    });
  });

  test("is finer for a smaller tolerance", () => {
    const trace = simulated("masse");
    const points = [1e-2, 1e-3, 1e-4].map((tolerance) => trace.polyline(0, tolerance).length);
    expect(points[0]).toBeLessThan(points[1]!);
    expect(points[1]).toBeLessThan(points[2]!);
  });

  test("refuses unknown balls and invalid tolerances", () => {
    const trace = simulated("draw_shot");
    expect(() => trace.polyline(2, 1e-3)).toThrow("there is no ball 2; write an index from 0 to 1");
    // @ts-expect-error a ball's id is not an index
    expect(() => trace.polyline("1", 1e-3)).toThrow('there is no ball "1"; write an index');
    expect(() => trace.polyline(0.5, 1e-3)).toThrow(RangeError);
    expect(() => trace.polyline(0, 0)).toThrow("the tolerance 0 m is out of range");
    expect(() => trace.polyline(0, NaN)).toThrow(RangeError);
  });
});

test("WebAssembly itself truncates neither an index nor an array", () => {
  const trace = simulated("draw_shot");
  const inner = InnerTrace.fromJson(trace.json());
  expect(inner.polyline(1, 1e-3)).toEqual(trace.polyline(1, 1e-3));
  for (const ball of [0.5, 1.7, -1, 2, 2 ** 32, NaN, Infinity]) {
    expect(() => inner.polyline(ball, 1e-3), String(ball)).toThrow(/^there is no ball .* 0 to 1$/);
  }
  for (const length of [0, STRIDE, 2 * STRIDE - 1, 2 * STRIDE + 1]) {
    const out = new Float64Array(length);
    expect(() => {
      inner.statesAt(0, out);
    }).toThrow(`out has ${length} numbers; it needs ${2 * STRIDE}`);
  }
  inner.free();
});

function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
}

/** Distance of a point from the line through `a` and `b`, or from `a` if they coincide. */
function offLine(p: ArrayLike<number>, a: readonly number[], b: readonly number[]): number {
  const [u, v, w] = [0, 1, 2].map((k) => b[k]! - a[k]!) as [number, number, number];
  const [x, y, z] = [0, 1, 2].map((k) => p[k]! - a[k]!) as [number, number, number];
  const length = Math.hypot(u, v, w);
  if (length === 0) return Math.hypot(x, y, z);
  return Math.hypot(y * w - z * v, z * u - x * w, x * v - y * u) / length;
}

test("a trace's JSON reads back to the same trace, and changed JSON is refused", () => {
  const trace = simulated("three_cushion");
  const again = engine.trace(trace.json());
  expect(again.hash).toBe(trace.hash);
  expect(again.outcome).toEqual(trace.outcome);
  // A record has dated names of presets.
  expect(again.shot.file).toEqual(engine.withDatedNames(trace.shot.file));
  const changed = trace.json().replace(`"hash": "${trace.hash}"`, '"hash": "0123456789abcdef"');
  expect(() => engine.trace(changed)).toThrow(/^hash: the events and final states hash to/);
});

test("the shot of a freed trace stays valid", () => {
  const trace = simulated("draw_shot");
  const shot = trace.shot;
  const states = trace.statesAt(1);
  trace.free();
  expect(() => trace.json()).toThrow();
  expect(shot.simulate().statesAt(1)).toEqual(states);
});

/** Memory (bytes) that the shots of freed traces may take until the garbage collector runs. */
const SHOTS = 1e6;

test("freed memory is reused", async () => {
  const { memory } = await initialised({ module_or_path: engine.module });
  const shot = engine.breakShot("eight-ball");
  const rounds = (count: number) => {
    for (let k = 0; k < count; k++) {
      const trace = shot.simulate();
      trace.statesAt(1);
      trace.free();
    }
  };
  rounds(20);
  const before = memory.buffer.byteLength;
  // Kept, these traces would take tens of megabytes.
  rounds(200);
  expect(memory.buffer.byteLength - before).toBeLessThan(SHOTS);
});
