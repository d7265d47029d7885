import { afterEach, describe, expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import { LANGUAGES } from "../../../src/app/words/catalogue.ts";
import { named, setLanguage } from "../../../src/app/words/translate.ts";
import { DRILLS, drillOf } from "../../../src/app/train/drills/index.ts";
import { deviation, layoutOf } from "../../../src/app/train/drill-layout.ts";
import { levelScores, nearestLevel } from "../../../src/app/train/drill-levels.ts";
import stored from "../../../src/app/train/drill-levels.json";
import { greatest } from "../../../src/app/train/drill-score.ts";
import { fingerprint } from "../../../scripts/drill_levels/levels.ts";

const engine = await load();

afterEach(() => setLanguage("en"));

const STEPS = DRILLS.flatMap((drill) =>
  drill.steps.map((step, k) => [`${drill.id} ${k + 1}`, { drill, step, attempt: 0 }] as const),
);

test("there are twenty drills with different ids, on pool, snooker and carom tables", () => {
  expect(new Set(DRILLS.map(({ id }) => id)).size).toBe(20);
  expect(new Set(DRILLS.map(({ table }) => table)).size).toBe(3);
});

test("every drill has a name and a goal in every language", () => {
  for (const language of Object.keys(LANGUAGES) as (keyof typeof LANGUAGES)[]) {
    setLanguage(language);
    for (const { id } of DRILLS) {
      expect(named("drill", id), id).not.toBeNull();
      expect(named("drill-goal", id), id).not.toBeNull();
    }
  }
});

describe.each(STEPS)("the layout of %s", (_, setting) => {
  test("is one that the engine accepts, with the cue on the cue ball", () => {
    const layout = layoutOf(engine, setting);
    const shot = engine.shot(layout);
    expect(layout.strike.ball).toBe(setting.drill.cue);
    expect(shot.simulate().duration).toBeGreaterThan(0);
  });

  test("does not deviate from itself", () => {
    const layout = layoutOf(engine, setting);
    expect(deviation(engine, setting, layout, layout, false)).toBeNull();
  });
});

describe("a layout that was changed", () => {
  const spot = drillOf("spot")!;
  const setting = { drill: spot, step: spot.steps[0]!, attempt: 0 };
  const set = layoutOf(engine, setting);
  const moved = (id: string, position: readonly [number, number]) => ({
    ...set,
    balls: set.balls.map((ball) => (ball.id === id ? { ...ball, position } : ball)),
  });

  test("counts while the cue ball is in hand and in its area", () => {
    const placed = moved("cue", [0.9, 0.3]);
    expect(deviation(engine, setting, set, placed, true)).toBeNull();
    expect(deviation(engine, setting, set, placed, false)).toBe("cue");
    expect(deviation(engine, setting, set, moved("cue", [0.9, 0.7]), true)).toBe("cue");
  });

  test("does not count with another ball elsewhere, another table or another struck ball", () => {
    expect(deviation(engine, setting, set, moved("1", [0.6, 1.9]), true)).toBe("balls");
    expect(deviation(engine, setting, set, { ...set, table: "wpa-8ft" }, true)).toBe("table");
    const other = { ...set, strike: { ...set.strike, ball: "1" } };
    expect(deviation(engine, setting, set, other, true)).toBe("struck");
    const fewer = { ...set, balls: set.balls.slice(1) };
    expect(deviation(engine, setting, set, fewer, true)).toBe("balls");
  });
});

test("a ball on the rail is within a tenth of a millimetre of it", () => {
  const rail = drillOf("rail")!;
  const { balls } = engine.shot(
    layoutOf(engine, { drill: rail, step: rail.steps[0]!, attempt: 0 }),
  );
  const { position, radius } = balls.find(({ id }) => id === "1")!;
  expect(1.27 - radius - position[0]).toBeGreaterThanOrEqual(0);
  expect(1.27 - radius - position[0]).toBeLessThan(1e-4);
});

describe.each(DRILLS.map((drill) => [drill.id, drill] as const))(
  "the levels in %s",
  (id, drill) => {
    test("were simulated with this drill and this engine", () => {
      const levels = (stored.drills as Record<string, { fingerprint: string } | undefined>)[id];
      // Otherwise run: node scripts/drill_levels.js
      expect(levels?.fingerprint).toBe(fingerprint(engine, drill));
    });

    test("score no less from level to level, within the error of the simulation", () => {
      const means = levelScores(drill).map(({ mean }) => mean);
      expect(means).toHaveLength(5);
      for (const [k, mean] of means.slice(1).entries()) {
        expect(mean).toBeGreaterThan(means[k]! - 0.06 * greatest(drill));
      }
    });

    test("can do every step", () => {
      const { chances } = (
        stored.drills as unknown as Record<string, { chances: Record<string, number[][]> }>
      )[id]!;
      for (const step of chances.professional!) expect(step[0]).toBeLessThan(0.6);
      for (const shares of Object.values(chances).flat()) {
        expect(shares.reduce((sum, share) => sum + share, 0)).toBeCloseTo(1, 2);
      }
    });
  },
);

test("a score is compared with the level of the nearest mean", () => {
  const drill = drillOf("straight")!;
  expect(nearestLevel(drill, 0)).toBe("beginner");
  expect(nearestLevel(drill, greatest(drill))).toBe("professional");
});
