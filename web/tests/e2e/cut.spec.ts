/** No sheet, panel or dialog cuts a text, in any language, on a phone, in landscape and on a desktop. */

import type { Page } from "playwright-core";
import { CATALOGUES, LANGUAGES, type Language } from "../../src/app/words/catalogue.ts";
import { type Key } from "../../src/app/words/translate.ts";
import { expect, PHONE, settled, test } from "./fixture.ts";
import { showTab } from "./sizes.ts";

/** Time limit (ms) of a test: it opens some thirty states. */
const SLOW = 480_000;

const WINDOWS = [PHONE, { width: 844, height: 390 }, { width: 1280, height: 800 }] as const;

const LOCALES: Readonly<Record<Language, string>> = { en: "en-GB", de: "de-DE", zh: "zh-CN" };

/**
 * Runs in the page: the texts that do not fit where they are. A text is cut if it is wider than its element, or
 * if its element hides what is too high. A list is cut if it is narrower than it is without a fixed width.
 */
function cutTexts(): string[] {
  const isShown = (element: Element): boolean =>
    element.checkVisibility({ visibilityProperty: true }) && !element.closest(".unseen, svg");
  const hasText = (element: Element): boolean =>
    [...element.childNodes].some(
      ({ nodeType, textContent }) => nodeType === Node.TEXT_NODE && textContent?.trim(),
    );
  const name = (element: Element): string => {
    const { id, className, textContent } = element as HTMLElement;
    return `${element.localName}${id && `#${id}`}${className && `.${className}`}: ${textContent}`;
  };
  const found: string[] = [];
  for (const element of document.querySelectorAll<HTMLElement>("body *")) {
    if (!isShown(element)) continue;
    if (element instanceof HTMLSelectElement) {
      const copy = element.cloneNode(true) as HTMLSelectElement;
      copy.style.cssText = "position: absolute; visibility: hidden; width: auto; max-width: none";
      element.after(copy);
      // The widest entry may be chosen, whichever is chosen now.
      if (copy.offsetWidth > element.offsetWidth + 1) {
        found.push(
          `select in ${element.closest("[id]:not(select)")?.id}: ${element.labels[0]?.textContent} (${element.offsetWidth} of ${copy.offsetWidth} px)`,
        );
      }
      copy.remove();
      continue;
    }
    if (element.matches("option, textarea, pre, .brand") || !hasText(element)) continue;
    const { overflowY, display } = getComputedStyle(element);
    if (display === "inline") {
      if (element.getBoundingClientRect().right > innerWidth + 1) found.push(name(element));
      continue;
    }
    const isWide = element.scrollWidth > element.clientWidth + 1;
    const isHigh = /hidden|clip/.test(overflowY) && element.scrollHeight > element.clientHeight + 1;
    if (isWide || isHigh) found.push(name(element));
  }
  return found;
}

for (const language of Object.keys(LANGUAGES) as Language[]) {
  for (const viewport of WINDOWS) {
    const size = `${viewport.width}×${viewport.height}`;
    const text = (key: Key) => CATALOGUES[language][key] as string;

    /** Opens the page, and what looks for cut texts in it. */
    const begin = async (open: (options: object) => Promise<Page>) => {
      const page = await open({ viewport, locale: LOCALES[language], reducedMotion: "reduce" });
      const look = async (state: string): Promise<void> => {
        await settled(page);
        expect.soft(await page.evaluate(cutTexts), state).toEqual([]);
      };
      const press = (key: Key) =>
        page
          .getByRole("button", { name: text(key), exact: true })
          .filter({ visible: true })
          .first()
          .click();
      const enter = (activity: "analyse" | "play" | "train") =>
        page.getByRole("radio", { name: text(`activity.${activity}`) }).click();
      const openAll = () =>
        page.evaluate(() =>
          document.querySelectorAll("details").forEach((each) => (each.open = true)),
        );
      return { page, look, press, enter, openAll };
    };

    /** Looks at the dock with a speed of every word in every unit. */
    const lookAtSpeeds = async (page: Page, look: (state: string) => Promise<void>) => {
      for (const units of ["m/s", "km/h", "mph"] as const) {
        for (const speed of [1.15, 2.15, 4.95, 7.45, 11.95]) {
          await page.evaluate(
            ([unit, given]) => {
              const { store } = window.carom!;
              store.setView({ units: unit });
              store.strike({ speed: given }, "speed");
            },
            [units, speed] as const,
          );
          await look(`${speed} m/s in ${units}`);
        }
      }
      await page.evaluate(() => window.carom!.store.setView({ units: "m/s" }));
    };

    test(
      `no text of Analyse is cut at ${size}: ${language}`,
      { timeout: SLOW },
      async ({ open }) => {
        const { page, look, press, openAll } = await begin(open);
        await page.locator("#chance-chip:not([data-stale])").waitFor();
        await lookAtSpeeds(page, look);
        await page.evaluate(() => window.carom!.store.setView({ units: "m/s" }));
        await showTab(page, "aim");
        await page.getByRole("switch", { name: text("aim.diamonds") }).check();
        await look("aim");
        await showTab(page, "lines");
        await page.locator(".lines[data-done=true]:not([data-stale])").waitFor();
        await look("lines");
        await press("aim.shoot");
        await page.locator("#leave-replay").click();
        await showTab(page, "tree");
        await openAll();
        await look("tree");
        await showTab(page, "layout");
        await openAll();
        await look("layout");
        await showTab(page, "physics");
        await openAll();
        await look("physics");
        await showTab(page, "whatif");
        await page.locator("#panel-whatif").getByRole("switch").check();
        await page.locator("#variants[data-done=true]").waitFor();
        await look("what if");
        await page.evaluate(() => document.getElementById("share-button")!.click());
        await look("share");
        await page.keyboard.press("Escape");
        await page.locator("#table").focus();
        await page.keyboard.press("?");
        await look("help");
        await page.keyboard.press("Escape");
        await press("aim.shoot");
        await showTab(page, "state");
        await openAll();
        await look("replay");
      },
    );

    test(`no text of Play is cut at ${size}: ${language}`, { timeout: SLOW }, async ({ open }) => {
      const { page, look, press, enter, openAll } = await begin(open);
      await enter("play");
      await showTab(page, "game");
      const panel = page.locator("#panel-game");
      await openAll();
      const games = panel.getByLabel(text("setup.game"), { exact: true });
      for (const rules of await games
        .locator("option")
        .evaluateAll((all) => all.map((each) => (each as HTMLOptionElement).value))) {
        await games.selectOption(rules);
        await look(`set-up of ${rules}`);
      }
      await games.selectOption("nine-ball");
      // Another rack could be won with the break.
      await panel.getByLabel(text("setup.seed")).fill("7");
      await panel.getByLabel(text("lag.label")).check();
      await press("setup.start");
      await page.getByRole("dialog").filter({ visible: true }).waitFor();
      await look("lag");
      await page.keyboard.press("Escape");
      await panel.getByLabel(text("lag.label")).uncheck();
      await panel.getByLabel(text("setup.played-by")).nth(1).selectOption("");
      await press("setup.start");
      await lookAtSpeeds(page, look);
      await showTab(page, "game");
      await look("game");
      await press("aim.shoot");
      await showTab(page, "game");
      await page.locator("#panel-game .record .again").first().waitFor();
      await look("list of moves");
      await page.locator("#panel-game .record .again").first().click();
      await page.locator("#game-bar .step").waitFor();
      await look("review");
    });

    test(`no text of a won game is cut at ${size}: ${language}`, async ({ open }) => {
      // Seen: the ruling of a break that pots the nine and two other balls.
      const { page, look, press, enter, openAll } = await begin(open);
      await enter("play");
      await showTab(page, "game");
      await openAll();
      const panel = page.locator("#panel-game");
      await panel.getByLabel(text("setup.seed")).fill("213");
      await panel.getByLabel(text("setup.played-by")).nth(1).selectOption("");
      await press("setup.start");
      await press("aim.shoot");
      const another = page.getByRole("button", { name: text("table.another"), exact: true });
      await another.waitFor();
      await look("won");
    });

    test(`no text of a game with calls is cut at ${size}: ${language}`, async ({ open }) => {
      const { page, look, press, enter } = await begin(open);
      await enter("play");
      await showTab(page, "game");
      const panel = page.locator("#panel-game");
      await panel.getByLabel(text("setup.game"), { exact: true }).selectOption("straight-pool");
      await panel.getByLabel(text("race.frames")).fill("3");
      await look("race");
      await panel.getByLabel(text("setup.played-by")).nth(1).selectOption("");
      await press("setup.start");
      await showTab(page, "game");
      await look("call");
    });

    test(`no text of Train is cut at ${size}: ${language}`, { timeout: SLOW }, async ({ open }) => {
      const { page, look, press, enter } = await begin(open);
      await enter("train");
      await showTab(page, "train");
      await page.locator("#play-puzzle").waitFor();
      await look("overview");
      await press("sheet.choose");
      await look("sheet");
      await press("train.all");
      await page.locator("#drill-stop").click();
      await look("drill");
      await press("train.at-table");
      await look("real table");
      await press("train.leave");
      await press("train.play");
      await look("attempt");
      await showTab(page, "train");
      await look("attempt with its sheet");
    });
  }
}
