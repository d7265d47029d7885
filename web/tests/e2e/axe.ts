/** What axe finds on a page. */

import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import type { Page } from "playwright-core";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

interface Violation {
  readonly id: string;
  readonly nodes: readonly { readonly html: string; readonly failureSummary?: string }[];
}

/**
 * Waits until the colours are those that stay. The page follows a change of the system's scheme in a later
 * frame, and on a busy machine axe would see the background of one theme and the text of the other.
 */
async function colored(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const { theme } = window.carom!.store.view;
    const system = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
    const wanted = theme === "auto" ? system : theme;
    return document.documentElement.dataset.theme === wanted;
  });
  await page.evaluate(async () => {
    // A transition that is replaced is not a failure.
    await Promise.allSettled(document.getAnimations().map(({ finished }) => finished));
  });
}

/** The violations that axe finds in carom's page, one line each. */
export async function violations(page: Page): Promise<string[]> {
  await colored(page);
  return violationsOf(page);
}

/** The violations that axe finds in any page, one line each. */
export async function violationsOf(page: Page): Promise<string[]> {
  await page.evaluate(AXE);
  const found = await page.evaluate(async () => {
    const { axe } = window as unknown as { axe: { run(): Promise<{ violations: Violation[] }> } };
    return (await axe.run()).violations;
  });
  return found.flatMap(({ id, nodes }) =>
    nodes.map(({ html, failureSummary = "" }) => `${id}: ${html} ${failureSummary}`),
  );
}
