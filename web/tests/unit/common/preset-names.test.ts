import { expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import { byAge, presetLabel } from "../../../src/app/common/preset-names.ts";

const engine = await load();
const PHYSICS = Object.keys(engine.physics);
const TABLES = engine.tables.flatMap(({ name }) => name ?? []);

test("every preset has a text of its own, not its name in files", () => {
  for (const names of [PHYSICS, TABLES]) {
    const labels = names.map(presetLabel);
    expect(new Set(labels).size).toBe(names.length);
    for (const label of labels) expect(label).toMatch(/^[A-Z][^_]*$/);
    for (const label of labels) expect(label).not.toMatch(/\d{4}-\d{2}/);
  }
});

test("older values have the month in their text", () => {
  expect(presetLabel("pool-2026-11")).toBe("Pool, Nov 2026");
  expect(presetLabel("wpa-9ft-2026-11")).toBe("WPA, 9 ft, Nov 2026");
  // The carom table of November 2026 was not heated.
  expect(presetLabel("carom-2026-11")).toBe("Carom, Nov 2026");
});

test("a preset without a text is listed by its name", () => {
  expect(presetLabel("felt")).toBe("felt");
});

test("older values are listed apart from the newest", () => {
  const { newest, older } = byAge(PHYSICS);
  expect([...newest, ...older]).toEqual(PHYSICS);
  expect(newest).toContain("pool-gold-crown");
  expect(older).toContain("pool-2026-11");
  for (const name of newest) expect(engine.currentPresetName(name)).toBe(name);
  for (const name of older) expect(engine.currentPresetName(name)).toBe(name);
});
