/** Drawing on the table: mouse, finger and keyboard; undo, links, pictures; and no violation of axe. */

import type { Page } from "playwright-core";
import { PNG } from "pngjs";
import { violations } from "./axe.ts";
import {
  DESKTOP,
  expect,
  onPage,
  picture,
  pressTool,
  settled,
  shotOf,
  storeNow,
  test,
} from "./fixture.ts";
import { finger, LYING, TOUCH } from "./finger.ts";

const PENCIL = "Draw on the table (D)";

const marks = async (page: Page) => (await shotOf(page)).marks ?? [];

/** Drags from one place of the table to another. */
async function drag(page: Page, from: readonly number[], to: readonly number[]): Promise<void> {
  const [a, b] = [await onPage(page, from[0]!, from[1]!), await onPage(page, to[0]!, to[1]!)];
  await page.mouse.move(a.x, a.y);
  await page.mouse.down();
  await page.mouse.move((a.x + b.x) / 2, (a.y + b.y) / 2);
  await settled(page);
  await page.mouse.move(b.x, b.y);
  await settled(page);
  await page.mouse.up();
}

test("three marks and a sentence are drawn by mouse, undone, linked and in the picture", async ({
  open,
}) => {
  const page = await open({ viewport: DESKTOP });
  const before = (await shotOf(page)).strike;
  await page.getByRole("button", { name: PENCIL }).click();
  await drag(page, [0.42, 0.72], [0.86, 1.74]);
  await page.getByRole("radio", { name: "Circle" }).click();
  await page.getByRole("radio", { name: "red" }).click();
  await drag(page, [0.35, 1.62], [0.35, 1.45]);
  await page.getByRole("radio", { name: "Label" }).click();
  await page.getByLabel("Text of the label").fill("half ball");
  const spot = await onPage(page, 0.9, 0.4);
  await page.mouse.click(spot.x, spot.y);
  await settled(page);
  const drawn = await marks(page);
  expect(drawn).toMatchObject([
    { kind: "arrow", color: "yellow", from: [0.42, 0.72], to: [0.86, 1.74] },
    { kind: "circle", color: "red", center: [0.35, 1.62] },
    { kind: "label", color: "red", text: "half ball" },
  ]);
  expect((await shotOf(page)).strike).toEqual(before);
  await picture(page, "drawing");
  await page.getByRole("button", { name: "Undo: put a label" }).click();
  expect(await marks(page)).toHaveLength(2);
  await page.getByRole("button", { name: "Redo: put a label" }).click();
  await page.getByRole("button", { name: "Done" }).click();
  expect(await page.locator("#shoot-button").isVisible()).toBe(true);

  const encoded = await page.evaluate(async () => {
    const bytes = new Uint8Array(await (await window.carom!.viewer.capture(1)).arrayBuffer());
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  });
  const taken = PNG.sync.read(Buffer.from(encoded, "base64"));
  const stage = (await page.locator("#table").boundingBox())!;
  const middle = await onPage(page, 0.64, 1.23);
  const scale = taken.width / stage.width;
  const [px, py] = [(middle.x - stage.x) * scale, (middle.y - stage.y) * scale].map(Math.round);
  const [red, green, blue] = taken.data.subarray(4 * (py! * taken.width + px!));
  expect(red! > 200 && green! > 160 && blue! < 120, `${red} ${green} ${blue}`).toBe(true);

  await storeNow(page);
  const other = await open({ url: page.url() });
  expect(await marks(other)).toEqual(drawn);
});

test("a finger draws, and a tap with the eraser removes the mark", async ({ open }) => {
  const page = await open(TOUCH);
  await pressTool(page, PENCIL);
  const touch = await finger(page);
  const [from, to] = [await onPage(page, 0.3, 0.5), await onPage(page, 0.9, 0.5)];
  await touch.down(from);
  await touch.move({ x: from.x + 30, y: from.y });
  await settled(page);
  await touch.move(to);
  await settled(page);
  await touch.up();
  expect(await marks(page)).toMatchObject([{ kind: "arrow" }]);
  await page.getByRole("radio", { name: "Erase" }).tap();
  const on = await onPage(page, 0.6, 0.5);
  await page.touchscreen.tap(on.x, on.y);
  await settled(page);
  expect(await marks(page)).toEqual([]);
  // A second finger gives the drag up.
  await page.getByRole("radio", { name: "Line" }).tap();
  await touch.down(from);
  await touch.move(to);
  await settled(page);
  expect(await marks(page)).toHaveLength(1);
  await page.evaluate(() => {
    const more = { pointerId: 99, pointerType: "touch", button: 0, clientX: 100, clientY: 300 };
    document.querySelector("#table")!.dispatchEvent(new PointerEvent("pointerdown", more));
  });
  expect(await marks(page)).toEqual([]);
  await touch.up();
});

test("everything is drawn and removed by keyboard alone", async ({ open }) => {
  const page = await open({ viewport: DESKTOP });
  await page.locator("#table").focus();
  await page.keyboard.press("d");
  const notice = page.locator("#notice");
  await page.keyboard.press("n");
  expect(await notice.innerText()).toMatch(/cue ball/i);
  await page.keyboard.press("Enter");
  await page.keyboard.press("n");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  const [arrow] = await marks(page);
  expect(arrow).toMatchObject({ kind: "arrow", from: [0.42, 0.72] });
  const { balls } = await shotOf(page);
  const [x, y] = balls[1]!.position;
  const { to } = arrow as { to: readonly [number, number] };
  expect(Math.hypot(to[0] - x, to[1] - y)).toBeCloseTo(0.02, 6);
  await page.getByRole("radio", { name: "Erase" }).focus();
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Remove", exact: true }).focus();
  await page.keyboard.press("Enter");
  expect(await marks(page)).toEqual([]);
  await page.locator("#table").focus();
  await page.keyboard.press("Escape");
  expect(await page.locator("#draw").isVisible()).toBe(false);
});

for (const colorScheme of ["light", "dark"] as const) {
  for (const [name, size] of [
    ["a desktop", { viewport: { width: 1280, height: 800 } }],
    ["a phone", TOUCH],
    ["a turned phone", LYING],
  ] as const) {
    test(`the tools have no violation and are in view on ${name} in ${colorScheme}`, async ({
      open,
    }) => {
      for (const locale of ["en-GB", "de-DE", "zh-CN"]) {
        const page = await open({ ...size, colorScheme, locale });
        await page.evaluate(() => {
          const { store } = window.carom!;
          const mark = { kind: "line", color: "red", from: [0.2, 0.2], to: [0.9, 1] } as const;
          store.apply({ shot: { ...store.document.shot, marks: [mark] } }, "draw");
        });
        await page.locator("#table").focus();
        await page.keyboard.press("d");
        for (const tool of [0, 4, 5]) {
          await page.locator("#draw [role=radio]").nth(tool).click();
          expect(await violations(page)).toEqual([]);
          const dock = (await page.locator(".dock").boundingBox())!;
          for (const control of await page
            .locator("#draw button, #draw input, #draw select")
            .all()) {
            if (!(await control.isVisible())) continue;
            const box = (await control.boundingBox())!;
            const isInside =
              box.y >= dock.y &&
              box.y + box.height <= dock.y + dock.height &&
              box.x + box.width <= dock.x + dock.width;
            expect(isInside, `${locale} ${tool} ${await control.innerText()}`).toBe(true);
          }
        }
      }
    });
  }
}
