/** What the picture of a table shows where nothing lies. */

import { PNG } from "pngjs";
import { expect, onPage, settled, test } from "./fixture.ts";

const SIZES = { tablet: { width: 1024, height: 768 }, phone: { width: 390, height: 844 } };

/** The cloth over the inner side of a leg, m from the nose lines: across the table, and along it. */
const ACROSS = [0.06, 0.14] as const;
const ALONG = [0.15, 0.22] as const;

for (const [name, viewport] of Object.entries(SIZES)) {
  for (const table of ["snooker-12ft", "carom-10ft"]) {
    test(`the cloth of ${table} has no dark lines near the corners, on a ${name}`, async ({
      open,
    }) => {
      // Seen: lines of 20 pixels, single pixels of the sides of the legs under the slate.
      const page = await open({ viewport, quality: "high", reducedMotion: "reduce" });
      const size = await page.evaluate((preset) => {
        const { store } = window.carom!;
        const balls = [{ id: "cue", position: [0.7, 1.4] as const }];
        const strike = { ball: "cue", speed: 1, azimuth_deg: 0 };
        store.apply({ shot: { format: "carom-shot/1", table: preset, balls, strike } }, "table");
        return store.shot.geometry.size!;
      }, table);
      await settled(page);
      const image = PNG.sync.read(await page.screenshot({ scale: "css" }));
      const brightness = (x: number, y: number) => {
        const [r, g, b] = image.data.subarray(4 * (y * image.width + x));
        return r! + g! + b!;
      };
      for (const isFar of [false, true]) {
        for (const isTop of [false, true]) {
          const [x, y] = [
            isFar ? (u: number) => size[0] - u : (u: number) => u,
            isTop ? (v: number) => size[1] - v : (v: number) => v,
          ];
          const ends = [
            await onPage(page, x(ACROSS[0]), y(ALONG[0]), 0),
            await onPage(page, x(ACROSS[1]), y(ALONG[1]), 0),
          ] as const;
          const [left, right] = [Math.min(ends[0].x, ends[1].x), Math.max(ends[0].x, ends[1].x)];
          const [top, bottom] = [Math.min(ends[0].y, ends[1].y), Math.max(ends[0].y, ends[1].y)];
          let darkest = Infinity;
          for (let v = Math.ceil(top) + 1; v < bottom - 1; v += 1) {
            for (let u = Math.ceil(left) + 1; u < right - 1; u += 1) {
              const around = [
                brightness(u - 1, v),
                brightness(u + 1, v),
                brightness(u, v - 1),
                brightness(u, v + 1),
              ];
              const usual = around.sort((a, b) => a - b)[2]!;
              darkest = Math.min(darkest, brightness(u, v) / usual);
            }
          }
          expect(darkest, `right: ${isFar}, top: ${isTop}`).toBeGreaterThan(0.85);
        }
      }
    });
  }
}
