import { describe, expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import {
  chosen,
  familyOf,
  NUMBERS,
  offered,
  TABLE_PARTS,
  type TablePart,
  USUAL,
  withChoice,
} from "../../../src/app/physics/choices.ts";
import { type Values, valueAt } from "../../../src/app/form/parameters.ts";

const engine = await load();
const presets = engine.physics;

type Physics = string | Values | undefined;

const baseOf = (physics: Physics, own: string): string => {
  const name = typeof physics === "object" ? physics.base : physics;
  return typeof name === "string" ? engine.currentPresetName(name) : own;
};
const valuesOf = (physics: Physics): Values => shotWith(physics).physics;
const choose = (physics: Physics, part: TablePart, condition: string, own = "pool"): Physics =>
  withChoice(valuesOf(physics), [part, condition], { presets, base: baseOf(physics, own), own });
const present = (physics: Physics) =>
  TABLE_PARTS.map((part) =>
    chosen(part, valuesOf(physics), { presets, base: baseOf(physics, "pool") }),
  );

/** A shot that meets a ball and cushions, so that every part counts. */
const SHOT = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.635, 0.6] },
    { id: "1", position: [0.66, 1.6] },
  ],
  strike: { ball: "cue", speed: 3, azimuth_deg: 90, side: 0.2 },
} as const;
const shotWith = (physics: Physics) =>
  engine.shot(physics === undefined ? SHOT : { ...SHOT, physics });
const hash = (physics: Physics) => shotWith(physics).simulate().hash;

test("pool has conditions of cloth, balls and rails, and no other physics has", () => {
  for (const name of Object.keys(presets)) {
    const family = familyOf(name, presets);
    const conditions = TABLE_PARTS.map((part) => offered(part, family, presets));
    if (family === "pool") {
      expect(conditions).toEqual([
        [USUAL, "new-cloth", "worn-cloth"],
        ["clean-balls", USUAL, "dirty-balls"],
        [USUAL, "gold-crown", "valley"],
      ]);
    } else {
      expect(family).toBe(name);
      expect(conditions, name).toEqual([[], [], []]);
    }
  }
});

test("every preset with a condition can be chosen, and differs in the key of its part only", () => {
  const keys = { cloth: "cloth", balls: "ball_ball", rails: "cushion" };
  const found = TABLE_PARTS.flatMap((part) =>
    offered(part, "pool", presets)
      .filter((condition) => condition !== USUAL)
      .map((condition) => {
        const name = `pool-${condition}`;
        const rest = Object.entries(presets[name]!).filter(([key]) => key !== keys[part]);
        expect(rest).toEqual(Object.entries(presets.pool!).filter(([key]) => key !== keys[part]));
        return name;
      }),
  );
  const all = Object.keys(presets).filter((name) => /^pool-\D+$/.test(name));
  expect(found.sort()).toEqual(all.sort());
});

describe.each(TABLE_PARTS)("a choice of %s", (part) => {
  const at = TABLE_PARTS.indexOf(part);
  const others = offered(part, "pool", presets).filter((condition) => condition !== USUAL);

  test("gives the name of its preset, and can be taken back", () => {
    for (const condition of others) {
      const physics = choose(undefined, part, condition);
      expect(physics).toBe(`pool-${condition}`);
      expect(present(physics)[at]).toBe(condition);
      expect(present(physics).filter((one) => one !== USUAL)).toEqual([condition]);
      expect(choose(physics, part, USUAL)).toBeUndefined();
      // On another table the physics of pool is not the table's own.
      expect(choose(physics, part, USUAL, "snooker")).toBe("pool");
    }
  });

  test("leaves numbers of other parts as they are", () => {
    const numbers = { gravity: 9.8, ball: { mass: 0.16 }, cue: { tip_friction: 0.7 } };
    for (const condition of others) {
      const physics = choose(numbers, part, condition);
      expect(physics).toEqual({ base: `pool-${condition}`, ...numbers });
      expect(choose(physics, part, USUAL)).toEqual(numbers);
    }
  });
});

test("three choices together have the values of the three presets", () => {
  const chains = offered("cloth", "pool", presets).flatMap((cloth) =>
    offered("balls", "pool", presets).flatMap((balls) =>
      offered("rails", "pool", presets).map((rails) => [cloth, balls, rails] as const),
    ),
  );
  expect(chains).toHaveLength(27);
  const orders = [
    [0, 1, 2],
    [2, 1, 0],
    [1, 0, 2],
  ];
  for (const conditions of chains) {
    const values = (condition: string, key: string) =>
      presets[condition === USUAL ? "pool" : `pool-${condition}`]![key];
    for (const order of orders) {
      const physics = order.reduce<Physics>(
        (now, k) => choose(now, TABLE_PARTS[k]!, conditions[k]!),
        undefined,
      );
      expect(valuesOf(physics)).toEqual({
        ...presets.pool,
        cloth: values(conditions[0], "cloth"),
        ball_ball: values(conditions[1], "ball_ball"),
        cushion: values(conditions[2], "cushion"),
      });
      expect(present(physics)).toEqual(conditions);
      const back = order.reduce<Physics>((now, k) => choose(now, TABLE_PARTS[k]!, USUAL), physics);
      expect(back).toBeUndefined();
    }
  }
});

test("choices are written as the nearest preset and what differs", () => {
  const physics = choose(choose("pool-gold-crown", "balls", "dirty-balls"), "cloth", "new-cloth");
  expect(physics).toEqual({
    base: "pool-new-cloth",
    ball_ball: { friction: { b: 0.1393, c: 0.455 } },
    cushion: { friction: 0.274 },
  });
});

test("the engine reads composed choices as the numbers of the presets", () => {
  const composed = choose(choose("pool-valley", "balls", "dirty-balls"), "cloth", "worn-cloth");
  const { cloth } = presets["pool-worn-cloth"]!;
  const { cushion } = presets["pool-valley"]!;
  const { ball_ball } = presets["pool-dirty-balls"]!;
  const written = { base: "pool", cloth, ball_ball, cushion };
  expect(hash(composed)).toBe(hash(written));
  expect(hash(composed)).not.toBe(hash("pool"));
  const coefficients = (physics: Physics) =>
    (["cloth.rolling_friction", "ball_ball.friction", "cushion.friction"] as const).map((key) =>
      shotWith(physics).coefficientAt(key, 0.7),
    );
  expect(coefficients(composed)).toEqual(coefficients(written));
});

test("a dated base, as in links, has the choices of the present one", () => {
  const dated = engine.withDatedNames({ table: "wpa-9ft", physics: "pool-new-cloth" }).physics;
  expect(dated).not.toBe("pool-new-cloth");
  expect(present(dated)).toEqual(["new-cloth", USUAL, USUAL]);
  expect(choose(dated, "cloth", USUAL)).toBeUndefined();
});

test("a named surface of the balls is the condition that has its numbers", () => {
  for (const [surface, condition] of [
    ["clean", "clean-balls"],
    ["used", USUAL],
    ["dirty", "dirty-balls"],
  ] as const) {
    const physics = { ball_ball: { friction: surface } };
    expect(present(physics)).toEqual([USUAL, condition, USUAL]);
    expect(hash(physics)).toBe(hash(choose(undefined, "balls", condition)));
    // It stays when another part is chosen.
    expect(choose(physics, "cloth", "new-cloth")).toEqual({ base: "pool-new-cloth", ...physics });
    expect(choose(physics, "balls", USUAL)).toBeUndefined();
  }
});

test("own numbers of a part are shown as such, and a choice replaces them", () => {
  for (const physics of [
    { cloth: { sliding_friction: 0.3 } },
    { cloth: { rolling_friction: [{ up_to: 1, friction: 0.01 }, { friction: 0.02 }] } },
    { base: "pool-new-cloth", cloth: { spin_deceleration: 6 } },
  ]) {
    expect(present(physics)).toEqual([NUMBERS, USUAL, USUAL]);
    expect(choose(physics, "cloth", USUAL)).toBeUndefined();
    const next = choose(physics, "rails", "valley") as Values;
    expect(present(next)).toEqual([NUMBERS, USUAL, "valley"]);
    expect(valuesOf(next).cloth).toEqual(valuesOf(physics).cloth);
  }
  const numbers = { ball_ball: { model: "elastic" }, cushion: { friction: { a: 0.2, b: 0.1 } } };
  expect(present(numbers)).toEqual([USUAL, NUMBERS, NUMBERS]);
});

test("numbers that a file repeats from the preset are not shown as own numbers", () => {
  const { cloth } = presets.pool!;
  expect(present({ cloth })).toEqual([USUAL, USUAL, USUAL]);
  expect(choose({ cloth }, "rails", "valley")).toBe("pool-valley");
});

test("the hint is true: on new cloth balls roll further and spin lasts, dirty balls throw more", () => {
  const number = (name: string, key: string) => valueAt(presets[name]!, ["cloth", key]) as number;
  for (const key of ["rolling_friction", "spin_deceleration", "sliding_friction"]) {
    expect(number("pool-new-cloth", key), key).toBeLessThan(number("pool", key));
    expect(number("pool", key), key).toBeLessThan(number("pool-worn-cloth", key));
  }
  const throwing = (name: string, slip: number) =>
    shotWith(name).coefficientAt("ball_ball.friction", slip);
  for (const slip of [0, 0.1, 0.5, 1, 2, 3]) {
    expect(throwing("pool-dirty-balls", slip)).toBeGreaterThan(throwing("pool", slip));
    expect(throwing("pool", slip)).toBeGreaterThan(throwing("pool-clean-balls", slip));
  }
});
