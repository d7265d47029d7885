import { CATALOGUES, type Language } from "../../src/app/words/catalogue.ts";
import { expect, PHONE, test } from "./fixture.ts";

const LOCALES = { de: "de-DE", zh: "zh-CN" } as const;

/** English texts that the language does not share, and that are long enough not to be part of a name. */
const foreign = (language: Language): string[] => {
  const own = new Set(Object.values(CATALOGUES[language]));
  return Object.values(CATALOGUES.en).filter(
    (text): text is string =>
      typeof text === "string" && /^[A-Z][^{]{4,}$/.test(text) && !own.has(text),
  );
};

for (const language of ["de", "zh"] as const) {
  test(`the page is in the browser's language: ${language}`, async ({ open }) => {
    const page = await open({ viewport: PHONE, locale: LOCALES[language], firstSteps: true });
    const english = foreign(language);
    const check = async (place: string): Promise<void> => {
      const { shown, wide } = await page.evaluate(() => ({
        shown: [...document.querySelectorAll("body *")]
          .filter((element) => element.checkVisibility() && !element.closest("pre, .language"))
          .flatMap((element) => [
            ...[...element.childNodes]
              .filter(({ nodeType }) => nodeType === Node.TEXT_NODE)
              .map(({ textContent }) => textContent?.trim()),
            element.getAttribute("aria-label"),
            element.getAttribute("title"),
          ]),
        wide: [...document.querySelectorAll("button")]
          .filter((button) => button.checkVisibility())
          .filter(
            (button) =>
              button.scrollWidth > button.clientWidth + 1 ||
              button.getBoundingClientRect().right > innerWidth + 1,
          )
          .map(({ textContent }) => textContent),
      }));
      expect(
        shown.filter((text) => text && english.includes(text)),
        place,
      ).toEqual([]);
      expect(wide, place).toEqual([]);
    };
    await check("first steps");
    expect(await page.evaluate(() => document.documentElement.lang)).toMatch(
      new RegExp(`^${language}`),
    );
    await page.locator("#first-use button").first().click();
    for (const tab of ["layout", "physics", "whatif", "game", "aim"]) {
      await page.locator(`#tab-${tab}`).click();
      await check(tab);
    }
    await page.locator("#share-button").click();
    await check("share");
    await page.keyboard.press("Escape");
    await page.locator("#shoot-button").click();
    await page.locator("#tab-state").click();
    await check("replay");
  });
}
