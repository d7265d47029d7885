/** The table keeps its place and size during a game. */

import type { Page } from "playwright-core";
import { expect, settled, test } from "./fixture.ts";
import { beginGame, SIZES } from "./sizes.ts";

/** Time limit (ms): twenty shots are played and drawn in software. */
const SLOW = 480_000;

const SHOTS = 20;

/** Collects the places of the table in every frame from now on. */
async function watch(page: Page): Promise<void> {
  await page.evaluate(() => {
    const table = document.getElementById("table")!;
    const seen = new Set<string>();
    const look = (): void => {
      const { x, y, width, height } = table.getBoundingClientRect();
      seen.add([x, y, width, height].join());
      requestAnimationFrame(look);
    };
    look();
    Object.assign(window, { seen });
  });
}

const places = (page: Page) =>
  page.evaluate(() => [...(window as unknown as { seen: Set<string> }).seen]);

/**
 * Plays a move, whatever the game asks for: an answer, or a shot whose replay is skipped.
 *
 * @returns Whether it was a shot.
 */
async function move(page: Page, k: number): Promise<boolean> {
  const made = () => page.evaluate(() => window.carom!.store.document.game!.moves.length);
  const before = await made();
  const answer = page.locator("#game-bar .answers button").first();
  const isShot = !(await answer.isVisible());
  if (!isShot) {
    await answer.click();
  } else {
    await page.evaluate((shot) => {
      const { store } = window.carom!;
      const { side, height } = [
        { side: 0, height: 0.2 },
        { side: 0.3, height: 0 },
      ][shot % 2]!;
      store.strike({ speed: shot === 0 ? 8 : 1 + (shot % 4), side, height }, "aim");
    }, k);
    await page.getByRole("button", { name: "Shoot" }).click();
    const back = page.getByRole("button", { name: "Back to aiming" });
    await back.click();
  }
  await settled(page);
  // Another frame begins without moves.
  expect(await made()).not.toBe(before);
  return isShot;
}

for (const viewport of SIZES) {
  test(
    `the table does not move in ${SHOTS} shots of a game at ${viewport.width}×${viewport.height}`,
    { timeout: SLOW },
    async ({ open }) => {
      const page = await open({ viewport });
      await beginGame(page);
      await settled(page);
      await watch(page);
      for (let k = 0; k < SHOTS;) if (await move(page, k)) k += 1;
      expect(await places(page)).toHaveLength(1);
    },
  );
}
