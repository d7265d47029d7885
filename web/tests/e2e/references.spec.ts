/**
 * Compares pictures of the page with stored ones. `npm run e2e:references` takes the pictures again; look
 * at each before you commit it.
 */

import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import pixelmatch from "pixelmatch";
import type { Page } from "playwright-core";
import { PNG } from "pngjs";
import { expect, PHONE, settled, SMALL, test } from "./fixture.ts";

const KEPT = fileURLToPath(new URL("./references/", import.meta.url));
const OUT = fileURLToPath(new URL("./out/", import.meta.url));

/** Whether to take the pictures again. */
const WRITE = process.env.CAROM_REFERENCES === "write";

/** Difference (0 to 1) up to which pixels count as equal: drivers smooth edges differently. */
const SAME_PIXEL = 0.2;

/** Share of the pixels that may differ: versions of fonts differ. */
const DIFFERENT_PIXELS = 0.01;

async function replayFromTheSide(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.evaluate(() => {
    const { store } = window.carom!;
    store.setView({ camera: "orbit" });
    store.setPart("replay", { time: 1, playing: false });
  });
}

/** A jump over a ball, seen from above: the flight is dotted over its shadow on the cloth. */
async function jump(page: Page): Promise<void> {
  await page.evaluate(() => {
    window.carom!.store.apply(
      {
        shot: {
          format: "carom-shot/1",
          table: "wpa-9ft",
          balls: [
            { id: "cue", position: [0.5, 0.5] },
            { id: "11", position: [0.5, 0.9] },
            { id: "4", position: [0.9, 2] },
          ],
          strike: { ball: "cue", speed: 5, azimuth_deg: 88, elevation_deg: 45 },
        },
      },
      "jump",
    );
  });
}

async function whatIf(page: Page): Promise<void> {
  await page.getByRole("tab", { name: "What if" }).click();
  await page.getByRole("switch").check();
  await page.locator("#variants[data-done=true]").waitFor();
  // The sheet covers a part of the table.
  await page.getByRole("tab", { name: "What if" }).click();
}

async function aim(page: Page): Promise<void> {
  await page.getByRole("tab", { name: "Aim" }).focus();
}

for (const [name, viewport, colorScheme, prepare] of [
  ["aiming on a desktop in light", SMALL, "light", aim],
  ["a jump from above in light", SMALL, "light", jump],
  ["a replay on a desktop in dark", SMALL, "dark", replayFromTheSide],
  ["aiming on a phone in dark", PHONE, "dark", aim],
  ["what if on a phone in light", PHONE, "light", whatIf],
] as const) {
  test(`${name} looks as in its reference`, async ({ open }) => {
    // With reduced motion the camera moves at once.
    const page = await open({ viewport, colorScheme, quality: "high", reducedMotion: "reduce" });
    await prepare(page);
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await settled(page);
    // The chance beside Shoot comes from a worker.
    await page.waitForFunction(() => {
      const { empty, stale } = document.getElementById("chance-chip")!.dataset;
      return empty === "true" || stale === undefined;
    });
    const file = `${name.replaceAll(" ", "-")}.png`;
    const taken = await page.screenshot({ animations: "disabled", caret: "hide" });
    if (WRITE) {
      mkdirSync(KEPT, { recursive: true });
      writeFileSync(KEPT + file, taken);
      return;
    }
    expect(existsSync(KEPT + file), `${file} exists; if not, run npm run e2e:references`).toBe(
      true,
    );
    const [now, kept] = [PNG.sync.read(taken), PNG.sync.read(readFileSync(KEPT + file))];
    expect([now.width, now.height]).toEqual([kept.width, kept.height]);
    const shown = new PNG({ width: now.width, height: now.height });
    const options = { threshold: SAME_PIXEL };
    const { width, height } = now;
    const count = pixelmatch(now.data, kept.data, shown.data, width, height, options);
    if (count > DIFFERENT_PIXELS * width * height) {
      mkdirSync(OUT, { recursive: true });
      writeFileSync(`${OUT}${file}`, taken);
      writeFileSync(`${OUT}different-${file}`, PNG.sync.write(shown));
    }
    expect(count / (width * height), `see ${OUT}different-${file}`).toBeLessThan(DIFFERENT_PIXELS);
  });
}
