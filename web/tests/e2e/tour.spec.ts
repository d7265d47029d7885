/** Faults that a tour by pictures has shown: at five sizes, in light and dark, in three languages. */

import type { Locator, Page } from "playwright-core";
import { expect, PHONE, settled, test } from "./fixture.ts";
import { beginGame, showTab } from "./sizes.ts";

const LANDSCAPE = { width: 844, height: 390 };
const TABLET = { width: 1024, height: 768 };
const GERMAN = "de-DE";
const CHINESE = "zh-CN";

interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

async function boxOf(element: Locator): Promise<Box> {
  return (await element.boundingBox())!;
}

const areApart = (a: Box, b: Box) =>
  a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;

/** How much of an element's content does not fit into it, px. */
const hiddenPart = (element: Locator) =>
  element.evaluate((one) =>
    Math.max(one.scrollHeight - one.clientHeight, one.scrollWidth - one.clientWidth),
  );

const activity = (page: Page, place: number) =>
  page.locator(`#entrances button:nth-child(${place})`).click();

for (const viewport of [LANDSCAPE, TABLET, PHONE]) {
  const size = `${viewport.width}×${viewport.height}`;

  test(`a notice covers no control at ${size}`, async ({ open }) => {
    // Seen: "Zwanzig Grundstellungen ist in der Sammlung gespeichert." over the tab Sammlung.
    const page = await open({ viewport, locale: GERMAN });
    await activity(page, 4);
    await showTab(page, "library");
    await page.locator("#library-example").click();
    await page.locator("#lesson-copy").click();
    const notice = page.locator("#notice");
    await notice.filter({ hasText: "Zwanzig Grundstellungen" }).waitFor();
    const over = await boxOf(notice);
    for (const control of await page.locator("button:visible, [role=tab]:visible").all())
      expect(areApart(over, await boxOf(control)), (await control.textContent())!).toBe(true);
    // What is below it can still be pressed.
    const [x, y] = [over.x + over.width / 2, over.y + over.height / 2];
    const below = ([left, top]: readonly [number, number]) =>
      document.elementFromPoint(left, top)?.id;
    expect(await page.evaluate(below, [x, y] as const)).toBe("table");
  });
}

test("a notice leaves what can be continued in view", async ({ visit }) => {
  // Seen: the notice lay over the button that closes the offer.
  const { open } = await visit({ viewport: PHONE });
  const first = await open();
  await first.evaluate(() => window.carom!.store.strike({ speed: 3 }, "aim"));
  await first.waitForTimeout(1500);
  await first.close();
  const page = await open();
  const banner = page.locator("#kept-banner");
  await banner.waitFor();
  await activity(page, 4);
  await page.locator("#library-list").getByLabel("Name", { exact: true }).first().fill("Cut");
  await page.locator("#library-save").click();
  const notice = page.locator("#notice");
  await notice.filter({ hasText: "Cut" }).waitFor();
  expect(areApart(await boxOf(notice), await boxOf(banner))).toBe(true);
  expect(areApart(await boxOf(notice), await boxOf(page.locator("#drawer")))).toBe(true);
});

for (const viewport of [LANDSCAPE, PHONE]) {
  const size = `${viewport.width}×${viewport.height}`;

  test(`two works that can be continued are each in view at ${size}`, async ({ visit }) => {
    // Seen: the button that closes lay over the second one, and a grey field over the table.
    const { open } = await visit({ viewport });
    const first = await open();
    await first.evaluate(() => window.carom!.store.strike({ speed: 3 }, "aim"));
    await first.waitForTimeout(1500);
    await beginGame(first);
    await first.getByRole("button", { name: "Shoot", exact: true }).click();
    await first.waitForTimeout(1500);
    await first.close();
    const page = await open();
    const banner = page.locator("#kept-banner");
    await banner.waitFor();
    const offers = await banner.locator(".continue").all();
    expect(offers.length).toBe(2);
    const close = await boxOf(banner.getByRole("button", { name: "Close" }));
    const [one, two] = (await Promise.all(offers.map(boxOf))) as [Box, Box];
    const stage = await boxOf(page.locator("#stage"));
    expect([areApart(one, two), areApart(one, close), areApart(two, close)]).toEqual([
      true,
      true,
      true,
    ]);
    for (const { x, width } of [one, two]) {
      expect(width).toBeGreaterThan(100);
      expect(x + width).toBeLessThan(stage.x + stage.width);
    }
    // Chromium without a graphics card draws over the table for a part that scrolls.
    expect(await hiddenPart(banner)).toBeLessThanOrEqual(0);
    expect((await boxOf(banner)).height).toBeLessThan(stage.height / 2);
  });

  test(`a choice of a game is whole at ${size}`, async ({ open }) => {
    // Seen: the last of three answers was cut by the edge of the window.
    const page = await open({ viewport, reducedMotion: "reduce" });
    await beginGame(page, "snooker");
    await page.evaluate(() => window.carom!.store.strike({ speed: 0.5 }, "a foul"));
    await page.getByRole("button", { name: "Shoot", exact: true }).click();
    const answers = page.locator("#game-bar .answers button");
    await answers.first().waitFor();
    expect(await answers.count()).toBe(3);
    const dock = await boxOf(page.locator(".dock"));
    for (const answer of await answers.all()) {
      const { y, height } = await boxOf(answer);
      expect(y + height).toBeLessThanOrEqual(dock.y + dock.height);
    }
  });
}

for (const isFolded of [true, false]) {
  test(`a game's request is whole at 844×390 beside ${isFolded ? "a folded" : "an open"} panel`, async ({
    open,
  }) => {
    // Seen: the names took two lines, and what is on was below the edge of the window.
    const page = await open({ viewport: LANDSCAPE, locale: GERMAN });
    await activity(page, 2);
    await showTab(page, "game");
    await page.locator("#panel-game .pinned button").click();
    const bar = page.locator("#game-bar");
    await bar.waitFor();
    if (!isFolded) await showTab(page, "game");
    expect(await bar.textContent()).toContain("hinter der Kopflinie");
    expect(await hiddenPart(bar)).toBeLessThanOrEqual(1);
  });
}

for (const locale of ["en-GB", GERMAN, CHINESE]) {
  test(`six tabs of a folded panel are whole in ${locale}`, async ({ open }) => {
    // Seen: "Streuun", and Chinese characters on top of each other.
    const page = await open({ viewport: LANDSCAPE, locale });
    expect(await page.locator("#panel").getAttribute("data-folded")).toBe("true");
    expect(await hiddenPart(page.locator("#tabs"))).toBeLessThanOrEqual(1);
    for (const tab of await page.locator(".tab:visible").all())
      expect(await hiddenPart(tab), (await tab.textContent())!).toBeLessThanOrEqual(1);
  });
}

test("the tools for drawing are whole in German at 1024×768, and the table stays", async ({
  open,
}) => {
  // Seen: the list of marks read "1. P", a button had two lines, and the table moved by four pixels.
  const page = await open({ viewport: TABLET, locale: GERMAN });
  const before = await boxOf(page.locator("#table"));
  await page.locator("#draw-button").click();
  await page.evaluate(() => {
    const { store } = window.carom!;
    const mark = { kind: "arrow", color: "yellow", from: [0.3, 1], to: [0.9, 1.5] } as const;
    store.apply({ shot: { ...store.document.shot, marks: [mark] } }, "arrow");
  });
  for (const tool of ["Beschriftung", "Löschen"]) {
    await page.getByRole("radio", { name: tool }).click();
    expect(await boxOf(page.locator("#table")), tool).toEqual(before);
  }
  const list = page.locator("#draw select");
  expect((await boxOf(list)).width).toBeGreaterThan(110);
  for (const button of await page.locator("#draw .button:not(.plain):visible").all())
    expect((await boxOf(button)).height).toBeLessThan(44);
});

test("the text of an attempt is whole on a phone in German", async ({ open }) => {
  // Seen: the end of the text was below the slider.
  const page = await open({ viewport: PHONE, locale: GERMAN, reducedMotion: "reduce" });
  await activity(page, 3);
  await showTab(page, "train");
  await page.locator("#drill-stop").click();
  await page.locator("#play-drill").click();
  await settled(page);
  const said = page.locator(".outcome-text");
  expect(await said.textContent()).toMatch(/Versuch 1 von 10.*Kugel 1: voll/);
  expect(await hiddenPart(said)).toBeLessThanOrEqual(1);
});

test("beside a task its text has the room of the chance, which is not told", async ({ open }) => {
  const page = await open({ viewport: TABLET });
  expect(await page.locator("#chance-chip").isVisible()).toBe(true);
  await activity(page, 3);
  expect(await page.locator("#chance-chip").isVisible()).toBe(false);
});

test("a hint does not touch the field or the buttons below it, and rows of buttons part", async ({
  open,
}) => {
  // Seen: "… and you can change it." with the label Name directly below.
  const page = await open({ viewport: TABLET });
  const gap = async (upper: Locator, lower: Locator) => {
    const [above, below] = [await boxOf(upper), await boxOf(lower)];
    return below.y - above.y - above.height;
  };
  await activity(page, 3);
  const panel = page.locator("#panel-train");
  await page.locator("#own-new").click();
  expect(
    await gap(panel.locator(".hint").first(), panel.locator(".labelled").first()),
  ).toBeGreaterThan(5);
  await page.locator("#all-drills").click();
  await page.locator("#drill-stop").click();
  const rows = panel.locator(".row:has(#play-drill), .row:has(#play-drill) + .row");
  expect(await gap(rows.nth(0), rows.nth(1))).toBeGreaterThan(5);
  await page.locator("#all-drills").click();
  await activity(page, 4);
  const library = page.locator("#library-list");
  expect(
    await gap(library.locator(".hint").first(), library.locator(".labelled").first()),
  ).toBeGreaterThan(5);
});

test("German and Chinese name the cue ball wherever a ball is chosen", async ({ open, close }) => {
  // Seen: "cue" in the list of the aimed ball, among the balls of the layout, and in the photo's tray.
  for (const [locale, name] of [
    [GERMAN, "Spielball"],
    [CHINESE, "母球"],
  ] as const) {
    const page = await open({ viewport: TABLET, locale });
    expect(await page.locator("#panel-aim .struck option").allTextContents()).toContain(name);
    await page.locator("#tab-layout").click();
    expect(await page.locator("#panel-layout [role=radio]").allTextContents()).toContain(name);
    await close(page);
  }
});
