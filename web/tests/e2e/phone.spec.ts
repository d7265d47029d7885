/** Analyse on a phone: the chip, the stopping place, the zone, the plan; and a finger's loupe. */

import type { Page } from "playwright-core";
import { PNG } from "pngjs";
import { expect, onPage, PHONE, picture, settled, shotOf, type Spot, test } from "./fixture.ts";
import { finger, TOUCH } from "./finger.ts";
import { showTab } from "./sizes.ts";

/** Records what the loupe is asked to show. */
async function watchLoupe(page: Page): Promise<() => Promise<(Spot | null)[]>> {
  await page.evaluate(() => {
    const { viewer } = window.carom!;
    const seen: unknown[] = [];
    const show = viewer.loupe.bind(viewer);
    viewer.loupe = (at, disc) => {
      seen.push(at && { x: Math.round(at.x), y: Math.round(at.y) });
      show(at, disc);
    };
    Object.assign(window, { seen });
  });
  return () => page.evaluate(() => (window as unknown as { seen: (Spot | null)[] }).seen);
}

const ballSpot = async (page: Page, id: string): Promise<Spot> => {
  const { balls } = await shotOf(page);
  const [x, y] = balls.find((ball) => ball.id === id)!.position;
  return onPage(page, x, y);
};

test("the table stays visible above an open panel", async ({ open }) => {
  const page = await open(TOUCH);
  await page.evaluate(() => window.carom!.store.setSession({ activity: "train" }));
  await page.waitForSelector("#play-puzzle");
  const stage = (await page.locator("#stage").boundingBox())!;
  const taken = PNG.sync.read(await page.screenshot({ scale: "css" }));
  const x = Math.round(stage.x + stage.width / 2);
  const y = Math.round(stage.y + stage.height / 5);
  const [red, green, blue] = taken.data.subarray(4 * (y * taken.width + x));
  expect([red! < green!, blue! < green!, green! > 60], `${red} ${green} ${blue}`).not.toContain(
    false,
  );
});

test("the chip, the stopping place, the zone and the plan work on a phone", async ({ open }) => {
  const page = await open(TOUCH);
  const chip = page.locator("#chance-chip:not([data-stale])");
  await chip.filter({ hasText: /^\d+ % club$/ }).waitFor();
  await page.evaluate(() => window.carom!.store.aimAtPocket("9", "top-right", "pot"));
  await settled(page);
  const place = () =>
    page.evaluate(() => {
      const { trace } = window.carom!.store.ghost;
      const [x, y] = trace!.statesAt(trace!.duration);
      return [x!, y!] as const;
    });
  const before = await place();
  const wanted = [0.5, 1.2] as const;
  const touch = await finger(page);
  await touch.down(await onPage(page, ...before));
  await touch.move(await onPage(page, 0.5, 1.5));
  await touch.move(await onPage(page, ...wanted));
  await settled(page);
  await touch.up();
  await page
    .locator("#notice")
    .filter({ hasText: /^Solved/ })
    .waitFor();
  const after = await place();
  expect(Math.hypot(after[0] - wanted[0], after[1] - wanted[1])).toBeLessThan(0.05);

  await showTab(page, "lines");
  await page.getByLabel("Next ball", { exact: true }).selectOption("1");
  await page
    .locator("#zone-status")
    .filter({ hasText: /ball 1 falls in about \d+ %/ })
    .waitFor();
  await page.locator("#plan").tap();
  await page.locator("#plan-legs[data-done=true]").waitFor();
  expect(await page.locator("#plan-legs .line").count()).toBe(3);
  await picture(page, "plan-phone");
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(PHONE.width);
});

test("a finger that rests on a ball has a loupe, which follows it until it is lifted", async ({
  open,
}) => {
  const page = await open(TOUCH);
  const seen = await watchLoupe(page);
  const touch = await finger(page);
  const ball = await ballSpot(page, "1");
  const start = (await shotOf(page)).balls;
  await touch.down(ball);
  await expect.poll(seen).toHaveLength(1);
  await picture(page, "loupe");
  const to = { x: ball.x + 40, y: ball.y + 30 };
  await touch.move(to);
  await settled(page);
  await touch.up();
  const spots = await seen();
  expect(spots[0]).toEqual({ x: Math.round(ball.x), y: Math.round(ball.y) });
  expect(spots.at(-2)).toEqual({ x: Math.round(to.x), y: Math.round(to.y) });
  expect(spots.at(-1)).toBeNull();
  expect((await shotOf(page)).balls).not.toEqual(start);
});

test("a finger that turns the aim has a close-up of the contact, until it is lifted", async ({
  open,
}) => {
  // Seen: the loupe showed the empty cloth under the finger.
  const page = await open(TOUCH);
  const seen = await watchLoupe(page);
  const touch = await finger(page);
  const [from, to] = [await onPage(page, 0.9, 1), await onPage(page, 0.9, 1.005)];
  await touch.down(from);
  await touch.move({ x: to.x + 4, y: to.y });
  await expect.poll(seen).toHaveLength(1);
  const [contact] = await seen();
  const ball = await ballSpot(page, "9");
  expect(Math.hypot(contact!.x - ball.x, contact!.y - ball.y)).toBeLessThan(12);
  await picture(page, "close-up");
  await touch.up();
  await expect.poll(async () => (await seen()).at(-1)).toBeNull();
});

test("neither a short tap nor a mouse has a loupe", async ({ open }) => {
  const page = await open(TOUCH);
  const seen = await watchLoupe(page);
  const ball = await ballSpot(page, "1");
  await page.touchscreen.tap(ball.x, ball.y);
  await page.mouse.move(ball.x, ball.y);
  await page.mouse.down();
  // Longer than a finger would have to rest.
  await page.waitForTimeout(600);
  await page.mouse.up();
  expect(await seen()).toEqual([]);
});

test("the button that shoots is in the dock, however long the text above it", async ({ open }) => {
  // Seen: the rule for the dock of a game held without one, and cut the button in a drill and the first steps.
  const button = async (page: Page) => {
    const dock = (await page.locator(".dock").boundingBox())!;
    const box = (await page.locator("#shoot-button").boundingBox())!;
    return dock.y + dock.height - box.y - box.height;
  };
  const page = await open({ viewport: PHONE });
  await page.getByRole("radio", { name: "Train" }).click();
  await page.locator("#drill-stop").click();
  await page.getByRole("button", { name: "Play here" }).click();
  await page.locator("#outcome", { hasText: "Attempt 1 of 10" }).waitFor();
  expect(await button(page), "drill").toBeGreaterThan(0);
  const other = await open({ viewport: PHONE, locale: "de-DE", firstSteps: true });
  await other.evaluate(() => window.carom!.store.aimAtPocket("9", "top-right", "aim"));
  await settled(other);
  expect(await button(other), "first steps").toBeGreaterThan(0);
});

test("the slider and Shoot stay where they are while the text above them changes", async ({
  open,
}) => {
  // Seen: the slider moved by 10 pixels under the finger when the text had one line instead of two.
  const page = await open(TOUCH);
  const places = async () => {
    await settled(page);
    const boxes = [page.locator("#shoot-button"), page.locator(".power-bar")];
    return Promise.all(boxes.map(async (one) => (await one.boundingBox())!.y));
  };
  const long = await places();
  const outcome = page.locator("#outcome");
  const tall = (await outcome.boundingBox())!.height;
  await page.evaluate(() => window.carom!.store.strike({ azimuth_deg: 180 }, "aim"));
  await settled(page);
  expect((await outcome.boundingBox())!.height).toBeLessThan(tall);
  expect(await places()).toEqual(long);
});

test("a notice uses the width of a phone before it wraps", async ({ open }) => {
  // Seen: three short lines, because the notice could be half as wide as the window only.
  const page = await open(TOUCH);
  const height = (text: string) =>
    page.locator("#notice").evaluate((notice, said) => {
      notice.textContent = said;
      return notice.getBoundingClientRect().height;
    }, text);
  const line = await height("Undone.");
  expect(await height("Missed: the cue ball is lost this time.")).toBe(line);
  expect(await height("A sentence that has no place in one line. ".repeat(4))).toBeGreaterThan(
    line,
  );
});

test("a refusal is in view while the panel is open", async ({ open }) => {
  // Seen: the panel covered the sentence about a damaged file.
  const page = await open(TOUCH);
  await page.getByRole("radio", { name: "Train" }).click();
  await page.locator("#progress-file").setInputFiles({
    name: "bad.json",
    mimeType: "application/json",
    buffer: Buffer.from("{"),
  });
  const refusal = page.getByText("bad.json is damaged or no progress file");
  const { x, y, width, height } = (await refusal.boundingBox())!;
  const top = await page.evaluate(([left, up]) => document.elementFromPoint(left, up)?.id, [
    x + width / 2,
    y + height / 2,
  ] as const);
  expect(top).toBe("refusal");
});

test("a finger drags a ball from the tray onto the table", async ({ open }) => {
  // Seen: the panel scrolled instead.
  const page = await open({ viewport: PHONE, hasTouch: true, isMobile: true });
  await showTab(page, "layout");
  const chip = (await page.getByRole("button", { name: "Put ball 5 on the table" }).boundingBox())!;
  const from = { x: chip.x + chip.width / 2, y: chip.y + chip.height / 2 };
  const to = await onPage(page, 0.635, 2);
  const session = await page.context().newCDPSession(page);
  const touch = async (type: "touchStart" | "touchMove" | "touchEnd", share: number) => {
    const x = from.x + share * (to.x - from.x);
    const y = from.y + share * (to.y - from.y);
    const touchPoints = type === "touchEnd" ? [] : [{ x, y }];
    await session.send("Input.dispatchTouchEvent", { type, touchPoints });
    await settled(page);
  };
  await touch("touchStart", 0);
  for (let k = 1; k <= 8; k += 1) await touch("touchMove", k / 8);
  await touch("touchEnd", 1);
  await session.detach();
  const [x, y] = (await shotOf(page)).balls.find(({ id }) => id === "5")!.position;
  expect(Math.hypot(x - 0.635, y - 2)).toBeLessThan(0.01);
});

test("a drag of 3 to 9 pixels turns the aim by as much as the finger turns, and never to the finger", async ({
  open,
}) => {
  // Seen: nine pixels were a tap, and the aim jumped from 19.8° to 26.0°.
  const page = await open(TOUCH);
  const touch = await finger(page);
  const azimuth = async () => (await shotOf(page)).strike!.azimuth_deg!;
  const [x, y] = (await shotOf(page)).balls[0]!.position;
  for (const pixels of [3, 6, 9]) {
    await page.evaluate(() => window.carom!.store.strike({ azimuth_deg: 110 }, "aim"));
    await settled(page);
    const from = await onPage(page, 1.1, 1.1);
    await touch.down(from);
    await touch.move({ x: from.x, y: from.y - pixels });
    await settled(page);
    await touch.up();
    await settled(page);
    const place = (spot: Spot) =>
      page.evaluate(({ x: u, y: v }) => window.carom!.viewer.pick(u, v).point, spot);
    const [a, b] = [(await place(from))!, (await place({ x: from.x, y: from.y - pixels }))!];
    const angle = ([u, v]: readonly number[]) => (Math.atan2(v! - y, u! - x) * 180) / Math.PI;
    const turned = (await azimuth()) - 110;
    expect(Math.abs(turned), `${pixels} px`).toBeGreaterThan(0);
    expect(Math.abs(turned - (angle(b) - angle(a))), `${pixels} px`).toBeLessThan(2.6);
  }
});

test("a drag that begins 11 pixels from the lesson's ball turns the aim, and Undo brings the lesson back after a ball was moved", async ({
  open,
}) => {
  // Seen: the 9 was moved, the lesson was over for good, and Undo did not bring it back.
  const page = await open({ ...TOUCH, firstSteps: true });
  const touch = await finger(page);
  const outcome = page.locator("#outcome");
  await outcome.filter({ hasText: "Pot the 9" }).waitFor();
  const { balls } = await shotOf(page);
  // The pocket of the lesson pulses, so that the picture never settles.
  const drawn = () =>
    page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );
  const drag = async (from: Spot, by: number) => {
    await touch.down(from);
    for (let k = 1; k <= 5; k += 1) {
      await touch.move({ x: from.x, y: from.y + (by * k) / 5 });
      await drawn();
    }
    await touch.up();
    await drawn();
  };
  const nine = await ballSpot(page, "9");
  const before = (await shotOf(page)).strike!.azimuth_deg;
  await drag({ x: nine.x + 11, y: nine.y }, 40);
  expect((await shotOf(page)).balls).toEqual(balls);
  expect((await shotOf(page)).strike!.azimuth_deg).not.toBe(before);
  expect(await outcome.textContent()).toContain("Pot the 9");

  await drag(nine, 40);
  expect((await shotOf(page)).balls).not.toEqual(balls);
  await page.getByText("The first steps wait: Undo brings them back.").waitFor();
  expect(await page.getByRole("region", { name: "First steps" }).isVisible()).toBe(false);
  await page.evaluate(() => window.carom!.store.undo());
  await outcome.filter({ hasText: "Pot the 9" }).waitFor();
  expect(await page.getByRole("region", { name: "First steps" }).isVisible()).toBe(true);
  expect(await page.evaluate(() => localStorage.getItem("carom-first-steps"))).toBeNull();
});

for (const viewport of [PHONE, { width: 1280, height: 800 }]) {
  test(`a tap on a ball aims at it and tells what a tap on a pocket does at ${viewport.width}×${viewport.height}`, async ({
    open,
  }) => {
    // Seen: the ball got a ring, the cue did not move, and nothing told how to go on.
    const page = await open({ viewport, hasTouch: true });
    const spot = await ballSpot(page, "1");
    await page.touchscreen.tap(spot.x, spot.y);
    await settled(page);
    const { balls, strike } = await shotOf(page);
    const place = (id: string) => balls.find((ball) => ball.id === id)!.position;
    const [x, y] = place("cue");
    const [u, v] = place("1");
    const wanted = (Math.atan2(v - y, u - x) * 180) / Math.PI;
    expect(strike!.azimuth_deg).toBeCloseTo(wanted, 3);
    const outcome = page.locator("#outcome");
    expect(await outcome.textContent()).toContain("Tap a pocket to aim ball 1 at it.");
    const pocket = await onPage(page, 0, 2.54, 0);
    await page.touchscreen.tap(pocket.x + 4, pocket.y + 4);
    await outcome.filter({ hasText: /^Ball 1 to the .* pocket/ }).waitFor();
    // The pot stays when its ball is tapped again.
    await page.touchscreen.tap(spot.x, spot.y);
    await settled(page);
    expect(await outcome.textContent()).toMatch(/^Ball 1 to the/);
  });
}
