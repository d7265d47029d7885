/**
 * Shots per second of the engine in WebAssembly, in Node and in Chromium, compared with the native engine:
 * random mid-game layouts, one core, no traces. Prints the results and writes them to benches/results/wasm.json.
 */
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { cpus, tmpdir } from "node:os";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";
import { expect, inject, test } from "vitest";
import { type Engine, load } from "../src/engine/index.ts";
import { commitAndDate } from "./commit.ts";
import { layouts } from "./layouts.ts";
import { median, nativeProgram, nativeTime, round, ROOT, timeOf } from "./measure.ts";

/** Least ratio of shots per second in WebAssembly to native ones. */
const LEAST_RATIO = 0.5;

/** Passes over all layouts per measurement: about half a second, for a clock of 10 ms resolution. */
const PASSES = 60;

/** Rounds of alternating measurements, for the medians. */
const ROUNDS = 11;

declare global {
  interface Window {
    benchShots?: ReturnType<Engine["shot"]>[];
  }
}

test("mid-game shots a second in WebAssembly are at least half of the native ones", async () => {
  const files = layouts();
  const shots = PASSES * files.length;
  const engine = await load();
  const ours = files.map((file) => engine.shot(file));
  const program = nativeProgram("carom", "bench_shots");
  const folder = mkdtempSync(`${tmpdir()}/carom-bench-`);
  const list = `${folder}/shots.jsonl`;
  writeFileSync(list, `${files.join("\n")}\n`);

  const browser = await chromium.connect(inject("browser"));
  const page = await browser.newPage();
  await page.goto(inject("page"));
  await page.waitForFunction(() => window.carom !== undefined);
  await page.evaluate((texts) => {
    window.benchShots = texts.map((text) => window.carom!.engine.shot(text));
  }, files);
  const inNode = (): number =>
    timeOf(() => {
      for (let pass = 0; pass < PASSES; pass++) engine.simulate(ours);
    });
  const session = await browser.newBrowserCDPSession();
  const rendererTime = async (): Promise<number> => {
    const { processInfo } = await session.send("SystemInfo.getProcessInfo");
    const renderers = processInfo.filter((process) => process.type === "renderer");
    return renderers.reduce((sum, { cpuTime }) => sum + cpuTime, 0) * 1e3;
  };
  const inChromium = async (): Promise<number> => {
    const before = await rendererTime();
    await page.evaluate((passes) => {
      for (let pass = 0; pass < passes; pass++) window.carom!.engine.simulate(window.benchShots!);
    }, PASSES);
    return (await rendererTime()) - before;
  };

  // Warm up, until the browser's optimizing compiler is done.
  inNode();
  await inChromium();
  const times = { native: [] as number[], node: [] as number[], chromium: [] as number[] };
  for (let round = 0; round < ROUNDS; round++) {
    times.native.push(nativeTime(program, list, PASSES + 1) - nativeTime(program, list, 1));
    times.node.push(inNode());
    times.chromium.push(await inChromium());
  }
  const version = browser.version();
  await browser.close();
  rmSync(folder, { recursive: true });

  const perSecond = (which: keyof typeof times) => Math.round((shots / median(times[which])) * 1e3);
  const wasm = readFileSync(`${ROOT}web/src/engine/pkg/carom_wasm_bg.wasm`);
  const result = {
    ...commitAndDate(),
    processor: cpus()[0]?.model,
    node: process.version,
    chromium: version,
    shots_per_second: {
      native: perSecond("native"),
      node: perSecond("node"),
      chromium: perSecond("chromium"),
    },
    ratio_to_native: {
      node: round(median(times.native.map((native, i) => native / times.node[i]!))),
      chromium: round(median(times.native.map((native, i) => native / times.chromium[i]!))),
    },
    wasm_bytes: { raw: wasm.length, gzip: gzipSync(wasm, { level: 9 }).length },
    load_ms: round(median(await loadTimes(wasm))),
  };
  writeFileSync(`${ROOT}benches/results/wasm.json`, `${JSON.stringify(result, null, 2)}\n`);
  console.log(result);
  expect(result.ratio_to_native.node).toBeGreaterThan(LEAST_RATIO);
  expect(result.ratio_to_native.chromium).toBeGreaterThan(LEAST_RATIO);
}, 600_000);

test("a shot with another strike takes tens of microseconds at most", async () => {
  const rack = (await load()).breakShot("snooker");
  const strike = rack.strike!;
  const times = Array.from({ length: 500 }, (_, k) => {
    const started = performance.now();
    rack.withStrike({ ...strike, speed: 1 + k / 1000 }).free();
    return performance.now() - started;
  });
  expect(median(times)).toBeLessThan(0.05);
});

/** Time to unpack and compile the engine, ms. */
async function loadTimes(wasm: Uint8Array<ArrayBuffer>): Promise<number[]> {
  const packed = gzipSync(wasm, { level: 9 });
  const times: number[] = [];
  for (let k = 0; k < 10; k++) {
    const started = performance.now();
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    await WebAssembly.compile(await new Response(stream).arrayBuffer());
    times.push(performance.now() - started);
  }
  return times;
}
