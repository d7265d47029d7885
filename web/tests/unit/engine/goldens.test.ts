import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { load } from "../../../src/engine/index.js";

const root = new URL("../../../../", import.meta.url);
const read = (path: string) => readFileSync(new URL(path, root), "utf8");

const goldens = JSON.parse(read("goldens/shots.json")) as Record<
  string,
  { events: number; hash: string }
>;
const engine = await load();

describe("every named shot has the native engine's events, to the bit", () => {
  test.each(Object.entries(goldens))("%s", (name, golden) => {
    const trace = engine.shot(read(`shots/${name}.json`)).simulate();
    expect({ events: trace.events.length, hash: trace.hash }).toEqual(golden);
  });
});
