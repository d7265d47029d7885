/** Nine balls from a rendered photo, at the sizes of a phone and of a desktop. */

import type { Locator, Page } from "playwright-core";
import { load, type Point } from "../../src/engine/index.ts";
import { project } from "../../src/photo/geometry/camera.ts";
import { landmarks } from "../../src/photo/geometry/landmarks.ts";
import { png } from "../photo/png.ts";
import { generator } from "../photo/random.ts";
import { lit, render } from "../photo/render.ts";
import { lookAt, randomLayout } from "../photo/views.ts";
import { expect, PHONE, shotOf, test } from "./fixture.ts";

const WIDE = { width: 1280, height: 800 };
const SIZE = [1200, 900] as const;
const RADIUS = 0.028575;
/** Standard deviation of a tap, pixels of the photo. */
const NOISE = 1.5;
const MOST_GESTURES = 25;
/** Largest median error of the balls, m. */
const LARGEST_ERROR = 0.008;

const engine = await load();
const random = generator(20);
const table = engine.tables.find(({ name }) => name === "wpa-9ft")!;
const marks = landmarks(table)!;
const camera = lookAt({
  eye: [0.5, -1.15, 1.25],
  target: [0.635, 0.95, 0],
  roll: 0.02,
  lens: { focal: 860, k1: -0.06, center: [SIZE[0] / 2, SIZE[1] / 2] },
});
const balls = randomLayout(random, marks.size, 9, RADIUS).map((position, k) => ({
  id: k === 0 ? "cue" : String(k),
  position,
}));
const scene = lit(random, { table, balls, radius: RADIUS, camera });
const photo = png(render(scene, { left: 0, top: 0, width: SIZE[0], height: SIZE[1] }, random));

async function openDialog(page: Page): Promise<Locator> {
  await page.getByRole("tab", { name: "Layout" }).click();
  await page.getByRole("button", { name: "Layout from a photo" }).click();
  return page.getByRole("dialog", { name: "Layout from a photo" });
}

async function choosePhoto(dialog: Locator, name = "table.png", buffer = photo): Promise<void> {
  const mimeType = "image/png";
  await dialog.locator("input[type=file]").setInputFiles({ name, mimeType, buffer });
}

/** Places on the page (CSS pixels) of pixels of the photo, with the noise of a hand. */
async function places(dialog: Locator, pixels: readonly Point[]): Promise<Point[]> {
  const box = (await dialog.locator("canvas").first().boundingBox())!;
  const scale = Math.min(box.width / SIZE[0], box.height / SIZE[1]);
  const shift = (length: number, side: number) => (length - scale * side) / 2;
  return pixels.map(([x, y]) => [
    box.x + shift(box.width, SIZE[0]) + scale * (x + random.gaussian(NOISE)),
    box.y + shift(box.height, SIZE[1]) + scale * (y + random.gaussian(NOISE)),
  ]);
}

for (const [name, viewport] of [
  ["phone", PHONE],
  ["desktop", WIDE],
] as const) {
  test(`nine balls take at most ${MOST_GESTURES} gestures on a ${name}`, async ({ open }) => {
    const page = await open({ viewport, hasTouch: name === "phone" });
    const requests: string[] = [];
    page.on("request", (request) => requests.push(request.url()));
    const dialog = await openDialog(page);
    let gestures = 1;
    await choosePhoto(dialog);
    await dialog.getByText("0 of 6").waitFor();
    const tapAll = async (pixels: readonly Point[]) => {
      for (const pixel of pixels) {
        const [[x, y]] = (await places(dialog, [pixel])) as [Point];
        if (name === "phone") await page.touchscreen.tap(x, y);
        else await page.mouse.click(x, y);
        gestures += 1;
      }
    };
    await tapAll(marks.places.map((place) => project(camera, place)!));
    await dialog.getByText("Tap the middle of the cue ball").waitFor();
    await tapAll(balls.map(({ position }) => project(camera, [...position, RADIUS])!));
    await dialog.getByRole("img", { name: "The layout so far: 9 balls" }).waitFor();
    await dialog.getByRole("button", { name: "Use this layout" }).click();
    gestures += 1;
    expect(gestures).toBeLessThanOrEqual(MOST_GESTURES);
    const shot = await shotOf(page);
    expect(shot.balls.map(({ id }) => id)).toEqual(balls.map(({ id }) => id));
    const errors = shot.balls.map(({ position: [x, y] }, k) => {
      const [u, v] = balls[k]!.position;
      return Math.hypot(x - u, y - v);
    });
    expect(errors.sort((a, b) => a - b)[4]).toBeLessThan(LARGEST_ERROR);
    expect(requests.filter((url) => !/^(blob|data):/.test(url))).toEqual([]);
  });
}
