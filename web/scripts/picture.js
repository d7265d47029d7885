/**
 * Takes the README's picture of the page: one time of a replay, seen from the side.
 * usage: node picture.js PAGE SECONDS OUT, where `carom shot --html` wrote PAGE
 */

/* global performance, window -- inside the page */

import process from "node:process";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { requireChromium } from "./find_chromium.js";

const [page, seconds, out] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: await requireChromium(),
  args: [
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-first-run",
  ],
});
try {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    // So that the camera moves at once.
    reducedMotion: "reduce",
    offline: true,
  });
  const tab = await context.newPage();
  await tab.goto(pathToFileURL(page).href);
  await tab.waitForFunction(() => performance.getEntriesByName("carom:interactive").length > 0);
  await tab.evaluate((time) => {
    window.carom.viewer.quality = "high";
    window.carom.store.setView({ camera: "orbit" });
    window.carom.store.setPart("replay", { time, playing: false });
  }, Number(seconds));
  const shown = `${Number(seconds).toFixed(3)} s`;
  await tab.getByText(`${shown} /`).waitFor();
  await tab.waitForFunction(() => window.carom.viewer.needsPicture === false);
  await tab.screenshot({ path: out });
} finally {
  await browser.close();
}
