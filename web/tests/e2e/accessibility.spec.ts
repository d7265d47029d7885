import type { Page } from "playwright-core";
import { violations } from "./axe.ts";
import { DESKTOP, expect, onPage, PHONE, pressTool, settled, test } from "./fixture.ts";

/** Presses of Tab that go round all controls of the page. */
const CONTROLS = 90;

for (const [name, viewport] of [
  ["desktop", DESKTOP],
  ["phone", PHONE],
] as const) {
  for (const colorScheme of ["light", "dark"] as const) {
    test(`axe finds no violation on a ${name} in ${colorScheme}`, async ({ open }) => {
      const page = await open({ viewport, colorScheme, firstSteps: true });
      expect(await violations(page), "first steps").toEqual([]);
      await page.getByRole("button", { name: "Skip" }).click();
      for (const tab of ["Layout", "Physics", "What if", "Aim"]) {
        await page.getByRole("tab", { name: tab }).click();
        if (tab === "Layout") await page.getByRole("radio", { name: "9", exact: true }).click();
        if (tab === "What if") {
          await page.getByRole("switch").check();
          await page.locator("#variants[data-done=true]").waitFor();
        }
        expect(await violations(page), tab).toEqual([]);
      }
      for (const activity of ["Play", "Train", "Analyse"]) {
        await page.getByRole("radio", { name: activity }).click();
        expect(await violations(page), activity).toEqual([]);
      }
      await pressTool(page, "Share");
      expect(await violations(page), "share").toEqual([]);
      await page.keyboard.press("Escape");
      await pressTool(page, "Help and keys");
      await page.getByText("Software inside this page").click();
      expect(await violations(page), "help").toEqual([]);
      await page.keyboard.press("Escape");
      await page.getByRole("button", { name: "Shoot" }).click();
      await page.getByRole("button", { name: "Pause" }).click();
      expect(await violations(page), "replay").toEqual([]);
    });

    test(`axe finds no violation in a game on a ${name} in ${colorScheme}`, async ({ open }) => {
      const page = await open({ viewport, colorScheme, reducedMotion: "reduce" });
      await page.getByRole("radio", { name: "Play" }).click();
      const panel = page.locator("#panel-game");
      await panel.getByLabel("Game", { exact: true }).selectOption("straight-pool");
      await panel.getByLabel("Played by").nth(1).selectOption("");
      await panel.getByRole("button", { name: "Start the game" }).click();
      // On a phone the sheet is folded when a game begins.
      if (!(await panel.isVisible())) await page.getByRole("tab", { name: "Game" }).click();
      await panel.getByRole("button", { name: "Ball and pocket" }).click();
      await panel.getByLabel("Called ball").selectOption("3");
      expect(await violations(page), "a call").toEqual([]);
      await panel.getByRole("button", { name: "Safety" }).click();
      await page.evaluate(() => {
        window.carom!.store.strike({ speed: 0.5 }, "a soft break");
      });
      await page.getByRole("button", { name: "Shoot" }).click();
      await page.getByRole("button", { name: "Rack again, Player 1 breaks" }).waitFor();
      expect(await violations(page), "a choice").toEqual([]);
    });
  }
}

test("Tab reaches every control, and the focused control has a visible outline", async ({
  open,
}) => {
  const page = await open();
  const reached = new Set<string>();
  for (let k = 0; k < 60; k += 1) {
    await page.keyboard.press("Tab");
    const { name, ring } = await page.evaluate(() => {
      const { activeElement: element } = document;
      const style = element && getComputedStyle(element);
      const label = element?.getAttribute("aria-label") ?? element?.textContent ?? "";
      return { name: element === document.body ? "" : label, ring: style?.outlineStyle ?? "none" };
    });
    if (name === "") continue; // controls of the browser
    reached.add(name);
    expect(ring, `focus ring of "${name}"`).not.toBe("none");
  }
  for (const name of ["Undo", "From above", "Shoot", "Aim", "Fine", "Help and keys"]) {
    expect([...reached]).toContain(name);
  }
  expect([...reached].some((name) => name.startsWith("Table."))).toBe(true);
});

/** @returns A function that presses Tab up to a control, and then a key. */
function byKeyboard(page: Page): (name: RegExp, key: string) => Promise<void> {
  return async (name, key) => {
    for (let k = 0; k < CONTROLS; k += 1) {
      await page.keyboard.press("Tab");
      const focused = await page.evaluate(() => {
        const element = document.activeElement;
        const labels = [...((element as HTMLInputElement | null)?.labels ?? [])];
        return [element?.ariaLabel, element?.textContent, ...labels.map((l) => l.textContent)];
      });
      if (!focused.some((label) => label && name.test(label))) continue;
      await page.keyboard.press(key);
      return;
    }
    throw new Error(`Tab does not reach ${String(name)}.`);
  };
}

test("two shots and a choice of a game are made by keyboard alone", async ({ open }) => {
  const page = await open({ reducedMotion: "reduce" });
  const onto = byKeyboard(page);
  const moves = () => page.evaluate(() => window.carom!.store.document.game!.moves.length);
  await onto(/^Analyse$/, "ArrowRight");
  await onto(/^Game$/, "Home"); // the tab, which has the same name as the list
  await onto(/^Game$/, "s"); // typing in a list selects "Straight pool"
  await onto(/^Played by$/, "Tab"); // of the first player
  await onto(/^Played by$/, "Home"); // a person
  await onto(/^Start the game$/, "Enter");
  await onto(/^Safety$/, "Space");
  await onto(/^Table\./, "ArrowDown");
  // A soft break is a foul.
  for (let k = 0; k < 19; k += 1) await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  expect(await moves()).toBe(1);
  await onto(/breaks$/, "Enter");
  expect(await moves()).toBe(2);
  // The table has the focus again.
  expect(await page.evaluate(() => document.activeElement?.id)).toBe("table");
});

test("what if, replay and sharing work by keyboard alone", async ({ open }) => {
  const page = await open();
  const onto = byKeyboard(page);
  await onto(/^Aim$/, "End");
  await onto(/^Simulate errors/, "Space");
  await page.locator("#variants[data-done=true]").waitFor();
  await onto(/^Share$/, "Enter");
  await onto(/^Copy as Python$/, "Enter");
  await page.getByText(/copied\.$|Here is the text/).waitFor();
  await page.keyboard.press("Escape");
  await onto(/^Shoot$/, "Enter");
  await onto(/^Pause$/, "Enter");
  await onto(/^Next event$/, "Enter");
  await onto(/^Time$/, "End");
  expect(
    await page.evaluate(() => {
      const { time, trace } = window.carom!.store.session.replay;
      return trace!.duration - time;
    }),
  ).toBe(0);
  await onto(/^Take it from here$/, "Enter");
  expect(await page.evaluate(() => window.carom!.store.session.mode)).toBe("aim");
});

test("with reduced motion the end of the shot is shown at once", async ({ open }) => {
  const page = await open({ reducedMotion: "reduce" });
  await page.getByRole("button", { name: "Shoot" }).click();
  const { time, duration, playing } = await page.evaluate(() => {
    const { session } = window.carom!.store;
    return {
      time: session.replay.time,
      duration: session.replay.trace!.duration,
      playing: session.replay.playing,
    };
  });
  expect([time, playing]).toEqual([duration, false]);
});

test("on a phone everything fits the width, and the table keeps two thirds of the screen", async ({
  open,
}) => {
  const page = await open({ viewport: PHONE });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(PHONE.width);
  const place = () => page.locator("#table").boundingBox();
  const before = await place();
  expect(before!.height).toBeGreaterThan((2 / 3) * PHONE.height);
  await page.getByRole("tab", { name: "Aim" }).click();
  expect(await page.locator("#panel-aim").isVisible()).toBe(true);
  expect(await page.getByRole("button", { name: "Shoot" }).isVisible()).toBe(true);
  expect(await place(), "with an open panel").toEqual(before);
  await page.getByRole("tab", { name: "Aim" }).click();
  await page.getByRole("button", { name: "Shoot" }).click();
  expect(await place(), "in a replay").toEqual(before);
  await page.getByRole("button", { name: "Back to aiming" }).click();
  const spot = await onPage(page, 1, 2.2);
  expect(spot.x).toBeGreaterThan(0);
  expect(spot.x).toBeLessThan(PHONE.width);
});

test("at every width all buttons are on the screen, and the last buttons of a bar are in one row", async ({
  open,
}) => {
  const page = await open({ reducedMotion: "reduce" });
  const beyond = () =>
    page.evaluate(() =>
      [...document.querySelectorAll(".top button, .tab, .dock button, .dock select")]
        .filter((element) => element.getBoundingClientRect().right > innerWidth + 1)
        .map((element) => element.textContent),
    );
  const top = async (id: string) => (await page.locator(id).boundingBox())!.y;
  for (const mode of ["aim", "replay"]) {
    if (mode === "replay") await page.getByRole("button", { name: "Shoot" }).click();
    for (const [width, height] of [
      [320, 568],
      [667, 375],
      [761, 600],
      [800, 450],
      [1280, 720],
    ] as const) {
      await page.setViewportSize({ width, height });
      await settled(page);
      expect(await beyond(), `${mode} at ${width} px`).toEqual([]);
      if (mode === "replay") expect(await top("#take-it")).toBe(await top("#leave-replay"));
    }
  }
});

test("the theme follows the system until the user chooses one", async ({ open }) => {
  const page = await open({ colorScheme: "dark" });
  const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
  expect(await theme()).toBe("dark");
  await page.getByRole("button", { name: "Theme: as the system" }).click();
  expect(await theme()).toBe("light");
  await page.emulateMedia({ colorScheme: "light" });
  await page.getByRole("button", { name: "Theme: light" }).click();
  expect(await theme()).toBe("dark");
});
