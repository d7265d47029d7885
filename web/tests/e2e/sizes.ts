/** The windows at which every sheet is looked at. */

import type { Page } from "playwright-core";

export const SIZES = [
  { width: 1440, height: 900 },
  { width: 1280, height: 800 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
  { width: 844, height: 390 },
] as const;

/** Shows a tab, also where the panel is a folded sheet. */
export async function showTab(page: Page, name: string): Promise<void> {
  if (!(await page.locator(`#panel-${name}`).isVisible()))
    await page.locator(`#tab-${name}`).click();
}

/** Starts a game of nine-ball of two persons. */
export async function beginGame(page: Page, rules = "nine-ball"): Promise<void> {
  await page.getByRole("radio", { name: "Play" }).click();
  await showTab(page, "game");
  const panel = page.locator("#panel-game");
  await panel.getByLabel("Game", { exact: true }).selectOption(rules);
  await panel.getByLabel("Played by").nth(1).selectOption("");
  await panel.getByText("Rack and table").click();
  await panel.getByLabel("Seed of the rack").fill("7");
  await panel.getByRole("button", { name: "Start the game" }).click();
}
