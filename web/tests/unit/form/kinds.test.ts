import { expect, test } from "vitest";
import { type CoefficientKey, load } from "../../../src/engine/index.ts";
import { inKind, type Kind, kindLabel, kindOf, kinds } from "../../../src/app/form/kinds.ts";
import {
  quantitySchema,
  type Schema,
  type Values,
  valueAt,
  withValue,
} from "../../../src/app/form/parameters.ts";

const engine = await load();
const schema = engine.schema("shot");

const KEYS = [
  "cloth.rolling_friction",
  "ball_ball.friction",
  "cushion.restitution",
  "cushion.friction",
] as const satisfies readonly CoefficientKey[];
const QUANTITIES = KEYS.map((key) => key.split("."));

const of = (path: readonly string[]): Schema => quantitySchema(schema, "physics", path)!;

/** The engine's shot with changes of the physics over a preset. */
function shotWith(base: string, changes: Values) {
  return engine.shot({
    format: "carom-shot/1",
    table: { cloth: "unbounded" },
    physics: { base, ...changes },
    balls: [{ id: "cue", position: [0, 0] }],
  });
}

const at = (base: string, changes: Values, key: string, speed: number) =>
  shotWith(base, changes).coefficientAt(key as CoefficientKey, speed);

test("the coefficients are those of the schema that may depend on a speed or an angle", () => {
  const { properties } = quantitySchema(schema, "physics", [])!;
  const found = Object.entries(properties!).flatMap(([group, { properties: inner }]) =>
    Object.entries(inner ?? {}).flatMap(([key, { argument }]) =>
      argument ? [`${group}.${key}`] : [],
    ),
  );
  expect(found).toEqual(KEYS);
});

test("every quantity of the schema that is a number or something else has a control", () => {
  const offered = (path: readonly string[], present: unknown = 0.1) =>
    kinds(of(path), present).map((kind) => kindLabel(of(path), kind));
  expect(offered(["cloth", "rolling_friction"])).toEqual(["as a number", "by speed"]);
  expect(offered(["ball_ball", "friction"])).toEqual(["as a number", "by speed"]);
  expect(offered(["ball_ball", "friction"], "used")).toEqual([
    "by surface",
    "as a number",
    "by speed",
  ]);
  expect(offered(["cushion", "restitution"])).toEqual(["as a number", "by speed"]);
  expect(offered(["cushion", "friction"])).toEqual(["as a number", "by angle"]);
  for (const path of [["cloth", "sliding_friction"], ["cushion", "model"], ["gravity"], ["x", "y"]])
    expect(offered(path), path.join(".")).toEqual([]);
});

test("another kind is the preset's value, or the same coefficient at every speed", () => {
  for (const [name, base] of Object.entries(engine.physics)) {
    for (const path of QUANTITIES) {
      const key = path.join(".");
      const coefficient = () => at(name, {}, key, 1);
      const own = kindOf(valueAt(base, path))!;
      for (const kind of kinds(of(path), valueAt(base, path))) {
        const value = inKind([path, of(path)], kind, { now: base, base }, coefficient);
        expect(kindOf(value), `${name} ${key} ${kind}`).toBe(kind);
        const changes = withValue({}, path, value);
        // The engine accepts it, and finds the preset's law or a constant.
        for (const speed of [0, 0.5, 1.2]) {
          const expected = kind === own ? at(name, {}, key, speed) : coefficient();
          expect(at(name, changes, key, speed), `${name} ${key} ${kind}`).toBeCloseTo(expected, 12);
        }
        const now = shotWith(name, changes).physics;
        const back = inKind([path, of(path)], own, { now, base }, coefficient);
        expect(back).toEqual(valueAt(base, path));
      }
    }
  }
});

test("a number of the file, not of the preset, becomes a fit or bands", () => {
  const base = engine.physics["pool-2026-11"]!;
  const become = (path: readonly string[], kind: Kind) => {
    const now = shotWith("pool-2026-11", withValue({}, path, 0.3)).physics;
    return inKind([path, of(path)], kind, { now, base }, () => NaN);
  };
  expect(become(["cushion", "restitution"], "fit")).toEqual({
    a: 0.3,
    b: 0,
    c: 0,
    lowest: 0,
    highest: 1,
  });
  expect(become(["cushion", "friction"], "fit")).toEqual({ a: 0.3, b: 0 });
  expect(become(["cloth", "rolling_friction"], "bands")).toEqual([
    { up_to: 1, friction: 0.3 },
    { friction: 0.3 },
  ]);
});

test("a fit of the file over a number of the preset becomes the preset's number", () => {
  const base = engine.physics["pool-2026-11"]!;
  const path = ["cushion", "restitution"];
  const changes = { cushion: { restitution: { a: 1, b: -0.1, c: 0 } } };
  const now = shotWith("pool-2026-11", changes).physics;
  expect(inKind([path, of(path)], "number", { now, base }, () => NaN)).toBe(valueAt(base, path));
});

test("a named surface becomes its number at the middle speed", () => {
  const base = engine.physics.pool!;
  const path = ["ball_ball", "friction"];
  const changes = { ball_ball: { friction: "dirty" } };
  const now = shotWith("pool", changes).physics;
  expect(kindOf(valueAt(now, path))).toBe("name");
  const number = inKind([path, of(path)], "number", { now, base }, (key) =>
    at("pool", changes, key, 1),
  );
  expect(number).toBeCloseTo(0.1393 * Math.exp(-0.455), 12);
});

test("coefficients of other keys and at other values are refused", () => {
  const shot = shotWith("pool", {});
  // @ts-expect-error not a coefficient that depends on speed
  expect(() => shot.coefficientAt("cloth.sliding_friction", 1)).toThrow(/^key: .*write one of/);
  expect(() => shot.coefficientAt("cushion.restitution", -1)).toThrow(/^at: -1.0 is out of range/);
  expect(() => shot.coefficientAt("cushion.restitution", NaN)).toThrow(/^at: /);
});
