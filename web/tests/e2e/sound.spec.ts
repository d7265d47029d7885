import { expect, settled, test, usable } from "./fixture.ts";

/** Counts the sounds that start. */
const counting = () => {
  const state = { started: 0 };
  const createNode = window.OscillatorNode;
  window.OscillatorNode = class extends createNode {
    override start(when?: number): void {
      state.started += 1;
      super.start(when);
    }
  };
  Object.assign(window, { heard: state });
};

const heard = () => (window as unknown as { heard: { started: number } }).heard.started;

test("a replay sounds, until the sound is switched off", async ({ open }) => {
  const page = await open();
  await page.evaluate(counting);
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.waitForFunction(heard);
  const button = page.getByRole("button", { name: "Sound", exact: true });
  expect(await button.getAttribute("aria-pressed")).toBe("true");
  await button.click();
  expect(await button.getAttribute("aria-pressed")).toBe("false");
  const before = await page.evaluate(heard);
  await page.evaluate(() => {
    const { store } = window.carom!;
    store.setPart("replay", { time: 0, playing: true });
  });
  await page.waitForFunction(() => window.carom!.store.session.replay.time > 1);
  expect(await page.evaluate(heard)).toBe(before);
  await page.keyboard.press("m");
  await settled(page);
  expect(await button.getAttribute("aria-pressed")).toBe("true");
});

test("a shared link opens without sound", async ({ open }) => {
  const page = await open();
  await page.evaluate(() => window.carom!.store.strike({ speed: 3 }, "change"));
  await page.waitForFunction(() => location.hash.length > 1);
  const hash = await page.evaluate(() => location.hash);
  const linked = await open({ hash });
  expect(await linked.evaluate(() => window.carom!.store.session.replay.sound)).toBe(false);
});

test("sound that is switched off stays off after a reload, and in the next visit", async ({
  open,
}) => {
  // Seen: a page that was silenced sounded again once it was loaded again.
  const page = await open({ locale: "en-CA" });
  const sounds = () => page.evaluate(() => window.carom!.store.session.replay.sound);
  const load = async (go: () => Promise<unknown>) => {
    await go();
    await usable(page);
  };
  await page.keyboard.press("m");
  expect(await sounds()).toBe(false);
  await load(() => page.reload());
  expect(await sounds()).toBe(false);
  const address = page.url().replace(/#.*/s, "");
  await load(async () => {
    await page.goto("about:blank");
    await page.goto(address);
  });
  expect(await sounds()).toBe(false);
  await page.keyboard.press("m");
  await load(() => page.reload());
  expect(await sounds()).toBe(true);
});

test("a shared link is still silent after a reload", async ({ open }) => {
  const page = await open();
  await page.evaluate(() => window.carom!.store.strike({ speed: 3 }, "change"));
  await page.waitForFunction(() => location.hash.length > 1);
  const linked = await open({ hash: await page.evaluate(() => location.hash) });
  await linked.reload();
  await usable(linked);
  expect(await linked.evaluate(() => window.carom!.store.session.replay.sound)).toBe(false);
});
