/** Games without pockets, in the words of carom. */

import type { Page } from "playwright-core";
import { DESKTOP, expect, PHONE, picture, settled, shotOf, test } from "./fixture.ts";
import { beginGame, showTab } from "./sizes.ts";

/** A carom: off the other cue ball around the table to the red. */
async function setUp(page: Page, struck: "cue" | "yellow"): Promise<void> {
  await page.evaluate((ball) => {
    const balls = [
      { id: ball === "cue" ? "yellow" : "cue", position: [1.1, 0.5] as const },
      { id: ball, position: [0.4, 0.6] as const },
      { id: "red", position: [0.9, 2.2] as const },
    ];
    const strike = { ball, speed: 4, azimuth_deg: 350.5, side: 0.3, height: 0.3 };
    const shot = { format: "carom-shot/1", table: "carom-10ft", balls, strike } as const;
    window.carom!.store.apply({ shot }, "a carom");
  }, struck);
}

for (const [name, viewport] of [
  ["desktop", DESKTOP],
  ["phone", PHONE],
] as const) {
  test(`the best shots of three-cushion are routes with one pattern each on a ${name}`, async ({
    open,
  }) => {
    const page = await open({ viewport, reducedMotion: "reduce" });
    await setUp(page, "cue");
    await showTab(page, "lines");
    await page.locator("#panel-lines").getByLabel("Game").selectOption("three-cushion");
    await page.locator("#panel-lines .lines[data-done=true]:not([data-stale])").waitFor();
    const titles = await page.locator(".line strong").allTextContents();
    const caroms = titles.filter((title) => title.includes(" first"));
    expect(caroms.length).toBeGreaterThan(0);
    const routes = await page.locator(".line .route").allTextContents();
    expect(routes).toHaveLength(caroms.length);
    for (const route of routes) {
      expect(route).toMatch(/(long|short), (long|short).* side$/);
      expect(route).toMatch(/off the (yellow|red), .* on the (yellow|red), /);
    }
    // The small picture has the cloth of the table.
    const cloth = page.locator(".line .leave .cloth").first();
    expect(await cloth.evaluate((element) => getComputedStyle(element).fill)).toBe(
      "rgb(43, 98, 160)",
    );
    await picture(page, `carom-best-${name}`);
  });
}

test("the best shots with the yellow as the cue ball are found and aimed", async ({ open }) => {
  // Seen: the page named no game, because the first player has the white.
  const page = await open({ viewport: DESKTOP, reducedMotion: "reduce" });
  await setUp(page, "yellow");
  await showTab(page, "lines");
  await page.locator("#panel-lines").getByLabel("Game").selectOption("three-cushion");
  await page.locator("#panel-lines .lines[data-done=true]:not([data-stale])").waitFor();
  const routes = await page.locator(".line .route").allTextContents();
  expect(routes.length).toBeGreaterThan(0);
  for (const route of routes) {
    expect(route).toMatch(/off the (white|red), .* on the (white|red), /);
  }
  await page.locator(".line").first().focus();
  await page.keyboard.press("Enter");
  expect((await shotOf(page)).strike!.ball).toBe("yellow");
  await picture(page, "carom-best-yellow");
});

test("a ruling counts balls and cushions", async ({ open }) => {
  const page = await open({ viewport: DESKTOP, reducedMotion: "reduce" });
  await beginGame(page, "three-cushion");
  await page.evaluate(() => {
    window.carom!.store.strike({ speed: 2, azimuth_deg: 90, side: 0, height: 0 }, "a miss");
  });
  await page.getByRole("button", { name: "Shoot" }).click();
  await page
    .locator(".ruling")
    .getByText(/no ball touched, no point/)
    .waitFor();
  await settled(page);
  await picture(page, "carom-ruling");
});

test("the guide names the white, and the replay numbers the cushions", async ({ open }) => {
  const page = await open({ viewport: DESKTOP, reducedMotion: "reduce" });
  await setUp(page, "yellow");
  await expect
    .poll(() => page.locator(".dock").first().textContent())
    .toMatch(/Hits the white first.*[Tt]hree-quarter ball/s);
  await page.getByRole("button", { name: "Shoot" }).click();
  const count = page.locator(".timeline .count");
  await expect.poll(() => count.textContent()).toBe("2 balls, 3 cushions");
  expect(await count.isVisible()).toBe(true);
  const events = await page.locator(".events").textContent();
  for (const cushion of [1, 2, 3]) expect(events).toContain(`, cushion ${cushion}`);
  expect(events).toContain("the white and the yellow collide, first ball");
  await picture(page, "carom-replay");
});
