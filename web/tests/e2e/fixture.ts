/**
 * Fixtures of the end-to-end tests: `test("…", async ({ open }) => …)`. An error on the console, or an
 * uncaught one, fails the test.
 */

import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import {
  type Browser,
  type BrowserContext,
  type BrowserContextOptions,
  chromium,
  type Page,
} from "playwright-core";
import { expect, inject, test as base } from "vitest";
import type { ShotFile, TraceFile } from "../../src/engine/index.ts";

export { expect } from "vitest";

export interface OpenOptions extends BrowserContextOptions {
  /** Fragment of the address, with its "#". */
  readonly hash?: string;
  /** Address of another page. */
  readonly url?: string;
  /** Whether the first steps stay open. Default false. */
  readonly firstSteps?: boolean;
  /** Quality of the drawing. Default low, because software draws it. */
  readonly quality?: "auto" | "low" | "high";
}

interface Fixtures {
  readonly browser: Browser;
  /** Opens the page in a new window and waits until it is usable. */
  readonly open: (options?: OpenOptions) => Promise<Page>;
}

/** Time (ms) that the page may take to start on a busy machine. */
const STARTING = 60_000;

/** Time (ms) that an action or a wait may take. */
const WAITING = 60_000;

/** Window of the performance budgets, at which software rendering must be fluent. */
export const SMALL = { width: 800, height: 450 };
export const DESKTOP = { width: 1000, height: 640 };
export const PHONE = { width: 390, height: 844 };

export const test = base.extend<Fixtures>({
  browser: [
    // eslint-disable-next-line no-empty-pattern -- vitest reads the parameter names of a fixture
    async ({}, use) => {
      const browser = await chromium.connect(inject("browser"));
      await use(browser);
      await browser.close();
    },
    // One connection per file; `open` closes its windows after each test.
    { scope: "file" },
  ],
  open: async ({ browser }, use) => {
    const errors: string[] = [];
    const contexts: BrowserContext[] = [];
    await use(async ({ hash = "", url, firstSteps = false, quality = "low", ...options } = {}) => {
      const context = await browser.newContext({ viewport: DESKTOP, ...options });
      contexts.push(context);
      context.setDefaultTimeout(WAITING);
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
    for (const context of contexts) await context.close();
    expect(errors, "errors in the console").toEqual([]);
  },
});

/** The present shot file. */
export function shotOf(page: Page): Promise<ShotFile> {
  return page.evaluate(() => window.carom!.store.document.shot);
}

/** Waits until all pending changes are drawn. */
export async function settled(page: Page): Promise<void> {
  await page.evaluate(
    () =>
      new Promise<void>((resolve) => {
        const look = (): void => {
          if (window.carom!.viewer.needsFrame) requestAnimationFrame(look);
          else resolve();
        };
        // The change that an event requests happens, and is drawn, in the next frame.
        requestAnimationFrame(() => requestAnimationFrame(look));
      }),
  );
}

/** Position of a place of the table (m) on the page (px). */
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

/** The native engine's command: `CAROM`, by default from the checkout's virtual environment. */
export const NATIVE = process.env.CAROM ?? `${ROOT}.venv/bin/carom`;

/** The native engine's trace of a shot. */
export function native(shot: ShotFile): TraceFile {
  if (!existsSync(NATIVE)) throw new Error(`${NATIVE} is missing: run "make setup", or set CAROM.`);
  const out = execFileSync(NATIVE, ["shot", "-", "--json"], {
    input: JSON.stringify(shot),
    maxBuffer: 1e9,
  });
  return JSON.parse(out.toString()) as TraceFile;
}

const OUT = fileURLToPath(new URL("./out/", import.meta.url));

/** Saves a picture of the page under tests/e2e/out. */
export async function picture(page: Page, name: string): Promise<void> {
  mkdirSync(OUT, { recursive: true });
  await settled(page);
  await page.screenshot({ path: `${OUT}${name}.png` });
}
