import type { Page } from "playwright-core";
import { expect, onPage, PHONE, test } from "./fixture.ts";

const DESKTOP = { width: 1280, height: 800 };

/** What the page asks for. */
const asked = (page: Page) => page.locator("#outcome").textContent();

for (const viewport of [PHONE, DESKTOP]) {
  const size = `${viewport.width}×${viewport.height}`;
  test(`somebody new pots the 9 and stops the cue ball at ${size}`, async ({ open }) => {
    const page = await open({ viewport, firstSteps: true, reducedMotion: "reduce" });
    expect(await asked(page)).toContain("Pot the 9");
    expect(await page.evaluate(() => window.carom!.store.undoLabel)).toBeNull();
    expect(await page.evaluate(() => window.carom!.store.ghost.trace!.outcome.pocketed)).toEqual(
      [],
    );
    // Two gestures: a drag that clicks into the pocket, and Shoot.
    const from = await onPage(page, 1, 2.1);
    const to = await onPage(page, 0.9, 2.2);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    let solved = false;
    for (let k = 1; k <= 60 && !solved; k += 1) {
      const share = k / 60;
      await page.mouse.move(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y));
      solved = await page.evaluate(
        () =>
          new Promise<boolean>((resolve) => {
            requestAnimationFrame(() =>
              requestAnimationFrame(() => {
                const { lock } = window.carom!.store.session;
                resolve(lock?.ball === "9" && lock.pocket === "top-right" && lock.solved);
              }),
            );
          }),
      );
    }
    await page.mouse.up();
    expect(solved, "the line clicks into the pocket").toBe(true);
    await page.getByRole("button", { name: "Shoot" }).click();
    await page.locator("#outcome", { hasText: "Now pot the 1" }).waitFor();

    // Without a change the cue ball follows the 1 out of the circle.
    await page.getByRole("button", { name: "Shoot" }).click();
    await page.locator("#outcome", { hasText: "Not yet" }).waitFor();
    await page.evaluate(() => window.carom!.store.strike({ speed: 2.5, height: -0.2 }, "draw"));
    await page.getByRole("button", { name: "Shoot" }).click();
    await page.getByText(/^Well done\. Best names/).waitFor();
    expect(await page.getByRole("region", { name: "First steps" }).isVisible()).toBe(false);
  });
}

test("the first steps can be skipped, do not come again, and the help begins them again", async ({
  open,
}) => {
  const page = await open({ firstSteps: true });
  await page.getByRole("button", { name: "Skip" }).click();
  expect(await asked(page)).not.toContain("Pot the 9");
  expect(await page.evaluate(() => localStorage.getItem("carom-first-steps"))).toBe("1");
  await page.keyboard.press("?");
  await page.getByRole("button", { name: "Show the first steps" }).click();
  await page.locator("#outcome", { hasText: "Pot the 9" }).waitFor();
  // Something else ends them.
  await page.getByRole("radio", { name: "Play" }).click();
  expect(await page.getByRole("region", { name: "First steps" }).isVisible()).toBe(false);
});

for (const viewport of [PHONE, { width: 844, height: 390 }]) {
  const size = `${viewport.width}×${viewport.height}`;
  test(`what skips the first steps, starts a game, prints a sheet and closes the help is in view at ${size}`, async ({
    open,
  }) => {
    // Seen: Skip lay over a corner pocket; the other two were below the edge of their forms.
    const page = await open({ viewport, firstSteps: true });
    const boxOf = async (name: string) => {
      const button = page.getByRole("button", { name, exact: true });
      await button.waitFor();
      return (await button.boundingBox())!;
    };
    const table = (await page.locator("#table").boundingBox())!;
    const skip = await boxOf("Skip");
    const isBeside = skip.x >= table.x + table.width || skip.y >= table.y + table.height;
    expect(isBeside, "Skip is beside the table").toBe(true);
    expect(await page.locator("#chance-chip").isVisible()).toBe(false);
    await page.getByRole("radio", { name: "Play" }).click();
    const start = await boxOf("Start the game");
    expect(start.y + start.height).toBeLessThan(viewport.height);
    const shownAt = await page.evaluate(([x, y]) => document.elementFromPoint(x, y)?.textContent, [
      start.x + start.width / 2,
      start.y + start.height / 2,
    ] as const);
    expect(shownAt).toBe("Start the game");
    await page.getByRole("radio", { name: "Train" }).click();
    await page.getByRole("button", { name: "Drills on the sheet" }).click();
    const print = (await page.locator("#print-sheet").boundingBox())!;
    expect(print.y + print.height).toBeLessThan(viewport.height);
    await page.locator("#table").focus();
    await page.keyboard.press("?");
    const close = await boxOf("Close");
    expect(close.y).toBeGreaterThan(0);
    expect(close.y + close.height).toBeLessThan(viewport.height / 2);
  });
}
