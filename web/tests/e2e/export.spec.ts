/** The exported page: a file on disk without a network, a notebook, and a frame of a site. */

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Frame, Page } from "playwright-core";
import { afterAll, beforeAll } from "vitest";
import type { TraceFile } from "../../src/engine/index.ts";
import { expect, NATIVE, newContext, test, usable } from "./fixture.ts";

let folder = "";
beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "carom-"));
});
afterAll(() => {
  rmSync(folder, { recursive: true });
});

/** Switches the what-if simulation on and waits for its result, which needs a worker. */
async function simulateErrors(inside: Page | Frame): Promise<void> {
  await inside.getByRole("tab", { name: "What if" }).click();
  await inside.getByText("Simulate errors").click();
  await inside.locator("#panel-whatif td").first().waitFor();
}

function address(name: string): string {
  return pathToFileURL(join(folder, name)).href;
}

test("a page written by carom --html replays its shot from disk, without a network", async ({
  open,
}) => {
  const arguments_ = ["break", "--game", "nine-ball", "--json", "--html", join(folder, "a b.html")];
  const out = execFileSync(NATIVE, arguments_, { maxBuffer: 1e9 });
  const native = JSON.parse(out.toString()) as TraceFile;
  const page = await open({ url: address("a b.html"), offline: true });
  expect(await page.title()).toBe("nine-ball break · carom");
  const shown = await page.evaluate(() => {
    const { mode, replay } = window.carom!.store.session;
    const { trace } = replay;
    return { mode, hash: trace?.hash, again: trace?.shot.simulate().hash };
  });
  expect(shown).toEqual({ mode: "replay", hash: native.hash, again: native.hash });
  const fetched = await page.evaluate(() =>
    performance
      .getEntriesByType("resource")
      .map((entry) => entry.name)
      .filter((name) => !/^(data|blob):/.test(name)),
  );
  expect(fetched).toEqual([]);
});

test("a trace in a notebook plays in its frame and has no access to the notebook", async ({
  browser,
}) => {
  const program = `
import carom
trace = carom.break_shot("nine-ball").simulate()
print(trace._repr_html_())
`;
  const frame = execFileSync(join(dirname(NATIVE), "python"), ["-c", program], { maxBuffer: 1e9 });
  writeFileSync(
    join(folder, "notebook.html"),
    `<!doctype html><p>In [1]: trace</p>${frame.toString()}`,
  );
  const context = await newContext(browser, { offline: true });
  const page = await context.newPage();
  const errors: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  page.on("pageerror", (error) => errors.push(error.message));
  await page.goto(address("notebook.html"));
  const inside = page.frames()[1]!;
  await usable(inside);
  await inside.getByRole("button", { name: "Play", exact: true }).click();
  await inside.waitForFunction(() => window.carom!.store.session.replay.time > 0.5);
  const reached = await inside.evaluate(() => {
    try {
      return window.parent.document.body.textContent;
    } catch {
      return null;
    }
  });
  expect(reached).toBeNull();
  await inside.getByRole("button", { name: "Back to aiming" }).click();
  await simulateErrors(inside);
  expect(errors).toEqual([]);
  await context.close();
});

/** Cells of a notebook whose kernel is this program; the first one has the page. */
const CELLS = `
import json, sys, types
shell = types.SimpleNamespace(kernel=None, execution_count=1, get_parent=dict)
sys.modules["IPython"] = types.SimpleNamespace(get_ipython=lambda: shell, version_info=(9, 0))
import carom
shot = carom.break_shot("nine-ball")
shown = [shot, shot.simulate(), carom.Frame("snooker")]
print(json.dumps([thing._repr_html_() for thing in shown]))
`;

test("the cells of a notebook share one page, in whichever order they are drawn", async ({
  browser,
}) => {
  const python = join(dirname(NATIVE), "python");
  const out = execFileSync(python, ["-c", CELLS], { maxBuffer: 1e9 }).toString();
  const [shot, trace, frame] = JSON.parse(out) as [string, string, string];
  expect(trace.length).toBeLessThan(300_000);
  const written = (name: string, cells: string[]) => {
    writeFileSync(join(folder, name), `<!doctype html>${cells.join("<hr>")}`);
    return address(name);
  };
  // A frame that is out of view is not drawn, so all of them are in view.
  const viewport = { width: 1000, height: 2400 };
  const context = await newContext(browser, { offline: true, viewport });
  const page = await context.newPage();
  // The cell with the page is the last one here, as in a notebook that was sorted after its run.
  await page.goto(written("cells.html", [trace, frame, shot]));
  await page.waitForFunction(() => document.querySelectorAll("iframe").length === 2);
  const modes = [];
  for (const cell of page.frames().slice(1)) {
    await usable(cell);
    modes.push(await cell.evaluate(() => window.carom!.store.session.mode));
  }
  expect(modes.sort()).toEqual(["aim", "replay"]);
  // Without the cell with the page, and without scripts, the pictures stay.
  await page.goto(written("no-page.html", [trace, frame]));
  expect(await page.locator("img").count()).toBe(2);
  expect(await page.locator("iframe").count()).toBe(0);
  const untrusted = await newContext(browser, { javaScriptEnabled: false });
  const plain = await untrusted.newPage();
  await plain.goto(address("cells.html"));
  expect(await plain.locator("img").count()).toBe(3);
  await untrusted.close();
  await context.close();
});

test("an embedded trace plays by itself in a frame, then the remaining balls can be aimed at", async ({
  browser,
}) => {
  const program = `
import sys, carom, carom.page
trace = carom.Shot.from_json(sys.stdin.read()).simulate()
page = carom.page.html(trace).replace('id="carom-document"', 'id="carom-document" data-play', 1)
open(sys.argv[1], "w", encoding="utf-8").write(page)
`;
  const file = join(folder, "live.html");
  const shot = readFileSync(new URL("../../../shots/half_ball_cut.json", import.meta.url));
  execFileSync(join(dirname(NATIVE), "python"), ["-c", program, file], { input: shot });
  writeFileSync(
    join(folder, "site.html"),
    '<!doctype html><iframe src="live.html" style="width: 800px; height: 600px"></iframe>',
  );
  const context = await newContext(browser, { offline: true });
  const page = await context.newPage();
  // Seen: the browser reported a refused vibration and a refused sound.
  const said: string[] = [];
  page.on("console", (message) => {
    if (/vibrate|AudioContext/.test(message.text())) said.push(message.text());
  });
  await page.goto(address("site.html"));
  const inside = page.frames()[1]!;
  await inside.waitForFunction(() => window.carom?.store.session.mode === "replay");
  const trace = await inside.evaluate(() => {
    const { trace, playing } = window.carom!.store.session.replay;
    return { playing, balls: trace!.shot.balls.length };
  });
  expect(trace.playing).toBe(true);
  await inside.waitForFunction(() => window.carom!.store.session.mode === "aim");
  const { label, balls } = await inside.evaluate(() => {
    const { store } = window.carom!;
    return { label: store.undoLabel, balls: store.document.shot.balls.length };
  });
  expect(label).toBe("take it from here");
  expect(balls).toBeLessThanOrEqual(trace.balls);
  expect(said).toEqual([]);
  await context.close();
});

test("a shot in an exported page opens for aiming, with any names of balls", async ({ open }) => {
  const name = "</script><b>";
  const program = `
import sys, carom, carom.page
shot = carom.Shot("wpa-9ft", {"cue": (0.6, 0.6), sys.argv[2]: (0.6, 1.8)}, carom.Strike(speed=2, azimuth=1.5))
open(sys.argv[1], "w", encoding="utf-8").write(carom.page.html(shot))
`;
  const file = join(folder, "aim.html");
  execFileSync(join(dirname(NATIVE), "python"), ["-c", program, file, name]);
  expect(readFileSync(file, "utf-8")).not.toContain(name);
  const page = await open({ url: address("aim.html") });
  const [mode, ids] = await page.evaluate(() => {
    const { session, document } = window.carom!.store;
    return [session.mode, document.shot.balls.map((ball) => ball.id)];
  });
  expect(mode).toBe("aim");
  expect(ids).toEqual(["cue", name]);
  await simulateErrors(page);
});
