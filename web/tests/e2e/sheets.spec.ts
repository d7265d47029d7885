/** axe over every sheet of the page, at five sizes, in light and dark. */

import type { Page } from "playwright-core";
import { violations } from "./axe.ts";
import { expect, pressTool, test } from "./fixture.ts";
import { beginGame, showTab, SIZES } from "./sizes.ts";

/** Time limit (ms) of a test: axe looks at some twenty states. */
const SLOW = 480_000;

/** Looks at the page in both colour schemes. */
function looker(page: Page): (sheet: string) => Promise<void> {
  return async (sheet) => {
    for (const colorScheme of ["light", "dark"] as const) {
      await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
      expect.soft(await violations(page), `${sheet} in ${colorScheme}`).toEqual([]);
    }
  };
}

/** Plays the aimed shot and returns to aiming. */
async function shoot(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.getByRole("button", { name: "Back to aiming" }).click();
}

for (const viewport of SIZES) {
  const size = `${viewport.width}×${viewport.height}`;

  test(
    `the sheets of Analyse have no violation at ${size}`,
    { timeout: SLOW },
    async ({ open }) => {
      const page = await open({ viewport, reducedMotion: "reduce" });
      const look = looker(page);
      await showTab(page, "aim");
      await page.getByRole("switch", { name: "Diamond system" }).check();
      await look("aim");
      await shoot(page);
      await showTab(page, "lines");
      await page.locator(".lines[data-done=true]:not([data-stale])").waitFor();
      await page.getByRole("button", { name: "Why is shot 1 better than shot 2?" }).first().click();
      await look("lines");
      await showTab(page, "tree");
      await page.locator("#panel-tree").getByText("As text", { exact: true }).click();
      await look("tree");
      await showTab(page, "layout");
      await page.getByRole("radio", { name: "9", exact: true }).click();
      await look("layout");
      await page.getByRole("button", { name: "Layout from a photo" }).click();
      await look("photo");
      await page.keyboard.press("Escape");
      await showTab(page, "physics");
      await look("physics");
      await page.locator("#panel-physics").getByText("Numbers", { exact: true }).click();
      await look("numbers of the physics");
      await showTab(page, "whatif");
      await page.locator("#panel-whatif").getByRole("switch").check();
      await page.locator("#variants[data-done=true]").waitFor();
      await look("what if");
      await pressTool(page, "Share");
      await look("share");
      await page.keyboard.press("Escape");
      await pressTool(page, "Help and keys");
      await look("help");
      await page.keyboard.press("Escape");
      const tools = page.getByRole("button", { name: "Tools" });
      if (await tools.isVisible()) {
        await tools.click();
        await look("tools");
        await page.keyboard.press("Escape");
      }
      await page.getByRole("button", { name: "Shoot" }).click();
      await showTab(page, "state");
      await page.getByText("More numbers and graphs").click();
      await look("replay");
    },
  );

  test(`the sheets of Play have no violation at ${size}`, { timeout: SLOW }, async ({ open }) => {
    const page = await open({ viewport, reducedMotion: "reduce" });
    const look = looker(page);
    await page.getByRole("radio", { name: "Play" }).click();
    await showTab(page, "game");
    await page.locator("#panel-game").getByText("Rack and table").click();
    await look("set-up");
    await page.getByLabel("Lag for the break").check();
    await page.getByRole("button", { name: "Start the game" }).click();
    await page.getByRole("dialog", { name: "The lag" }).waitFor();
    await look("lag");
    await page.keyboard.press("Escape");
    await page.getByLabel("Lag for the break").uncheck();
    await page.locator("#panel-game").getByText("Rack and table").click();
    await beginGame(page);
    await look("game");
    await page.getByRole("button", { name: "Shoot" }).click();
    await showTab(page, "game");
    await page.getByRole("button", { name: "Replay move 1", exact: true }).waitFor();
    await look("list of moves");
    await page.getByRole("button", { name: "Replay move 1", exact: true }).click();
    await page.locator("#game-bar").getByRole("button", { name: "Analyse" }).waitFor();
    await look("review");
    await page.locator("#game-bar").getByRole("button", { name: "Analyse" }).click();
    await showTab(page, "tree");
    await look("variations");
  });

  test(`the sheets of Train have no violation at ${size}`, { timeout: SLOW }, async ({ open }) => {
    const page = await open({ viewport, reducedMotion: "reduce" });
    const look = looker(page);
    await page.getByRole("radio", { name: "Train" }).click();
    await showTab(page, "train");
    await page.getByRole("button", { name: "Play the puzzle" }).waitFor();
    await look("overview");
    await page.getByRole("button", { name: "Drills on the sheet" }).click();
    await look("sheet");
    await page.getByRole("button", { name: "All drills" }).click();
    await page.locator("#drill-stop").click();
    await look("drill");
    await page.getByRole("button", { name: "Play here" }).click();
    await look("attempt");
    await showTab(page, "train");
    await look("attempt with its sheet");
  });
}
