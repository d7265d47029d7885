/**
 * The page as a person has looked at it and found it right. `npm run e2e:references` takes the
 * pictures anew: look at them before they are kept.
 */

import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import pixelmatch from "pixelmatch";
import type { Page } from "playwright-core";
import { PNG } from "pngjs";
import { expect, PHONE, settled, SMALL, test } from "./fixture.ts";

const KEPT = fileURLToPath(new URL("./references/", import.meta.url));
const OUT = fileURLToPath(new URL("./out/", import.meta.url));

/** Whether to take them anew. */
const WRITE = process.env.CAROM_REFERENCES === "write";

/** How different (0 to 1) a pixel may be and still count as the same: edges are smoothed by drivers. */
const SAME_PIXEL = 0.2;

/** Share of the pixels that may differ: letters, as fonts come in versions. */
const DIFFERENT_PIXELS = 0.01;

async function replayFromTheSide(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.evaluate(() => {
    const { store } = window.carom!;
    store.setView({ camera: "orbit" });
    store.setSession({ time: 1, playing: false });
  });
}

async function whatIf(page: Page): Promise<void> {
  await page.getByRole("tab", { name: "What if" }).click();
  await page.getByRole("switch").check();
  await page.locator("#variants[data-done=true]").waitFor();
}

async function aim(page: Page): Promise<void> {
  await page.getByRole("tab", { name: "Aim" }).focus();
}

for (const [name, viewport, colorScheme, prepare] of [
  ["aiming on a desktop in light", SMALL, "light", aim],
  ["a replay on a desktop in dark", SMALL, "dark", replayFromTheSide],
  ["aiming on a phone in dark", PHONE, "dark", aim],
  ["what if on a phone in light", PHONE, "light", whatIf],
] as const) {
  test(`${name} looks as it is kept`, async ({ open }) => {
    // Without motion there is no flight of the camera to wait for.
    const page = await open({ viewport, colorScheme, quality: "high", reducedMotion: "reduce" });
    await prepare(page);
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await settled(page);
    const file = `${name.replaceAll(" ", "-")}.png`;
    const taken = await page.screenshot({ animations: "disabled", caret: "hide" });
    if (WRITE) {
      mkdirSync(KEPT, { recursive: true });
      writeFileSync(KEPT + file, taken);
      return;
    }
    expect(existsSync(KEPT + file), `${file} is kept: npm run e2e:references`).toBe(true);
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
