/** What the page keeps: works with their undo, games that have ended, and everything as a file. */

import type { Page } from "playwright-core";
import { inject } from "vitest";
import { violations } from "./axe.ts";
import { contentsOf, DESKTOP, expect, PHONE, storeNow, test, usable } from "./fixture.ts";

/** Starts nine-ball between two persons, and plays `count` shots. */
async function play(page: Page, count: number): Promise<void> {
  await page.getByRole("radio", { name: "Play", exact: true }).click();
  const panel = page.locator("#panel-game");
  await panel.getByLabel("Player 1", { exact: true }).fill("Ann");
  await panel.getByLabel("Played by").nth(1).selectOption("");
  await panel.getByLabel("Player 2", { exact: true }).fill("Bea");
  await panel.getByRole("button", { name: "Start the game" }).click();
  for (let k = 0; k < count; k += 1) await shoot(page);
}

async function shoot(page: Page): Promise<void> {
  const before = await moves(page);
  await page.evaluate(() => window.carom!.store.strike({ speed: 3 }, "aim"));
  await page.getByRole("button", { name: "Shoot", exact: true }).click();
  await page.waitForFunction(
    (count) => (window.carom!.store.document.game?.moves.length ?? 0) > count,
    before,
  );
  await page.waitForFunction(() => window.carom!.store.session.mode === "aim");
}

const moves = (page: Page) =>
  page.evaluate(() => window.carom!.store.document.game?.moves.length ?? 0);

/** Everything that undo and redo can restore. */
const steps = (page: Page) =>
  page.evaluate(() => JSON.parse(JSON.stringify(window.carom!.store.steps)) as { at: number });

const offers = (page: Page) => page.locator("#kept-banner .continue");
const banner = (page: Page) => page.locator("#kept-banner");

/** Waits until a tab has read what can be continued. */
async function offered(page: Page): Promise<void> {
  await page.waitForFunction(() => performance.getEntriesByName("carom:offers").length > 0);
}

/** The same, and lets the tab store its last changes. */
async function settle(page: Page): Promise<void> {
  await offered(page);
  await storeNow(page);
}

/** Closes tabs, and waits until the browser has released their works; other tabs have none. */
async function leave(...pages: readonly Page[]): Promise<void> {
  const context = pages[0]!.context();
  for (const page of pages) {
    await Promise.all([page.waitForEvent("close"), page.close({ runBeforeUnload: true })]);
  }
  const watch = await context.newPage();
  await watch.goto(new URL("icon-192.png", inject("page")).href);
  await watch.waitForFunction(async () => {
    const { held } = await navigator.locks.query();
    return !held!.some(({ name }) => name!.startsWith("carom-work-"));
  });
  await watch.close();
}

for (const [name, viewport] of [
  ["a desktop", DESKTOP],
  ["a phone", PHONE],
] as const) {
  test(`a closed game is continued with one tap on ${name}, with its whole undo`, async ({
    visit,
  }) => {
    const { open } = await visit({ viewport });
    const first = await open();
    expect(await banner(first).isVisible(), "nothing to continue yet").toBe(false);
    await play(first, 2);
    const before = await steps(first);
    await leave(first);

    const page = await open();
    expect(await moves(page)).toBe(0);
    await offered(page);
    expect(await offers(page).count(), (await banner(page).textContent())!).toBe(1);
    expect(await offers(page).textContent()).toMatch(
      /^ContinueNine-ball, Ann against Bea, 2 shots/,
    );
    expect(await violations(page), "with the banner").toEqual([]);
    if (viewport === PHONE) {
      // Seen: the banner covered the upper third of the table.
      const height = (await banner(page).boundingBox())!.height;
      expect(height).toBeLessThanOrEqual(56);
    }
    await page.screenshot({ path: `tests/e2e/out/continue-on-${name.replaceAll(" ", "-")}.png` });
    await offers(page).click();
    await page.waitForFunction(() => window.carom!.store.document.game !== null);
    expect(await steps(page)).toEqual(before);
    expect(await banner(page).isVisible()).toBe(false);
    const undo = page.getByRole("button", { name: /^Undo/ });
    for (let k = before.at; k > 0; k -= 1) await undo.click();
    expect(await page.evaluate(() => window.carom!.store.undoLabel)).toBe(null);
    expect(await moves(page)).toBe(0);
    const redo = page.getByRole("button", { name: /^Redo/ });
    for (let k = 0; k < before.at; k += 1) await redo.click();
    expect(await moves(page)).toBe(2);
  });
}

test("a page that is loaded again still undoes what was done before", async ({ visit }) => {
  const { open } = await visit();
  const page = await open();
  await play(page, 2);
  await page.getByRole("button", { name: /^Undo/ }).click();
  const before = await steps(page);
  await page.reload();
  await usable(page);
  await page.waitForFunction(() => window.carom!.store.undoLabel !== null);
  expect(await steps(page)).toEqual(before);
  await page.getByRole("button", { name: /^Redo/ }).click();
  expect(await moves(page)).toBe(2);
  // And again, after a change.
  await shoot(page);
  const later = await steps(page);
  await page.reload();
  await usable(page);
  await page.waitForFunction((at) => window.carom!.store.steps.at === at, later.at);
  expect(await steps(page)).toEqual(later);
});

test("an analysis, a game and a drill are each continued", async ({ visit }) => {
  const { open } = await visit();
  const first = await open();
  await first.evaluate(() => {
    const { store } = window.carom!;
    store.strike({ azimuth_deg: 12 }, "aim");
    store.settle();
  });
  await settle(first);
  await play(first, 1);
  await settle(first);
  await first.getByRole("radio", { name: "Train", exact: true }).click();
  await first.locator("#drill-straight").click();
  await first.getByRole("button", { name: "Play here" }).click();
  await settle(first);
  await leave(first);

  const second = await open();
  await offered(second);
  const texts = await offers(second).allTextContents();
  expect(texts.map((text) => /, (0 of|1 shot|\d ball)/.exec(text)?.[1])).toEqual([
    "0 of",
    "1 shot",
    "4 ball",
  ]);
  await offers(second).first().click();
  await second
    .getByText(/^Attempt 1 of/)
    .first()
    .waitFor();
  expect(await second.evaluate(() => window.carom!.store.session.activity)).toBe("train");
  const third = await open();
  await offered(third);
  // The drill is open in the other tab.
  expect(await offers(third).count()).toBe(2);
  await offers(third).nth(1).click();
  await third.waitForFunction(() => window.carom!.store.undoLabel !== null);
  expect(await third.evaluate(() => window.carom!.store.document.shot.strike.azimuth_deg)).toBe(12);
});

test("two tabs never write to the same game", async ({ visit }) => {
  const { open } = await visit();
  const [first, second] = [await open(), await open()];
  await play(first, 1);
  await play(second, 2);
  for (const page of [first, second]) await settle(page);
  const third = await open();
  await settle(third);
  expect(await offers(third).count(), "both games are open").toBe(0);
  const before = [await steps(first), await steps(second)];
  await leave(first, second);
  // Two tabs that continue the same game at once: one of them gets a copy.
  const [a, b] = [await open(), await open()];
  for (const page of [a, b]) await offered(page);
  await Promise.all([offers(a).first().click(), offers(b).first().click()]);
  for (const page of [a, b]) {
    await page.waitForFunction(() => window.carom!.store.document.game !== null);
    expect(await steps(page)).toEqual(before[1]);
  }
  await shoot(a);
  const after = await steps(a);
  for (const page of [a, b]) await settle(page);
  await leave(a, b);
  await third.getByRole("radio", { name: "Play", exact: true }).click();
  const listed = third.locator("#kept-list .continue");
  await listed.nth(2).waitFor();
  const texts = (await listed.allTextContents()).map((text) => /\d shots?/.exec(text)![0]);
  expect(texts.sort()).toEqual(["1 shot", "2 shots", "3 shots"]);
  await listed.filter({ hasText: "3 shots" }).click();
  await third.waitForFunction(() => window.carom!.store.document.game !== null);
  expect(await steps(third)).toEqual(after);
});

test("a finished game is listed with its result, and opens in the review", async ({ visit }) => {
  const { open } = await visit();
  const page = await open();
  await play(page, 1);
  await page.getByRole("button", { name: "Concede" }).click();
  await page.getByRole("button", { name: "Another frame" }).waitFor();
  await settle(page);
  await leave(page);

  const next = await open();
  await settle(next);
  expect(await offers(next).count(), "nothing to continue").toBe(0);
  await next.getByRole("radio", { name: "Play", exact: true }).click();
  const row = next.locator("#kept-list li");
  await row.waitFor();
  expect(await row.textContent()).toMatch(
    /^Nine-ball: (Ann has beaten Bea|Bea has beaten Ann)\d+ \w+ \d{4}/,
  );
  await row.scrollIntoViewIfNeeded();
  await next.screenshot({ path: "tests/e2e/out/finished-games.png" });
  await row.getByRole("button", { name: /^Review/ }).click();
  await next.getByRole("button", { name: "Another frame" }).waitFor();
  expect(await moves(next)).toBe(2);
  await next
    .getByRole("button", { name: /^Replay/ })
    .first()
    .waitFor();
  await settle(next);
  // Its review is not a second game.
  await next.getByRole("button", { name: /^Undo/ }).click();
  await next.getByRole("radio", { name: "Play", exact: true }).click();
  await row.waitFor();
  expect(await row.count()).toBe(1);
  await row.getByRole("button", { name: /^Delete/ }).click();
  await next.getByRole("button", { name: "Delete for good" }).click();
  await next.getByText("Games that you play to their end are listed here").waitFor();
});

test("everything is saved as one file and brought back in another browser", async ({ visit }) => {
  const { open } = await visit();
  const page = await open();
  await play(page, 1);
  await page.getByRole("button", { name: "Concede" }).click();
  await page.getByRole("button", { name: "Another frame" }).click();
  await shoot(page);
  const before = await steps(page);
  await settle(page);
  const tab = await open();
  await tab.getByRole("radio", { name: "Play", exact: true }).click();
  const [file] = await Promise.all([
    tab.waitForEvent("download"),
    tab.getByRole("button", { name: "Save everything as a file" }).click(),
  ]);
  expect(file.suggestedFilename()).toMatch(/^carom-\d{4}-\d\d-\d\d\.json$/);
  const buffer = await contentsOf(file);

  const other = await (await visit()).open();
  await other.getByRole("radio", { name: "Play", exact: true }).click();
  const choose = (content: Buffer) =>
    other.setInputFiles("#kept-file", {
      name: "backup.json",
      mimeType: "application/json",
      buffer: content,
    });
  const damaged = JSON.parse(buffer.toString()) as { works: { shots: { strike: unknown }[] }[] };
  damaged.works[0]!.shots[0]!.strike = "alert(1)";
  await choose(Buffer.from(JSON.stringify(damaged)));
  await other
    .getByText("backup.json is damaged at works[0].shots[0]. Nothing was changed.")
    .waitFor();
  await choose(Buffer.from("{}"));
  await other.getByText("backup.json is damaged or no file of this page.").waitFor();
  await choose(buffer);
  await other.getByText("2 new entries added.").waitFor();
  await other.locator("#kept-list li", { hasText: "has beaten" }).waitFor();
  expect(await violations(other), "with the list of games").toEqual([]);
  // The Open button of the header reads it too, and nothing comes twice.
  await other.setInputFiles("#open-file", { name: "again.json", mimeType: "", buffer });
  await other.getByText("0 new entries added.").waitFor();
  expect(await other.locator("#kept-list .continue").count()).toBe(1);
  await other.locator("#kept-list .continue").click();
  await other.waitForFunction(() => window.carom!.store.document.game !== null);
  expect(await steps(other)).toEqual(before);
});

test("a browser that keeps nothing says so, and the page works", async ({ visit }) => {
  const script = () => Object.defineProperty(window, "indexedDB", { value: undefined });
  const { open } = await visit({ script });
  const page = await open();
  await page.getByText("This browser keeps nothing for this page").first().waitFor();
  await banner(page).getByRole("button", { name: "Close" }).click();
  await play(page, 1);
  await page.reload();
  await usable(page);
  expect(await moves(page), "a reload still keeps the game").toBe(1);
});

test("a full storage shows one sentence, and the page works", async ({ visit }) => {
  const script = () => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException("no room", "QuotaExceededError");
    };
  };
  const { open } = await visit({ script });
  const page = await open();
  await play(page, 1);
  await banner(page).getByText("The storage of the browser is full").waitFor();
  await banner(page).getByRole("button", { name: "Close" }).click();
  await shoot(page);
  await settle(page);
  expect(await banner(page).isVisible()).toBe(false);
  expect(await moves(page)).toBe(2);
});

test("a damaged entry has a sentence, is saved and deleted, and the others are continued", async ({
  visit,
}) => {
  const { open } = await visit();
  const first = await open();
  await play(first, 1);
  await settle(first);
  await first.evaluate(
    () =>
      new Promise((resolve) => {
        const opening = indexedDB.open("carom");
        opening.onsuccess = () => {
          const writing = opening.result.transaction("works", "readwrite");
          const changed = "2030-01-01T00:00:00.000Z";
          writing.objectStore("works").put({ id: "wrong", kind: "game", changed, steps: 7 });
          writing.oncomplete = resolve;
        };
      }),
  );
  await leave(first);
  const page = await open();
  await banner(page).getByText("1 entry in the storage of the browser is damaged").waitFor();
  expect(await offers(page).count()).toBe(1);
  await page.getByRole("radio", { name: "Play", exact: true }).click();
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: "Save what is damaged" }).click(),
  ]);
  expect((await contentsOf(file)).toString()).toContain('"id":"wrong"');
  await page.getByRole("button", { name: "Delete what is damaged" }).click();
  await page.locator("#kept-list .continue").click();
  await page.waitForFunction(() => window.carom!.store.document.game !== null);
  expect(await moves(page)).toBe(1);
});
