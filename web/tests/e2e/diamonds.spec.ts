/** The overlay of the diamond systems. */

import { DESKTOP, expect, onPage, PHONE, picture, settled, test } from "./fixture.ts";
import { showTab } from "./sizes.ts";

for (const [name, viewport] of [
  ["desktop", DESKTOP],
  ["phone", PHONE],
] as const) {
  test(`a kick over three cushions has the numbers of corner five on a ${name}`, async ({
    open,
  }) => {
    const page = await open({ viewport, reducedMotion: "reduce" });
    const overlay = page.locator(".diamonds");
    expect(await overlay.isVisible()).toBe(false);
    await page.evaluate(() => {
      const cue = { id: "cue", position: [0.206, 2.147] as const };
      const one = { id: "1", position: [0.2, 1.9] as const };
      const strike = { ball: "cue", speed: 2.2, azimuth_deg: 307.6, side: 0.3, height: 0.3 };
      const shot = { format: "carom-shot/1", table: "wpa-9ft", balls: [cue, one], strike } as const;
      window.carom!.store.apply({ shot }, "kick");
    });
    await showTab(page, "aim");
    await page.getByRole("switch", { name: "Diamond system" }).check();
    await page.locator("#tab-aim").click();
    await overlay.waitFor();
    await settled(page);
    const text = (await overlay.getByRole("status").textContent())!;
    expect(text).toMatch(/^Corner five: \d\.\d − \d\.\d = \d\.\d\. The ball arrives /);
    // The target of the system is where its number says.
    const target = Number(/= (\d\.\d)/.exec(text)![1]);
    const ring = overlay.locator("circle.predicted");
    const box = (await ring.boundingBox())!;
    const at = await onPage(page, -0.0937, target * 0.3175, 0.036);
    expect(Math.abs(box.x + box.width / 2 - at.x)).toBeLessThan(12);
    expect(Math.abs(box.y + box.height / 2 - at.y)).toBeLessThan(12);
    expect(await overlay.locator("circle.actual").count()).toBe(1);
    await picture(page, `diamonds-${name}`);
    // It follows the window.
    const before = await ring.boundingBox();
    await page.setViewportSize({ width: viewport.width - 60, height: viewport.height - 60 });
    await expect.poll(() => ring.boundingBox()).not.toEqual(before);
    await page.evaluate(() => window.carom!.store.strike({ azimuth_deg: 90, speed: 0.3 }, "aim"));
    await expect
      .poll(() => overlay.getByRole("status").textContent())
      .toMatch(/^No diamond system/);
    await page.getByRole("button", { name: "Shoot" }).click();
    expect(await overlay.isVisible()).toBe(false);
  });
}
