import { describe, expect, test } from "vitest";
import type { ShotFile, Trace } from "../../../src/engine/index.ts";
import { guideOf } from "../../../src/app/document/stored-game.ts";
import { shortPaths } from "../../../src/app/game/guide/short-paths.ts";
import { guideText } from "../../../src/app/game/guide/guide-words.ts";
import { begun, engine } from "./games.ts";

function traceOf(more: object, balls: readonly (readonly [string, number, number])[] = []): Trace {
  const file: ShotFile = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [
      { id: "cue", position: [0.635, 0.6] },
      ...balls.map(([id, x, y]) => ({ id, position: [x, y] as const })),
    ],
    strike: { ball: "cue", speed: 4, azimuth_deg: 90, ...more },
  };
  return engine.shot(file).simulate();
}

/** Points [x, y] of a path. */
function places(points: Float64Array): (readonly [number, number])[] {
  return Array.from({ length: points.length / 4 }, (_, k) => [points[4 * k]!, points[4 * k + 1]!]);
}

function length(points: Float64Array, from = 0): number {
  const all = places(points);
  return all.slice(1).reduce((sum, [x, y], k) => {
    if (points[4 * k + 3]! < from) return sum;
    return sum + Math.hypot(x - all[k]![0], y - all[k]![1]);
  }, 0);
}

describe("the short guide", () => {
  test("shows the aim line to the ball, and 0.2 m of what follows", () => {
    const trace = traceOf({}, [
      ["1", 0.66, 1.4],
      ["2", 0.2, 2.2],
      ["3", 1.1, 0.3],
    ]);
    const contact = trace.events.find(({ type }) => type === "ball-collision")!;
    const paths = shortPaths(trace, 0.0005);
    expect(paths.map(({ ball }) => ball).sort()).toEqual([0, 1]);
    for (const { points } of paths) {
      expect(length(points, contact.time)).toBeCloseTo(0.2, 3);
      expect(points.at(-1)!).toBeLessThan(trace.duration);
    }
    const cue = places(paths.find(({ ball }) => ball === 0)!.points);
    expect(Math.hypot(cue[0]![0] - 0.635, cue[0]![1] - 0.6)).toBeLessThan(1e-9);
    const passed = cue.some(([x, y]) => {
      const [cx, cy] = contact.before[contact.balls.indexOf("cue")]!.position;
      return Math.hypot(x - cx, y - cy) < 1e-3;
    });
    expect(passed).toBe(true);
  });

  test("ends 0.2 m behind a cushion that is met first", () => {
    const trace = traceOf({ azimuth_deg: 20 }, [["1", 0.2, 2.2]]);
    const rail = trace.events.find(({ type }) => type === "rail-collision")!;
    const [path, ...others] = shortPaths(trace, 0.0005);
    expect(others).toEqual([]);
    expect(length(path!.points, rail.time)).toBeCloseTo(0.2, 3);
  });

  test("does not follow a ball into its pocket", () => {
    const trace = traceOf({ azimuth_deg: 90 }, [["1", 0.635, 1.2]]);
    const paths = shortPaths(trace, 0.0005);
    const [, y] = places(paths.find(({ ball }) => ball === 1)!.points).at(-1)!;
    expect(y).toBeCloseTo(1.4, 2);
  });

  test("tells the hit, and the same whether the ball falls or not", () => {
    const balls = [["1", 0.66, 1.2]] as const;
    const [soft, hard] = [traceOf({ speed: 1 }, balls), traceOf({ speed: 7 }, balls)];
    expect(guideText(soft, "short")).toMatch(/^Ball 1: .*, a cut of \d+°\.$/);
    expect(guideText(hard, "short")).toBe(guideText(soft, "short"));
    expect(guideText(soft, "none")).not.toMatch(/1/);
    expect(guideText(traceOf({ azimuth_deg: 20 }), "short")).toBe("Aimed at a cushion.");
    expect(guideText(traceOf({ speed: 0.3 }), "short")).toBe("Aimed at no ball.");
  });
});

test("a game has the short guide unless another is chosen, free play the full one", () => {
  expect(guideOf(begun("nine-ball").document.game)).toBe("short");
  expect(guideOf(begun("nine-ball", { guide: "none" }).document.game)).toBe("none");
  expect(guideOf(null)).toBe("full");
});
