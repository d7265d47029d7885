import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Page } from "playwright-core";
import { inject } from "vitest";
import { CATALOGUES, type Language } from "../../src/app/words/catalogue.ts";
import type { ShotFile } from "../../src/engine/index.ts";
import { expect, PHONE, pressTool, settled, shotOf, test, usable } from "./fixture.ts";

const WIDE = { width: 1280, height: 800 };

const LOCALES = { de: "de-DE", zh: "zh-CN" } as const;

/** English texts that the language does not share, and that are long enough not to be part of a name. */
const foreign = (language: Language): string[] => {
  const own = new Set(Object.values(CATALOGUES[language]));
  return Object.values(CATALOGUES.en).filter(
    (text): text is string =>
      typeof text === "string" && /^[A-Z][^{]{2,}$/.test(text) && !own.has(text),
  );
};

/** All visible texts and names of controls, the buttons that do not fit, and the texts that are cut. */
const visible = (page: Page) =>
  page.evaluate(() => {
    const elements = [...document.querySelectorAll("body *")].filter((element) =>
      element.checkVisibility(),
    );
    return {
      texts: elements
        // Licences are in English, and the languages have their own names.
        .filter((element) => !element.closest("pre, .languages select"))
        .flatMap((element) => [
          ...[...element.childNodes]
            .filter(({ nodeType }) => nodeType === Node.TEXT_NODE)
            .map(({ textContent }) => textContent?.trim()),
          element.getAttribute("aria-label"),
          element.getAttribute("title"),
        ]),
      tooWide: elements
        .filter(
          (element) =>
            element.matches("button") &&
            (element.scrollWidth > element.clientWidth + 1 ||
              element.getBoundingClientRect().right > innerWidth + 1),
        )
        .map(({ textContent }) => textContent),
      cut: elements
        .filter(
          (element) =>
            !element.matches(".unseen, .brand, svg *, select, option, textarea") &&
            [...element.childNodes].some(
              ({ nodeType, textContent }) => nodeType === Node.TEXT_NODE && textContent?.trim(),
            ) &&
            (element.clientWidth > 0
              ? element.scrollWidth > element.clientWidth + 1
              : element.getBoundingClientRect().right > innerWidth + 1),
        )
        .map(({ textContent }) => textContent),
      aside: elements
        .filter(
          (element) =>
            element.matches(".tabpanel, .dock") && element.scrollWidth > element.clientWidth,
        )
        .map(({ id, className }) => id || className),
      overflow: document.documentElement.scrollWidth - innerWidth,
    };
  });

for (const [language, viewport] of [
  ["de", PHONE],
  ["zh", PHONE],
  ["de", WIDE],
  ["zh", WIDE],
] as const) {
  const size = `${viewport.width}×${viewport.height}`;
  test(`every panel is in the browser's language and fits ${size}: ${language}`, async ({
    open,
  }) => {
    const page = await open({ viewport, locale: LOCALES[language], firstSteps: true });
    const english = foreign(language);
    const check = async (place: string): Promise<void> => {
      const { texts, ...rest } = await visible(page);
      const found = texts.filter((text) => text && english.includes(text));
      expect({ found, ...rest }, place).toEqual({
        found: [],
        tooWide: [],
        cut: [],
        aside: [],
        overflow: 0,
      });
    };
    const text = (key: keyof typeof CATALOGUES.en) => CATALOGUES[language][key] as string;
    const press = (key: keyof typeof CATALOGUES.en) =>
      page.getByRole("button", { name: text(key), exact: true }).click();
    await check("first steps");
    // Seen: "Sammlung" was cut to "Sam" beside the buttons of a phone, also of one with 360 px.
    for (const width of [360, viewport.width]) {
      await page.setViewportSize({ ...viewport, width });
      const room = await page
        .locator("#entrances")
        .evaluate(({ scrollWidth, clientWidth }) => clientWidth - scrollWidth);
      expect(room, `${width} px`).toBeGreaterThanOrEqual(0);
    }
    expect(await page.evaluate(() => document.documentElement.lang)).toBe(
      { de: "de", zh: "zh-Hans" }[language],
    );
    await press("steps.skip");
    for (const tab of ["aim", "layout", "physics", "whatif"] as const) {
      await page.getByRole("tab", { name: text(`tab.${tab}`) }).click();
      await page.evaluate(() =>
        document.querySelectorAll("details").forEach((each) => (each.open = true)),
      );
      await check(tab);
    }
    for (const activity of ["play", "train", "analyse"] as const) {
      await page.getByRole("radio", { name: text(`activity.${activity}`) }).click();
      await check(activity);
    }
    for (const [dialog, close] of [
      ["page.help", "help.close"],
      ["share.share", "share.close"],
    ] as const) {
      await pressTool(page, text(dialog));
      await check(dialog);
      await press(close);
    }
    await page.evaluate(() => window.carom!.store.aimAtPocket("9", "top-right", "aim"));
    await settled(page);
    await check("a pot");
    await press("aim.shoot");
    await page.getByRole("tab", { name: text("tab.state") }).click();
    await check("replay");
    await page.getByRole("tab", { name: text("tab.aim") }).click();
    await page.keyboard.press("Escape");
    await page.getByRole("radio", { name: text("activity.play") }).click();
    await press("setup.start");
    await check("a game");
  });
}

/** Chooses a language in the help, and waits until the page has loaded again. */
async function choose(page: Page, help: string, language: Language): Promise<void> {
  await page.getByRole("button", { name: help }).click();
  await Promise.all([
    page.waitForEvent("load"),
    page.locator("#help select").selectOption(language),
  ]);
  await usable(page);
}

test("another language is chosen, and the shot, the game and the view stay", async ({ open }) => {
  // No other test has this locale, so none gets a tab in which a language was chosen.
  const page = await open({ locale: "en-US" });
  await page.evaluate(() => {
    const { store } = window.carom!;
    store.strike({ azimuth_deg: 61.5, side: 0.25 }, "change");
    store.setView({ theme: "dark", units: "km/h" });
  });
  const contents = () => page.evaluate(() => window.carom!.store.document);
  const before = await contents();
  await choose(page, "Help and keys", "de");
  expect(await page.evaluate(() => document.documentElement.lang)).toBe("de");
  expect(await page.getByRole("tab", { name: "Zielen" }).count()).toBe(1);
  expect(await contents()).toEqual(before);
  expect(await page.evaluate(() => window.carom!.store.view)).toMatchObject({
    theme: "dark",
    units: "km/h",
  });

  await page.getByRole("radio", { name: "Spielen" }).click();
  await page.getByRole("button", { name: "Spiel beginnen" }).click();
  const game = await contents();
  expect(game.game).not.toBeNull();
  await choose(page, "Hilfe und Tasten", "en");
  expect(await contents()).toEqual(game);
  // The choice outlives the page, what was kept does not.
  expect(await page.evaluate(() => Object.keys(sessionStorage))).toEqual([]);
  expect((await page.evaluate(() => Object.keys(localStorage))).sort()).toEqual([
    "carom-first-steps",
    "carom-language",
  ]);
});

test("a change of an embedded document outlives the choice of a language", async ({ open }) => {
  const file = join(mkdtempSync(join(tmpdir(), "carom-")), "page.html");
  const shot = readFileSync(new URL("../../../shots/half_ball_cut.json", import.meta.url), "utf8");
  const html = readFileSync(inject("file"), "utf8");
  writeFileSync(file, html.replace(/(id="carom-document")>/, `$1>${shot}`));
  const page = await open({ url: pathToFileURL(file).href, locale: "en-NZ" });
  await page.evaluate(() => window.carom!.store.strike({ side: 0.125 }, "change"));
  const before = await shotOf(page);
  expect(before.balls).toEqual((JSON.parse(shot) as ShotFile).balls);
  await choose(page, "Help and keys", "zh");
  expect(await shotOf(page)).toEqual(before);
});

test("a page that may store nothing says why the language stays", async ({ open }) => {
  const page = await open({ locale: "en-CA" });
  await page.evaluate(() => {
    Object.defineProperty(Storage.prototype, "setItem", {
      value() {
        throw new DOMException("no storage", "SecurityError");
      },
    });
  });
  await page.getByRole("button", { name: "Help and keys" }).click();
  await page.locator("#help select").selectOption("zh");
  expect(await page.getByRole("alert").textContent()).toContain(
    "does not let this page store the language",
  );
  expect(await page.evaluate(() => document.documentElement.lang)).toBe("en");
});

test("a stored language that the page does not have gives the browser's language", async ({
  open,
}) => {
  // No other test has this locale: the stored value stays with the tab.
  const page = await open({ locale: "de-AT" });
  const load = async (stored: string) => {
    await page.evaluate((value) => localStorage.setItem("carom-language", value), stored);
    await page.reload();
    await page.waitForFunction(() => window.carom !== undefined);
    return page.evaluate(() => document.documentElement.lang);
  };
  for (const stored of ["fr", "", "toString", "DE", "zh-Hans"])
    expect(await load(stored)).toBe("de");
  expect(await page.getByRole("tab", { name: "Zielen" }).count()).toBe(1);
  // A known one is obeyed.
  expect(await load("zh")).toBe("zh-Hans");
  await page.evaluate(() => localStorage.removeItem("carom-language"));
});
