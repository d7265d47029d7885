/** The tree of shots, and the variations of a game: comments, branches, text, links and records. */

import type { Page } from "playwright-core";
import type { FrameRecord } from "../../src/engine/index.ts";
import { contentsOf, expect, PHONE, pressTool, shotOf, storeNow, test } from "./fixture.ts";

const WIDE = { width: 1280, height: 800 };
const CLIPBOARD = { permissions: ["clipboard-read", "clipboard-write"] };

const treeOf = (page: Page) =>
  page.evaluate(() => {
    const { nodes, at } = window.carom!.store.document.tree!;
    return {
      at,
      nodes: nodes.map(({ id, parent, comment, shot }) => ({
        id,
        parent,
        comment,
        azimuth: shot.strike.azimuth_deg,
      })),
    };
  });

/** Aims, shoots and returns to aiming. */
async function play(page: Page, azimuth_deg: number): Promise<void> {
  await page.evaluate((to) => window.carom!.store.strike({ azimuth_deg: to }, "aim"), azimuth_deg);
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.getByRole("button", { name: "Back to aiming" }).click();
}

const rows = (page: Page) => page.locator("#panel-tree .node").allTextContents();

for (const [name, viewport] of [
  ["desktop", WIDE],
  ["phone", PHONE],
] as const) {
  test(`shots are branched, commented, copied and opened as text on a ${name}`, async ({
    open,
  }) => {
    const page = await open({ viewport, reducedMotion: "reduce", ...CLIPBOARD });
    await play(page, 66.8);
    await page.getByRole("button", { name: "Shoot" }).click();
    await page.getByRole("button", { name: "Take it from here" }).click();
    await play(page, 200);
    await page.locator("#tab-tree").click();
    const panel = page.locator("#panel-tree");
    await panel.locator(".node").first().click();
    // Another shot from the same place.
    await play(page, 90);
    const { nodes, at } = await treeOf(page);
    expect(nodes.map(({ parent, azimuth }) => [parent, azimuth])).toEqual([
      [null, 66.8],
      [1, 200],
      [null, 90],
    ]);
    expect(at).toBe(3);
    if (!(await panel.isVisible())) await page.locator("#tab-tree").click();
    await panel.getByLabel("Comment").fill("safe, if soft");
    await panel.getByLabel("Comment").blur();
    expect((await rows(page)).at(-1)).toContain("safe, if soft");

    // Seen: the curve had neither a title nor numbers.
    await panel.getByText("Chance of each pot: 0 % at the bottom").waitFor();
    await panel.getByText("As text", { exact: true }).click();
    // Seen: the text was empty until Copy was pressed.
    const asText = panel.getByLabel("The shots as text");
    await expect.poll(() => asText.inputValue()).toContain("{safe, if soft} *");
    await panel.getByRole("button", { name: "Copy" }).click();
    const text = await page.evaluate(() => navigator.clipboard.readText());
    expect(text).toMatch(/^\[Carom "tree\/1"\]\n\[Layout .*\]\n1\. "cue" /);
    expect(text).toContain("{safe, if soft} *");

    await panel.getByRole("button", { name: "Delete with all that follow" }).click();
    expect((await treeOf(page)).nodes.length).toBe(2);
    await panel.getByLabel("The shots as text").fill(text);
    await panel.getByRole("button", { name: "Open this text" }).click();
    // The text is read in tasks of one shot each.
    await expect.poll(async () => (await treeOf(page)).nodes.length).toBe(3);
    const back = await treeOf(page);
    expect(back.nodes.map(({ azimuth }) => azimuth).sort()).toEqual([200, 66.8, 90]);
    expect(back.nodes.find(({ id }) => id === back.at)!.comment).toBe("safe, if soft");
    expect((await shotOf(page)).strike!.azimuth_deg).toBe(90);

    await panel.getByLabel("The shots as text").fill(text.replace("azimuth_deg=90", "force=9"));
    await panel.getByRole("button", { name: "Open this text" }).click();
    await page.getByText(/cannot be read at “force=9”/).waitFor();
    // Seen: the notice of an earlier action stood beside the refusal.
    expect(await page.locator("#notice").textContent()).toBe("");
    expect(await treeOf(page)).toEqual(back);
  });
}

test("a shot of the list is visited by the first press after a comment is written", async ({
  open,
}) => {
  // The comment is kept when it loses the focus, between press and release, and the list was made again.
  const page = await open({ viewport: WIDE, reducedMotion: "reduce" });
  await play(page, 66.8);
  await play(page, 90);
  await page.locator("#tab-tree").click();
  const panel = page.locator("#panel-tree");
  await panel.getByLabel("Comment").fill("safe");
  await panel.locator(".node").first().click();
  expect((await treeOf(page)).at).toBe(1);
  expect((await rows(page)).at(-1)).toContain("safe");
});

test("pockets in the list of shots have the names of the picture when a link opens", async ({
  open,
}) => {
  // Seen: "right side pocket" where the picture and the rest of the page said "bottom side".
  const page = await open({ viewport: WIDE, reducedMotion: "reduce" });
  await page.evaluate(() => window.carom!.store.aimAtPocket("9", "right", "pot"));
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.getByRole("button", { name: "Back to aiming" }).click();
  await page.locator("#tab-tree").click();
  const named = page.locator("#panel-tree .node").first();
  await named.filter({ hasText: "bottom side pocket" }).waitFor();
  await storeNow(page);
  const hash = await page.evaluate(() => location.hash);
  const other = await open({ viewport: WIDE, hash });
  await other.locator("#tab-tree").click();
  const there = other.locator("#panel-tree .node").first();
  expect(await there.textContent()).toContain("bottom side pocket");
  // The table stands upright: the names of the list follow.
  await other.setViewportSize(PHONE);
  await there.filter({ hasText: "right side pocket" }).waitFor({ state: "attached" });
});

test("a link opens at the selected shot of its tree", async ({ open }) => {
  const page = await open({ viewport: WIDE, reducedMotion: "reduce" });
  await play(page, 66.8);
  await play(page, 90);
  await page.locator("#tab-tree").click();
  await page.locator("#panel-tree .node").first().click();
  const kept = await treeOf(page);
  // The link of the Share dialog has the present state at once.
  await pressTool(page, "Share");
  const hash = new URL(await page.locator("#share-dialog input").inputValue()).hash;
  const other = await open({ viewport: WIDE, hash });
  expect((await shotOf(other)).strike!.azimuth_deg).toBe(66.8);
  const opened = await treeOf(other);
  expect(opened.nodes.find(({ id }) => id === opened.at)!.azimuth).toBe(66.8);
  expect(opened.nodes.length).toBe(kept.nodes.length);
});

test("one undo takes back one shot", async ({ open }) => {
  const page = await open({ viewport: WIDE, reducedMotion: "reduce" });
  await page.evaluate(() => window.carom!.store.strike({ azimuth_deg: 90 }, "aim"));
  const before = await shotOf(page);
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.getByRole("button", { name: "Take it from here" }).click();
  expect((await treeOf(page)).nodes.length).toBe(1);
  await page.getByRole("button", { name: /^Undo/ }).click();
  expect(await shotOf(page)).toEqual(before);
  expect(await page.evaluate(() => window.carom!.store.document.tree?.nodes.length ?? 0)).toBe(0);
});

async function begin(page: Page): Promise<void> {
  await page.getByRole("radio", { name: "Play" }).click();
  const panel = page.locator("#panel-game");
  await panel.getByLabel("Played by").nth(1).selectOption("");
  await panel.getByText("Rack and table").click();
  await panel.getByLabel("Seed of the rack").fill("7");
  await panel.getByRole("button", { name: "Start the game" }).click();
}

const gameOf = (page: Page) => page.evaluate(() => window.carom!.store.document.game);

for (const [name, viewport] of [
  ["desktop", WIDE],
  ["phone", PHONE],
] as const) {
  test(`a shot of a game is analysed, and its record has the variations, on a ${name}`, async ({
    open,
    close,
  }) => {
    const page = await open({ viewport, reducedMotion: "reduce", ...CLIPBOARD });
    await begin(page);
    await page.evaluate(() => window.carom!.store.strike({ speed: 4 }, "aim"));
    await page.getByRole("button", { name: "Shoot" }).click();
    await expect.poll(async () => (await gameOf(page))!.moves.length).toBe(1);
    const table = await page.locator("#table").boundingBox();
    if (!(await page.locator("#panel-game").isVisible())) await page.locator("#tab-game").click();
    await page.getByRole("button", { name: "Analyse move 1" }).click();
    expect(await gameOf(page)).toBeNull();
    await page.getByText(/^Move 1 of the game, by Player 1/).waitFor();
    await play(page, 91.5);
    expect(await page.locator("#table").boundingBox()).toEqual(table);
    await page.locator("#tab-tree").click();
    expect(await rows(page)).toEqual([
      expect.stringMatching(/^1\. As played: /),
      expect.stringMatching(/^1\. (?!As played)/),
    ]);
    await page.locator("#panel-tree").getByLabel("Comment").fill("fuller");
    await page.locator("#close-study").click();
    const { moves, variations } = (await gameOf(page))!;
    expect(moves.length).toBe(1);
    expect(variations![0]).toContain("{fuller}");
    await expect
      .poll(() => page.locator("#panel-game .record").textContent())
      .toContain("1 variation");

    await pressTool(page, "Share");
    await page.locator("#copy-game-python").click();
    await page.getByText("The game is copied as a Python program.").waitFor();
    const program = await page.evaluate(() => navigator.clipboard.readText());
    expect(program).toContain("carom.Frame.replay({");
    expect(program).not.toContain("tree/1");
    const [file] = await Promise.all([
      page.waitForEvent("download"),
      page.locator("#download-record").click(),
    ]);
    expect(file.suggestedFilename()).toBe("frame.json");
    const json = (await contentsOf(file)).toString();
    const record = JSON.parse(json) as FrameRecord;
    expect(record.moves[0]).toHaveProperty("variations", variations![0]);
    await close(page);

    const other = await open({ viewport, reducedMotion: "reduce" });
    const buffer = Buffer.from(json);
    await other
      .locator("#open-file")
      .setInputFiles({ name: "frame.json", mimeType: "application/json", buffer });
    await other.locator("#game-bar:not([hidden])").waitFor();
    expect((await gameOf(other))!.variations).toEqual(variations);
    expect((await gameOf(other))!.moves).toEqual(moves);
  });
}
