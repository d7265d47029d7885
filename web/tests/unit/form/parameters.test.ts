import { expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import { title } from "../../../src/app/common/parameter-names.ts";
import {
  isChanged,
  label,
  parameters,
  type Values,
  valueAt,
  withoutValue,
  withValue,
  writtenPath,
} from "../../../src/app/form/parameters.ts";

const engine = await load();
const schema = engine.schema("shot");

test("the form has every number and choice of every preset", () => {
  for (const [name, values] of Object.entries(engine.physics)) {
    const found = new Set(parameters(schema, "physics", values).map(({ path }) => path.join(".")));
    expect(found, name).toEqual(new Set(leaves(values)));
  }
});

function leaves(values: object, above: readonly string[] = []): string[] {
  return Object.entries(values).flatMap(([key, value]) =>
    typeof value === "object" && value !== null
      ? leaves(value as object, [...above, key])
      : [[...above, key].join(".")],
  );
}

test("units come from the schema", () => {
  const units = new Map(
    parameters(schema, "physics", engine.physics.pool!).map(({ path, unit }) => [
      path.join("."),
      unit,
    ]),
  );
  expect(units.get("gravity")).toBe("m/s²");
  expect(units.get("ball.mass")).toBe("kg");
  expect(units.get("cloth.spin_deceleration")).toBe("rad/s²");
  expect(units.get("cue.end_mass")).toBe("kg");
  expect(units.get("contact_times.tip")).toBe("s");
  expect(units.get("cloth.sliding_friction")).toBe("");
});

test("the numbers of a fit are labelled as in its formula, which their quantity has", () => {
  const rows = parameters(schema, "physics", engine.physics.carom!);
  const [below, alone] = [true, false].map((fit) =>
    rows.filter(({ quantity }) => (quantity !== "") === fit),
  );
  const of = (...keys: string[]) =>
    below!.filter(({ path }) => keys.every((k, i) => path[i] === k));
  expect(of("cushion", "restitution").map(label)).toEqual(["a", "b", "c", "Lowest", "Highest"]);
  for (const { quantity } of of("cushion", "restitution"))
    expect(quantity).toMatch(/e = a \+ bV \+ cV² .* normal speed V in m\/s/);
  for (const { quantity } of of("ball_ball", "friction")) expect(quantity).toMatch(/slip speed/);
  expect(of("cloth", "rolling_friction").slice(0, 2).map(label)).toEqual([
    "Band 1, up to",
    "Band 1, friction",
  ]);
  // A single number has the name of its quantity.
  for (const parameter of alone!) expect(parameter.path.length).toBeLessThan(3);
  expect(alone!.map(label)).toContain("Sliding friction");
  expect(alone!.map(label)).toContain("Stroke elevation");
});

test("a change that is reset leaves no trace", () => {
  const changed = withValue({ base: "pool" }, ["cloth", "sliding_friction"], 0.3);
  expect(changed).toEqual({ base: "pool", cloth: { sliding_friction: 0.3 } });
  expect(withoutValue(changed, ["cloth", "sliding_friction"])).toEqual({ base: "pool" });
});

test("of physics that a game writes in full, only the changed value is marked", () => {
  const physics = { cloth: { sliding_friction: 0.3 } };
  const frame = engine.frame("nine-ball", { table: "wpa-9ft", physics });
  const strike = { speed: 1, azimuth: 1.5, elevation: 0, side: 0, height: 0 };
  const written = frame.shot({ strike }).file.physics as Values;
  const base = engine.physics.pool!;
  expect(new Set(leaves(written))).toEqual(new Set(leaves(base)));
  const marked = parameters(schema, "physics", written).filter(({ path }) =>
    isChanged(written, base, path),
  );
  expect(marked.map(({ path }) => path.join("."))).toEqual(["cloth.sliding_friction"]);
});

/** The engine's values of the physics with changes over `pool`. */
const valuesWith = (changes: Values): Values =>
  engine.shot({
    format: "carom-shot/1",
    table: { cloth: "unbounded" },
    physics: { base: "pool", ...changes },
    balls: [{ id: "cue", position: [0, 0] }],
  }).physics;

test("the values of a shot are the file's own over those of the base", () => {
  const now = valuesWith({ cloth: { rolling_friction: 0.02 } });
  expect(valueAt(now, ["cloth", "rolling_friction"])).toBe(0.02);
  expect(valueAt(now, ["cloth", "sliding_friction"])).toBe(
    valueAt(engine.physics.pool!, ["cloth", "sliding_friction"]),
  );
});

test("elastic balls have no losses, and a tip has one of its two properties", () => {
  const now = valuesWith({ ball_ball: { model: "elastic" }, cue: { tip_efficiency: 0.8 } });
  expect(valueAt(now, ["ball_ball", "restitution"])).toBe(1);
  expect(valueAt(now, ["cue", "tip_efficiency"])).toBe(0.8);
  expect(valueAt(now, ["cue", "tip_restitution"])).toBeUndefined();
});

test("a coefficient has the form that the file gives", () => {
  const path = ["cushion", "friction"];
  const formula = valuesWith({ cushion: { friction: { a: 0.2, b: 0 } } });
  expect(valueAt(formula, path)).toEqual({ a: 0.2, b: 0 });
  expect(valueAt(valuesWith({ cushion: { friction: 0.2 } }), path)).toBe(0.2);
  const surface = valuesWith({ ball_ball: { friction: "dirty" } });
  expect(valueAt(surface, ["ball_ball", "friction"])).toBe("dirty");
});

const BANDS = [{ up_to: 0.5, friction: 0.008 }, { friction: 0.012 }];

test("speed bands have a row for each number, with its unit", () => {
  const now = valuesWith({ cloth: { rolling_friction: BANDS } });
  const rows = parameters(schema, "physics", now).filter(({ path }) => path.length > 2);
  const bands = rows.filter(({ path }) => path[1] === "rolling_friction");
  expect(bands.map(({ path, unit }) => [path.slice(2).join("."), unit])).toEqual([
    ["0.up_to", "m/s"],
    ["0.friction", ""],
    ["1.friction", ""],
  ]);
  expect(bands.map(({ path }) => title(path[2]!))).toEqual(["Band 1", "Band 1", "Band 2"]);
});

test("a changed number of a speed band is written with the whole list", () => {
  const now: Values = { cloth: { rolling_friction: BANDS } };
  const path = ["cloth", "rolling_friction", "1", "friction"];
  const written = writtenPath(now, path);
  expect(written).toEqual(["cloth", "rolling_friction"]);
  const next = valueAt(withValue(now, path, 0.02), written);
  expect(next).toEqual([BANDS[0], { friction: 0.02 }]);
  const changes = withValue({ base: "pool" }, written, next);
  expect(isChanged(changes, now, path)).toBe(true);
  expect(isChanged(now, now, path)).toBe(false);
  expect(isChanged(changes, engine.physics.pool!, path)).toBe(true);
  expect(withoutValue(changes, written)).toEqual({ base: "pool" });
  // A value outside a list is written alone.
  expect(writtenPath(now, ["cloth", "sliding_friction"])).toEqual(["cloth", "sliding_friction"]);
});
