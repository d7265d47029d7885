/** The progress in the browser's database. */

import "fake-indexeddb/auto";
import { IDBFactory, IDBObjectStore } from "fake-indexeddb";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { KeptStorage } from "../../../src/app/kept/kept-storage.ts";
import type { Box } from "../../../src/app/train/progress/earlier-progress.ts";
import { NOTHING, progressToText } from "../../../src/app/train/progress/practice-progress.ts";
import { drill, ENGINE, result, SOME } from "./some-progress.ts";
import { Keeper } from "../../../src/app/train/progress/progress-keeper.ts";

beforeEach(() => {
  vi.stubGlobal("indexedDB", new IDBFactory());
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

/** A tab with the progress of the browser. */
async function opened(box: Box | null = null): Promise<Keeper> {
  const keeper = new Keeper(new KeptStorage(), box);
  await keeper.ready;
  return keeper;
}

/** Makes it later: drills have the order of their making. */
let seconds = 0;
function later(): void {
  vi.useFakeTimers({ toFake: ["Date"], now: 1000 * (seconds += 1) });
}

/** What earlier versions kept. */
function box(first: Record<string, string>): Box & { readonly texts: Map<string, string> } {
  const texts = new Map(Object.entries(first));
  return {
    texts,
    getItem: (key) => texts.get(key) ?? null,
    removeItem: (key) => void texts.delete(key),
  };
}

test("the progress is there again when the page is opened again, and nothing is there twice", async () => {
  const first = await opened();
  expect(await first.add(SOME)).toBe(true);
  expect(await first.add(SOME)).toBe(true);
  const again = await opened();
  expect(again.progress).toEqual(SOME);
  expect([again.isKept, again.damaged]).toEqual([true, null]);
});

test("it lasts as long as the page where there is no storage", async () => {
  vi.stubGlobal("indexedDB", undefined);
  for (const keeper of [new Keeper(null, null), await opened()]) {
    expect(await keeper.add(SOME)).toBe(false);
    expect(keeper.isKept).toBe(false);
    expect(keeper.progress).toEqual(SOME);
    keeper.clear();
    expect(keeper.progress).toEqual({ ...NOTHING, drills: SOME.drills });
  }
});

test("what did not fit into a full storage is stored with the next result", async () => {
  const keeper = await opened();
  const full = vi.spyOn(IDBObjectStore.prototype, "put").mockImplementation(() => {
    throw new DOMException("full", "QuotaExceededError");
  });
  expect(await keeper.add({ ...NOTHING, results: [result(3, [1])] })).toBe(false);
  expect([keeper.isKept, keeper.progress.results.length]).toEqual([false, 1]);
  full.mockRestore();
  expect(await keeper.add({ ...NOTHING, results: [result(4, [2])] })).toBe(true);
  expect(keeper.isKept).toBe(true);
  expect((await opened()).progress.results).toEqual([result(3, [1]), result(4, [2])]);
});

test("an earlier version's progress is moved over once, its damaged copies too", async () => {
  const earlier = box({
    "carom-progress": progressToText(SOME, ENGINE),
    "carom-progress-damaged-1": "{older",
    "carom-other": "stays",
  });
  // Two tabs move it at the same time.
  const [one] = await Promise.all([opened(earlier), opened(earlier)]);
  expect([one.progress, one.damaged]).toEqual([SOME, "{older"]);
  expect([...earlier.texts.keys()]).toEqual(["carom-other"]);
  const again = await opened(earlier);
  expect([again.progress, again.damaged]).toEqual([SOME, "{older"]);
});

test("an earlier version's progress stays where it was until it is stored", async () => {
  const earlier = box({ "carom-progress": progressToText(SOME, ENGINE) });
  const full = vi.spyOn(IDBObjectStore.prototype, "put").mockImplementation(() => {
    throw new DOMException("full", "QuotaExceededError");
  });
  const keeper = await opened(earlier);
  expect([keeper.progress, keeper.isKept]).toEqual([SOME, false]);
  expect(earlier.texts.size).toBe(1);
  full.mockRestore();
  expect((await opened(earlier)).isKept).toBe(true);
  expect(earlier.texts.size).toBe(0);
});

test("damaged entries stay, are offered as text, and the others are as before", async () => {
  await (await opened()).add(SOME);
  const storage = new KeptStorage();
  const broken = { id: "results broken", kind: "results", value: { drill: "stop", points: -1 } };
  await storage.put("progress", broken as never);
  const keeper = await opened(box({ "carom-progress": "{" }));
  expect(keeper.progress).toEqual(SOME);
  expect(keeper.damaged?.split("\n").sort()).toEqual(["{", JSON.stringify(broken)].sort());
  keeper.clear();
  await vi.waitFor(async () => expect((await opened()).progress.results).toEqual([]));
  expect((await opened()).damaged).toBe(keeper.damaged);
});

test("two tabs have the results of both, and drills of one name stay beside each other", async () => {
  const [one, two] = await Promise.all([opened(), opened()]);
  const told = vi.fn();
  one.onStored = told;
  later();
  await one.add({ ...NOTHING, results: [result(3, [1])], drills: [drill("Mine", 5)] });
  expect(told).toHaveBeenCalled();
  later();
  await two.add({ ...NOTHING, results: [result(4, [2])], drills: [drill("Mine", 6)] });
  await one.refresh();
  expect(one.progress.results).toEqual([result(3, [1]), result(4, [2])]);
  expect(one.progress.drills.map(({ name, attempts }) => [name, attempts])).toEqual([
    ["Mine", 5],
    ["Mine (2)", 6],
  ]);
  one.deleteDrill("Mine (2)");
  await vi.waitFor(async () => expect((await opened()).progress.drills).toHaveLength(1));
});

test("a changed drill replaces the one that it was", async () => {
  const keeper = await opened();
  later();
  expect(keeper.addDrill(drill("Mine", 5))).toBe("Mine");
  expect(keeper.addDrill(drill("Mine", 6), "Mine")).toBe("Mine");
  later();
  expect(keeper.addDrill(drill("Mine", 7))).toBe("Mine (2)");
  expect(keeper.addDrill(drill("Mine", 7))).toBe("Mine (2)");
  await vi.waitFor(async () =>
    expect((await opened()).progress.drills.map(({ attempts }) => attempts)).toEqual([6, 7]),
  );
});

test("deleted results do not come back with the next one of another tab", async () => {
  const [one, two] = await Promise.all([opened(), opened()]);
  await one.add(SOME);
  await two.refresh();
  two.clear();
  expect(two.progress).toEqual({ ...NOTHING, drills: SOME.drills });
  await one.add({ ...NOTHING, results: [result(4, [2])] });
  expect((await opened()).progress).toEqual({
    ...NOTHING,
    results: [result(4, [2])],
    drills: SOME.drills,
  });
});
