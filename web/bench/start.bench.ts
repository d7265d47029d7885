/**
 * How the page starts: its first paint, the time until it can be used, the longest task of the main thread
 * until then and at the first shot; on a laptop, on a phone, and on a phone with a quarter of the speed, for
 * which the pictures of a replay are counted too. Software draws. Prints the results and writes them to
 * benches/results/start.json. CAROM_PAGE measures another page, a file, and writes nothing.
 */
import { writeFileSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { pathToFileURL } from "node:url";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import { expect, inject } from "vitest";
import { PHONE, test } from "../tests/e2e/fixture.ts";
import { commitAndDate } from "./commit.ts";
import { type Tasks, tasksOf } from "./main-thread.ts";
import { median, round, ROOT } from "./measure.ts";

/** Number of starts, for the medians. */
const STARTS = Number(process.env.CAROM_STARTS ?? 7);

/** Time (ms) after which a new tab is at rest: until then its process takes a processor from the page. */
const REST = 1500;

/** Time (ms) after the start, and after the first shot, whose tasks count too: stills and idle work. */
const AFTER = 1500;

/** Time (ms) over which the pictures of a replay are counted. */
const REPLAY = 4000;

/** A kind of device. Times are the bars, ms; `pictures` is the least number in a second of a replay. */
interface Device {
  readonly options: BrowserContextOptions;
  /** How many times slower the processor is. */
  readonly slower: number;
  readonly bars: {
    readonly first_paint: number;
    readonly usable: number;
    readonly load_task?: number;
    readonly shot_task?: number;
    readonly pictures?: number;
  };
}

const DEVICES: Readonly<Record<string, Device>> = {
  laptop: {
    options: { viewport: { width: 1280, height: 800 } },
    slower: 1,
    bars: { first_paint: 500, usable: 1000, load_task: 200, shot_task: 100 },
  },
  phone: {
    options: { viewport: PHONE, hasTouch: true, isMobile: true },
    slower: 1,
    bars: { first_paint: 800, usable: 800, load_task: 200, shot_task: 100 },
  },
  slow_phone: {
    options: { viewport: PHONE, hasTouch: true, isMobile: true },
    slower: 4,
    bars: { first_paint: 2000, usable: 2000, pictures: 40 },
  },
};

interface Start {
  readonly first_paint: number;
  readonly usable: number;
  readonly load: Tasks;
  readonly shot: Tasks;
  readonly pictures: number;
}

/** Draws nothing for a while, so that the tasks of what came before are over. */
const wait = (page: Page) => page.waitForTimeout(AFTER);

async function start(browser: Browser, { options, slower }: Device): Promise<Start> {
  const context = await browser.newContext({ locale: "en-GB", ...options });
  const page = await context.newPage();
  const address = process.env.CAROM_PAGE;
  const url = address === undefined ? inject("page") : pathToFileURL(address).href;
  // The same process shows an empty page first, so that the trace is of one process.
  await page.goto(url.startsWith("file:") ? url.replace(/[^/]*$/, "") : `${url}icon-192.png`);
  await page.waitForTimeout(REST);
  const session = await context.newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: slower });
  const load = await tasksOf(page, async () => {
    await page.goto(url);
    await page.waitForFunction(() => performance.getEntriesByName("carom:interactive").length > 0);
    await wait(page);
  });
  const times = await page.evaluate(() => ({
    first_paint: performance.getEntriesByName("first-contentful-paint")[0]!.startTime,
    usable: performance.getEntriesByName("carom:interactive")[0]!.startTime,
  }));
  const shot = await tasksOf(page, async () => {
    await page.getByRole("button", { name: "Shoot" }).click();
    await wait(page);
  });
  const pictures = await replay(page);
  await context.close();
  return { ...times, load, shot, pictures };
}

/** Pictures that the page draws in a second of the replay of a break. */
async function replay(page: Page): Promise<number> {
  await page.evaluate(() => {
    const { store, engine } = window.carom!;
    store.setSession({ mode: "aim" });
    const { strike, ...rest } = engine.breakShot("nine-ball", { seed: 1 }).file;
    if (strike) store.apply({ shot: { ...rest, strike } }, "break");
  });
  await page.getByRole("button", { name: "Shoot" }).click();
  return page.evaluate(async (time) => {
    const frame = () => new Promise(requestAnimationFrame);
    await frame();
    const begin = performance.now();
    let frames = 0;
    while (performance.now() - begin < time) {
      await frame();
      frames += 1;
    }
    return (1000 * frames) / (performance.now() - begin);
  }, REPLAY);
}

const ofTasks = (tasks: readonly Tasks[]) => ({
  longest_ms: round(median(tasks.map(({ longest }) => longest))),
  longest_processor_ms: round(median(tasks.map(({ longest_processor }) => longest_processor))),
  over_50_ms: median(tasks.map(({ long }) => long)),
});

test("the page starts fast", { timeout: 900_000 }, async ({ browser }) => {
  const stamp = commitAndDate();
  const found: Record<string, ReturnType<typeof summary>> = {};
  for (const [name, device] of Object.entries(DEVICES)) {
    const starts: Start[] = [];
    for (let k = 0; k < STARTS; k += 1) starts.push(await start(browser, device));
    found[name] = summary(starts);
  }
  const result = {
    ...stamp,
    starts: STARTS,
    ...found,
    machine: `${cpus()[0]!.model}, ${cpus().length} cores`,
    // Load of the machine: times mean little if it exceeds the number of cores.
    load: round(loadavg()[0]!),
  };
  console.log(JSON.stringify(result, null, 2));
  if (process.env.CAROM_PAGE !== undefined) return;
  writeFileSync(`${ROOT}benches/results/start.json`, `${JSON.stringify(result, null, 2)}\n`);
  for (const [name, { bars }] of Object.entries(DEVICES)) {
    const { first_paint_ms, usable_ms, load, shot, pictures_per_second } = found[name]!;
    expect.soft(first_paint_ms, name).toBeLessThan(bars.first_paint);
    expect.soft(usable_ms, name).toBeLessThan(bars.usable);
    if (bars.load_task) expect.soft(load.longest_ms, name).toBeLessThan(bars.load_task);
    if (bars.shot_task) expect.soft(shot.longest_ms, name).toBeLessThan(bars.shot_task);
    if (bars.pictures) expect.soft(pictures_per_second, name).toBeGreaterThan(bars.pictures);
  }
});

function summary(starts: readonly Start[]) {
  return {
    first_paint_ms: round(median(starts.map(({ first_paint }) => first_paint))),
    usable_ms: round(median(starts.map(({ usable }) => usable))),
    load: ofTasks(starts.map(({ load }) => load)),
    shot: ofTasks(starts.map(({ shot }) => shot)),
    pictures_per_second: round(median(starts.map(({ pictures }) => pictures))),
  };
}
