import { expect, test } from "vitest";
import { Table } from "../../../src/viewer/table/drawn-table.ts";
import { TableMaterials } from "../../../src/viewer/table/materials.ts";
import { RAILED } from "./tables.ts";

test("the opaque parts of a table share one shader, and its flat shadows another", () => {
  // Seen: a software renderer took half of the time until the first picture to compile seven of them.
  const { cloth, wood, apron, leather, sights, shade, floor, markings } = new TableMaterials();
  const kinds = (materials: readonly { type: string; customProgramCacheKey(): string }[]) =>
    new Set(materials.map((one) => `${one.type} ${one.customProgramCacheKey()}`));
  expect(kinds([cloth, wood, apron, leather, sights]).size).toBe(1);
  expect(kinds([shade, floor, markings]).size).toBe(1);
  for (const one of [cloth, wood, apron, leather, sights]) expect(one.transparent).toBe(false);
  for (const one of [shade, floor, markings]) {
    expect([one.transparent, one.depthWrite]).toEqual([true, false]);
  }
});

test("every part of a table has the colours at its corners that the shaders read", () => {
  for (const geometry of RAILED) {
    const table = new Table();
    table.setGeometry(geometry, [0, 0]);
    expect(table.group.children.length).toBeGreaterThan(0);
    table.group.traverse((object) => {
      if (!("geometry" in object)) return;
      const { attributes } = object.geometry as { attributes: { color?: { itemSize: number } } };
      expect(attributes.color?.itemSize).toBe(4);
    });
  }
});
