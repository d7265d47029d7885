import { expect, test } from "vitest";
import { parameters, type Values } from "../../../src/app/form/parameters.ts";
import { tableValues, withMarkings } from "../../../src/app/layout/table-form.ts";
import { load, type Geometry } from "../../../src/engine/index.ts";

const engine = await load();
const schema = engine.schema("shot");

const tableOf = (table: string | Values): Geometry =>
  engine.shot({ format: "carom-shot/1", table, balls: [{ id: "cue", position: [0.5, 0.5] }] })
    .geometry;
const preset = (name: string) => engine.tables.find((table) => table.name === name)!;

test("the form has every dimension of every table, and its values make the same table", () => {
  for (const table of engine.tables) {
    const values = tableValues(table);
    const found = parameters(schema, "table", values).map(({ path }) => path.join("."));
    const drawn = ({ key }: { key: string }) => /^(sights|markings)\./.test(key);
    for (const { key } of table.dimensions!.filter((dimension) => !drawn(dimension))) {
      expect(found, table.name!).toContain(key);
    }
    expect(found).toContain("pockets");
    const again = tableOf({ ...values, physics: table.physics! });
    expect(again.cushions, table.name!).toEqual(table.cushions);
    expect(again.pockets, table.name!).toEqual(table.pockets);
  }
});

test("every dimension has its unit", () => {
  const units = new Set(
    parameters(schema, "table", tableValues(preset("showood-7ft")))
      .filter(({ kind }) => kind === "number")
      .map(({ path, unit }) => `${unit} ${path.at(-1) === "cut_angle_deg"}`),
  );
  expect(units).toEqual(new Set(["m false", "deg true"]));
});

test("markings move in proportion to the size of the table", () => {
  const base = preset("wpa-9ft");
  const shorter = withMarkings({ base: "wpa-9ft", length: 2 }, base, base);
  expect(shorter.markings).toMatchObject({ head_string: 0.5 });
  const { markings } = tableOf(shorter);
  expect(markings!.spots.map(({ position }) => position[1])).toEqual([0.5, 1, 1.5]);
  // At the preset's own size no change is left to write.
  const back = withMarkings(
    { base: "wpa-9ft", markings: shorter.markings },
    tableOf(shorter),
    base,
  );
  expect(back).toEqual({ base: "wpa-9ft" });
});
