/** The analysis: the best shots, and why one is better than another. */

import type { Page } from "playwright-core";
import { violations } from "./axe.ts";
import { expect, onPage, PHONE, picture, settled, shotOf, test } from "./fixture.ts";

const WIDE = { width: 1280, height: 800 };

async function searched(page: Page): Promise<void> {
  await page.locator(".lines[data-done=true]:not([data-stale])").waitFor();
}

async function openLines(page: Page): Promise<void> {
  await page.locator("#tab-lines").click();
  await searched(page);
}

/** The strike of the shot whose paths are shown; null without a preview. */
const previewed = (page: Page) =>
  page.evaluate(() => window.carom!.store.session.analysis.preview?.trace?.shot.strike ?? null);

for (const [name, viewport] of [
  ["desktop", WIDE],
  ["phone", PHONE],
] as const) {
  test(`five lines are found, looked at and aimed on a ${name}`, async ({ open }) => {
    const page = await open({ viewport });
    await openLines(page);
    const lines = page.locator(".line");
    expect(await lines.count()).toBe(5);
    expect(await lines.first().textContent()).toMatch(/Pot\s\d+ %.*Foul\s\d+ %.*Win\s\d+ %/);
    expect(await violations(page), "axe").toEqual([]);

    const before = await shotOf(page);
    await lines.nth(1).focus();
    await settled(page);
    const shown = await previewed(page);
    expect(shown).not.toBeNull();
    expect(await shotOf(page)).toEqual(before);
    await picture(page, `lines-${name}`);

    await page.keyboard.press("Enter");
    const aimed = await page.evaluate(() => window.carom!.store.shot.strike);
    expect(aimed).toEqual(shown);
    expect(await previewed(page)).toBeNull();
    // Aiming does not change the position: the lines stay.
    await searched(page);
    await page.evaluate(() => window.carom!.store.undo());
    expect(await shotOf(page)).toEqual(before);
  });
}

test("why compares two lines in a sentence", async ({ open }) => {
  const page = await open({ viewport: WIDE });
  await openLines(page);
  // Seen: two buttons had the name "Why is shot 1 better than shot 2?".
  const asked = page.locator("#panel-lines .ask");
  const names = await asked.evaluateAll((all) => all.map(({ ariaLabel }) => ariaLabel));
  expect(names.length).toBeGreaterThan(2);
  expect(new Set(names).size).toBe(names.length);
  const ask = page.getByRole("button", { name: "Why is shot 1 better than shot 3?" });
  await ask.click();
  expect(await ask.getAttribute("aria-expanded")).toBe("true");
  expect(await page.locator("li:nth-child(3) .why").textContent()).toMatch(
    /^Shots? 1 (?:wins more often than shot 3|and 3 are too close)/,
  );
  expect(await violations(page)).toEqual([]);
});

test("the lines follow the position, the game and the level", async ({ open }) => {
  const page = await open({ viewport: WIDE });
  await openLines(page);
  const wins = () => page.locator(".line .facts").allTextContents();
  const first = await wins();
  await page.getByLabel("Your level").selectOption("professional");
  await searched(page);
  const better = await wins();
  expect(better).not.toEqual(first);
  await page.locator("#panel-lines").getByLabel("Game").selectOption("straight-pool");
  await searched(page);
  expect(await wins()).not.toEqual(better);
  // A drag of a ball makes the lines stale at once.
  const stale = await page.evaluate(() => {
    const { store } = window.carom!;
    const { shot } = store.document;
    const balls = shot.balls.map((ball) =>
      ball.id === "1" ? { ...ball, position: [0.6, 1.2] as const } : ball,
    );
    store.apply({ shot: { ...shot, balls } }, "move");
    return document.querySelector<HTMLElement>(".lines")!.dataset.stale;
  });
  expect(stale).toBe("true");
  await searched(page);
});

test("a line of a game is called when it is aimed", async ({ open }) => {
  const page = await open({ viewport: WIDE });
  await page.getByRole("radio", { name: "Play" }).click();
  const panel = page.locator("#panel-game");
  await panel.getByLabel("Game", { exact: true }).selectOption("straight-pool");
  await panel.getByRole("button", { name: "Start the game" }).click();
  await page.getByRole("radio", { name: "Analyse" }).click();
  await openLines(page);
  await page.locator(".line").first().click();
  // The break of straight pool is called like every other shot.
  const call = await page.evaluate(() => window.carom!.store.document.game!.call);
  expect(["pocket", "safety"]).toContain(call?.kind);
});

test("balls that fit no game are named with a remedy", async ({ open }) => {
  const page = await open({ viewport: WIDE });
  await page.evaluate(() => {
    const { store } = window.carom!;
    const { shot } = store.document;
    const balls = shot.balls.map((ball) => (ball.id === "3" ? { ...ball, id: "mine" } : ball));
    store.apply({ shot: { ...shot, balls } }, "rename");
  });
  await page.locator("#tab-lines").click();
  await page.locator("#lines-status").filter({ hasText: "No game fits these balls" }).waitFor();
});

test("a chip beside Shoot has the chance of the aim, and opens What if", async ({ open }) => {
  const page = await open({ viewport: WIDE });
  const chip = page.locator("#chance-chip:not([data-stale])");
  await chip.filter({ hasText: /^\d+ % club$/ }).waitFor();
  expect(await chip.getAttribute("aria-label")).toMatch(/pot ball 9 in the bottom right pocket/);
  const box = await chip.boundingBox();

  // The number stays, dimmed, until the new one comes; without a pot the chip keeps its place.
  const before = await chip.textContent();
  const stale = await page.evaluate(
    () =>
      new Promise<string>((resolve) => {
        const { store } = window.carom!;
        const element = document.querySelector<HTMLElement>("#chance-chip")!;
        new MutationObserver((_, watcher) => {
          watcher.disconnect();
          resolve(`${element.dataset.stale} ${element.textContent}`);
        }).observe(element, { attributeFilter: ["data-stale"] });
        store.strike({ speed: 6 }, "faster");
      }),
  );
  expect(stale).toBe(`true ${before}`);
  await chip.waitFor();
  await page.evaluate(() => window.carom!.store.strike({ azimuth_deg: 180 }, "away"));
  await page.waitForFunction(
    () => document.querySelector<HTMLElement>("#chance-chip")!.dataset.empty === "true",
  );
  expect(await page.locator("#chance-chip").boundingBox()).toEqual(box);

  await page.evaluate(() => window.carom!.store.undo());
  await chip.waitFor();
  await chip.click();
  await page.getByRole("switch").check();
  await page.locator("#whatif-legend").waitFor();
  expect(await page.locator("#panel-whatif").getByLabel("Like").inputValue()).toBe("Club");
});

test("the stopping place of the cue ball is dragged, and the ball still falls", async ({
  open,
}) => {
  const page = await open({ viewport: WIDE });
  await page.evaluate(() => window.carom!.store.aimAtPocket("9", "top-right", "pot"));
  await settled(page);
  const place = () =>
    page.evaluate(() => {
      const { trace } = window.carom!.store.ghost;
      const [x, y] = trace!.statesAt(trace!.duration);
      return { x: x!, y: y!, pocketed: trace!.outcome.pocketed };
    });
  const before = await place();
  const wanted = { x: 0.5, y: 1.2 };
  const from = await onPage(page, before.x, before.y);
  const to = await onPage(page, wanted.x, wanted.y);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await settled(page);
  await picture(page, "stop-drag");
  await page.mouse.up();
  await page
    .locator("#notice")
    .filter({ hasText: /^Solved/ })
    .waitFor();
  const after = await place();
  expect(after.pocketed).toEqual([["9", "top-right"]]);
  expect(Math.hypot(after.x - wanted.x, after.y - wanted.y)).toBeLessThan(0.03);
  expect(await page.evaluate(() => window.carom!.store.session.lock?.solved)).toBe(true);
  await page.evaluate(() => window.carom!.store.undo());
  expect(await place()).toEqual(before);
});

test("the stopping place is moved by keys, and one out of reach is reported", async ({ open }) => {
  const page = await open({ viewport: WIDE });
  await page.evaluate(() => window.carom!.store.aimAtPocket("9", "top-right", "pot"));
  await page.locator("#tab-lines").click();
  await page.locator("#stop-keys").focus();
  // The table lies: half a metre across it and along it, to a place beside the line of the cue ball.
  for (let k = 0; k < 10; k += 1) await page.keyboard.press("ArrowUp");
  for (let k = 0; k < 9; k += 1) await page.keyboard.press("ArrowLeft");
  await settled(page);
  await page.keyboard.press("Enter");
  await page
    .locator("#notice")
    .filter({ hasText: /cannot stop there.*\d+ cm away/ })
    .waitFor();
  const { pocketed } = await page.evaluate(() => window.carom!.store.ghost.trace!.outcome);
  expect(pocketed[0]).toEqual(["9", "top-right"]);
});

test("the zone for the next ball and a plan of three balls are shown", async ({ open }) => {
  const page = await open({ viewport: WIDE });
  await page.locator("#tab-lines").click();
  const next = page.getByLabel("Next ball", { exact: true });
  await next.selectOption("1");
  await page
    .locator("#zone-status")
    .filter({ hasText: /ball 1 falls in about \d+ %/ })
    .waitFor();
  expect(await page.evaluate(() => window.carom!.store.session.analysis.zone?.values.length)).toBe(
    288,
  );
  await picture(page, "zone");
  await next.selectOption("");
  expect(await page.evaluate(() => window.carom!.store.session.analysis.zone)).toBeNull();

  await page.locator("#plan").click();
  await page.locator("#plan-legs[data-done=true]").waitFor();
  const legs = page.locator("#plan-legs .line");
  expect(await legs.count()).toBe(3);
  expect(await page.locator("#plan-status").textContent()).toMatch(
    /^All 3 balls fall in \d+ % \(\d+ % to \d+ %\) of 64 simulated runs/,
  );
  expect(await violations(page)).toEqual([]);
  await page.mouse.move(5, 5); // off the list, which has grown under the pointer
  await legs.nth(1).focus();
  await settled(page);
  const shown = await previewed(page);
  await page.keyboard.press("Enter");
  expect(await page.evaluate(() => window.carom!.store.shot.strike)).toEqual(shown);
  // Seen: its second shot discarded the plan, and Undo did not bring it back.
  expect(await legs.count()).toBe(3);
  await page.evaluate(() => window.carom!.store.undo());
  expect((await shotOf(page)).balls.length).toBe(4);
  expect(await legs.count()).toBe(3);
  expect(await page.locator("#plan-status").textContent()).toMatch(/^All 3 balls fall in/);
});

test("a plan is drawn on the table with a number and a dash for each shot", async ({ open }) => {
  // Seen: only the shot that is pointed at was drawn.
  const page = await open({ viewport: WIDE });
  await page.locator("#tab-lines").click();
  await page.locator("#plan").click();
  await page.locator("#plan-legs[data-done=true]").waitFor();
  await page.mouse.move(5, 5);
  const button = page.getByRole("button", { name: "Draw all on the table" });
  const drawn = () => page.evaluate(() => window.carom!.store.session.analysis.preview?.marks);
  const marks = (await drawn())!;
  expect(marks.flatMap((mark) => (mark.kind === "label" ? [mark.text] : []))).toEqual([
    "1",
    "2",
    "3",
  ]);
  // The pieces of the lines: whole ones, dashes and dots.
  const longest = (color: string) =>
    Math.max(
      ...marks.flatMap((mark) =>
        mark.kind === "line" && mark.color === color
          ? [Math.hypot(mark.to[0] - mark.from[0], mark.to[1] - mark.from[1])]
          : [],
      ),
    );
  expect(longest("white")).toBeGreaterThan(0.2);
  expect(longest("yellow")).toBeCloseTo(0.07, 6);
  expect(longest("blue")).toBeCloseTo(0.015, 6);
  expect(await button.getAttribute("aria-pressed")).toBe("true");
  await settled(page);
  expect(await page.evaluate(() => window.carom!.scene.stats.paths), "of the aimed shot").toBe(0);
  await picture(page, "plan-drawn");
  expect(await violations(page)).toEqual([]);
  // A shot that is pointed at takes its place for that time.
  await page.locator("#plan-legs .line").nth(1).hover();
  expect(await drawn()).toBeUndefined();
  expect(await previewed(page)).not.toBeNull();
  await page.mouse.move(5, 5);
  expect((await drawn())!.length).toBe(marks.length);
  await button.click();
  expect(await drawn()).toBeUndefined();
  await button.click();
  expect((await drawn())!.length).toBe(marks.length);
  // Another aim is drawn itself, and the plan stays in the list.
  await page.evaluate(() => window.carom!.store.strike({ azimuth_deg: 50 }, "aim"));
  expect(await drawn()).toBeUndefined();
  expect(await button.getAttribute("aria-pressed")).toBe("false");
  await button.click();
  await page.locator("#tab-layout").click();
  await expect.poll(drawn).toBeUndefined();
});

test("the zone for the next ball is not shown beside other tabs", async ({ open }) => {
  // Seen: it stayed on the cloth while the layout was changed.
  const page = await open({ viewport: WIDE });
  await page.locator("#tab-lines").click();
  await page.getByLabel("Next ball", { exact: true }).selectOption("1");
  const zone = () => page.evaluate(() => window.carom!.store.session.analysis.zone !== null);
  await expect.poll(zone).toBe(true);
  await page.locator("#tab-layout").click();
  await expect.poll(zone).toBe(false);
  await page.locator("#tab-lines").click();
  await expect.poll(zone).toBe(true);
});

test("in practice the chances are those of the pots", async ({ open }) => {
  const page = await open({ viewport: WIDE });
  const pot = await page.locator("#chance-chip:not([data-stale])").textContent();
  await page.getByRole("radio", { name: "Play" }).click();
  const panel = page.locator("#panel-game");
  await panel.getByLabel("Game", { exact: true }).selectOption("practice");
  await panel.getByText("Rack and table").click();
  await panel.getByLabel("Begin with").selectOption("lie");
  await panel.getByRole("button", { name: "Start the game" }).click();
  await page.getByRole("radio", { name: "Analyse" }).click();
  await page.evaluate(() => {
    window.carom!.store.strike({ speed: 2, azimuth_deg: 66.8, height: -0.2 }, "aim");
  });
  const chip = page.locator("#chance-chip:not([data-stale])");
  await expect.poll(() => chip.textContent()).toMatch(/^\d+ % club$/);
  // The same variants of the same shot.
  expect(await chip.textContent()).toBe(pot);
  expect(pot).not.toMatch(/^100 %/);
  await openLines(page);
  const facts = page.locator(".line .facts");
  await expect.poll(async () => (await facts.allTextContents()).join()).not.toContain("…");
  const said = await facts.allTextContents();
  for (const text of said) expect(text).toMatch(/^(Pot \d+ %)?$/);
  expect(said.some((text) => text !== "" && text !== "Pot 100 %")).toBe(true);
});
