/** The page of a report: axe, and nothing that is cut, on a phone, on a desktop and on paper. */

import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Page } from "playwright-core";
import { violationsOf } from "./axe.ts";
import { expect, PHONE, test } from "./fixture.ts";
import { python } from "./python.ts";

/** A tournament of three players with measured luck, and a sequential test. */
const PROGRAM = `
import sys
from carom.arena import Tournament
from carom.arena.report import read_report
from carom.arena.report_page import report_html

folder = sys.stdin.read()
long = "a player with a long name"
settings = {"game": "nine-ball", "pairs": 2}
file = {
    "format": "carom-tournament/1",
    "secret": "7" * 64,
    "players": ["greedy:9", {"name": long, "player": "pool-master:9"}, "deep-green-0:9"],
    "events": [
        {"name": "all", "type": "round-robin", "noise": ["olympiad", "club"], "luck": 4, **settings},
        {"name": "test", "type": "test", "players": ["greedy:9", long], "nelo": [-5, 90], **settings},
    ],
}
Tournament(file).run(folder)
open(folder + "/report.html", "w").write(report_html(read_report(folder), title="Report"))
`;

let address = "";

/** The address of the report, which is written once. */
function report(): string {
  if (address === "") {
    const folder = mkdtempSync(join(tmpdir(), "carom-report-"));
    process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
    python(PROGRAM, folder);
    address = pathToFileURL(join(folder, "report.html")).href;
  }
  return address;
}

/** What reaches beyond the right edge of the page, apart from tables that scroll. */
function cut(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const width = document.documentElement.clientWidth;
    const isScrolled = (element: Element) =>
      element.closest(".wide") !== null && matchMedia("screen").matches;
    return [...document.querySelectorAll("main *")]
      .filter((element) => element.checkVisibility() && !isScrolled(element.parentElement!))
      .filter((element) => element.getBoundingClientRect().right > width + 0.5)
      .map((element) => element.outerHTML.slice(0, 80));
  });
}

for (const [name, viewport] of [
  ["phone", PHONE],
  ["desktop", { width: 1280, height: 800 }],
] as const) {
  for (const colorScheme of ["light", "dark"] as const) {
    test(`axe finds no violation in a report on a ${name} in ${colorScheme}`, async ({ open }) => {
      const url = report();
      const page = await open();
      await page.setViewportSize(viewport);
      await page.emulateMedia({ colorScheme });
      await page.goto(url);
      await page.locator("summary").first().click();
      expect(await violationsOf(page)).toEqual([]);
      expect(await cut(page)).toEqual([]);
    });
  }
}

test("on a phone a name stays in sight and is not broken into letters", async ({ open }) => {
  const url = report();
  const page = await open();
  await page.setViewportSize(PHONE);
  await page.goto(url);
  const table = page.getByRole("region", { name: /^nine-ball, noise club.* Players/ });
  const head = table.getByRole("rowheader", { name: "greedy:9" });
  const before = (await head.boundingBox())!;
  // A line of text is 24 px high.
  expect(before.height).toBeLessThan(60);
  expect(before.width).toBeLessThan(140);
  await table.evaluate((element) => element.scrollTo(1000, 0));
  expect(await table.evaluate((element) => element.scrollLeft)).toBeGreaterThan(50);
  expect((await head.boundingBox())!.x).toBeCloseTo(before.x, 0);
});

test("the curve of a game has the luck that was measured in its match", async ({ open }) => {
  const url = report();
  const page = await open();
  await page.goto(url);
  await page.locator("summary").first().click();
  await page.getByRole("link", { name: "frame 1" }).first().click();
  const viewer = page.frameLocator("iframe");
  await viewer.getByRole("tab", { name: "Game" }).click();
  const curve = viewer.getByRole("img", { name: /^Chance of .+ to win/ });
  await curve.waitFor();
  // Each shot is a solid step, its decision, and a dashed one, its luck.
  await viewer.getByText(/solid lines are decisions, dashed lines are luck/).waitFor();
  const steps = (kind: string) => curve.locator(`.${kind}`).count();
  expect(await steps("luck")).toBeGreaterThan(2);
  expect(await steps("decision")).toBe(await steps("luck"));
});

test("on paper no table is cut", async ({ open }) => {
  const url = report();
  const page = await open();
  await page.goto(url);
  await page.emulateMedia({ media: "print" });
  // A4 with margins of 1 cm.
  await page.setViewportSize({ width: 718, height: 1047 });
  expect(await cut(page)).toEqual([]);
  expect(await page.locator("summary").first().isVisible()).toBe(false);
  await page.emulateMedia({ media: null });
});
