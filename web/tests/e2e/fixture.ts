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
  type Download,
  type Frame,
  type Page,
} from "playwright-core";
import { expect, inject, test as base, vi } from "vitest";
import type { ShotFile, TraceFile } from "../../src/engine/index.ts";
import type { Quality } from "../../src/viewer/viewer-types.ts";

export { expect } from "vitest";

/** `coarse` is low with fewer pixels, for tests that look at no pixel of the table. */
type Drawing = Quality | "coarse";

/** Pixels of the table per CSS pixel at quality coarse. Software needs a tenth of a second for all. */
const COARSE = 0.25;

export interface OpenOptions extends BrowserContextOptions {
  /** Fragment of the address, with its "#". */
  readonly hash?: string;
  /** Address of another page. */
  readonly url?: string;
  /** Whether the page opens for the first time in this browser, with the first steps. Default false. */
  readonly firstSteps?: boolean;
  /** Quality of the drawing. Default coarse, because software draws it. */
  readonly quality?: Drawing;
}

interface Fixtures {
  readonly browser: Browser;
  readonly tabs: Tabs;
  /** Opens the page in a tab of its own and waits until it is usable. */
  readonly open: (options?: OpenOptions) => Promise<Page>;
  /** Closes the page before the end of its test, so that the next one opens in its tab. */
  readonly close: (page: Page) => Promise<void>;
  /** A browser with a storage of its own, which lasts until the end of the test. */
  readonly visit: (options?: VisitOptions) => Promise<User>;
}

export interface VisitOptions {
  readonly viewport?: typeof PHONE;
  /** Runs in each page before its own scripts. */
  readonly script?: () => void;
}

export interface User {
  readonly context: BrowserContext;
  readonly open: (hash?: string) => Promise<Page>;
}

/** Time (ms) that the page may take to start on a busy machine. */
const STARTING = 120_000;

/** Time (ms) that an action or a wait may take. */
export const WAITING = 60_000;

/** Window of the performance budgets, at which software rendering must be fluent. */
export const SMALL = { width: 800, height: 450 };
export const DESKTOP = { width: 1000, height: 640 };
export const PHONE = { width: 390, height: 844 };

/** A tab in use. */
interface Used {
  /** Options that are fixed for the life of the tab. */
  readonly kind: string;
  readonly page: Page;
}

/**
 * The tabs of a file. A test gets a new document in a tab that an earlier test has left: the browser's
 * process for the tab has the page's scripts, WebAssembly and shaders compiled already. What the page keeps
 * of a test is deleted, except a language that the user chose: a test that chooses one has a tab of its own.
 */
class Tabs {
  readonly #browser: Browser;
  /** Free tabs by kind. */
  readonly #free = new Map<string, Page[]>();
  readonly #used: Used[] = [];

  constructor(browser: Browser) {
    this.#browser = browser;
  }

  /** An empty tab. */
  async take(
    fixed: BrowserContextOptions,
    quality: Drawing,
    origin: string,
    isFirst: boolean,
  ): Promise<Page> {
    const kind = JSON.stringify([fixed, quality, origin, isFirst]);
    const page = this.#free.get(kind)?.pop() ?? (await this.#create(fixed, quality, isFirst));
    this.#used.push({ kind, page });
    return page;
  }

  /** Empties all tabs in use and makes them free. */
  async releaseAll(): Promise<void> {
    for (const { page } of [...this.#used]) await this.release(page);
  }

  /** Empties a tab and makes it free, unless a test has closed it. */
  async release(page: Page): Promise<void> {
    const at = this.#used.findIndex((one) => one.page === page);
    const [{ kind }] = this.#used.splice(at, 1) as [Used];
    if (page.isClosed()) return;
    page.removeAllListeners();
    await page.goto("about:blank");
    const session = await page.context().newCDPSession(page);
    await session.send("Page.resetNavigationHistory");
    // The next test has nothing to continue.
    const storage = { origin: new URL(inject("page")).origin, storageTypes: "indexeddb" };
    await session.send("Storage.clearDataForOrigin", storage);
    await session.detach();
    this.#free.set(kind, [...(this.#free.get(kind) ?? []), page]);
  }

  async #create(fixed: BrowserContextOptions, quality: Drawing, isFirst: boolean): Promise<Page> {
    const context = await newContext(this.#browser, {
      locale: "en-GB",
      serviceWorkers: "block",
      ...fixed,
    });
    await context.addInitScript((first) => {
      try {
        if (first) localStorage.removeItem("carom-first-steps");
        else localStorage.setItem("carom-first-steps", "1");
      } catch {
        // A frame of another origin has no storage.
      }
    }, isFirst);
    // Before the first picture, and before every later one.
    await context.addInitScript(
      ([level, scale]) => {
        let carom: Window["carom"];
        Object.defineProperty(window, "carom", {
          get: () => carom,
          set(value: NonNullable<Window["carom"]>) {
            carom = value;
            carom.viewer.quality = level;
          },
        });
        if (scale !== null) Object.assign(window, { devicePixelRatio: scale });
      },
      quality === "coarse" ? (["low", COARSE] as const) : ([quality, null] as const),
    );
    return context.newPage();
  }
}

export const test = base.extend<Fixtures>({
  browser: [
    // eslint-disable-next-line no-empty-pattern -- vitest reads the parameter names of a fixture
    async ({}, use) => {
      const browser = await chromium.connect(inject("browser"));
      await use(browser);
      await browser.close();
    },
    // One connection per file.
    { scope: "file" },
  ],
  tabs: [
    async ({ browser }, use) => {
      await use(new Tabs(browser));
    },
    { scope: "file" },
  ],
  open: async ({ tabs }, use) => {
    const errors: string[] = [];
    await use(
      async ({ hash = "", url, firstSteps = false, quality = "coarse", ...options } = {}) => {
        const {
          viewport = DESKTOP,
          colorScheme = "light",
          reducedMotion = "no-preference",
          ...fixed
        } = options;
        const address = (url ?? inject("page")) + hash;
        const page = await tabs.take(fixed, quality, new URL(address).protocol, firstSteps);
        page.on("console", (message) => {
          if (message.type() === "error") errors.push(message.text());
        });
        page.on("pageerror", (error) => errors.push(error.message));
        await page.setViewportSize(viewport!);
        await page.emulateMedia({ colorScheme, reducedMotion });
        await page.goto(address);
        await usable(page);
        return page;
      },
    );
    await tabs.releaseAll();
    expect(errors, "errors in the console").toEqual([]);
  },
  visit: async ({ browser }, use) => {
    const contexts: BrowserContext[] = [];
    const errors: string[] = [];
    await use(async ({ viewport = DESKTOP, script } = {}) => {
      const context = await newContext(browser, {
        locale: "en-GB",
        serviceWorkers: "block",
        reducedMotion: "reduce",
        viewport,
        permissions: ["clipboard-read", "clipboard-write"],
      });
      contexts.push(context);
      await context.addInitScript(() => localStorage.setItem("carom-first-steps", "1"));
      if (script) await context.addInitScript(script);
      const open = async (hash = "") => {
        const page = await context.newPage();
        page.on("pageerror", (error) => errors.push(error.message));
        await page.goto(inject("page") + hash);
        await usable(page);
        return page;
      };
      return { context, open };
    });
    for (const context of contexts) await context.close();
    expect(errors, "uncaught errors").toEqual([]);
  },
  close: async ({ tabs }, use) => {
    await use((page) => tabs.release(page));
  },
});

/** A context whose actions wait as long as a busy machine needs, and whose pages draw the same numbers. */
export async function newContext(
  browser: Browser,
  options?: BrowserContextOptions,
): Promise<BrowserContext> {
  const context = await browser.newContext(options);
  context.setDefaultTimeout(WAITING);
  await fixRandom(context);
  return context;
}

/** Waits until the page is usable: its first picture is drawn. */
export async function usable(page: Page | Frame): Promise<void> {
  // Asked again each time: a frame that moves to another process of the browser loses a wait inside it.
  await vi.waitFor(
    async () => {
      const reached = await page.evaluate(() => ({
        marks: performance.getEntriesByType("mark").map(({ name }) => name),
        document: document.readyState,
        visibility: document.visibilityState,
        refusal: document.getElementById("refusal")?.textContent,
      }));
      if (reached.marks.includes("carom:interactive")) return;
      throw new Error(`The page has not started: ${JSON.stringify(reached)}`);
    },
    { timeout: STARTING, interval: 50 },
  );
}

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
          if (window.carom!.viewer.needsPicture) requestAnimationFrame(look);
          else resolve();
        };
        // The change that an event requests happens, and is drawn, in the next frame.
        requestAnimationFrame(() => requestAnimationFrame(look));
      }),
  );
}

/** Presses a tool of the header. On a narrow screen it is in a menu. */
export async function pressTool(page: Page, name: string): Promise<void> {
  const button = page.getByRole("button", { name, exact: true });
  if (!(await button.isVisible())) await page.locator("#tools-button").click();
  await button.click();
}

/** The contents of a saved file. */
export async function contentsOf(file: Download): Promise<Buffer> {
  const chunks: Buffer[] = [];
  for await (const chunk of await file.createReadStream()) chunks.push(chunk as Buffer);
  return Buffer.concat(chunks);
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

/**
 * Each page draws the same numbers after it is loaded, so that a test plays the same racks every time: after some
 * breaks there is a choice instead of a shot. The generator is Park & Miller's (1988).
 */
async function fixRandom(context: BrowserContext): Promise<void> {
  await context.addInitScript(() => {
    let state = 1;
    Math.random = () => (state = (16807 * state) % 2147483647) / 2147483647;
  });
}

/** Lets the page store its last changes and write them into its address, as it does before it is left. */
export async function storeNow(page: Page): Promise<void> {
  await page.evaluate(() => dispatchEvent(new PageTransitionEvent("pagehide")));
}

/** Saves a picture of the page under tests/e2e/out, with a pixel of the table per CSS pixel. */
export async function picture(page: Page, name: string): Promise<void> {
  mkdirSync(OUT, { recursive: true });
  await page.evaluate(drawAt, 1);
  await settled(page);
  await page.screenshot({ path: `${OUT}${name}.png` });
  await page.evaluate(drawAt, COARSE);
}

/** Runs in the page: draws at quality low with `scale` pixels per CSS pixel. */
function drawAt(scale: number): void {
  Object.assign(window, { devicePixelRatio: scale });
  window.carom!.viewer.quality = "low";
}
