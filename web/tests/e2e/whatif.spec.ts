import type { Page } from "playwright-core";
import type { Noise } from "../../src/engine/index.ts";
import { inject } from "vitest";
import { expect, picture, shotOf, SMALL, test } from "./fixture.ts";
import { python } from "./python.ts";

const COUNT = 1000;

async function turnOn(page: Page): Promise<void> {
  await page.getByRole("tab", { name: "What if" }).click();
  await page.getByRole("switch").check();
  await finished(page);
}

async function finished(page: Page): Promise<void> {
  await page.locator("#variants[data-done=true]").waitFor();
}

/** The table of chances, by name of the ball. */
async function chances(page: Page): Promise<Record<string, string>> {
  return page.evaluate(() => {
    const rows = document.querySelectorAll("table.chances tbody tr");
    const cells = [...rows].map((row) => [...row.children].map((cell) => cell.textContent));
    return Object.fromEntries(cells) as Record<string, string>;
  });
}

/** Number of variants of a native batch in which each ball is pocketed. */
function nativeHits(shot: string, noise: Noise, seed: number): number[] {
  const program = `
import carom, json, sys
given = json.load(sys.stdin)
shot = carom.Shot.from_json(given["shot"])
result = shot.vary(carom.Noise(**given["noise"]), given["count"], seed=given["seed"])
print(json.dumps([int(n) for n in (result.pocket >= 0).sum(axis=0)]))
`;
  const given = JSON.stringify({ shot, noise, seed, count: COUNT });
  return JSON.parse(python(program, given)) as number[];
}

/** A chance of `hits` in `COUNT` as the page writes it, computed independently. */
function inWords(hits: number): string {
  if (hits === 0) return "less than 0.3 %";
  if (hits === COUNT) return "more than 99.7 %";
  const p = hits / COUNT;
  const error = Math.sqrt((p * (1 - p)) / COUNT);
  return `${(100 * p).toFixed(1)} % ± ${(100 * error).toFixed(1)} %`;
}

test("the chances are those of a native batch with the same seed", async ({ open }) => {
  const page = await open();
  await turnOn(page);
  const seed = page.locator("#panel-whatif").getByLabel("Seed");
  await seed.fill("12345");
  await seed.press("Enter");
  await page.waitForFunction(() => window.carom!.store.document.seed === 12345);
  const given = await page.evaluate(() => {
    const { shot, document } = window.carom!.store;
    return { json: shot.json(), ids: shot.balls.map(({ id }) => id), noise: document.noise! };
  });
  const hits = nativeHits(given.json, given.noise, 12345);
  expect(Math.max(...hits)).toBeGreaterThan(0);
  const names = given.ids.map((id) => (id === "cue" ? "the cue ball (scratch)" : `ball ${id}`));
  const expected = Object.fromEntries(names.map((name, ball) => [name, inWords(hits[ball]!)]));
  await expect.poll(() => chances(page)).toEqual(expected);
  await picture(page, "whatif");
});

test("another noise gives other chances, and the same noise the same", async ({ open }) => {
  const page = await open();
  await turnOn(page);
  const first = await chances(page);
  const like = page.getByLabel("Like");
  const own = await like.inputValue();
  await like.selectOption("Olympiad × 2");
  await expect.poll(() => chances(page)).not.toEqual(first);
  await finished(page);
  await like.selectOption(own);
  await expect.poll(() => chances(page)).toEqual(first);
});

test("every change of the aim simulates a thousand variants", async ({ open }) => {
  const page = await open({ viewport: SMALL });
  await turnOn(page);
  const first = await chances(page);
  await page.evaluate(() => {
    const { store } = window.carom!;
    document.querySelector<HTMLElement>("#variants")!.dataset.done = "false";
    store.strike({ azimuth_deg: store.document.shot.strike.azimuth_deg! + 1 }, "aim");
  });
  await finished(page);
  expect(await page.locator("#variants").textContent()).toMatch(/^1000 variants in \d+ ms$/);
  expect(await chances(page)).not.toEqual(first);
});

test("switching the simulation off hides the chances, and undo shows them again", async ({
  open,
}) => {
  const page = await open();
  await turnOn(page);
  await page.getByRole("switch").uncheck();
  expect(await page.locator("table.chances").isVisible()).toBe(false);
  await page.keyboard.press("Control+z");
  await page.locator("table.chances").waitFor({ state: "visible" });
  expect(await page.getByRole("switch").isChecked()).toBe(true);
});

test("an invalid seed is refused, and the old one stays", async ({ open }) => {
  const page = await open();
  await turnOn(page);
  const seed = page.locator("#panel-whatif").getByLabel("Seed");
  await seed.fill("-3");
  await seed.press("Enter");
  expect(await page.getByRole("alert").textContent()).toMatch(/whole number/);
  expect(await seed.inputValue()).toBe("0");
});

test("the worker also starts in a page from disk", async ({ open }) => {
  const page = await open({ url: `file://${inject("file")}` });
  await turnOn(page);
  expect(Object.keys(await chances(page)).length).toBeGreaterThan(1);
});

test("the rows of several reds have their numbers, and the table shows which ball a row is about", async ({
  open,
}) => {
  // Seen: fifteen rows "a red".
  const page = await open({ viewport: { width: 1280, height: 800 } });
  await page.locator("#tab-layout").click();
  const panel = page.locator("#panel-layout");
  await panel.getByLabel("Game", { exact: true }).selectOption("snooker");
  await panel.getByRole("button", { name: "Rack", exact: true }).click();
  await turnOn(page);
  await finished(page);
  const names = await page.locator(".chances th[scope=row]").allTextContents();
  expect(names.filter((name) => /^red \d+$/.test(name))).toHaveLength(15);
  expect(new Set(names).size).toBe(names.length);
  const row = page.locator('.chances tr:has(th:text-is("red 7"))');
  await row.hover();
  const area = () => page.evaluate(() => window.carom!.store.session.analysis.preview?.areas[0]);
  const [x, y] = (await shotOf(page)).balls.find(({ id }) => id === "red-7")!.position;
  const { outline } = (await area())!;
  for (const corner of outline) expect(Math.hypot(corner[0] - x, corner[1] - y)).toBeLessThan(0.06);
  await page.mouse.move(5, 5);
  expect(await area()).toBeUndefined();
});
