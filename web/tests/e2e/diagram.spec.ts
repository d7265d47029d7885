/** Diagrams for paper: files, and what the browser prints. */

import { mkdirSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Page } from "playwright-core";
import { contentsOf, DESKTOP, expect, test } from "./fixture.ts";

const OUT = fileURLToPath(new URL("./out/", import.meta.url));

/** Numbers of the pages of a PDF, and their sizes, points. */
function pagesOf(pdf: Buffer): { readonly count: number; readonly boxes: readonly string[] } {
  const text = pdf.toString("latin1");
  const boxes = [...text.matchAll(/\/MediaBox\s*\[([^\]]*)\]/g)].map(([, box]) => box!.trim());
  return { count: [...text.matchAll(/\/Type\s*\/Page\b(?!s)/g)].length, boxes };
}

async function saved(page: Page, button: string): Promise<Buffer> {
  const [file] = await Promise.all([page.waitForEvent("download"), page.locator(button).click()]);
  mkdirSync(OUT, { recursive: true });
  return contentsOf(file);
}

async function printed(page: Page, name: string): Promise<Buffer> {
  const pdf = await page.pdf({ preferCSSPageSize: true, printBackground: true });
  mkdirSync(OUT, { recursive: true });
  writeFileSync(`${OUT}${name}.pdf`, pdf);
  return pdf;
}

test("Ctrl+P prints the diagram on one lying page, and nothing of the interface", async ({
  open,
}) => {
  const page = await open({ viewport: DESKTOP, reducedMotion: "reduce" });
  const { count, boxes } = pagesOf(await printed(page, "diagram-print"));
  expect(count).toBe(1);
  const [, , width, height] = boxes[0]!.split(/\s+/).map(Number);
  expect(Math.round((width! / 72) * 25.4)).toBe(297);
  expect(Math.round((height! / 72) * 25.4)).toBe(210);
  // Afterwards the page is as before.
  expect(await page.locator(".print-diagrams").count()).toBe(0);
  expect(await page.locator("body").getAttribute("data-printing")).toBeNull();
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  const shown = await page.evaluate(() =>
    [...document.body.children]
      .filter((element) => getComputedStyle(element).display !== "none")
      .map(({ className }) => className),
  );
  expect(shown).toEqual(["print-diagrams"]);
  expect(await page.locator(".print-diagrams svg path").count()).toBeGreaterThan(0);
});

test("all shots of the analysis are printed on letter, two on a page", async ({ open }) => {
  const page = await open({ viewport: DESKTOP, reducedMotion: "reduce" });
  await page.evaluate(() => {
    const { store } = window.carom!;
    const { shot } = store.document;
    const nodes = [1, 2, 3].map((id) => ({ id, parent: null, shot, comment: `Idea ${id}` }));
    store.apply({ tree: { nodes, at: 1 } }, "three shots");
  });
  await page.locator("#share-button").click();
  const section = page.locator("#share-diagram");
  await section.getByLabel("What").selectOption("all");
  await section.getByLabel("Paper").selectOption("letter");
  await section.getByLabel("Diagrams on a page").selectOption("2");
  await page.locator("#close-share").click();
  const { count, boxes } = pagesOf(await printed(page, "diagram-two"));
  expect(count).toBe(2);
  const [, , width, height] = boxes[0]!.split(/\s+/).map(Number);
  expect([Math.round(width!), Math.round(height!)]).toEqual([612, 792]);
});

test("the diagram is an SVG that needs no style sheet, and a PNG", async ({ open }) => {
  const page = await open({ viewport: DESKTOP, reducedMotion: "reduce" });
  await page.locator("#share-button").click();
  const text = (await saved(page, "#diagram-svg")).toString("utf8");
  writeFileSync(`${OUT}diagram.svg`, text);
  expect(text).toMatch(/^<svg [^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
  expect(text).not.toContain("class=");
  expect(text.match(/<circle/g)!.length).toBeGreaterThan(10);
  const pixels = await saved(page, "#diagram-png");
  writeFileSync(`${OUT}diagram.png`, pixels);
  expect(pixels.subarray(1, 4).toString("latin1")).toBe("PNG");
  expect(pixels.readUInt32BE(16)).toBe(2400);
});
