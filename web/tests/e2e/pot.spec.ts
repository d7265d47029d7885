import type { Page } from "playwright-core";
import { expect, onPage, PHONE, settled, shotOf, test } from "./fixture.ts";

const lock = (page: Page) => page.evaluate(() => window.carom!.store.session.lock);
const pocketed = (page: Page) =>
  page.evaluate(() => window.carom!.store.ghost.trace!.outcome.pocketed);

/** Waits for the worker that searches the line. */
const solved = (page: Page) =>
  page.waitForFunction(() => window.carom!.store.session.lock?.solved === true);

/** Where ball 9 and the pocket at the top right lie in the picture. */
async function targets(page: Page) {
  const { geometry, ball } = await page.evaluate(() => {
    const { shot } = window.carom!.store;
    return { geometry: shot.geometry, ball: shot.balls.find(({ id }) => id === "9")!.position };
  });
  const [x, y] = geometry.pockets.find(({ name }) => name === "top-right")!.center;
  return { ball: await onPage(page, ball[0], ball[1]), pocket: await onPage(page, x, y, 0) };
}

/** Turns the cue away from everything. */
async function turnAway(page: Page): Promise<void> {
  await page.evaluate(() => window.carom!.store.strike({ azimuth_deg: 190 }, "turn"));
  await settled(page);
}

for (const viewport of [PHONE, { width: 1280, height: 800 }]) {
  test(`a ball falls after three taps at ${viewport.width}×${viewport.height}`, async ({
    open,
  }) => {
    const isPhone = viewport === PHONE;
    const page = await open({ viewport, ...(isPhone && { hasTouch: true, isMobile: true }) });
    await turnAway(page);
    const { ball, pocket } = await targets(page);
    const tap = ({ x, y }: { x: number; y: number }) =>
      isPhone ? page.touchscreen.tap(x, y) : page.mouse.click(x, y);
    await tap(ball);
    await tap(pocket);
    await solved(page);
    await settled(page);
    expect(await lock(page)).toMatchObject({ ball: "9", pocket: "top-right", solved: true });
    expect(await page.locator("#outcome").textContent()).toMatch(
      isPhone
        ? /^Ball 9 to the top right pocket: .*(ball|hit|cut), a cut of \d+°, ± 0\.\d+°\. /
        : /^Ball 9 to the bottom right pocket: .*(ball|hit|cut), a cut of \d+°, ± 0\.\d+°\. /,
    );
    const shoot = page.getByRole("button", { name: "Shoot" });
    await (isPhone ? shoot.tap() : shoot.click());
    const outcome = await page.evaluate(() => window.carom!.store.session.replay.trace!.outcome);
    expect(outcome.pocketed).toEqual([["9", "top-right"]]);
  });
}

test("the pot stays aimed while speed, English and elevation change, until the cue is turned", async ({
  open,
}) => {
  const page = await open();
  await turnAway(page);
  const { ball, pocket } = await targets(page);
  await page.mouse.click(ball.x, ball.y);
  await page.mouse.click(pocket.x, pocket.y);
  await solved(page);
  const strike = (patch: object) =>
    page.evaluate((patch) => window.carom!.store.strike(patch, "change"), patch);
  const azimuths = new Set<number>();
  for (const patch of [{ side: 0.4 }, { speed: 3.5 }, { elevation_deg: 20 }, { height: -0.3 }]) {
    await strike(patch);
    await solved(page);
    expect(await pocketed(page)).toContainEqual(["9", "top-right"]);
    azimuths.add((await shotOf(page)).strike!.azimuth_deg!);
  }
  expect(azimuths.size).toBe(4);
  // Too slow: the cue stays, and a sentence says why.
  await strike({ speed: 0.1 });
  await settled(page);
  expect((await lock(page))!.solved).toBe(false);
  expect(await page.locator("#outcome").textContent()).toContain("no line with this stroke");
  await strike({ speed: 3 });
  await solved(page);
  expect(await pocketed(page)).toContainEqual(["9", "top-right"]);
  await page.keyboard.press("Control+z");
  expect(await lock(page)).toBeNull();
});

test("a drag past a pot clicks into it, and with Shift it does not", async ({ open }) => {
  const page = await open();
  const { ball, pocket } = await targets(page);
  await page.mouse.click(ball.x, ball.y);
  await page.mouse.click(pocket.x, pocket.y);
  await solved(page);
  const middle = (await shotOf(page)).strike!.azimuth_deg!;
  const drag = async (from: number, by: number, fine: boolean) => {
    await page.evaluate((azimuth_deg) => window.carom!.store.strike({ azimuth_deg }, "turn"), from);
    await settled(page);
    expect(await lock(page)).toBeNull();
    const [x, y] = (await shotOf(page)).balls[0]!.position;
    const spot = (degrees: number) => {
      const angle = (degrees * Math.PI) / 180;
      return onPage(page, x + 0.6 * Math.cos(angle), y + 0.6 * Math.sin(angle));
    };
    const [start, end] = [await spot(100), await spot(100 + by)];
    if (fine) await page.keyboard.down("Shift");
    await page.mouse.move(start.x, start.y);
    await page.mouse.down();
    await page.mouse.move(end.x, end.y, { steps: 6 });
    await settled(page);
    const found = [(await shotOf(page)).strike!.azimuth_deg!, await lock(page)] as const;
    await page.mouse.up();
    if (fine) await page.keyboard.up("Shift");
    return found;
  };
  const [snapped, kept] = await drag(middle - 6, 5.4, false);
  expect(snapped).toBeCloseTo(middle, 1);
  expect(kept).toMatchObject({ ball: "9", pocket: "top-right" });
  const [free, none] = await drag(middle - 1.2, 6, true);
  expect(none).toBeNull();
  expect(free).not.toBeCloseTo(middle, 2);
});

test("the keyboard aims the selected ball at one pocket after another", async ({ open }) => {
  const page = await open();
  await turnAway(page);
  await page.getByRole("application", { name: /^Table/ }).focus();
  // Seen: the first N selected the cue ball, and P answered that no object ball is selected.
  await page.keyboard.press("n");
  const seen: string[] = [];
  for (let k = 0; k < 3; k += 1) {
    const before = await lock(page);
    await page.keyboard.press("p");
    await page.waitForFunction(
      (pocket) => ![undefined, pocket].includes(window.carom!.store.session.lock?.pocket),
      before?.pocket,
    );
    const aim = (await lock(page))!;
    seen.push(aim.pocket);
    expect(await pocketed(page)).toContainEqual(["9", aim.pocket]);
  }
  expect(new Set(seen).size).toBe(3);
  await page.keyboard.press("Shift+P");
  await expect.poll(async () => (await lock(page))?.pocket).toBe(seen[1]);
});

/** Place and size of the table's part of the page. */
const stage = (page: Page) =>
  page.evaluate(() => {
    const { x, y, width, height } = document.getElementById("stage")!.getBoundingClientRect();
    return { x, y, width, height };
  });

test("the table does not move from aiming to the replay", async ({ open }) => {
  for (const viewport of [
    { width: 1440, height: 900 },
    { width: 1280, height: 800 },
    { width: 1024, height: 768 },
  ]) {
    const page = await open({ viewport });
    const before = await stage(page);
    await page.evaluate(() => window.carom!.store.aimAtPocket("9", "top-right", "aim"));
    await settled(page);
    expect(await stage(page)).toEqual(before);
    await page.getByRole("button", { name: "Shoot" }).click();
    await settled(page);
    expect(await page.evaluate(() => window.carom!.store.session.mode)).toBe("replay");
    expect(await stage(page)).toEqual(before);
  }
});

test("the table is upright on a phone, however long the description of the shot", async ({
  open,
}) => {
  for (const locale of ["en", "de"]) {
    const page = await open({ viewport: PHONE, hasTouch: true, isMobile: true, locale });
    await page.evaluate(() => window.carom!.store.aimAtPocket("9", "top-right", "aim"));
    await settled(page);
    const { width, height } = await stage(page);
    expect(height).toBeGreaterThan(width);
    const [head, foot] = [await onPage(page, 0.6, 0.3), await onPage(page, 0.6, 2.2)];
    expect(Math.abs(head.x - foot.x)).toBeLessThan(5);
  }
});
