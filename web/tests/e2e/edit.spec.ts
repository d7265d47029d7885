import type { Page } from "playwright-core";
import { DESKTOP, expect, onPage, PHONE, picture, settled, shotOf, test } from "./fixture.ts";

const ball = async (page: Page, id: string) =>
  (await shotOf(page)).balls.find((one) => one.id === id)?.position;

async function drag(page: Page, from: readonly number[], to: readonly number[]): Promise<void> {
  const start = await onPage(page, from[0]!, from[1]!);
  const end = await onPage(page, to[0]!, to[1]!);
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.mouse.move(end.x, end.y, { steps: 6 });
  await settled(page);
}

/** Size of a pixel on the table, m. */
const PIXEL = 0.004;

test("a ball is dragged, undone and redone in one step each", async ({ open }) => {
  const page = await open();
  const before = (await ball(page, "3"))!;
  await drag(page, before, [0.6, 0.4]);
  await page.mouse.up();
  const after = (await ball(page, "3"))!;
  expect(Math.hypot(after[0] - 0.6, after[1] - 0.4)).toBeLessThan(PIXEL);
  await page.getByRole("button", { name: "Undo: move ball 3" }).click();
  expect(await ball(page, "3")).toEqual(before);
  await page.keyboard.press("Control+Shift+z");
  expect(await ball(page, "3")).toEqual(after);
  await page.keyboard.press("Control+z");
  expect(await ball(page, "3")).toEqual(before);
});

/** Distance between the centres of two balls, m. */
const between = ([x, y]: readonly number[], [u, v]: readonly number[]) =>
  Math.hypot(x! - u!, y! - v!);

test("a ball dragged onto another touches it, and one dragged into a rail is frozen to it", async ({
  open,
}) => {
  const page = await open();
  const target = (await ball(page, "1"))!;
  await drag(page, (await ball(page, "3"))!, target);
  await page.mouse.up();
  expect(Math.abs(between((await ball(page, "3"))!, target) - 2 * 0.028575)).toBeLessThan(1e-9);
  await drag(page, (await ball(page, "9"))!, [1.4, 0.5]);
  await page.mouse.up();
  const [x] = (await ball(page, "9"))!;
  // The nose is higher than the centre of a ball, so a frozen ball is a little under it.
  expect(1.27 - x).toBeGreaterThan(0.026);
  expect(1.27 - x).toBeLessThan(0.0286);
  const frozen = await page.evaluate(() => {
    const { store } = window.carom!;
    const before = store.shot.balls.find(({ id }) => id === "9")!.position;
    const further = [before[0] + 1e-6, before[1]] as const;
    const balls = store.document.shot.balls.map((one) =>
      one.id === "9" ? { ...one, position: further } : one,
    );
    return !store.apply({ shot: { ...store.document.shot, balls } }, "try");
  });
  expect(frozen, "a micrometre further is refused").toBe(true);
});

test("a ball dragged into a pocket is shown as refused, and goes back", async ({ open }) => {
  const page = await open();
  const before = (await ball(page, "3"))!;
  await drag(page, before, [1.28, 2.55]);
  const alert = page.getByRole("alert");
  expect(await alert.textContent()).toMatch(/pocket/);
  await picture(page, "refused");
  await page.mouse.up();
  await settled(page);
  expect(await page.evaluate(() => window.carom!.store.session.refusal?.shot ?? null)).toBeNull();
  // The reason stays until the next accepted change.
  expect(await alert.isVisible()).toBe(true);
  await page.getByRole("application", { name: /^Table/ }).focus();
  await page.keyboard.press("ArrowLeft");
  expect(await alert.isVisible()).toBe(false);
});

for (const viewport of [PHONE, { width: 1280, height: 800 }]) {
  const size = `${viewport.width}×${viewport.height}`;
  test(`a ball goes off the table into the tray, and back, at ${size}`, async ({ open }) => {
    const page = await open({ viewport });
    await page.getByRole("tab", { name: "Layout" }).click();
    const tray = page.getByRole("group", { name: "Tray" });
    expect(await tray.getByRole("button").count()).toBe(12);
    const start = await onPage(page, 0.35, 1.62);
    const table = (await page.locator("#table").boundingBox())!;
    await page.mouse.move(start.x, start.y);
    await page.mouse.down();
    await page.mouse.move(table.x + 2, table.y + 20, { steps: 5 });
    await settled(page);
    await page.mouse.up();
    expect(await ball(page, "1")).toBeUndefined();
    await page.getByRole("button", { name: "Undo: remove ball 1" }).click();
    expect(await ball(page, "1"), "in one step").toEqual([0.35, 1.62]);

    const chip = tray.getByRole("button", { name: "Put ball 5 on the table" });
    await chip.scrollIntoViewIfNeeded();
    const from = (await chip.boundingBox())!;
    const to = await onPage(page, 0.3, 2);
    await page.mouse.move(from.x + 5, from.y + 5);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 5 });
    await settled(page);
    await page.mouse.up();
    expect(between((await ball(page, "5"))!, [0.3, 2])).toBeLessThan(0.02);
    await tray.getByRole("button", { name: "Put ball 7 on the table" }).click();
    expect(await ball(page, "7")).toBeDefined();
    expect(await tray.getByRole("button").count()).toBe(10);
  });
}

test("racks, tables and balls are changed, and undo restores the first layout", async ({
  open,
}) => {
  const page = await open();
  const first = await shotOf(page);
  await page.getByRole("tab", { name: "Layout" }).click();
  await page.locator("#panel-layout").getByLabel("Game").selectOption("nine-ball");
  await page.locator("#panel-layout").getByLabel("Seed").fill("7");
  await page.getByRole("button", { name: "Rack", exact: true }).click();
  const racked = await shotOf(page);
  expect(racked.balls).toHaveLength(10);
  expect(
    await page.evaluate(() => window.carom!.engine.breakShot("nine-ball", { seed: 7 }).source),
  ).toEqual(racked);

  await page.getByRole("radio", { name: "5", exact: true }).click();
  await page.getByRole("button", { name: "Remove" }).click();
  expect(await ball(page, "5")).toBeUndefined();
  await page.getByLabel("New ball").fill("5");
  await page.getByRole("button", { name: "Add ball" }).click();
  expect(await ball(page, "5")).toBeDefined();
  await page.getByLabel("Across").first().fill("0.3");
  await page.getByLabel("Across").first().press("Enter");
  expect((await ball(page, "5"))![0]).toBe(0.3);
  await page.getByLabel("Across").first().fill("9");
  await page.getByLabel("Across").first().press("Enter");
  expect(await page.getByRole("alert").textContent()).toContain("outside the table");
  expect((await ball(page, "5"))![0]).toBe(0.3);

  await page.getByRole("combobox", { name: "Table" }).selectOption("wpa-8ft");
  expect((await shotOf(page)).table).toBe("wpa-8ft");
  for (let k = 0; k < 5; k += 1) await page.getByRole("button", { name: /^Undo: / }).click();
  expect(await shotOf(page)).toEqual(first);
  expect(await page.evaluate(() => window.carom!.store.undoLabel)).toBeNull();
});

test("every game can be racked on its table", async ({ open }) => {
  const page = await open();
  await page.getByRole("tab", { name: "Layout" }).click();
  const games = await page.evaluate(() => window.carom!.engine.games);
  expect(games.length).toBeGreaterThan(3);
  for (const game of games) {
    const list = page.locator("#panel-layout").getByLabel("Game");
    await list.selectOption(game);
    const [first = "", ...rest] = (await list.locator("option:checked").textContent()) ?? "";
    await page.getByRole("button", { name: "Rack", exact: true }).click();
    await settled(page);
    const name = first.toLowerCase() + rest.join("");
    expect(await page.evaluate(() => window.carom!.store.undoLabel)).toBe(`rack ${name}`);
  }
});

test("cloth, balls and rails are chosen, kept by the link, and taken back in one step each", async ({
  open,
}) => {
  const page = await open();
  await page.getByRole("tab", { name: "Physics" }).click();
  const panel = page.locator("#panel-physics");
  const chosen = () =>
    panel
      .locator(".labelled select:visible")
      .evaluateAll((lists) =>
        lists.map((list) => (list as HTMLSelectElement).selectedOptions[0]!.textContent),
      );
  const before = await shotOf(page);
  expect(await chosen()).toEqual(["As the table has it", "Used", "As the table has it"]);
  await panel.getByRole("combobox", { name: "Cloth" }).selectOption("Slow club cloth");
  expect((await shotOf(page)).physics).toBe("pool-worn-cloth");
  await panel.getByRole("combobox", { name: "Balls" }).selectOption("Dirty");
  await panel.getByRole("combobox", { name: "Rails" }).selectOption("Valley");
  const physics = {
    base: "pool-worn-cloth",
    ball_ball: { friction: { b: 0.1393, c: 0.455 } },
    cushion: { friction: 0.208 },
  };
  expect((await shotOf(page)).physics).toEqual(physics);
  await picture(page, "physics-choices");
  // What is chosen is also in the numbers.
  await panel.getByText("Numbers", { exact: true }).click();
  expect(await panel.getByRole("combobox", { name: "Preset" }).inputValue()).toBe(physics.base);
  await panel.getByText("Cushions", { exact: true }).click();
  const friction = panel.getByRole("spinbutton", { name: "Friction" });
  expect(await friction.last().inputValue()).toBe("0.208");

  await expect.poll(() => new URL(page.url()).hash).toMatch(/^#s=/);
  const hash = new URL(page.url()).hash;
  const other = await open({ hash });
  await other.getByRole("tab", { name: "Physics" }).click();
  const lists = other.locator("#panel-physics").getByRole("combobox");
  expect(
    await lists.evaluateAll((all) => all.map((one) => (one as HTMLSelectElement).value)),
  ).toEqual(["worn-cloth", "dirty-balls", "valley"]);
  const first = lists.first().locator("option").first();
  expect(await first.textContent()).toBe("As the table has it");

  const undo = page.getByRole("button", { name: "Undo: change the physics" });
  await undo.click();
  await undo.click();
  expect((await shotOf(page)).physics).toBe("pool-worn-cloth");
  await undo.click();
  expect(await shotOf(page)).toEqual(before);
  await panel.getByText("Numbers", { exact: true }).click();
  expect(await chosen()).toEqual(["As the table has it", "Used", "As the table has it"]);
});

test("own numbers of a cloth are shown, and a choice replaces them in one step", async ({
  open,
}) => {
  const page = await open();
  await page.getByRole("tab", { name: "Physics" }).click();
  const panel = page.locator("#panel-physics");
  const cloth = panel.getByRole("combobox", { name: "Cloth" });
  expect(await cloth.getByText("Own numbers").count()).toBe(0);
  await panel.getByText("Numbers", { exact: true }).click();
  const field = panel.getByRole("spinbutton", { name: "Sliding friction" });
  await field.fill("0.3");
  await field.press("Enter");
  expect(await cloth.inputValue()).toBe("numbers");
  await cloth.focus();
  await cloth.selectOption("New cloth");
  expect((await shotOf(page)).physics).toBe("pool-new-cloth");
  expect(await field.inputValue()).toBe("0.15");
  expect(await cloth.getByText("Own numbers").count()).toBe(0);
  await page.getByRole("button", { name: "Undo: change the physics" }).click();
  expect((await shotOf(page)).physics).toEqual({ cloth: { sliding_friction: 0.3 } });
  expect(await cloth.inputValue()).toBe("numbers");
  await cloth.selectOption("As the table has it");
  expect("physics" in (await shotOf(page))).toBe(false);
});

test("a snooker table has no choices, and with the physics of pool it has them", async ({
  open,
}) => {
  const page = await open();
  await page.getByRole("tab", { name: "Layout" }).click();
  await page.getByRole("combobox", { name: "Table" }).selectOption("snooker-12ft");
  await page.getByRole("tab", { name: "Physics" }).click();
  const panel = page.locator("#panel-physics");
  await panel.getByText(/^This physics has one cloth/).waitFor();
  expect(await panel.getByRole("combobox").count()).toBe(0);
  await panel.getByText("Numbers", { exact: true }).click();
  await panel.getByRole("combobox", { name: "Preset" }).selectOption("pool-valley");
  await panel.getByText(/^On new cloth balls roll further/).waitFor();
  const rails = panel.getByRole("combobox", { name: "Rails" });
  expect(await rails.inputValue()).toBe("valley");
  await rails.selectOption("Usual");
  // Not the table's own physics, which is that of snooker.
  expect((await shotOf(page)).physics).toBe("pool");
});

test("a physics parameter is changed, refused out of range, and reset", async ({ open }) => {
  const page = await open();
  await page.getByRole("tab", { name: "Physics" }).click();
  await page.getByText("Numbers", { exact: true }).click();
  const field = page.getByRole("spinbutton", { name: "Sliding friction" });
  await field.fill("0.3");
  await field.press("Enter");
  expect((await shotOf(page)).physics).toEqual({ cloth: { sliding_friction: 0.3 } });
  await field.fill("-1");
  await field.press("Enter");
  expect(await page.getByRole("alert").textContent()).toBe(
    "Cloth sliding friction: -1 is not possible. Write a number of at least 0.",
  );
  expect((await shotOf(page)).physics).toEqual({ cloth: { sliding_friction: 0.3 } });
  await page.getByRole("button", { name: "Reset cloth sliding friction" }).click();
  expect((await shotOf(page)).physics ?? {}).toEqual({});
});

test("of a preset a speed band and a rail's fit are changed and reset", async ({ open }) => {
  const page = await open();
  await page.getByRole("tab", { name: "Physics" }).click();
  await page.getByText("Numbers", { exact: true }).click();
  await page.getByRole("combobox", { name: "Preset" }).selectOption("Carom, heated");
  expect((await shotOf(page)).physics).toBe("carom");
  const write = async (quantity: string, name: string, value: string) => {
    const group = page.getByRole("group", { name: quantity, exact: true });
    const field = group.getByRole("spinbutton", { name, exact: true }).first();
    await field.fill(value);
    await field.press("Enter");
  };
  await write("Rolling friction", "Band 2, friction", "0.005");
  await page.getByText("Cushions", { exact: true }).click();
  await write("Restitution", "a", "0.9");
  const physics = (await shotOf(page)).physics as {
    cloth: { rolling_friction: readonly object[] };
  };
  const bands = await page.evaluate(
    () => window.carom!.engine.physics.carom!.cloth as { rolling_friction: readonly object[] },
  );
  expect(physics).toMatchObject({ base: "carom", cushion: { restitution: { a: 0.9 } } });
  expect(physics.cloth.rolling_friction).toEqual(
    bands.rolling_friction.map((band, k) => (k === 1 ? { ...band, friction: 0.005 } : band)),
  );
  await page.getByRole("button", { name: "Reset cushions restitution a" }).click();
  await page.getByRole("button", { name: "Reset cloth rolling friction band 2 friction" }).click();
  expect((await shotOf(page)).physics).toEqual({ base: "carom" });
});

test("a coefficient is given as a number or by speed, and back", async ({ open }) => {
  const page = await open();
  await page.getByRole("tab", { name: "Physics" }).click();
  await page.getByText("Numbers", { exact: true }).click();
  const physics = async () => (await shotOf(page)).physics ?? {};
  const group = (name: string) => page.getByRole("group", { name, exact: true });
  const given = (name: string) => group(name).getByRole("combobox", { name: "Given" });
  // Rolling friction: the preset has a number.
  await given("Rolling friction").selectOption("by speed");
  const bands = [{ up_to: 1, friction: 0.01 }, { friction: 0.01 }];
  expect(await physics()).toEqual({ cloth: { rolling_friction: bands } });
  expect(await given("Rolling friction").evaluate((e) => e === document.activeElement)).toBe(true);
  const faster = group("Rolling friction").getByRole("spinbutton", { name: "Band 2, friction" });
  await faster.fill("0.012");
  await faster.press("Enter");
  bands[1] = { friction: 0.012 };
  expect(await physics()).toEqual({ cloth: { rolling_friction: bands } });
  await page.getByRole("button", { name: "Reset how cloth rolling friction is given" }).click();
  expect(await physics()).toEqual({});
  // The restitution of the cushions: the preset has a fit, 1.04 − 0.05 V.
  await page.getByText("Cushions", { exact: true }).click();
  await given("Restitution").selectOption("as a number");
  expect(await physics()).toEqual({ cushion: { restitution: 0.99 } });
  const number = group("Restitution").getByRole("spinbutton", { name: "Restitution" });
  await number.fill("0.9");
  await number.press("Enter");
  expect(await physics()).toEqual({ cushion: { restitution: 0.9 } });
  expect(
    await page.evaluate(() => window.carom!.store.shot.coefficientAt("cushion.restitution", 4)),
  ).toBe(0.9);
  await given("Restitution").selectOption("by speed");
  expect(await physics()).toEqual({});
  await page.getByRole("button", { name: "Undo: change cushions restitution" }).click();
  expect(await physics()).toEqual({ cushion: { restitution: 0.9 } });
  expect(await given("Restitution").inputValue()).toBe("number");
});

for (const [device, viewport] of [
  ["a desktop", DESKTOP],
  ["a phone", PHONE],
] as const) {
  test(`on ${device} the lists and rows of the physics fit their panel`, async ({ open }) => {
    const page = await open({ viewport });
    // The texts of this table and of its physics are the longest.
    const table = "english-7ft-2026-11";
    await page.getByRole("tab", { name: "Layout" }).click();
    await page.getByRole("combobox", { name: "Table" }).selectOption(table);
    expect((await shotOf(page)).table).toBe(table);
    const tooWide = (tab: string) =>
      page.evaluate((id) => {
        const panel = document.querySelector<HTMLElement>(`#panel-${id}`)!;
        for (const group of panel.querySelectorAll("details")) group.open = true;
        // The heading is as wide as the panel's contents. Half a pixel is for fractions of widths.
        const right = panel.querySelector("h2")!.getBoundingClientRect().right + 0.5;
        return [...panel.querySelectorAll("select, input, button, .unit, .hint")]
          .filter((element) => element.getBoundingClientRect().right > right)
          .map((element) => element.outerHTML);
      }, tab);
    for (const tab of ["Layout", "Physics"]) {
      await page.getByRole("tab", { name: tab }).click();
      expect(await tooWide(tab.toLowerCase()), tab).toEqual([]);
    }
    for (const preset of ["pool", "carom", "snooker"]) {
      await page.getByRole("combobox", { name: "Preset" }).selectOption(preset);
      expect(await tooWide("physics"), preset).toEqual([]);
    }
  });
}

test("table dimensions are changed, refused with the reason, reset and undone", async ({
  open,
}) => {
  const page = await open();
  await page.getByRole("tab", { name: "Layout" }).click();
  await page.getByText("Dimensions", { exact: true }).click();
  const table = async () => (await shotOf(page)).table;
  const write = async (name: string, value: string, nth = 0) => {
    const field = page.getByRole("spinbutton", { name, exact: true }).nth(nth);
    await field.fill(value);
    await field.press("Enter");
  };
  const refusal = page.getByRole("alert");

  await page.getByText("Corner pockets", { exact: true }).click();
  await write("Mouth", "0.125");
  expect(await table()).toEqual({ base: "wpa-9ft", corner_pocket: { mouth: 0.125 } });
  const mouth = await page.evaluate(() =>
    window.carom!.store.shot.geometry.dimensions!.find(({ key }) => key === "corner_pocket.mouth"),
  );
  expect(mouth?.value).toBe(0.125);

  await write("Mouth", "-1");
  expect(await refusal.textContent()).toBe(
    "Corner pockets mouth: -1 is not possible. Write a number above 0.",
  );
  await write("Mouth", "0.4");
  expect(await refusal.textContent()).toContain("corner_pocket.shelf");
  // A ball of the first shot is 0.98 m from the left cushion.
  await write("Width", "0.9");
  expect(await refusal.textContent()).toMatch(/^Ball 3 .*table/);
  expect(await table()).toEqual({ base: "wpa-9ft", corner_pocket: { mouth: 0.125 } });
  await page.getByRole("button", { name: "Reset corner pockets mouth" }).click();
  expect(await table()).toBe("wpa-9ft");

  await write("Length", "2");
  expect(await table()).toMatchObject({
    base: "wpa-9ft",
    length: 2,
    markings: { head_string: 0.5 },
  });
  await page.getByRole("button", { name: "Reset all" }).click();
  expect(await table()).toBe("wpa-9ft");
  await page.getByRole("combobox", { name: "Pocket model" }).selectOption("mouth-line");
  expect(await table()).toEqual({ base: "wpa-9ft", pocket_model: "mouth-line" });
  await page.locator("body").press("Control+z");
  await page.locator("body").press("Control+z");
  expect(await table()).toMatchObject({ length: 2 });
  expect(await page.getByRole("spinbutton", { name: "Length", exact: true }).inputValue()).toBe(
    "2",
  );
});
