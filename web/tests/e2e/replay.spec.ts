import type { Page } from "playwright-core";
import { expect, native, picture, settled, shotOf, SMALL, test } from "./fixture.ts";

/** The present time of the replay, s. */
const time = (page: Page) => page.evaluate(() => window.carom!.store.session.replay.time);
const playing = (page: Page) => page.evaluate(() => window.carom!.store.session.replay.playing);

async function shoot(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.getByRole("slider", { name: "Time" }).waitFor();
}

async function shootAndPause(page: Page): Promise<void> {
  await shoot(page);
  await page.getByRole("button", { name: "Pause" }).click();
}

test("a shot plays to its end, and its states are the native engine's", async ({ open }) => {
  const page = await open();
  await shoot(page);
  expect(await playing(page)).toBe(true);
  const trace = native(await shotOf(page));
  await page.waitForFunction(() => !window.carom!.store.session.replay.playing);
  expect(await time(page)).toBe(trace.duration);
  expect(await page.locator("#hash").textContent()).toBe(trace.hash);
  const positions = await page.evaluate(() => {
    const { trace, time } = window.carom!.store.session.replay;
    const states = [...trace!.statesAt(time)];
    const stride = states.length / trace!.shot.balls.length;
    return trace!.shot.balls.map((_, ball) => states.slice(stride * ball, stride * ball + 3));
  });
  expect(positions).toEqual(trace.final.map(({ position }) => position));
});

test("slow motion runs at the chosen fraction of wall time", async ({ open }) => {
  const page = await open();
  await shoot(page);
  await page.getByLabel("Speed of the replay").selectOption("0.1");
  const { whole, slow } = await page.evaluate(async () => {
    const { store } = window.carom!;
    const frame = () => new Promise(requestAnimationFrame);
    const run = async (): Promise<number> => {
      await frame();
      const [wall, shot] = [performance.now(), store.session.replay.time];
      while (performance.now() - wall < 500) await frame();
      return (store.session.replay.time - shot) / ((performance.now() - wall) / 1000);
    };
    const slow = await run();
    store.setPart("replay", { rate: 1 });
    return { whole: await run(), slow };
  });
  // A busy machine drops frames, which shortens both.
  expect(slow).toBeGreaterThan(0);
  expect(slow).toBeLessThan(whole / 2);
});

test("steps visit every instant with an event, and go back", async ({ open }) => {
  const page = await open();
  await shootAndPause(page);
  await page.getByRole("slider", { name: "Time" }).press("Home");
  const trace = native(await shotOf(page));
  const instants = [...new Set(trace.events.map((event) => event.time))];
  const visited = [await time(page)];
  for (let i = 1; i < instants.length; i++) {
    await page.getByRole("button", { name: "Next event" }).click();
    visited.push(await time(page));
  }
  expect(visited).toEqual(instants);
  await page.getByRole("button", { name: "Previous event" }).click();
  expect(await time(page)).toBe(instants.at(-2));
});

test("keys move the slider, and its text gives the time", async ({ open }) => {
  const page = await open();
  await shootAndPause(page);
  const slider = page.getByRole("slider", { name: "Time" });
  await slider.press("Home");
  expect(await time(page)).toBe(0);
  await slider.press("ArrowRight");
  expect(await time(page)).toBeCloseTo(0.05, 12);
  expect(await slider.getAttribute("aria-valuetext")).toMatch(/^0\.050 s of .*, last: /);
  await slider.press("PageUp");
  const next = native(await shotOf(page)).events.find((event) => event.time > 0.05);
  expect(await time(page)).toBe(next?.time);
  await slider.press("End");
  expect(await page.getByRole("button", { name: "Play again" }).isVisible()).toBe(true);
});

test("scrubbing with the pointer shows another instant", async ({ open }) => {
  const page = await open();
  await shoot(page);
  const box = (await page.getByRole("slider", { name: "Time" }).boundingBox())!;
  await page.mouse.move(box.x + box.width / 4, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, { steps: 5 });
  await page.mouse.up();
  expect(await playing(page)).toBe(false);
  const { duration } = native(await shotOf(page));
  expect((await time(page)) / duration).toBeCloseTo(0.5, 1);
});

test("an event on the timeline or in the list leads to its time", async ({ open }) => {
  const page = await open();
  await shoot(page);
  const { events } = native(await shotOf(page));
  const contact = events.find((event) => event.type === "ball-collision")!;
  await page.getByRole("button", { name: "collide" }).first().click();
  expect(await time(page)).toBe(contact.time);
  expect(await playing(page)).toBe(false);
  expect(await page.locator("tr[aria-current]").count()).toBeGreaterThan(0);

  const marks = page.locator(".marks > svg");
  expect(await marks.count()).toBe(events.length);
  const last = (await marks.last().boundingBox())!;
  await page.mouse.move(last.x + last.width / 2, last.y + last.height / 2);
  await page.locator(".event-tip").waitFor({ state: "visible" });
  await page.mouse.click(last.x + last.width / 2, last.y + last.height / 2);
  expect(await time(page)).toBe(events.at(-1)!.time);
});

test("the panel shows the selected ball's state, and its plots", async ({ open }) => {
  const page = await open();
  await shootAndPause(page);
  const { events } = native(await shotOf(page));
  const contact = events.find((event) => event.type === "ball-collision")!;
  const { id } = contact.after[1]!;
  // The ball may bounce off the slate in the same instant.
  const hit = events
    .filter(({ time }) => time === contact.time)
    .flatMap(({ after }) => after)
    .findLast((state) => state.id === id)!;
  await page.getByLabel("Ball", { exact: true }).selectOption(hit.id);
  await page.getByRole("button", { name: "collide" }).first().click();
  const speed = Math.hypot(...hit.velocity);
  await page.getByText(`${speed.toFixed(3)} m/s`, { exact: true }).waitFor();
  expect(await page.locator(".numbers").first().textContent()).toContain(hit.motion);
  await page.getByText("More numbers and graphs").click();
  const spin = Math.hypot(...hit.angular_velocity);
  const words = await page.locator("table.spin").textContent();
  expect(words).toContain(spin.toFixed(1));
  expect(words).toContain(((spin * 30) / Math.PI).toFixed(0));
  for (const name of [/^Speed against time/, /^Spin against time/]) {
    const curve = page.getByRole("img", { name }).locator(".curve").first();
    expect((await curve.getAttribute("d"))!.length).toBeGreaterThan(500);
  }
  await picture(page, "replay-panel");
});

test("with reduced motion a replay does not start by itself", async ({ open }) => {
  const page = await open({ reducedMotion: "reduce" });
  await shoot(page);
  expect(await playing(page)).toBe(false);
});

test("a picture that restores a part of the table equals one that is drawn as a whole", async ({
  open,
}) => {
  const page = await open({ viewport: SMALL });
  await shootAndPause(page);
  const pixels = async (scale: number): Promise<string> => {
    await page.evaluate((ratio) => {
      Object.assign(window, { devicePixelRatio: ratio });
      window.carom!.viewer.quality = "low";
    }, scale);
    await settled(page);
    return page.evaluate(() => (document.getElementById("table") as HTMLCanvasElement).toDataURL());
  };
  const pictures = new Set<string>();
  for (const time of [0, 0.4, 0.8, 1.3, 1.2]) {
    await page.evaluate((at) => window.carom!.store.setPart("replay", { time: at }), time);
    const restored = await pixels(1);
    // Another size makes the viewer draw everything again.
    await pixels(0.5);
    expect((await pixels(1)) === restored, `t = ${time} s`).toBe(true);
    pictures.add(restored);
  }
  expect(pictures.size).toBe(5);
});
