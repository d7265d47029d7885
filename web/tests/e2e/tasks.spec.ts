/** Long games and trees: no task of the page's main thread simulates many shots. */

import type { Page } from "playwright-core";
import type { FrameRecord } from "../../src/engine/index.ts";
import { expect, pressTool, test } from "./fixture.ts";

const MOVES = 60;

/** Variations of a move, fewer than the most that a tree may have. */
const VARIATIONS = 400;

/** The most shots of a task. A game that is replayed at once has them all in one. */
const MOST = 8;

/** Counts the simulated shots, and the changes of names, in the tasks of the main thread from the next document on. */
async function countShots(page: Page): Promise<void> {
  await page.addInitScript(() => {
    let [now, isCounting] = [0, false];
    const counted = { most: 0 };
    Object.assign(window, { counted });
    const { port1, port2 } = new MessageChannel();
    // It is sent before any message that begins the next slice.
    port1.onmessage = () => ([now, isCounting] = [0, false]);
    const count = (): void => {
      if (!isCounting) port2.postMessage(null);
      isCounting = true;
      counted.most = Math.max(counted.most, (now += 1));
    };
    const { prototype } = WebAssembly.Instance;
    const getter = Object.getOwnPropertyDescriptor(prototype, "exports")!;
    Object.defineProperty(prototype, "exports", {
      get(this: WebAssembly.Instance) {
        const exports = getter.get!.call(this) as WebAssembly.Exports;
        const watched = { ...exports };
        for (const name of ["frame_play", "shot_simulate", "with"]) {
          const call = exports[name] as (...given: unknown[]) => unknown;
          watched[name] = (...given: unknown[]) => {
            count();
            return call(...given);
          };
        }
        return watched;
      },
    });
  });
  await page.reload();
  await page.waitForFunction(() => window.carom !== undefined);
}

/** The most shots of a task since the last question. */
const mostShots = (page: Page) =>
  page.evaluate(() => {
    const { counted } = window as unknown as { counted: { most: number } };
    const { most } = counted;
    counted.most = 0;
    return most;
  });

/** A long game of soft shots. */
const longGame = (page: Page, moves = MOVES): Promise<FrameRecord> =>
  page.evaluate((most) => {
    const frame = window.carom!.engine.frame("practice", { seed: 1 });
    for (let k = 0; k < most; k += 1) {
      const { request } = frame.state;
      if (request.kind !== "shot") break;
      const strike = { speed: 0.3, azimuth: 0.1 * k, elevation: 0.05, side: 0, height: 0 };
      const [first, last] = frame.handBounds ?? [];
      const hand = first && last && ([(first[0] + last[0]) / 2, (first[1] + last[1]) / 2] as const);
      frame.play({ strike, ...(hand && { cue_ball: hand }) }).trace.free();
    }
    const { record } = frame;
    frame.free();
    return record;
  }, moves);

const moves = (page: Page) =>
  page.evaluate(() => window.carom!.store.document.game?.moves.length ?? 0);

/** The head of a tree, and the layout of its first shots. */
function treeHead(): string[] {
  const balls = [{ id: "cue", position: [0.6, 1.2] }];
  const layout = JSON.stringify({ format: "carom-shot/1", table: "wpa-9ft", balls });
  return ['[Carom "tree/1"]', `[Layout ${layout}]`];
}

test("a long game opens from a file and a link, and is watched, in short tasks", async ({
  open,
}) => {
  const page = await open({ reducedMotion: "reduce" });
  const record = await longGame(page);
  expect(record.moves.length).toBe(MOVES);
  await countShots(page);
  const buffer = Buffer.from(JSON.stringify(record));
  await page
    .locator("#open-file")
    .setInputFiles({ name: "frame.json", mimeType: "application/json", buffer });
  await expect.poll(() => moves(page)).toBe(MOVES);
  expect(await mostShots(page), "file").toBeLessThan(MOST);

  await page.locator("#tab-game").click();
  await page.getByRole("button", { name: `Replay move ${MOVES - 1}`, exact: true }).click();
  await page.locator("#game-bar").getByRole("button", { name: "Analyse" }).waitFor();
  expect(await mostShots(page), "replay").toBeLessThan(MOST);
  await page.locator("#game-bar").getByRole("button", { name: "Analyse" }).click();
  await page.getByText(new RegExp(`^Move ${MOVES - 1} of the game`)).waitFor();
  expect(await mostShots(page), "analysis").toBeLessThan(MOST);
  await page.locator("#close-study").click();

  await pressTool(page, "Share");
  const link = new URL(await page.locator("#share-dialog input").inputValue()).hash;
  await page.keyboard.press("Escape");
  await page.evaluate(() => window.carom!.store.undo());
  await page.evaluate(() => window.carom!.store.undo());
  await page.evaluate(() => window.carom!.store.undo());
  expect(await moves(page)).toBe(0);
  // The same address again would not be opened.
  await expect.poll(() => page.evaluate(() => location.hash)).not.toBe(link);
  await mostShots(page);
  await page.evaluate((hash) => (location.hash = hash), link);
  await expect.poll(() => moves(page)).toBe(MOVES);
  expect(await mostShots(page), "link").toBeLessThan(MOST);

  await page.reload();
  await page.waitForFunction(() => window.carom !== undefined);
  expect(await moves(page)).toBe(MOVES);
  expect(await mostShots(page), "reload").toBeLessThan(MOST);
  // The script that counts stays with the tab.
  await page.close();
});

test("a long tree opens from a text in short tasks", async ({ open }) => {
  const page = await open({ reducedMotion: "reduce" });
  await countShots(page);
  // A square, again and again.
  const shots = Array.from(
    { length: MOVES },
    (_, k) => `${k + 1}. "cue" speed=0.2 azimuth_deg=${90 * (k % 4)}`,
  );
  const text = [...treeHead(), ...shots, ""].join("\n");
  await page
    .locator("#open-file")
    .setInputFiles({ name: "tree.txt", mimeType: "text/plain", buffer: Buffer.from(text) });
  const nodes = () => page.evaluate(() => window.carom!.store.document.tree?.nodes.length ?? 0);
  await expect.poll(nodes).toBe(MOVES);
  await page.locator("#tab-tree").click();
  expect(await page.locator("#panel-tree .node").count()).toBe(MOVES);
  expect(await mostShots(page)).toBeLessThan(MOST);
  await page.close();
});

test("a move with hundreds of variations opens, is shown and closes in short tasks", async ({
  open,
}) => {
  // Seen: the text of the variations was read in one task, and the page stood still for a second.
  const page = await open({ reducedMotion: "reduce" });
  const record = await longGame(page, 2);
  const [first, ...others] = record.moves;
  // Half of them from the same layout, half of them one after another.
  const siblings = Array.from(
    { length: VARIATIONS / 2 },
    (_, k) => `( 1. "cue" speed=0.2 azimuth_deg=${k} )`,
  );
  const line = Array.from(
    { length: VARIATIONS / 2 },
    (_, k) => `${k + 2}. "cue" speed=0.2 azimuth_deg=${90 * (k % 4)}`,
  );
  const played = '1. "cue" speed=0.2 azimuth_deg=270';
  const variations = [...treeHead(), played, ...siblings, ...line].join("\n");
  const moves = [{ ...first!, variations }, ...others];
  await countShots(page);
  const buffer = Buffer.from(JSON.stringify({ ...record, moves }));
  await page
    .locator("#open-file")
    .setInputFiles({ name: "frame.json", mimeType: "application/json", buffer });
  await page.locator("#tab-game").click();
  const study = page.getByRole("button", { name: "Analyse move 1", exact: true });
  await study.waitFor();
  expect(await mostShots(page), "file").toBeLessThan(MOST);

  await study.click();
  await page.locator("#close-study").waitFor();
  await page.locator("#tab-tree").click();
  // The move itself is one more.
  expect(await page.locator("#panel-tree .node").count()).toBe(VARIATIONS + 2);
  expect(await mostShots(page), "opened").toBeLessThan(MOST);

  // A later shot of the line is visited, and the analysis is kept while the page loads again.
  const address = () => page.evaluate(() => location.hash);
  const before = await address();
  await page.locator("#panel-tree .node").last().click();
  await expect.poll(address).not.toBe(before);
  expect(await mostShots(page), "visited").toBeLessThan(MOST);
  await page.reload();
  await page.waitForFunction(() => window.carom !== undefined);
  expect(await mostShots(page), "reload").toBeLessThan(MOST);

  await page.locator("#close-study").click();
  await expect
    .poll(() => page.evaluate(() => window.carom!.store.document.game !== null))
    .toBe(true);
  expect(await mostShots(page), "closed").toBeLessThan(MOST);
  // The script that counts stays with the tab.
  await page.close();
});
