/** Drills, their results, the puzzle of the day and the printed sheets. */

import type { Page } from "playwright-core";
import stored from "../unit/train/puzzles.json";
import { violations } from "./axe.ts";
import { contentsOf, expect, PHONE, settled, shotOf, test } from "./fixture.ts";

const SIZES = [{ width: 1280, height: 800 }, PHONE] as const;

/** Opens the drills; on a phone the sheet with them. */
async function train(page: Page): Promise<void> {
  await page.getByRole("radio", { name: "Train" }).click();
  await page.locator("#panel-train .drill-list").waitFor();
}

/** Opens a drill and begins it on the table, without errors. */
async function begin(page: Page, id: string, errors = ""): Promise<void> {
  await page.locator(`#drill-${id}`).click();
  await page.locator("#drill-errors").selectOption(errors);
  await page.getByRole("button", { name: "Play here" }).click();
  await settled(page);
}

/** Shoots, and waits until the balls are set for the next attempt. */
async function shoot(page: Page, strike: object): Promise<void> {
  await page.evaluate((patch) => window.carom!.store.strike(patch, "aim"), strike);
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.waitForFunction(() => window.carom!.store.session.mode === "aim");
  await settled(page);
}

const attempt = (page: Page) => page.evaluate(() => window.carom!.store.session.attempt);
const results = (page: Page) =>
  page.evaluate(() => {
    const text = localStorage.getItem("carom-progress");
    return text === null ? null : (JSON.parse(text) as { results: unknown[]; puzzles: unknown[] });
  });
const clear = (page: Page) => page.evaluate(() => localStorage.clear());

for (const viewport of SIZES) {
  const size = `${viewport.width}×${viewport.height}`;

  test(`a drill is played, judged and kept at ${size}, and the earlier shot comes back`, async ({
    open,
  }) => {
    const page = await open({ viewport, reducedMotion: "reduce" });
    await clear(page);
    const before = await page.evaluate(() => window.carom!.store.document);
    await train(page);
    await begin(page, "straight");
    expect((await shotOf(page)).balls).toHaveLength(2);
    const made = { azimuth_deg: 0, speed: 2 };
    for (let k = 0; k < 10; k += 1) {
      // The third attempt misses.
      const aim = await page.evaluate(() => {
        const found = window.carom!.store.shot.potAim("1", "top-right")!;
        return (found.strike.azimuth * 180) / Math.PI;
      });
      await shoot(page, { ...made, azimuth_deg: k === 2 ? aim + 90 : aim });
      const said = await page.locator("#panel-train").textContent();
      expect(said, `attempt ${k + 1}`).toContain(k === 2 ? "Missed: ball 1" : "Made.");
    }
    // Steps 1, 2, 3 missed, 2, 3, 4, 5, 6, 7, 7.
    expect(await page.locator("#panel-train").textContent()).toContain("Finished: 37 of 49.");
    expect(await results(page)).toMatchObject({
      results: [
        { drill: "straight", place: "page", points: [1, 2, 0, 2, 3, 4, 5, 6, 7, 7], errors: null },
      ],
    });
    expect(await attempt(page)).toBeNull();
    await page.getByRole("button", { name: "Leave" }).click();
    expect(await page.evaluate(() => window.carom!.store.document)).toEqual(before);
    // Undo leads back through the drill, and redo out of it.
    await page.keyboard.press("Control+z");
    expect((await shotOf(page)).balls).toHaveLength(2);
    await page.keyboard.press("Control+y");
    expect(await page.evaluate(() => window.carom!.store.document)).toEqual(before);
    await clear(page);
  });

  test(`results of a real table are tapped, taken back and shown at ${size}`, async ({ open }) => {
    const page = await open({ viewport });
    await clear(page);
    await train(page);
    const before = await page.evaluate(() => window.carom!.store.document);
    await page.locator("#drill-spot").click();
    await page.getByRole("button", { name: "At a real table" }).click();
    // Seen: the buttons were below the edge of a phone.
    for (const name of ["Made", "Missed"]) {
      const box = (await page.getByRole("button", { name, exact: true }).boundingBox())!;
      expect(box.y + box.height, name).toBeLessThanOrEqual(viewport.height);
    }
    // Seen: the hint touched the diagram below it.
    const hint = (await page.locator("#panel-train .hint").first().boundingBox())!;
    const picture = (await page.locator("#panel-train .diagram").boundingBox())!;
    expect(picture.y - hint.y - hint.height).toBeGreaterThanOrEqual(8);
    const tap = (name: string) => page.getByRole("button", { name, exact: true }).click();
    for (let k = 0; k < 9; k += 1) await tap(k % 3 === 0 ? "Made" : "Missed");
    await tap("Take back the last one");
    await tap("Made");
    await tap("Missed");
    expect(await results(page)).toMatchObject({
      results: [{ drill: "spot", place: "table", points: [1, 0, 0, 1, 0, 0, 1, 0, 1, 0] }],
    });
    expect(await page.locator("#panel-train").textContent()).toMatch(
      /Finished: 4 of 10\..*Like this level: Club\./,
    );
    expect(await page.locator(".history-curve").isVisible()).toBe(true);
    await tap("Leave");
    await tap("All drills");
    const name = /^Spot shot Best 4 of 10$/;
    expect(await page.getByRole("button", { name }).count()).toBe(1);
    expect(await page.evaluate(() => window.carom!.store.document)).toEqual(before);
    await clear(page);
  });

  test(`the puzzle of the day is made in the page and solved at ${size}`, async ({ open }) => {
    // A time zone gives the test a tab of its own, because the clock of a tab stays fixed.
    const timezoneId = viewport === PHONE ? "Asia/Shanghai" : "Europe/Berlin";
    const page = await open({ viewport, timezoneId, reducedMotion: "reduce" });
    await clear(page);
    await page.clock.setFixedTime("2026-11-24T12:00:00Z");
    await train(page);
    await page.getByRole("button", { name: "Play the puzzle" }).click();
    const puzzle = stored["2026-11-24"];
    const { balls } = await shotOf(page);
    for (const { id, position } of balls) {
      const [x, y] = puzzle.drill.steps[0]!.balls[id as "cue" | "9" | "5"];
      expect(position[0]).toBeCloseTo((x! * 1.27) / 4, 4);
      expect(position[1]).toBeCloseTo((y! * 2.54) / 8, 4);
    }
    await shoot(page, { azimuth_deg: 3, speed: 1 });
    const { speed, azimuth, elevation, side, height } = puzzle.solution;
    const degrees = (radians: number) => (radians * 180) / Math.PI;
    await page.evaluate(() => window.carom!.store.session.attempt);
    await shoot(page, {
      speed,
      side,
      height,
      azimuth_deg: degrees(azimuth),
      elevation_deg: degrees(elevation),
    });
    expect(await page.locator("#panel-train").textContent()).toContain("Solved with 2 shots.");
    expect(await results(page)).toMatchObject({
      puzzles: [{ date: "2026-11-24", tries: 2, solved: true }],
    });
    await page.getByRole("button", { name: "Leave" }).click();
    await page.getByText("1 day in a row").waitFor();
    await clear(page);
  });

  for (const colorScheme of ["light", "dark"] as const) {
    test(`axe finds no violation in the drills at ${size} in ${colorScheme}`, async ({ open }) => {
      const page = await open({ viewport, colorScheme, reducedMotion: "reduce" });
      await clear(page);
      await train(page);
      await page.getByRole("button", { name: "Play the puzzle" }).waitFor();
      expect(await violations(page), "overview").toEqual([]);
      await page.getByRole("button", { name: "Drills on the sheet" }).click();
      expect(await violations(page), "sheet").toEqual([]);
      await page.getByRole("button", { name: "All drills" }).click();
      await page.locator("#drill-lag").click();
      expect(await violations(page), "drill").toEqual([]);
      await page.getByRole("button", { name: "At a real table" }).click();
      for (let k = 0; k < 9; k += 1) await page.locator("#tap-2").click();
      expect(await violations(page), "real table").toEqual([]);
      await page.locator("#tap-0").click();
      expect(await violations(page), "result").toEqual([]);
      await page.getByRole("button", { name: "Leave" }).click();
      await page.getByRole("button", { name: "Play here" }).click();
      expect(await violations(page), "in play").toEqual([]);
      await clear(page);
    });
  }

  test(`the Train tab fits the width in every language at ${size}`, async ({ open }) => {
    for (const locale of ["en-GB", "de", "zh-CN"]) {
      const page = await open({ viewport, locale });
      await page.evaluate(() => window.carom!.store.setSession({ activity: "train" }));
      await page.locator("#drill-stop").waitFor();
      const beyond = () =>
        page.evaluate(() => {
          const panel = document.getElementById("panel-train")!;
          return panel.scrollWidth - panel.clientWidth;
        });
      expect(await beyond(), `${locale}, overview`).toBeLessThanOrEqual(0);
      await page.locator("#drill-colours").click();
      expect(await beyond(), `${locale}, drill`).toBeLessThanOrEqual(0);
      await page.locator("#table-drill").click();
      expect(await beyond(), `${locale}, run`).toBeLessThanOrEqual(0);
    }
  });
}

test("while a drill is aimed, neither the table nor the dock shows how the shot ends", async ({
  open,
}) => {
  const page = await open();
  await train(page);
  await begin(page, "kick");
  await page.evaluate(() => window.carom!.store.strike({ azimuth_deg: 30 }, "aim"));
  await settled(page);
  expect(await page.locator("#outcome").textContent()).toMatch(/^The 8 is in the way.*Attempt 1/);
  await page.getByRole("radio", { name: "Analyse" }).click();
  await settled(page);
  expect(await page.locator("#outcome").textContent()).not.toContain("Attempt 1");
  await page.getByRole("radio", { name: "Train" }).click();
  expect((await attempt(page))!.text).toContain("Attempt 1");
});

test("a shot with the errors of a level differs from the aim, and from the next one", async ({
  open,
}) => {
  const page = await open({ reducedMotion: "reduce" });
  await clear(page);
  await train(page);
  await begin(page, "lag", "club");
  const hashes = new Set<string>();
  const aimed = await page.evaluate(() => window.carom!.store.ghost.trace!.hash);
  for (let k = 0; k < 3; k += 1) {
    await page.getByRole("button", { name: "Shoot" }).click();
    hashes.add(await page.evaluate(() => window.carom!.store.session.replay.trace!.hash));
    await page.waitForFunction(() => window.carom!.store.session.mode === "aim");
  }
  expect(hashes.size).toBe(3);
  expect(hashes.has(aimed)).toBe(false);
  await clear(page);
});

test("a shot of balls that were moved does not count, and they are set again", async ({ open }) => {
  const page = await open({ reducedMotion: "reduce" });
  await train(page);
  await begin(page, "thin");
  await page.evaluate(() => {
    const { store } = window.carom!;
    const { shot } = store.document;
    const balls = shot.balls.map((ball) =>
      ball.id === "1" ? { ...ball, position: [0.6, 1] as const } : ball,
    );
    store.apply({ shot: { ...shot, balls } }, "move");
  });
  await page.getByText("Not counted: the balls lie elsewhere").waitFor();
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.waitForFunction(() => window.carom!.store.session.mode === "aim");
  expect((await attempt(page))!.text).toContain("Attempt 1 of 10");
  expect((await shotOf(page)).balls.find(({ id }) => id === "1")!.position[1]).toBeGreaterThan(2);
});

test("a run goes on where the balls stop, and the next attempt has the layout again", async ({
  open,
}) => {
  const page = await open({ reducedMotion: "reduce" });
  await clear(page);
  await train(page);
  await begin(page, "three");
  const layout = (await shotOf(page)).balls;
  await page.evaluate(() => window.carom!.store.aimAtPocket("1", "top-right", "aim"));
  await shoot(page, {});
  expect((await attempt(page))!.text).toContain("Good, 2 balls to go.");
  const left = (await shotOf(page)).balls;
  expect(left.map(({ id }) => id).sort()).toEqual(["2", "8", "cue"]);
  await page.evaluate(() => window.carom!.store.setSession({ lock: null }));
  await shoot(page, { azimuth_deg: 270, speed: 0.3 });
  expect((await attempt(page))!.text).toContain("The run ends after 1 ball.");
  expect((await shotOf(page)).balls).toEqual(layout);
  await page.getByRole("button", { name: "Leave" }).click();
});

test("progress is saved as a file and added without duplicates; a damaged file changes nothing", async ({
  open,
}) => {
  const page = await open();
  await clear(page);
  await train(page);
  await page.locator("#drill-bank").click();
  await page.locator("#table-drill").click();
  for (let k = 0; k < 10; k += 1) await page.locator("#tap-1").click();
  await page.getByRole("button", { name: "Leave" }).click();
  await page.getByRole("button", { name: "All drills" }).click();
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save as a file" }).click();
  const saved = String(await contentsOf(await download));
  const kept = await results(page);
  const add = (buffer: Buffer, name = "progress.json") =>
    page.locator("#progress-file").setInputFiles({ name, mimeType: "application/json", buffer });
  await add(Buffer.from(saved));
  await page.getByText("0 new results added.").waitFor();
  expect(await results(page)).toEqual(kept);
  await clear(page);
  await page.reload();
  await page.waitForFunction(() => window.carom !== undefined);
  await train(page);
  await add(Buffer.from(saved));
  await page.getByText("1 new result added.").waitFor();
  expect(await results(page)).toEqual(kept);
  for (const [text, sentence] of [
    ["{", "is damaged or no progress file"],
    ['{"format": "carom-shot/1"}', "is no progress of this page"],
    [saved.replace("table", "moon"), "is damaged at results[0].place"],
  ] as const) {
    await add(Buffer.from(text), "bad.json");
    await page.getByText(`bad.json ${sentence}`).waitFor();
    expect(await results(page)).toEqual(kept);
  }
  // Seen: the refusal of the damaged file stayed beside the confirmation of the whole one.
  await add(Buffer.from(saved));
  await page.getByText("0 new results added.").waitFor();
  expect(await page.locator("#refusal").isVisible()).toBe(false);
  await clear(page);
});

test("progress is deleted by two presses, and by one it is kept", async ({ open }) => {
  const page = await open();
  await clear(page);
  await train(page);
  // Without a result there is nothing to delete.
  expect(await page.locator("#delete-progress").count()).toBe(0);
  await page.locator("#drill-bank").click();
  await page.locator("#table-drill").click();
  for (let k = 0; k < 10; k += 1) await page.locator("#tap-1").click();
  await page.getByRole("button", { name: "Leave" }).click();
  await page.getByRole("button", { name: "All drills" }).click();
  const kept = await results(page);
  expect(kept?.results).toHaveLength(1);
  const ask = page.getByRole("button", { name: "Delete it" });
  await ask.click();
  await page.getByRole("button", { name: "Keep it" }).click();
  expect(await ask.evaluate((button) => button === document.activeElement)).toBe(true);
  expect(await results(page)).toEqual(kept);
  await ask.click();
  await page.getByRole("button", { name: "Delete 1 result for good" }).click();
  await page.getByText("1 result deleted.").waitFor();
  expect(await results(page)).toBeNull();
  expect(await page.locator("#drill-bank").textContent()).toContain("Not played yet");
  expect(await ask.count()).toBe(0);
});

test("damaged progress in the browser is set aside and can be saved", async ({ open }) => {
  const page = await open();
  await page.evaluate(() => localStorage.setItem("carom-progress", "{damaged"));
  await page.reload();
  await page.waitForFunction(() => window.carom !== undefined);
  await train(page);
  await page.getByText("The stored progress could not be read").waitFor();
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save the old one" }).click();
  expect(String(await contentsOf(await download))).toBe("{damaged");
  expect(await page.evaluate(() => localStorage.getItem("carom-progress-damaged-1"))).toBe(
    "{damaged",
  );
  await clear(page);
});

test("a damaged drill in progress is reported, and the page works", async ({ open }) => {
  // Seen: an exception while the page was mounted.
  const page = await open();
  await page.evaluate(() => {
    addEventListener("pagehide", () => sessionStorage.setItem("carom-drill", "{damaged"));
  });
  await page.reload();
  await page.getByText("The drill that was under way could not be read").waitFor();
  await train(page);
  await begin(page, "stop");
  expect((await attempt(page))!.text).toContain("Attempt 1 of 10");
});

/** A drawing's unit: points of 1/72 inch. */
const PAPERS = { a4: [595, 842], letter: [612, 792] } as const;

for (const locale of ["en-GB", "de", "zh-CN"]) {
  test(`a sheet is one page of the paper, with diagrams to scale (${locale})`, async ({ open }) => {
    const page = await open({ locale });
    await page.evaluate(() => {
      window.print = () => undefined;
      window.carom!.store.setSession({ activity: "train" });
    });
    await page.locator("#open-sheet").click();
    for (const [paper, [width, height]] of Object.entries(PAPERS)) {
      for (const drills of [
        ["wheel"],
        ["long", "colours"],
        ["stop", "wheel", "long", "colours", "cushions", "ghost"],
      ]) {
        await page.evaluate((ids) => {
          for (const box of document.querySelectorAll<HTMLInputElement>(".sheet-choice input")) {
            if (box.checked && !ids.includes(box.id.replace("sheet-", ""))) box.click();
          }
          for (const id of ids) {
            const box = document.querySelector<HTMLInputElement>(`#sheet-${id}`)!;
            if (!box.checked) box.click();
          }
        }, drills);
        await page.locator("#sheet-paper").selectOption(paper);
        await page.locator("#print-sheet").click();
        const pictures = await page
          .locator(".sheet .diagram")
          .evaluateAll((all) =>
            all.map((one) => [one.getAttribute("width"), one.getAttribute("viewBox")]),
          );
        expect(pictures).toHaveLength(drills.length);
        const scale = { 1: 25, 2: 40 }[drills.length] ?? 50;
        for (const [drawn, box] of pictures) {
          expect(Number.parseFloat(drawn!) * scale).toBeCloseTo(Number(box!.split(" ")[2]), 0);
          expect(drawn).toMatch(/mm$/);
        }
        const pdf = (await page.pdf({ preferCSSPageSize: true })).toString("latin1");
        expect(pdf.match(/\/Type\s*\/Page[^s]/g), `${drills.join()} on ${paper}`).toHaveLength(1);
        const [, w, h] = /\/MediaBox\s*\[0 0 ([\d.]+) ([\d.]+)\]/.exec(pdf)!;
        expect([Number(w), Number(h)].map(Math.round)).toEqual([width, height]);
        // Printing is over: the page is as before.
        expect(await page.locator(".sheet").count()).toBe(0);
      }
    }
  });
}

test("a seventh drill does not fit on a sheet, and a sheet needs one", async ({ open }) => {
  const page = await open();
  await train(page);
  await page.locator("#open-sheet").click();
  for (const id of ["wheel", "lag"]) await page.locator(`#sheet-${id}`).check();
  await page.locator("#sheet-bank").click();
  expect(await page.locator("#sheet-bank").isChecked()).toBe(false);
  await page.getByText("A sheet has room for six drills").waitFor();
  for (const id of ["stop", "follow", "draw", "cuts", "wheel", "lag"]) {
    await page.locator(`#sheet-${id}`).uncheck();
  }
  await page.locator("#print-sheet").click();
  await page.getByText("Choose a drill for the sheet first").waitFor();
});

test("a drill at a real table is played by keyboard alone", async ({ open }) => {
  const page = await open();
  await clear(page);
  await train(page);
  await page.locator("#drill-bank").focus();
  await page.keyboard.press("Enter");
  expect(await page.evaluate(() => document.activeElement?.textContent)).toBe("Cross-side bank");
  for (let k = 0; k < 3; k += 1) await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  const press = async (text: string) => {
    for (let k = 0; k < 20; k += 1) {
      if ((await page.evaluate(() => document.activeElement?.textContent)) === text) break;
      await page.keyboard.press("Tab");
    }
    await page.keyboard.press("Enter");
  };
  await press("Made");
  // The focus stays on the button, so that Enter counts the next attempt.
  for (let k = 0; k < 9; k += 1) await page.keyboard.press("Enter");
  expect(await page.locator("#panel-train").textContent()).toContain("Finished: 10 of 10.");
  await clear(page);
});

test("the puzzle is made in a worker, which ends with it", async ({ open }) => {
  const page = await open();
  const ended: Promise<unknown>[] = [];
  page.on("worker", (worker) => ended.push(worker.waitForEvent("close")));
  await page.evaluate(() => window.carom!.store.setSession({ activity: "train" }));
  await page.waitForSelector("#play-puzzle");
  // The worker of Analyse may start in the same time; it does not end.
  expect(ended).not.toHaveLength(0);
  await Promise.race(ended);
});

test("a reload keeps a drill, and counts the shot that was under way", async ({ open }) => {
  const page = await open({ viewport: SIZES[0] });
  await train(page);
  const before = await shotOf(page);
  await begin(page, "stop");
  await page.evaluate(() => window.carom!.store.strike({ azimuth_deg: 200, speed: 1 }, "miss"));
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.reload();
  await page.waitForFunction(() => performance.getEntriesByName("carom:interactive").length > 0);
  const boxes = page.locator(".attempts li[data-made]");
  await expect.poll(() => boxes.count()).toBe(1);
  expect(await page.evaluate(() => window.carom!.store.session.attempt !== null)).toBe(true);
  expect(await page.evaluate(() => window.carom!.store.session.mode)).toBe("aim");
  await page.getByRole("button", { name: "Leave" }).click();
  expect((await shotOf(page)).balls).toEqual(before.balls);
});
