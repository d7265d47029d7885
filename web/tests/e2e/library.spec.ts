/** The library: entries in folders, studies that one writes, reads, shares and prints. */

import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Page } from "playwright-core";
import { inject } from "vitest";
import { violations } from "./axe.ts";
import { contentsOf, DESKTOP, expect, newContext, PHONE, test, usable } from "./fixture.ts";

const EXAMPLE = new URL("../../../studies/twenty_positions.en.json", import.meta.url);

async function toLibrary(page: Page): Promise<void> {
  await page.getByRole("radio", { name: "Library", exact: true }).click();
}

const entries = (page: Page) => page.locator("#library-entries .entry strong").allTextContents();

test("a page with an embedded study opens it as a lesson", async ({ browser }) => {
  const html = readFileSync(inject("file"), "utf8");
  const study = readFileSync(new URL("../../../studies/twenty_positions.de.json", import.meta.url));
  const file = join(mkdtempSync(join(tmpdir(), "carom-")), "study.html");
  const embedded = JSON.stringify(JSON.parse(String(study))).replaceAll("<", "\\u003c");
  writeFileSync(
    file,
    html.replace(/(id="carom-document")>/, () => `id="carom-document">${embedded}`),
  );
  const page = await (await newContext(browser)).newPage();
  await page.goto(pathToFileURL(file).href);
  await page.locator("#lesson-next").waitFor();
  await page.locator("#lesson-next").click();
  const { lesson } = await page.evaluate(() => window.carom!.store.session);
  expect([lesson!.chapter, lesson!.id, lesson!.study.chapters.length]).toEqual([1, null, 20]);
  await page.context().close();
});

async function openExample(page: Page): Promise<void> {
  await toLibrary(page);
  await page.locator("#library-example").click();
  await page.locator("#lesson-next").waitFor();
}

/** Plays a shot of the table with the strike of the solution of the shown chapter, or another height. */
async function shoot(page: Page, height?: number): Promise<void> {
  await page.evaluate((given) => {
    const { store } = window.carom!;
    const { study, chapter } = store.session.lesson!;
    const solution = study.chapters[chapter]!.task!.solution!;
    store.strike({ ...solution, height: given ?? solution.height ?? 0 }, "test");
  }, height);
  await page.getByRole("button", { name: "Shoot", exact: true }).click();
}

test("positions are kept in folders, renamed, moved and deleted with undo, also after the tab was closed", async ({
  visit,
}) => {
  const user = await visit();
  const page = await user.open();
  await toLibrary(page);
  const list = page.locator("#library-list");
  await list.getByLabel("Name", { exact: true }).first().fill("Easy cut");
  await list.getByLabel("Folder", { exact: true }).first().fill("Monday");
  await page.locator("#library-save").click();
  await expect.poll(() => entries(page)).toEqual(["Easy cut"]);
  await expect.poll(() => list.locator("summary h3").textContent()).toBe("Monday");
  await list.getByText("Rename, move, delete").click();
  await list.getByLabel("Name", { exact: true }).last().fill("Cut");
  await list.getByLabel("Folder", { exact: true }).last().fill("Tuesday");
  await list.getByRole("button", { name: "Apply" }).click();
  await expect.poll(() => entries(page)).toEqual(["Cut"]);
  await expect.poll(() => list.locator("summary h3").textContent()).toBe("Tuesday");
  await list.getByText("Rename, move, delete").click();
  await list.getByRole("button", { name: "Delete Cut" }).click();
  await expect.poll(() => entries(page)).toEqual([]);
  await page.locator("#library-undo").click();
  await expect.poll(() => entries(page)).toEqual(["Cut"]);
  await page.close();

  const later = await user.open();
  await later.evaluate(() => window.carom!.store.strike({ azimuth_deg: 10 }, "test"));
  await toLibrary(later);
  await later.locator(".entry").click();
  await later.waitForFunction(() => window.carom!.store.document.shot.strike.azimuth_deg === 66.8);
  expect(await later.evaluate(() => window.carom!.store.session.activity)).toBe("analyse");
});

test("a study is written with marks, text and a task, stays, and goes on after the tab was closed", async ({
  visit,
}) => {
  const user = await visit();
  const page = await user.open();
  await page.evaluate(() => {
    const { store } = window.carom!;
    const marks = [{ kind: "circle", color: "red", center: [0.9, 2.1], radius: 0.4 }] as const;
    store.apply(({ shot }) => ({ shot: { ...shot, marks } }), "test");
  });
  await toLibrary(page);
  await page.locator("#library-study").click();
  await page.locator("#lesson-edit").click();
  await page.locator("#study-title").fill("Tomorrow");
  await page.locator("#study-title").press("Tab");
  await page.locator("#chapter-title").fill("A cut");
  await page.locator("#chapter-text").fill("First line.\n<b>Second</b> line.");
  await page.locator("#chapter-text").press("Tab");
  const facts = page.locator(".fact");
  await facts.filter({ hasText: "falls into the" }).locator("input").check();
  await page.locator("#task-take").click();
  await page.locator("#chapter-add").click();
  await expect.poll(() => page.locator("#lesson h2").textContent()).toBe("Chapter 2 of 2");
  await page.locator("#chapter-delete").click();
  await page.locator("#study-undo").click();
  await expect.poll(() => page.locator("#lesson h2").textContent()).toBe("Chapter 2 of 2");
  await page.locator("#chapter-up").click();
  await page.locator("#chapter-down").click();
  await page.reload();
  await usable(page);
  // The same study is open, and can still be changed.
  await page.locator("#lesson-edit").waitFor();
  await page.close();

  const later = await user.open();
  await toLibrary(later);
  await expect.poll(() => entries(later)).toEqual(["Tomorrow"]);
  await later.locator(".entry").click();
  const text = later.locator(".lesson-text");
  await expect.poll(() => text.textContent()).toBe("First line.\n<b>Second</b> line.");
  expect(await text.locator("b").count(), "text is only text").toBe(0);
  expect(await later.locator(".lesson-task").textContent()).toMatch(/^Task: ball 9 falls into the/);
  expect(await later.evaluate(() => window.carom!.store.document.shot.marks?.length)).toBe(1);
  await shoot(later);
  await expect.poll(() => later.locator(".lesson-said").textContent()).toBe("Solved.");
});

test("a task is tried, judged, and its solution shown; the position comes back", async ({
  visit,
}) => {
  const page = await (await visit()).open();
  const before = await page.evaluate(() => JSON.stringify(window.carom!.store.document.shot));
  await openExample(page);
  expect(await page.locator("#lesson h3").first().textContent()).toBe("Stop shot");
  await shoot(page, 0.3);
  const said = page.locator(".lesson-said");
  await expect.poll(() => said.textContent()).toMatch(/^(Not solved yet|Missed)/);
  await page.waitForFunction(() => window.carom!.store.session.mode === "aim");
  expect(await page.locator(".variations").count(), "it would show how").toBe(0);
  await shoot(page);
  await expect.poll(() => said.textContent()).toBe("Solved.");
  expect(await page.locator(".variations li").count()).toBe(3);
  await page.locator("#lesson-next").click();
  await page.locator("#lesson-solution").click();
  await page.waitForFunction(
    () => window.carom!.store.session.replay.trace?.outcome.pocketed.length === 1,
  );
  await page.locator("#lesson-close").click();
  await page.waitForFunction(() => window.carom!.store.session.lesson === null);
  expect(await page.evaluate(() => JSON.stringify(window.carom!.store.document.shot))).toBe(before);
});

test("a link opens a study read-only, in a fresh browser too, and it can be copied into the own library", async ({
  visit,
}) => {
  const page = await (await visit()).open();
  await openExample(page);
  await page.locator("#lesson-link").click();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toMatch(/#s=1\./);

  const other = await (await visit()).open(link.slice(link.indexOf("#")));
  await other.locator("#lesson-next").waitFor();
  expect(await other.locator("#lesson h2").textContent()).toBe("Twenty basic positions");
  expect(await other.locator("#lesson-edit").count()).toBe(0);
  await other.locator("#lesson-copy").click();
  await other.locator("#lesson-edit").waitFor();
  await other.locator("#lesson-close").click();
  await expect.poll(() => entries(other)).toEqual(["Twenty basic positions"]);
});

test("a study is saved as a file and opened from it; damaged files change nothing", async ({
  visit,
}) => {
  const page = await (await visit()).open();
  await openExample(page);
  const download = page.waitForEvent("download");
  await page.locator("#lesson-file").click();
  const saved = (await contentsOf(await download)).toString();
  expect(JSON.parse(saved)).toEqual(JSON.parse(readFileSync(EXAMPLE, "utf8")));
  await page.locator("#lesson-close").click();
  const give = (name: string, text: string) =>
    page
      .locator("#open-file")
      .setInputFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });
  const refusal = page.locator("#refusal");
  for (const [text, part] of [
    [saved.replace("carom-study/1", "carom-study/9"), "bad.json cannot be opened"],
    [saved.replace('"wpa-9ft"', '"wpa-99ft"'), "chapters[0].shot.table"],
    [saved.replace('"title"', '"script"'), "script"],
    [saved.slice(0, 900), "cannot be opened"],
  ] as const) {
    await give("bad.json", text);
    await expect.poll(() => refusal.textContent()).toContain(part);
    expect(await page.evaluate(() => window.carom!.store.session.lesson)).toBeNull();
    await page.evaluate(() => window.carom!.store.setSession({ refusal: null }));
  }
  await give("good.json", saved);
  await page.locator("#lesson-next").waitFor();
  expect(await page.locator("#lesson-edit").count()).toBe(0);
});

test("a damaged link of a study is refused with a sentence", async ({ visit }) => {
  const user = await visit();
  const page = await user.open();
  await openExample(page);
  await page.locator("#lesson-link").click();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const other = await user.open(link.slice(link.indexOf("#"), -40));
  await expect.poll(() => other.locator("#refusal").textContent()).not.toBe("");
  expect(await other.evaluate(() => window.carom!.store.session.lesson)).toBeNull();
});

test("a lesson is read with the keyboard alone", async ({ visit }) => {
  const page = await (await visit()).open();
  const entrance = page.getByRole("radio", { name: "Analyse", exact: true });
  await entrance.focus();
  // From the first entrance to the last one.
  await page.keyboard.press("ArrowLeft");
  await page.locator("#library-example").focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => page.evaluate(() => document.activeElement?.tagName)).toBe("H2");
  const title = () => page.locator("#lesson h3").first().textContent();
  await page.keyboard.press("PageDown");
  await expect.poll(title).toBe("Stop shot from far away");
  await page.keyboard.press("PageUp");
  await expect.poll(title).toBe("Stop shot");
  await page.locator("#lesson-next").focus();
  await page.keyboard.press("Enter");
  await expect.poll(title).toBe("Stop shot from far away");
  expect(await page.evaluate(() => document.activeElement?.id)).toBe("lesson-next");
  await page.locator("#lesson-solution").focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => window.carom!.store.session.mode === "replay");
});

test("printing gives the chapters, with their solutions once they were shown", async ({
  visit,
}) => {
  const page = await (await visit()).open();
  await openExample(page);
  const printed = () =>
    page.evaluate(() => {
      dispatchEvent(new Event("beforeprint"));
      const figures = [...document.querySelectorAll(".print-diagrams figure")];
      const found = figures.map((figure) => ({
        title: figure.querySelector("figcaption")!.textContent,
        text: figure.querySelector("p")!.textContent,
        paths: figure.querySelectorAll("path[stroke='#000000']").length,
      }));
      dispatchEvent(new Event("afterprint"));
      return found;
    });
  const plain = await printed();
  expect(plain).toHaveLength(20);
  expect(plain[0]).toMatchObject({ title: "1. Stop shot" });
  expect(plain[0]!.text).toContain("Pot the 1");
  await page.evaluate(() => {
    globalThis.print = () => undefined;
  });
  await page.locator("#lesson-solution").click();
  await page.locator("#lesson-print").click();
  expect((await printed())[0]!.paths).toBeGreaterThan(plain[0]!.paths);
});

test.for([
  { size: DESKTOP, scheme: "light" },
  { size: DESKTOP, scheme: "dark" },
  { size: PHONE, scheme: "light" },
  { size: PHONE, scheme: "dark" },
] as const)(
  "library, lesson and editor have no fault of accessibility: $size.width px, $scheme",
  async ({ size, scheme }, { visit }) => {
    const page = await (await visit({ viewport: size })).open();
    await page.emulateMedia({ colorScheme: scheme, reducedMotion: "reduce" });
    await openExample(page);
    expect(await violations(page), "lesson").toEqual([]);
    await page.locator("#lesson-copy").click();
    await page.locator("#lesson-edit").click();
    expect(await violations(page), "editor").toEqual([]);
    await page.locator("#lesson-read").click();
    await page.locator("#lesson-close").click();
    await expect.poll(() => entries(page)).toHaveLength(1);
    await page.locator("#library-list").getByText("Rename, move, delete").click();
    expect(await violations(page), "list").toEqual([]);
  },
);
