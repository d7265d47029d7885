/** Nine balls from a rendered photo, at the sizes of a phone and of a desktop. */

import type { Locator, Page } from "playwright-core";
import { load, type Point } from "../../src/engine/index.ts";
import { project } from "../../src/photo/geometry/camera.ts";
import { landmarks } from "../../src/photo/geometry/landmarks.ts";
import { png } from "../photo/png.ts";
import { generator } from "../photo/random.ts";
import { lit, render } from "../photo/render.ts";
import { lookAt, randomLayout } from "../photo/views.ts";
import { violations } from "./axe.ts";
import { expect, PHONE, shotOf, test } from "./fixture.ts";

const WIDE = { width: 1280, height: 800 };
const SIZE = [1200, 900] as const;
const RADIUS = 0.028575;
/** Standard deviation of a tap, pixels of the photo. */
const NOISE = 1.5;
/** Less than the radius of a ball on a phone, CSS pixels. */
const NEAR = 4;
const MOST_GESTURES = 12;
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
  return pixels.map(([x, y]) =>
    shown(box, [x + random.gaussian(NOISE), y + random.gaussian(NOISE)]),
  );
}

interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Where the dialog shows a pixel of the photo, CSS pixels. */
function shown(box: Box, [x, y]: Point): Point {
  const scale = Math.min(box.width / SIZE[0], box.height / SIZE[1]);
  const shift = (length: number, side: number) => (length - scale * side) / 2;
  return [
    box.x + shift(box.width, SIZE[0]) + scale * x,
    box.y + shift(box.height, SIZE[1]) + scale * y,
  ];
}

/** The number of balls that the page has found, once it has. */
async function foundBalls(dialog: Locator): Promise<number> {
  const hint = dialog.getByText("Balls that were found");
  await hint.waitFor();
  return Number(/\d+/.exec((await hint.textContent())!)![0]);
}

/** The name of the handle at a place; null if there is none. */
async function handleAt(handles: Locator, [x, y]: Point): Promise<string | null> {
  for (const handle of await handles.all()) {
    const [u, v] = await middle(handle);
    if (Math.hypot(u - x, v - y) < NEAR) return handle.getAttribute("aria-label");
  }
  return null;
}

/** Presses of a finger or of the mouse. */
function presser(page: Page, isPhone: boolean) {
  return async ([x, y]: Point) => {
    if (isPhone) await page.touchscreen.tap(x, y);
    else await page.mouse.click(x, y);
  };
}

/** The middle of an element, after it was scrolled into view. */
async function middle(element: Locator): Promise<Point> {
  await element.scrollIntoViewIfNeeded();
  const box = (await element.boundingBox())!;
  return [box.x + box.width / 2, box.y + box.height / 2];
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
    const press = presser(page, name === "phone");
    const act = async (at: Point) => {
      await press(at);
      gestures += 1;
    };
    const [...points] = await places(
      dialog,
      marks.places.map((place) => project(camera, place)!),
    );
    for (const point of points) await act(point);
    await foundBalls(dialog);
    // What is wrong is corrected. A tap on the ball and a press on its number rename it; one that is missing
    // takes the same gestures in the other order; one that is too much is tapped and removed.
    const tray = dialog.locator(".photo-tray");
    const handles = dialog.getByRole("button", { name: "in the photo" });
    const box = (await dialog.locator("canvas").first().boundingBox())!;
    for (const { id, position } of balls) {
      const [[x, y]] = (await places(dialog, [project(camera, [...position, RADIUS])!])) as [Point];
      const ball = id === "cue" ? "the cue ball" : `ball ${id}`;
      const near = await handleAt(handles, shown(box, project(camera, [...position, RADIUS])!));
      if (near?.startsWith(`${ball} `)) continue;
      const chip = tray.getByRole("radio", { name: new RegExp(`^${ball}(,|$)`) });
      if (near !== null) await act([x, y]);
      await act(await middle(chip));
      if (near === null) await act([x, y]);
    }
    for (let k = (await handles.count()) - 1; k >= 0; k -= 1) {
      const at = await middle(handles.nth(k));
      const isBall = balls.some(({ position }) => {
        const [u, v] = shown(box, project(camera, [...position, RADIUS])!);
        return Math.hypot(u - at[0], v - at[1]) < NEAR;
      });
      if (isBall) continue;
      await act(at);
      await act(await middle(dialog.getByRole("button", { name: "Remove" })));
    }
    await dialog.getByRole("img", { name: "The layout so far. Number of balls: 9" }).waitFor();
    await dialog.getByRole("button", { name: "Use this layout" }).click();
    gestures += 1;
    expect(gestures).toBeLessThanOrEqual(MOST_GESTURES);
    const shot = await shotOf(page);
    expect(shot.balls.map(({ id }) => id).sort()).toEqual(balls.map(({ id }) => id).sort());
    const errors = balls.map(({ id, position: [u, v] }) => {
      const [x, y] = shot.balls.find((ball) => ball.id === id)!.position;
      return Math.hypot(x - u, y - v);
    });
    expect(errors.sort((a, b) => a - b)[4]).toBeLessThan(LARGEST_ERROR);
    expect(requests.filter((url) => !/^(blob|data):/.test(url))).toEqual([]);
  });
}

test("a tap confirms a ball that was found, a drag moves it, and undo takes them all back", async ({
  open,
}) => {
  const page = await open({ viewport: WIDE });
  const dialog = await openDialog(page);
  await choosePhoto(dialog);
  await dialog.getByText("0 of 6").waitFor();
  const press = presser(page, false);
  for (const at of await places(
    dialog,
    marks.places.map((place) => project(camera, place)!),
  ))
    await press(at);
  const count = await foundBalls(dialog);
  expect(count).toBeGreaterThan(5);
  const left = async (number: number) =>
    dialog.getByText(`Balls that were found: ${number} `).waitFor();
  await press(await middle(dialog.locator(".photo-handle").nth(6)));
  await left(count - 1);
  const handle = dialog.locator(".photo-handle").nth(7);
  const [x, y] = await middle(handle);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y, { steps: 4 });
  await page.mouse.up();
  await left(count - 2);
  expect((await middle(handle))[0]).toBeCloseTo(x + 20, 0);
  await dialog.locator(".photo-handle").nth(8).focus();
  await page.keyboard.press("Enter");
  await left(count - 3);
  for (let k = 0; k < 4; k += 1) await dialog.getByRole("button", { name: "Undo" }).click();
  await dialog.getByRole("img", { name: "Number of balls: 0" }).waitFor();
  await dialog.getByText("Tap the middle of the cue ball").waitFor();
});

for (const [name, viewport] of [
  ["phone", PHONE],
  ["desktop", WIDE],
] as const) {
  test(`the first press on a ball of the tray counts after a tap on the photo, on a ${name}`, async ({
    open,
  }) => {
    // Seen: the eight was pressed, nothing happened, and the next tap made the black ball the cue ball.
    const page = await open({ viewport, hasTouch: name === "phone" });
    const dialog = await openDialog(page);
    await choosePhoto(dialog);
    await dialog.getByText("0 of 6").waitFor();
    const press = async (x: number, y: number) => {
      if (name === "phone") await page.touchscreen.tap(x, y);
      else await page.mouse.click(x, y);
    };
    const tap = async (pixel: Point) => {
      const [[x, y]] = (await places(dialog, [pixel])) as [Point];
      await press(x, y);
    };
    for (const place of marks.places) await tap(project(camera, place)!);
    // Takes the balls back that the page has found.
    await dialog.getByText("Balls that were found").waitFor();
    await dialog.getByRole("button", { name: "Undo" }).click();
    await dialog.getByText("Tap the middle of the cue ball").waitFor();
    // A tap on the photo gives it the focus; the press in the tray takes the focus away.
    await tap(project(camera, [...balls[0]!.position, RADIUS])!);
    const placed: string[] = ["cue"];
    for (const [id, { position }] of [
      ["8", balls[1]!],
      ["3", balls[2]!],
    ] as const) {
      const chip = dialog.locator(".photo-tray").getByRole("radio", { name: `ball ${id}` });
      await chip.scrollIntoViewIfNeeded();
      const box = (await chip.boundingBox())!;
      await press(box.x + box.width / 2, box.y + box.height / 2);
      await dialog.getByText(`Tap the middle of ball ${id}`).waitFor();
      await tap(project(camera, [...position, RADIUS])!);
      placed.push(id);
    }
    await dialog.getByRole("button", { name: "Use this layout" }).click();
    expect((await shotOf(page)).balls.map(({ id }) => id)).toEqual(placed);
  });
}

test("a file that is not a photo is refused with a sentence, and the work is kept", async ({
  open,
}) => {
  const page = await open({ viewport: PHONE });
  const dialog = await openDialog(page);
  await choosePhoto(dialog, "notes.png", Buffer.from("no photo"));
  await dialog.getByText("notes.png is not a photo that this browser can show").waitFor();
  await choosePhoto(dialog);
  await dialog.getByText("0 of 6").waitFor();
  const [[x, y]] = (await places(dialog, [[600, 450]])) as [Point];
  await page.mouse.click(x, y);
  await dialog.getByText("1 of 6").waitFor();
  await choosePhoto(dialog, "damaged.png", photo.subarray(0, 3000));
  await dialog.getByText("damaged.png is not a photo that this browser can show").waitFor();
  expect(await dialog.getByText("1 of 6").count()).toBe(1);
  await dialog.getByRole("button", { name: "Close" }).click();
  await page.getByRole("button", { name: "Layout from a photo" }).click();
  expect(await dialog.getByText("1 of 6").count()).toBe(1);
});

test("points that are not the table's are reported", async ({ open }) => {
  const page = await open({ viewport: WIDE });
  const dialog = await openDialog(page);
  await choosePhoto(dialog);
  await dialog.getByText("0 of 6").waitFor();
  const pixels = marks.places.map((place) => project(camera, place)!);
  // The third landmark is a side pocket: the tap is far from it.
  pixels[2] = [pixels[2]![0] + 60, pixels[2]![1] - 40];
  for (const [x, y] of await places(dialog, pixels)) await page.mouse.click(x, y);
  await dialog.getByText(/points do not look like this table|No table looks like/).waitFor();
});

test("the keyboard marks the table, places a ball and moves it", async ({ open }) => {
  const page = await open({ viewport: WIDE });
  const dialog = await openDialog(page);
  await choosePhoto(dialog);
  await dialog.getByText("0 of 6").waitFor();
  let [x, y] = [SIZE[0] / 2, SIZE[1] / 2];
  /** Steps of 50 pixels with Shift, and of 5 without. */
  const press = async (key: string, times: number) => {
    for (let k = 0; k < times; k += 1) await page.keyboard.press(key);
  };
  const go = async (target: Point) => {
    for (const [axis, keys] of [
      [0, ["ArrowLeft", "ArrowRight"]],
      [1, ["ArrowUp", "ArrowDown"]],
    ] as const) {
      const steps = Math.round((target[axis] - [x, y][axis]!) / 5);
      const key = keys[steps > 0 ? 1 : 0];
      await press(`Shift+${key}`, Math.floor(Math.abs(steps) / 10));
      await press(key, Math.abs(steps) % 10);
      if (axis === 0) x += 5 * steps;
      else y += 5 * steps;
    }
    await page.keyboard.press("Enter");
  };
  for (const place of marks.places) await go(project(camera, place)!);
  await dialog.getByText("Balls that were found").waitFor();
  await page.keyboard.press("Control+z");
  await dialog.getByText("Tap the middle of the cue ball").waitFor();
  await go(project(camera, [...balls[0]!.position, RADIUS])!);
  await dialog.getByRole("img", { name: "The layout so far. Number of balls: 1" }).waitFor();
  const handle = dialog.getByRole("button", { name: "the cue ball in the photo" });
  await handle.focus();
  const before = (await handle.boundingBox())!;
  await press("Shift+ArrowRight", 2);
  expect((await handle.boundingBox())!.x).toBeGreaterThan(before.x);
  await page.keyboard.press("Delete");
  await dialog.getByRole("img", { name: "The layout so far. Number of balls: 0" }).waitFor();
});

for (const locale of ["en-GB", "de-DE"]) {
  test(`the buttons of the photo dialog are in view in a low window (${locale})`, async ({
    open,
  }) => {
    // Seen: the button that uses the layout was below the edge of the dialog.
    const page = await open({ viewport: { width: 844, height: 390 }, locale });
    await page.locator("#tab-layout").click();
    await page
      .locator("#panel-layout")
      .getByText(/photo|Foto/)
      .click();
    const dialog = page.locator(".photo-dialog");
    await choosePhoto(dialog);
    await dialog.locator(".photo-actions").waitFor();
    for (const [x, y] of await places(
      dialog,
      marks.places.map((place) => project(camera, place)!),
    ))
      await page.mouse.click(x, y);
    await dialog.locator(".photo-tray").waitFor();
    const box = (await dialog.boundingBox())!;
    const actions = (await dialog.locator(".photo-actions").boundingBox())!;
    expect(actions.y + actions.height).toBeLessThanOrEqual(box.y + box.height);
    const tray = (await dialog.locator(".photo-tray").boundingBox())!;
    expect(tray.y + tray.height).toBeLessThanOrEqual(actions.y);
    // Seen: the row was scrolled by the distance of the tray from the dialog.
    const chosen = (await dialog.locator(".photo-tray [aria-checked=true]").boundingBox())!;
    expect(chosen.x).toBeGreaterThanOrEqual(tray.x);
    expect(chosen.x + chosen.width).toBeLessThanOrEqual(tray.x + tray.width);
  });
}

for (const colorScheme of ["light", "dark"] as const) {
  test(`axe finds no violation in the photo dialog in ${colorScheme}`, async ({ open }) => {
    const page = await open({ viewport: PHONE, colorScheme });
    const dialog = await openDialog(page);
    expect(await violations(page), "without a photo").toEqual([]);
    await choosePhoto(dialog);
    await dialog.getByText("0 of 6").waitFor();
    const pixels = [
      ...marks.places.map((place) => project(camera, place)!),
      project(camera, [...balls[0]!.position, RADIUS])!,
    ];
    for (const [x, y] of await places(dialog, pixels)) await page.mouse.click(x, y);
    await foundBalls(dialog);
    expect(await violations(page), "with balls").toEqual([]);
  });
}
