/** A shot that was filmed: its track beside the simulation. */

import type { Page } from "playwright-core";
import {
  contentsOf,
  expect,
  native,
  onPage,
  picture,
  pressTool,
  settled,
  shotOf,
  type Spot,
  test,
} from "./fixture.ts";
import type { ShotFile } from "../../src/engine/index.ts";

const BALLS = [
  { id: "1", position: [0.5, 0.6] },
  { id: "2", position: [1.1, 2.2] },
] as const;

/** A shot along the table, and a film in which ball 1 rolls where the simulation has no ball. */
const FILE: ShotFile = {
  format: "carom-shot/1",
  table: "carom-10ft",
  balls: BALLS,
  strike: { ball: "1", speed: 1.5, azimuth_deg: 90 },
  track: [
    {
      ball: "1",
      samples: Array.from({ length: 51 }, (_, k) => [k / 25, 0.5 + k / 100, 0.6] as const),
    },
  ],
};

/** The place (m) of the filmed ball after a second. */
const THERE = [0.75, 0.6] as const;

async function openFile(page: Page, file: ShotFile): Promise<void> {
  await page.setInputFiles("#open-file", {
    name: "filmed.json",
    mimeType: "application/json",
    buffer: Buffer.from(JSON.stringify(file)),
  });
  await page.getByText("filmed.json is open.").waitFor();
}

/** The picture of a square of 24 pixels about a spot. */
async function pixelsAt(page: Page, { x, y }: Spot): Promise<Buffer> {
  await settled(page);
  return page.screenshot({ clip: { x: x - 12, y: y - 12, width: 24, height: 24 } });
}

test("the filmed paths and balls are drawn beside the simulated ones", async ({ open }) => {
  const page = await open({ quality: "low" });
  const at = async () => pixelsAt(page, await onPage(page, ...THERE));
  await openFile(page, { ...FILE, track: [] });
  const bare = await at();
  expect(await page.locator("#film-legend").isVisible()).toBe(false);
  await openFile(page, FILE);
  expect(await page.locator("#film-legend").textContent()).toMatch(/^Dotted: what/);
  const dotted = await at();
  expect(dotted, "a dotted path").not.toEqual(bare);
  await picture(page, "a-filmed-shot");
  await page.evaluate(() => {
    const { store } = window.carom!;
    const { trace } = store.ghost;
    store.setSession({ mode: "replay" });
    store.setPart("replay", { trace, time: 1, playing: false });
  });
  expect(await page.locator("#film-legend").textContent()).toMatch(/^Dotted and ringed/);
  const ringed = await at();
  expect(ringed, "a ring at the filmed ball").not.toEqual(dotted);
  await picture(page, "a-replay-beside-its-film");
  await page.evaluate(() => window.carom!.store.setPart("replay", { time: 2 }));
  expect(await at(), "the ring goes on").not.toEqual(ringed);
});

test("a filmed shot is saved with its film, and its link says that it has none", async ({
  open,
}) => {
  const page = await open();
  await openFile(page, FILE);
  await page.evaluate(() => window.carom!.store.strike({ speed: 2 }, "speed"));
  expect(await shotOf(page)).not.toHaveProperty("track");
  await pressTool(page, "Share");
  await page.getByText("The link does not have the filmed paths").waitFor();
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Download shot file" }).click(),
  ]);
  const saved = JSON.parse((await contentsOf(file)).toString()) as ShotFile;
  expect(saved.track).toEqual(FILE.track);
  expect(native(saved).hash).toBe(await page.evaluate(() => window.carom!.store.ghost.trace!.hash));
  await page.getByRole("button", { name: "Close" }).click();
  // The film began with other places.
  await page.evaluate(() => {
    const { store } = window.carom!;
    const [first, second] = store.document.shot.balls;
    const balls = [{ ...first!, position: [0.5, 0.9] as const }, second!];
    store.apply({ shot: { ...store.document.shot, balls } }, "move");
  });
  expect(await page.locator("#film-legend").isVisible()).toBe(false);
});
