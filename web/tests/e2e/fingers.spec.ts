/** Fingers: fine aim by a slow drag and by the wheel, sheets that step aside, the tip's window, a turned phone. */

import type { Page } from "playwright-core";
import { expect, onPage, pressTool, settled, shotOf, test } from "./fixture.ts";
import { finger, LYING, TOUCH } from "./finger.ts";
import { showTab } from "./sizes.ts";

const azimuth = async (page: Page) => (await shotOf(page)).strike!.azimuth_deg!;

/** Time (ms) between the moves of a slow finger, which is at 40 pixels per second. */
const PAUSE = 25;

test("a finger aims to a twentieth of a degree in two gestures", async ({ open }) => {
  const page = await open(TOUCH);
  const touch = await finger(page);
  const wanted = 71.37;
  // A tap near the wanted line.
  const rough = (wanted + 1.3) * (Math.PI / 180);
  const [cue] = (await shotOf(page)).balls;
  const [x, y] = cue!.position;
  const spot = await onPage(page, x + 0.9 * Math.cos(rough), y + 0.9 * Math.sin(rough), 0);
  await page.touchscreen.tap(spot.x, spot.y);
  await settled(page);
  expect(Math.abs((await azimuth(page)) - wanted)).toBeGreaterThan(0.5);
  // One slow drag: the player watches the line and stops there.
  const from = await onPage(page, 0.2, 1.3);
  let at = from;
  await touch.down(at);
  let before = await azimuth(page);
  for (let step = 0; step < 120 && Math.abs(before - wanted) > 0.025; step += 1) {
    at = { x: at.x + 1, y: at.y };
    await page.waitForTimeout(PAUSE);
    await touch.move(at);
    await settled(page);
    const now = await azimuth(page);
    expect(Math.abs(now - before), "a jump").toBeLessThan(0.15);
    before = now;
  }
  await touch.up();
  expect(Math.abs((await azimuth(page)) - wanted)).toBeLessThanOrEqual(0.05);
});

test("the fine wheel turns the cue by hundredths, with a close-up, as one step of undo", async ({
  open,
}) => {
  const page = await open(TOUCH);
  const wheel = page.getByRole("slider", { name: "Fine aim" });
  const box = (await wheel.boundingBox())!;
  const before = await azimuth(page);
  const touch = await finger(page);
  const at = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await touch.down(at);
  for (const by of [5, 10, 20]) await touch.move({ x: at.x, y: at.y - by });
  await settled(page);
  await touch.up();
  expect((await azimuth(page)) - before).toBeCloseTo(0.3, 3);
  await page.getByRole("button", { name: "Undo: aim" }).tap();
  expect(await azimuth(page)).toBe(before);
  await wheel.focus();
  await page.keyboard.press("ArrowDown");
  expect((await azimuth(page)) - before).toBeCloseTo(-0.05, 3);
  await showTab(page, "aim");
  await page.getByLabel("Fine wheel on the left").check();
  expect((await wheel.boundingBox())!.x).toBe(0);
  await page.getByLabel("Fine wheel on the left").uncheck();
});

test("a mouse has no fine wheel", async ({ open }) => {
  const page = await open();
  expect(await page.locator(".fine-wheel").isVisible()).toBe(false);
});

test("a sheet steps aside while a finger drags on the table, and a swipe closes it", async ({
  open,
}) => {
  const page = await open(TOUCH);
  await showTab(page, "aim");
  const sheet = page.locator("#drawer");
  const covered = (await sheet.boundingBox())!;
  const touch = await finger(page);
  const opacity = () => sheet.evaluate((one) => getComputedStyle(one).opacity);
  const from = await onPage(page, 0.9, 1.7);
  await touch.down(from);
  await touch.move({ x: from.x + 12, y: from.y });
  await settled(page);
  await expect.poll(opacity).toBe("0");
  const under = { x: covered.x + 60, y: covered.y + 60 };
  const found = await page.evaluate((at) => document.elementFromPoint(at.x, at.y)?.id, under);
  expect(found).toBe("table");
  await touch.up();
  await expect.poll(opacity).toBe("1");
  const handle = (await page.getByRole("button", { name: "Close the settings" }).boundingBox())!;
  const at = { x: handle.x + handle.width / 2, y: handle.y + handle.height / 2 };
  await touch.down(at);
  await touch.move({ x: at.x, y: at.y + 60 });
  await touch.up();
  await expect.poll(() => sheet.isVisible()).toBe(false);
  await showTab(page, "aim");
  await page.getByRole("button", { name: "Close the settings" }).tap();
  await expect.poll(() => sheet.isVisible()).toBe(false);
});

test("a ball of the tray goes onto the part of the table that its sheet covers", async ({
  open,
}) => {
  // Seen: the lower half could not be reached, and a press put the ball under the sheet.
  const page = await open(TOUCH);
  await showTab(page, "layout");
  const sheet = (await page.locator("#drawer").boundingBox())!;
  const chip = page.getByRole("button", { name: "Put ball 2 on the table" });
  await chip.scrollIntoViewIfNeeded();
  const box = (await chip.boundingBox())!;
  const touch = await finger(page);
  await touch.down({ x: box.x + 10, y: box.y + 10 });
  const to = await onPage(page, 0.9, 0.35);
  expect(to.y).toBeGreaterThan(sheet.y);
  await touch.move({ x: box.x + 40, y: box.y + 10 });
  await touch.move(to);
  await settled(page);
  await touch.move(to);
  await settled(page);
  await touch.up();
  const { balls } = await shotOf(page);
  const put = balls.find(({ id }) => id === "2")!.position;
  expect(Math.hypot(put[0] - 0.9, put[1] - 0.35)).toBeLessThan(0.02);
  await page.getByRole("button", { name: "Put ball 4 on the table" }).tap();
  const [x, y] = (await shotOf(page)).balls.find(({ id }) => id === "4")!.position;
  expect((await onPage(page, x, y)).y).toBeLessThan(sheet.y);
});

test("the tip has a small window over the cue, which leaves the shot in view", async ({ open }) => {
  // Seen: the sheet of the tip hid the cue ball and the place where it is to stop.
  const page = await open(TOUCH);
  await page.locator(".spin-button").tap();
  const face = page.locator(".tip-window .face");
  const box = (await face.boundingBox())!;
  const [cue] = (await shotOf(page)).balls;
  const ball = await onPage(page, cue!.position[0], cue!.position[1]);
  const top = await page.evaluate((at) => document.elementFromPoint(at.x, at.y)?.id, ball);
  expect(top).toBe("table");
  await page.touchscreen.tap(box.x + box.width * 0.5, box.y + box.height * 0.35);
  await settled(page);
  expect((await shotOf(page)).strike!.height).toBeGreaterThan(0.2);
  await page.getByRole("button", { name: "Close the tip" }).tap();
  expect(await page.locator(".tip-window").isVisible()).toBe(false);
  await page.locator(".spin-button").tap();
  await page.keyboard.press("Escape");
  expect(await page.locator(".tip-window").isVisible()).toBe(false);
});

test("Back closes what is open, keeps the shot, and then leaves the page", async ({ open }) => {
  // Seen: Back left the page while a sheet was open.
  const page = await open(TOUCH);
  const address = page.url();
  const back = () => page.evaluate(() => history.back());
  const label = () => page.evaluate(() => window.carom!.store.undoLabel);
  await page.locator("#tab-aim").tap();
  const drawer = page.locator("#drawer");
  expect(await drawer.isVisible()).toBe(true);
  // The address changes while the sheet is open.
  await page.evaluate(() => window.carom!.store.strike({ azimuth_deg: 12.5 }, "aim"));
  await expect.poll(() => page.url()).not.toBe(address);
  await back();
  await expect.poll(() => drawer.isVisible()).toBe(false);
  await page.waitForTimeout(300);
  expect(await azimuth(page)).toBe(12.5);
  expect(await label()).toBe("aim");
  await page.locator(".spin-button").tap();
  await page.waitForFunction(() => history.state !== null);
  await back();
  await expect.poll(() => page.locator(".tip-window").isVisible()).toBe(false);
  await pressTool(page, "Help and keys");
  await page.waitForFunction(() => history.state !== null);
  await back();
  await expect.poll(() => page.locator("#help").isVisible()).toBe(false);
  // Closed by its own handle, a sheet leaves no step behind.
  await page.locator("#tab-aim").tap();
  await page.getByRole("button", { name: "Close the settings" }).tap();
  expect(await azimuth(page)).toBe(12.5);
  await page.evaluate(() => history.back());
  await expect.poll(() => page.url()).toBe("about:blank");
});

test("on a turned phone the panel is folded, and its tabs open it", async ({ open }) => {
  // Seen: the panel took two fifths of the width and could not be folded.
  const page = await open(LYING);
  const width = async () => (await page.locator("#stage").boundingBox())!.width;
  expect(await width()).toBeGreaterThan(780);
  await page.locator("#tab-layout").tap();
  expect(await page.locator("#panel-layout").isVisible()).toBe(true);
  expect(await width()).toBeLessThan(530);
  await page.getByRole("button", { name: "Hide the settings" }).tap();
  expect(await width()).toBeGreaterThan(780);
});

test("at a zoom of 200 % the text of a lesson is whole, in every language", async ({ open }) => {
  for (const locale of ["en-GB", "de-DE", "zh-CN"]) {
    const page = await open({
      viewport: { width: 640, height: 400 },
      locale,
      firstSteps: true,
    });
    await page.locator("#outcome", { hasText: "9" }).waitFor();
    const isCut = await page.locator(".outcome-text").evaluate((text) => {
      const box = text.getBoundingClientRect();
      const dock = text.closest(".dock")!.getBoundingClientRect();
      return text.scrollHeight > text.clientHeight + 1 || box.bottom > dock.bottom;
    });
    expect(isCut, locale).toBe(false);
  }
});
