import type { Page } from "playwright-core";
import { expect, native, onPage, PHONE, settled, shotOf, test } from "./fixture.ts";

const azimuth = async (page: Page) => (await shotOf(page)).strike!.azimuth_deg!;

/** Direction from the cue ball to a place of the table, degrees. */
async function towards(page: Page, x: number, y: number): Promise<number> {
  const [cx, cy] = (await shotOf(page)).balls[0]!.position;
  return (Math.atan2(y - cy, x - cx) * 180) / Math.PI;
}

const speedField = (page: Page) => page.getByRole("spinbutton", { name: "Cue speed" });

/** Angle of one pixel seen from the cue ball, degrees. */
const PIXEL = 0.5;

test("a click on the cloth aims there", async ({ open }) => {
  const page = await open();
  const spot = await onPage(page, 1, 2.2);
  await page.mouse.click(spot.x, spot.y);
  await settled(page);
  expect(Math.abs((await azimuth(page)) - (await towards(page, 1, 2.2)))).toBeLessThan(PIXEL);
});

test("a drag on the cloth turns the cue by the angle of the pointer, with Shift by a tenth", async ({
  open,
}) => {
  const page = await open();
  const from = await onPage(page, 1, 1.6);
  const to = await onPage(page, 0.7, 1.9);
  const angle = (await towards(page, 0.7, 1.9)) - (await towards(page, 1, 1.6));
  for (const [shift, factor] of [
    [false, 1],
    [true, 0.1],
  ] as const) {
    const before = await azimuth(page);
    if (shift) await page.keyboard.down("Shift");
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 8 });
    await page.mouse.up();
    if (shift) await page.keyboard.up("Shift");
    expect(Math.abs((await azimuth(page)) - before - factor * angle)).toBeLessThan(PIXEL);
  }
});

test("a touch aims: a drag turns the cue, a tap aims at the place", async ({ open }) => {
  const page = await open({ viewport: PHONE, hasTouch: true, isMobile: true });
  const client = await page.context().newCDPSession(page);
  const from = await onPage(page, 1, 1.6);
  const to = await onPage(page, 0.7, 1.9);
  const angle = (await towards(page, 0.7, 1.9)) - (await towards(page, 1, 1.6));
  const before = await azimuth(page);
  // A quick finger, 10 ms between two events, on a busy machine too: a slow one turns the cue finely.
  let timestamp = Date.now() / 1000;
  const touch = (
    type: "touchStart" | "touchMove" | "touchEnd",
    spot?: { x: number; y: number },
  ) => {
    timestamp += 0.01;
    return client.send("Input.dispatchTouchEvent", {
      type,
      timestamp,
      touchPoints: spot ? [spot] : [],
    });
  };
  await touch("touchStart", from);
  for (let k = 1; k <= 6; k += 1) {
    await touch("touchMove", {
      x: from.x + ((to.x - from.x) * k) / 6,
      y: from.y + ((to.y - from.y) * k) / 6,
    });
  }
  await touch("touchEnd");
  await settled(page);
  expect(Math.abs((await azimuth(page)) - before - angle)).toBeLessThan(2 * PIXEL);
  const spot = await onPage(page, 1, 2.2);
  await page.touchscreen.tap(spot.x, spot.y);
  await settled(page);
  expect(Math.abs((await azimuth(page)) - (await towards(page, 1, 2.2)))).toBeLessThan(2 * PIXEL);
});

test("the keyboard alone aims, sets the speed, shoots, and continues from the final positions", async ({
  open,
}) => {
  const page = await open();
  await page.getByRole("application", { name: /^Table/ }).focus();
  const before = (await shotOf(page)).strike!;
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowUp");
  const after = (await shotOf(page)).strike!;
  expect(after.azimuth_deg).toBeCloseTo(before.azimuth_deg! + 1 - 0.1, 6);
  expect(after.speed).toBeCloseTo(before.speed + 0.2, 6);

  await page.keyboard.press("Enter");
  await page.waitForFunction(() => window.carom!.store.session.mode === "replay");
  await page.keyboard.press("t");
  await page.waitForFunction(() => window.carom!.store.session.mode === "aim");
  const expected = native({
    ...(await shotOf(page)),
    balls: (await firstShot(page)).balls,
    strike: after,
  });
  const left = expected.final.filter(
    ({ motion }) => motion !== "pocketed" && motion !== "off-table",
  );
  expect((await shotOf(page)).balls.map(({ id, position }) => [id, ...position])).toEqual(
    left.map(({ id, position }) => [id, position[0], position[1]]),
  );
});

async function firstShot(page: Page) {
  return page.evaluate(() => {
    const { store } = window.carom!;
    store.undo();
    const { shot } = store.document;
    store.redo();
    return shot;
  });
}

test("the played shot has the native engine's final positions and hash, to the bit", async ({
  open,
}) => {
  const page = await open();
  await speedField(page).fill("4.7");
  await speedField(page).press("Enter");
  await page.getByLabel("Side in tips").fill("1.86");
  await page.getByLabel("Side in tips").press("Enter");
  await page.getByRole("button", { name: "Shoot" }).click();
  const ours = await page.evaluate(() => {
    const trace = window.carom!.store.session.replay.trace!;
    return { json: trace.json(), hash: trace.hash };
  });
  const shot = await shotOf(page);
  expect(shot.strike).toMatchObject({ speed: 4.7, side: 0.31 });
  const theirs = native(shot);
  expect(ours.hash).toBe(theirs.hash);
  expect((JSON.parse(ours.json) as typeof theirs).final).toEqual(theirs.final);
});

test("the tip position takes clicks and arrow keys, and stays within the miscue limit", async ({
  open,
}) => {
  const page = await open();
  const face = page.getByRole("application", { name: /^Tip position/ });
  const box = (await face.boundingBox())!;
  await page.mouse.click(box.x + box.width * 0.6, box.y + box.height * 0.4);
  const { side, height } = (await shotOf(page)).strike!;
  // The drawing's border is 0.08 of the radius.
  expect(side).toBeCloseTo(0.216, 1);
  expect(height).toBeCloseTo(0.216, 1);

  await page.mouse.move(box.x + box.width * 0.6, box.y + box.height * 0.4);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.95, box.y + box.height * 0.45, { steps: 1 });
  await page.mouse.up();
  const limit = await page.evaluate(() => window.carom!.store.shot.miscueLimit);
  const edge = (await shotOf(page)).strike!;
  const offset = Math.hypot(edge.side!, edge.height!);
  expect(offset).toBeLessThanOrEqual(limit);
  expect(offset).toBeGreaterThan(limit - 0.003);
  expect(edge.side! / edge.height!).toBeGreaterThan(5);
  expect(await page.getByRole("alert").isVisible()).toBe(false);

  await face.focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowDown");
  expect((await shotOf(page)).strike).toMatchObject({ side: 0, height: -0.02 });
});

test("an obstructed cue is reported with the necessary elevation, and a button raises the cue", async ({
  open,
}) => {
  const page = await open();
  await page.evaluate(() => {
    const { store } = window.carom!;
    const { shot } = store.document;
    const balls = shot.balls.map((ball) =>
      ball.id === "cue" ? { ...ball, position: [0.03, 0.6] as const } : ball,
    );
    const strike = { ...shot.strike, azimuth_deg: 10, elevation_deg: 0 };
    store.apply({ shot: { ...shot, balls, strike } }, "try");
  });
  await page.getByText(/^The cue would pass through the top left rail: raise it to/).waitFor();
  const raise = page.getByRole("button", { name: "Raise the cue", exact: true });
  await raise.click();
  await settled(page);
  expect(await raise.isVisible()).toBe(false);
  expect((await shotOf(page)).strike!.elevation_deg).toBeGreaterThan(5);
});

test("the elevation is automatic until an angle is set, and links have the angle", async ({
  open,
}) => {
  const page = await open();
  const automatic = page.getByRole("button", { name: "Automatic elevation" });
  const field = page.getByRole("spinbutton", { name: /^Elevation/ });
  const pressed = () => automatic.getAttribute("aria-pressed");
  expect([await pressed(), await field.inputValue()]).toEqual(["true", "3"]);
  await field.fill("20");
  await field.press("Enter");
  await settled(page);
  expect([await pressed(), await field.inputValue()]).toEqual(["false", "20"]);
  await automatic.click();
  await settled(page);
  expect([await pressed(), await field.inputValue()]).toEqual(["true", "3"]);
  const file = await page.evaluate(() => window.carom!.store.shot.file.strike!);
  expect(file.elevation_deg).toBe(3);
});

test("speed is shown and set in the chosen unit", async ({ open }) => {
  const page = await open();
  await page.getByLabel("Unit of speed").selectOption("km/h");
  expect(await speedField(page).inputValue()).toBe("7.2");
  await speedField(page).fill("9");
  await speedField(page).press("Enter");
  expect((await shotOf(page)).strike!.speed).toBeCloseTo(2.5, 9);
});

for (const [viewport, pocket] of [
  [{ width: 1280, height: 800 }, "bottom right"],
  [PHONE, "top right"],
] as const) {
  const size = `${viewport.width}×${viewport.height}`;
  test(`the pocket is named as it is seen at ${size}`, async ({ open }) => {
    const page = await open({ viewport });
    await settled(page);
    expect(await page.locator("#outcome").textContent()).toContain(`${pocket} pocket`);
    const seen = await page.evaluate(() => {
      const { store, viewer } = window.carom!;
      const { pockets, size } = store.shot.geometry;
      const [x, y] = pockets.find(({ name }) => name === "top-right")!.center;
      const [at, middle] = [
        viewer.project(x, y, 0)!,
        viewer.project(size![0] / 2, size![1] / 2, 0)!,
      ];
      return `${at[1] > middle[1] ? "bottom" : "top"} ${at[0] > middle[0] ? "right" : "left"}`;
    });
    expect(seen).toBe(pocket);
  });
}

test("the speed has one slider, which follows the number under Aim", async ({ open }) => {
  // Seen: two sliders of one speed stood at different places.
  const page = await open();
  await page.getByRole("tab", { name: "Aim" }).click();
  const panel = page.locator("#panel-aim");
  const names = () =>
    panel
      .getByRole("slider")
      .evaluateAll((sliders) => sliders.map((each) => each.getAttribute("aria-label")));
  expect(await names()).toEqual(["Elevation"]);
  const bar = page.locator("#shoot .power-bar");
  const before = Number(await bar.inputValue());
  await speedField(page).fill("9");
  await speedField(page).press("Enter");
  expect(Number(await bar.inputValue())).toBeGreaterThan(before);
});
