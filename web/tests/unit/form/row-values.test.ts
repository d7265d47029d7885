import { describe, expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import { parameters, type Values } from "../../../src/app/form/parameters.ts";
import {
  changesWith,
  grouped,
  rowKind,
  rowValue,
  valueOf,
} from "../../../src/app/form/row-values.ts";

const engine = await load();
const schema = engine.schema("shot");

const SLIDING = ["cloth", "sliding_friction"];
const ROLLING = ["cloth", "rolling_friction"];

const base = { gravity: 9.81, cloth: { sliding_friction: 0.2, rolling_friction: 0.01 } };
const values = (changes: Values) => {
  const cloth = { ...base.cloth, ...(changes.cloth as object | undefined) };
  return { now: { ...base, ...changes, cloth }, base, changes };
};

describe("a row", () => {
  test("is marked if the file changes its value", () => {
    expect(rowValue(values({}), SLIDING)).toEqual(["0.2", false]);
    expect(rowValue(values({ cloth: { sliding_friction: 0.3 } }), SLIDING)).toEqual(["0.3", true]);
    expect(rowValue(values({ cloth: { sliding_friction: 0.3 } }), ROLLING)).toEqual([
      "0.01",
      false,
    ]);
  });

  test("shows a value of the base that the file repeats without a mark", () => {
    expect(rowValue(values({ gravity: 9.81 }), ["gravity"])).toEqual(["9.81", false]);
  });

  test("shows no rounding errors of binary fractions", () => {
    expect(rowValue(values({ gravity: 0.1 + 0.2 }), ["gravity"])).toEqual(["0.3", true]);
  });

  test("of the kind is marked if the kind is not that of the preset, whatever the numbers", () => {
    expect(rowKind(values({ cloth: { rolling_friction: 0.02 } }), ROLLING)).toEqual([
      "number",
      false,
    ]);
    const bands = [{ up_to: 1, friction: 0.01 }, { friction: 0.01 }];
    expect(rowKind(values({ cloth: { rolling_friction: bands } }), ROLLING)).toEqual([
      "bands",
      true,
    ]);
  });
});

describe("the changes of the file", () => {
  test("get a new value, and keep the others", () => {
    expect(changesWith(values({ base: "pool", gravity: 1 }), SLIDING, 0.3)).toEqual({
      base: "pool",
      gravity: 1,
      cloth: { sliding_friction: 0.3 },
    });
  });

  test("lose a value that is reset to that of the base", () => {
    const changed = values({ base: "pool", cloth: { sliding_friction: 0.3 } });
    expect(changesWith(changed, SLIDING, 0.2)).toEqual({ base: "pool" });
  });

  test("get the whole list if a number in it changes, and lose it with its last difference", () => {
    const bands = [{ up_to: 1, friction: 0.01 }, { friction: 0.02 }];
    const cloth = { ...base.cloth, rolling_friction: bands };
    const usual = { ...base, cloth };
    const path = [...ROLLING, "1", "friction"];
    const changes = changesWith({ now: usual, base: usual, changes: {} }, path, 0.03);
    const other = [{ up_to: 1, friction: 0.01 }, { friction: 0.03 }];
    expect(changes).toEqual({ cloth: { rolling_friction: other } });
    const now = { ...base, cloth: { ...cloth, rolling_friction: other } };
    expect(changesWith({ now, base: usual, changes }, path, 0.02)).toEqual({});
  });
});

test("a text that is not a number has no value, and a choice is its text", () => {
  const [number, choice] = (["number", "choice"] as const).map((kind) => ({
    ...parameters(schema, "physics", engine.physics.pool!)[0]!,
    kind,
  }));
  expect(valueOf(number!, " 0.25 ")).toBe(0.25);
  expect(valueOf(number!, " ")).toBeNull();
  expect(valueOf(number!, "0,25")).toBeNull();
  expect(valueOf(choice!, "0.25")).toBe("0.25");
});

describe("the groups of a preset", () => {
  const found = parameters(schema, "physics", engine.physics.carom!);
  const { single, groups } = grouped(found);
  const rows = groups.flatMap(([, quantities]) => quantities.flatMap((quantity) => quantity.rows));

  test("contain every parameter once, in its order within the group", () => {
    expect([...single, ...rows.map(({ parameter }) => parameter)]).toEqual([
      ...found.filter(({ path }) => path.length === 1),
      ...found.filter(({ path }) => path.length > 1),
    ]);
    expect(single.map(({ path }) => path[0])).toContain("gravity");
    for (const [key, quantities] of groups)
      for (const { path } of quantities) expect(path[0]).toBe(key);
  });

  test("show the hint of the bands of a list once", () => {
    const cloth = groups.find(([key]) => key === "cloth")![1];
    const bands = cloth.find(({ path }) => path[1] === "rolling_friction")!;
    const [limit, friction, ...others] = bands.rows.map(({ isHintRepeated }) => isHintRepeated);
    expect([limit, friction]).toEqual([false, false]);
    expect(others.length).toBeGreaterThan(0);
    expect(others.every(Boolean)).toBe(true);
    expect(bands.hint).not.toBe("");
  });

  test("give a single number its own hint", () => {
    const cloth = groups.find(([key]) => key === "cloth")![1];
    const sliding = cloth.find(({ path }) => path[1] === "sliding_friction")!;
    expect(sliding.hint).toBe("");
    expect(sliding.rows.map(({ isHintRepeated }) => isHintRepeated)).toEqual([false]);
  });
});
