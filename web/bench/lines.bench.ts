/**
 * The five lines of the page: time from a new position to the first lines and to all five, in mid-game
 * layouts of eight-ball with the errors of a club player, and the longest task of the page meanwhile. By
 * default with software drawing. Prints the results and writes them to benches/results/lines.json.
 */
import { writeFileSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { fileURLToPath } from "node:url";
import { expect } from "vitest";
import type { ShotFile } from "../src/engine/index.ts";
import { test } from "../tests/e2e/fixture.ts";
import { commitAndDate } from "./commit.ts";
import { layouts } from "./layouts.ts";
import { median } from "./measure.ts";

const RESULT = fileURLToPath(new URL("../../benches/results/lines.json", import.meta.url));

/** Bars for the medians, ms. */
const FIRST = 300;
const ALL = 1500;
/** Longest call of the engine or of planning on the page's thread, ms. */
const CALL = 16;

/** Mid-game layouts. The first one also starts the workers. */
const LAYOUTS = 16;

interface Times {
  readonly first: number;
  readonly all: number;
  /** Longest synchronous answer of the page to the change of the position, ms. */
  readonly call: number;
}

test("the best shots come in time", { timeout: 300_000 }, async ({ open }) => {
  const page = await open({ viewport: { width: 1280, height: 800 } });
  await page.locator("#tab-lines").click();
  await page.locator(".lines[data-done=true]").waitFor();
  const times: Times[] = [];
  for (const json of layouts().slice(0, LAYOUTS)) {
    const { balls, strike } = JSON.parse(json) as ShotFile;
    times.push(
      await page.evaluate(
        async ([layout, aim]) => {
          const { store } = window.carom!;
          const list = document.querySelector<HTMLElement>(".lines")!;
          const start = performance.now();
          store.apply({ shot: { ...store.document.shot, balls: layout, strike: aim! } }, "layout");
          const call = performance.now() - start;
          return new Promise<Times>((resolve) => {
            let first = NaN;
            const look = () => {
              const now = performance.now() - start;
              if (list.dataset.stale === undefined) first = Number.isNaN(first) ? now : first;
              if (!Number.isNaN(first) && list.dataset.done === "true")
                resolve({ first, all: now, call });
              else setTimeout(look, 5);
            };
            look();
          });
        },
        [balls, strike] as const,
      ),
    );
  }
  const warm = times.slice(1);
  const of = (key: keyof Times) => warm.map((time) => time[key]);
  const result = {
    ...commitAndDate(),
    machine: { cpu: cpus()[0]?.model, cores: cpus().length, load: loadavg()[0] },
    layouts: warm.length,
    first_ms: {
      median: Math.round(median(of("first"))),
      worst: Math.round(Math.max(...of("first"))),
    },
    all_ms: { median: Math.round(median(of("all"))), worst: Math.round(Math.max(...of("all"))) },
    call_ms: { median: median(of("call")), worst: Math.max(...of("call")) },
  };
  console.log(JSON.stringify(result, null, 2));
  writeFileSync(RESULT, `${JSON.stringify(result, null, 2)}\n`);
  expect(result.first_ms.median).toBeLessThanOrEqual(FIRST);
  expect(result.all_ms.median).toBeLessThanOrEqual(ALL);
  expect(result.call_ms.median).toBeLessThanOrEqual(CALL);
});
