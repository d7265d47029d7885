/**
 * What an end-to-end test starts from: `test("…", async ({ open }) => …)`. A page that writes an
 * error to the console, or throws one, fails its test.
 */

import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { type Browser, type BrowserContextOptions, chromium, type Page } from "playwright-core";
import { expect, inject, test as base } from "vitest";
import type { ShotFile, TraceFile } from "../../src/engine/index.ts";

export { expect } from "vitest";

export interface OpenOptions extends BrowserContextOptions {
  /** The address's fragment, "#" included. */
  readonly hash?: string;
  /** Another page than the served one. */
  readonly url?: string;
  /** Leaves the first steps where they are; else they are dismissed. */
  readonly firstSteps?: boolean;
  /** Of the drawing; low unless a test is about pictures, for software draws them. */
  readonly quality?: "auto" | "low" | "high";
}

interface Fixtures {
  readonly browser: Browser;
  /** Opens the page in a window of its own and waits until it can be used. */
  readonly open: (options?: OpenOptions) => Promise<Page>;
}

/** How long (ms) the page may take to start on a machine that is busy with other tests. */
const STARTING = 15_000;

/** Desktop window of the budgets: at this size software rendering must be fluid. */
export const SMALL = { width: 800, height: 450 };
export const DESKTOP = { width: 1000, height: 640 };
export const PHONE = { width: 390, height: 844 };

export const test = base.extend<Fixtures>({
  // eslint-disable-next-line no-empty-pattern -- vitest reads the names of what a fixture needs
  browser: async ({}, use) => {
    const browser = await chromium.connect(inject("browser"));
    await use(browser);
    await browser.close();
  },
  open: async ({ browser }, use) => {
    const errors: string[] = [];
    await use(async ({ hash = "", url, firstSteps = false, quality = "low", ...options } = {}) => {
      const context = await browser.newContext({ viewport: DESKTOP, ...options });
      const page = await context.newPage();
      page.on("console", (message) => {
        if (message.type() === "error") errors.push(message.text());
      });
      page.on("pageerror", (error) => errors.push(error.message));
      await page.goto((url ?? inject("page")) + hash);
      await page.waitForFunction(
        () => performance.getEntriesByName("carom:interactive").length > 0,
        undefined,
        { timeout: STARTING },
      );
      await page.evaluate(
        ([dismissed, level]) => {
          window.carom!.viewer.quality = level;
          if (dismissed) {
            [...document.querySelectorAll("button")]
              .find(({ textContent }) => textContent === "Skip")
              ?.click();
          }
        },
        [!firstSteps, quality] as const,
      );
      return page;
    });
    expect(errors, "errors in the console").toEqual([]);
  },
});

/** The present shot file. */
export function shotOf(page: Page): Promise<ShotFile> {
  return page.evaluate(() => window.carom!.store.document.shot);
}

/** Waits until what was set in motion is drawn. */
export async function settled(page: Page): Promise<void> {
  await page.evaluate(
    () =>
      new Promise<void>((resolve) => {
        const look = (): void => {
          if (window.carom!.viewer.needsFrame) requestAnimationFrame(look);
          else resolve();
        };
        // What an event asked for happens in the next frame, and is drawn in it.
        requestAnimationFrame(() => requestAnimationFrame(look));
      }),
  );
}

/** Where a place of the table (m) is on the page (px). */
export async function onPage(page: Page, x: number, y: number, z = 0.028575): Promise<Spot> {
  const spot = await page.evaluate(([px, py, pz]) => window.carom!.viewer.project(px, py, pz), [
    x,
    y,
    z,
  ] as const);
  if (!spot) throw new Error(`(${x}, ${y}) is behind the camera`);
  return { x: spot[0], y: spot[1] };
}
export interface Spot {
  readonly x: number;
  readonly y: number;
}

const ROOT = fileURLToPath(new URL("../../..", import.meta.url));

/** The native engine's command: `CAROM`, else that of the checkout's virtual environment. */
export const NATIVE = process.env.CAROM ?? `${ROOT}.venv/bin/carom`;

/** What the native engine makes of a shot. */
export function native(shot: ShotFile): TraceFile {
  if (!existsSync(NATIVE)) throw new Error(`${NATIVE} is missing: run "make setup", or set CAROM.`);
  const out = execFileSync(NATIVE, ["shot", "-", "--json"], {
    input: JSON.stringify(shot),
    maxBuffer: 1e9,
  });
  return JSON.parse(out.toString()) as TraceFile;
}

const OUT = fileURLToPath(new URL("./out/", import.meta.url));

/** Keeps a picture of the page under tests/e2e/out, to be looked at. */
export async function picture(page: Page, name: string): Promise<void> {
  mkdirSync(OUT, { recursive: true });
  await settled(page);
  await page.screenshot({ path: `${OUT}${name}.png` });
}
