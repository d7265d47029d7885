import { readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { fileURLToPath, pathToFileURL } from "node:url";
import type { Page } from "playwright-core";
import { build } from "vite";
import { type Decision, type FrameRecord, load } from "../../src/engine/index.ts";
import type { Thinker } from "../../src/engine/thinker-client.ts";
import { read } from "../unit/engine/files.ts";
import { compiledPackage } from "../unit/engine/package.ts";
import { expect, newContext, test } from "./fixture.ts";

declare global {
  interface Window {
    /** The thinker of a test's page. */
    thinking?: Promise<Thinker>;
  }
}

const RECORD = (JSON.parse(read("goldens/decisions.json")) as { readonly record: FrameRecord }[])
  .map(({ record }) => record)
  .find(({ setup }) => setup.game === "nine-ball")!;

const WEB = fileURLToPath(new URL("../..", import.meta.url));

/** What the thinker of the page decides, before and after it was stopped, and an error's place. */
async function answers(page: Page) {
  await page.waitForFunction(() => window.thinking !== undefined);
  return page.evaluate(async (record) => {
    const thinker = await window.thinking!;
    const rounds: number[] = [];
    const decision = await thinker.choose(record);
    const long = thinker.choose(record, {
      simulations: 1e7,
      onProgress: (progress) => {
        rounds.push(progress.rounds);
        thinker.stop();
      },
    });
    const { interrupted } = await long;
    const place = await thinker.choose(record, { seed: -1 }).catch((error: unknown) => {
      const { name, place } = error as { readonly name: string; readonly place: string };
      return [name, place];
    });
    thinker.close();
    return { decision, interrupted, rounds, place };
  }, RECORD);
}

async function expected(): Promise<Decision> {
  const engine = await load();
  const player = engine.player({ noise: engine.noisePresets.club!, simulations: 300, seed: 4 });
  return player.choose(engine.replay(RECORD));
}

async function check(page: Page): Promise<void> {
  const { decision, interrupted, rounds, place } = await answers(page);
  expect(decision).toEqual(await expected());
  expect(interrupted).toBe(true);
  expect(rounds[0]).toBe(1);
  expect(place).toEqual(["CaromError", "seed"]);
}

test("a page in one file on the disk thinks in a worker that it contains", async ({ browser }) => {
  const outDir = `${WEB}tests/e2e/out/thinker`;
  await build({
    root: `${WEB}tests/e2e/thinker`,
    configFile: `${WEB}vite.config.ts`,
    logLevel: "warn",
    build: { outDir, emptyOutDir: true },
  });
  const page = await (await newContext(browser)).newPage();
  await page.goto(pathToFileURL(`${outDir}/index.html`).href);
  await check(page);
  await page.context().close();
});

test("over HTTP the package's thinker starts its own worker", async ({ browser }) => {
  const folder = compiledPackage();
  const html = `<!doctype html><script type="module">
    import { load } from "./dist/index.js";
    import { createThinker } from "./dist/thinker.js";
    window.thinking = load().then((engine) =>
      createThinker(engine, { noise: engine.noisePresets.club, simulations: 300, seed: 4 }));
  </script>`;
  const server = createServer(({ url }, response) => {
    const isScript = /^\/dist\/[\w/-]+\.js$/.test(url!);
    response.setHeader("content-type", isScript ? "text/javascript" : "text/html");
    response.end(isScript ? readFileSync(folder + url!) : html);
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  try {
    const page = await (await newContext(browser)).newPage();
    await page.goto(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
    await check(page);
    await page.context().close();
  } finally {
    server.close();
    rmSync(folder, { recursive: true });
  }
});
