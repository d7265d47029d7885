import { readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import type { ShotFile, TraceFile } from "../../src/engine/index.ts";
import { toFragment } from "../../src/app/share/link.ts";
import { contentsOf, expect, native, picture, shotOf, pressTool, SMALL, test } from "./fixture.ts";
import { python } from "./python.ts";

const ROOT = new URL("../../../", import.meta.url);
const read = (path: string): string => readFileSync(new URL(path, ROOT), "utf8");
const example = (name: string): string => read(`shots/${name}.json`);
const GOLDENS = JSON.parse(read("goldens/shots.json")) as Record<string, { hash: string }>;

/** Time limit (ms) of tests that draw hundreds of pictures in software. */
const SLOW = 120_000;

const CLIPBOARD = { permissions: ["clipboard-read", "clipboard-write"] };

/** The hash of the shot that the page would play. */
const hash = (page: Page) => page.evaluate(() => window.carom!.store.ghost.trace!.hash);

async function openShare(page: Page): Promise<void> {
  await pressTool(page, "Share");
}

async function download(page: Page, button: string): Promise<{ name: string; content: Buffer }> {
  const [file] = await Promise.all([
    page.waitForEvent("download", { timeout: 100_000 }),
    page.getByRole("button", { name: button }).click(),
  ]);
  return { name: file.suggestedFilename(), content: await contentsOf(file) };
}

async function copied(page: Page, button: string): Promise<string> {
  await page.getByRole("button", { name: button }).click();
  await page.getByText(/copied\.$/).waitFor();
  return page.evaluate(() => navigator.clipboard.readText());
}

/** Drops a file on the table. */
async function drop(page: Page, name: string, content: string): Promise<void> {
  const dataTransfer = await page.evaluateHandle(
    ([fileName, text]) => {
      const data = new DataTransfer();
      data.items.add(new File([text], fileName));
      return data;
    },
    [name, content] as const,
  );
  for (const type of ["dragenter", "dragover", "drop"]) {
    await page.dispatchEvent("#stage", type, { dataTransfer });
  }
}

test("a link opens the same shot, noise, seed and view elsewhere", async ({ open }) => {
  const page = await open(CLIPBOARD);
  await page.evaluate(() => {
    const { store } = window.carom!;
    store.strike({ azimuth_deg: 71.23456789, side: 0.3, elevation_deg: 12.3 }, "aim");
    const sigmas = { speed: 0.1, azimuth: 0.003, elevation: 0, side_m: 0.001, height_m: 0 };
    const noise = { ...sigmas, cling_probability: 0.05, cling_friction: 0.3 };
    store.apply({ noise, seed: 77 }, "noise");
    store.setView({ units: "mph" });
  });
  await openShare(page);
  const other = await open({ url: await copied(page, "Copy link") });
  expect(await hash(other)).toBe(await hash(page));
  expect(native(await shotOf(other)).hash).toBe(await hash(page));
  const rest = (p: Page) =>
    p.evaluate(() => {
      const { document, view } = window.carom!.store;
      return { noise: document.noise, seed: document.seed, view };
    });
  expect(await rest(other)).toEqual(await rest(page));
  expect((await rest(other)).seed).toBe(77);
});

test("a link made during a replay opens at the same time of the replay", async ({ open }) => {
  const page = await open(CLIPBOARD);
  await page.getByRole("button", { name: "Shoot" }).click();
  await page.getByRole("button", { name: "Pause" }).click();
  await page.getByRole("button", { name: "Next event" }).click();
  await openShare(page);
  const other = await open({ url: await copied(page, "Copy link") });
  const session = (p: Page) =>
    p.evaluate(() => {
      const { mode, replay } = window.carom!.store.session;
      const { time, playing } = replay;
      return { mode, time, playing };
    });
  expect(await session(other)).toEqual(await session(page));
  expect((await session(other)).mode).toBe("replay");
});

test(
  "every example shot that is dropped has its golden hash, and the last one survives a reload",
  async ({ open }) => {
    const page = await open();
    for (const [name, golden] of Object.entries(GOLDENS)) {
      await drop(page, `${name}.json`, example(name));
      await expect.poll(() => hash(page), { message: name }).toBe(golden.hash);
    }
    // The address is updated after a short time without changes.
    const link = await page.evaluate(() => location.hash);
    await expect.poll(() => page.evaluate(() => location.hash)).not.toBe(link);
    const last = await hash(page);
    await page.reload();
    await page.waitForFunction(() => window.carom);
    expect(await hash(page)).toBe(last);
  },
  SLOW,
);

test("the address follows the document without adding to the browser's history", async ({
  open,
}) => {
  const page = await open();
  const entries = await page.evaluate(() => history.length);
  for (const speed of [1, 2, 3]) {
    const link = await page.evaluate(() => location.hash);
    await page.evaluate((s) => window.carom!.store.strike({ speed: s }, "speed"), speed);
    await expect.poll(() => page.evaluate(() => location.hash)).not.toBe(link);
  }
  expect(await page.evaluate(() => location.hash)).toMatch(/^#s=1\./);
  expect(await page.evaluate(() => history.length)).toBe(entries);
});

test("a link with a malformed shot or a huge noise opens the first shot and names the fault", async ({
  open,
  close,
}) => {
  const first = await hash(await open());
  const shot = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [{ id: "cue", position: [0.5, 1] }],
  };
  const noise = { speed: 1e9, azimuth: 0, elevation: 0, side_m: 0, height_m: 0 };
  for (const [data, words] of [
    [{ shot: {} }, /format/],
    [{ shot: { balls: 5 } }, /format/],
    [{ shot: { balls: [null] } }, /format/],
    [{ shot: { ...shot, balls: [null] } }, /balls\[0\]/],
    [{ shot, noise }, /noise\.speed/],
  ] as const) {
    const page = await open({ hash: toFragment(data) });
    expect(await page.getByRole("alert").textContent()).toMatch(words);
    expect(await hash(page)).toBe(first);
    await close(page);
  }
});

test("a damaged link or one of another version is refused and stays in the address", async ({
  open,
}) => {
  for (const [link, words] of [
    ["#s=1.eNplkN2Owx", /damaged/],
    ["#s=9.whatever", /another version/],
  ] as const) {
    const page = await open({ hash: link });
    expect(await page.getByRole("alert").textContent()).toMatch(words);
    expect(await page.evaluate(() => location.hash)).toBe(link);
    // The page works nevertheless.
    expect(await hash(page)).toMatch(/^[0-9a-f]{16}$/);
  }
});

test("a link entered in the address of an open page is opened, and undo returns", async ({
  open,
}) => {
  const page = await open(CLIPBOARD);
  const before = await hash(page);
  await page.evaluate(() => window.carom!.store.strike({ speed: 3.21 }, "speed"));
  const after = await hash(page);
  await openShare(page);
  const link = await copied(page, "Copy link");
  await page.getByRole("button", { name: "Close" }).click();
  await page.evaluate(() => window.carom!.store.undo());
  await expect.poll(() => page.evaluate(() => location.hash)).not.toBe(new URL(link).hash);
  await page.evaluate((url) => (location.hash = new URL(url).hash), link);
  await expect.poll(() => hash(page)).toBe(after);
  await page.evaluate(() => window.carom!.store.undo());
  expect(await hash(page)).toBe(before);
});

test("the copied Python program runs unchanged and has the page's hash", async ({ open }) => {
  const page = await open(CLIPBOARD);
  await drop(page, "break.json", example("eight_ball_break"));
  await expect.poll(() => hash(page)).toBe(GOLDENS.eight_ball_break!.hash);
  await openShare(page);
  const program = await copied(page, "Copy as Python");
  const printed = python(`${program}\nprint("HASH", trace.hash)`);
  expect(printed).toContain(`HASH ${await hash(page)}`);
});

test("the native engine reads the downloaded shot file and writes the same trace", async ({
  open,
}) => {
  const page = await open(CLIPBOARD);
  await openShare(page);
  await picture(page, "share");
  const shot = await download(page, "Download shot file");
  expect(shot.name).toBe("shot.json");
  const trace = native(JSON.parse(shot.content.toString()) as ShotFile);
  expect(trace.hash).toBe(await hash(page));
  expect(await copied(page, "Copy shot file")).toBe(shot.content.toString());
  const saved = await download(page, "Download trace");
  const { events } = JSON.parse(saved.content.toString()) as TraceFile;
  expect(events).toEqual(trace.events);
});

test("a trace dropped on the page is replayed", async ({ open }) => {
  const page = await open();
  const program = `
import carom, json, sys
print(json.dumps(carom.Shot.from_json(sys.stdin.read()).simulate().to_dict()))
`;
  await drop(page, "trace.json", python(program, example("jump_shot")));
  await page.getByRole("slider", { name: "Time" }).waitFor();
  expect(await page.locator("#hash").textContent()).toBe(GOLDENS.jump_shot!.hash);
});

test("a file can be chosen with a button", async ({ open }) => {
  const page = await open();
  const [chooser] = await Promise.all([
    page.waitForEvent("filechooser"),
    page.getByRole("button", { name: "Open", exact: true }).click(),
  ]);
  const buffer = Buffer.from(example("masse"));
  await chooser.setFiles({ name: "masse.json", mimeType: "application/json", buffer });
  await expect.poll(() => hash(page)).toBe(GOLDENS.masse!.hash);
});

test("a bad file is refused with the engine's reason, and nothing changes", async ({ open }) => {
  const page = await open();
  const before = await hash(page);
  const overlapping = JSON.parse(example("stop_shot")) as { balls: { position: number[] }[] };
  overlapping.balls[1]!.position = overlapping.balls[0]!.position;
  for (const [content, words] of [
    ["no JSON at all", /cannot be opened/],
    ['{"format": "carom-shot/1", "table": "wpa-9ft"}', /balls/],
    [JSON.stringify(overlapping), /overlaps/],
    ["null", /not a shot, a trace, a game or an analysis/],
    ["[]", /not a shot, a trace, a game or an analysis/],
    ['{"format": "other/1"}', /not a shot, a trace, a game or an analysis/],
    ['{"format": "carom-frame/9"}', /another version of carom/],
  ] as const) {
    await drop(page, "bad.json", content);
    await expect.poll(() => page.getByRole("alert").textContent()).toMatch(words);
    expect(await hash(page)).toBe(before);
  }
});

test("a picture of the table is exported as PNG", async ({ open }) => {
  const page = await open();
  await openShare(page);
  const { content } = await download(page, "Download PNG");
  expect(content.subarray(0, 8)).toEqual(Buffer.from("\x89PNG\r\n\x1a\n", "latin1"));
  expect(content.length).toBeGreaterThan(20_000);
});

test(
  "an exported film has the duration of the shot, and the page is as before",
  async ({ open }) => {
    const page = await open({ viewport: SMALL, quality: "low" });
    await page.evaluate(() => window.carom!.store.strike({ speed: 0.5 }, "softly"));
    const { duration } = native(await shotOf(page));
    await openShare(page);
    const { content } = await download(page, "Download film");
    const shown = await page.evaluate(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      const video = document.createElement("video");
      video.src = URL.createObjectURL(new Blob([bytes]));
      await new Promise((resolve, reject) => {
        video.onloadeddata = resolve;
        video.onerror = () => reject(new Error(video.error?.message));
      });
      return { length: video.duration, width: video.videoWidth };
    }, content.toString("base64"));
    // The last frame lasts half a second.
    expect(shown.length).toBeGreaterThan(duration);
    expect(shown.length).toBeLessThan(duration + 0.7);
    expect(shown.width).toBeGreaterThan(300);
    expect(await page.evaluate(() => window.carom!.store.session.mode)).toBe("aim");
  },
  SLOW,
);

test("a film can be cancelled", async ({ open }) => {
  const page = await open();
  await openShare(page);
  await page.getByRole("button", { name: "Download film" }).click();
  await page.getByRole("button", { name: "Cancel" }).click();
  await page.getByText("Cancelled.").waitFor();
  expect(await page.getByRole("button", { name: "Download film" }).isEnabled()).toBe(true);
});

test("if the clipboard is forbidden the text is shown, selected", async ({ open }) => {
  const page = await open();
  await page.evaluate(() => {
    Object.defineProperty(navigator, "clipboard", { value: undefined });
    Object.defineProperty(document, "execCommand", { value: () => false });
  });
  await openShare(page);
  await page.getByRole("button", { name: "Copy as Python" }).click();
  const text = page.getByLabel("Text to copy");
  expect(await text.inputValue()).toMatch(/^import carom/);
  expect(await page.evaluate(() => getSelection()?.toString())).toMatch(/^import carom/);
});

for (const viewport of [
  { width: 390, height: 844 },
  { width: 1280, height: 800 },
]) {
  test(`a link to this computer tells that other computers cannot open it at ${viewport.width}×${viewport.height}`, async ({
    open,
  }) => {
    // Seen: http://127.0.0.1:port/ was offered as a link to send, and no text said so.
    const page = await open({ viewport });
    await pressTool(page, "Share");
    const dialog = page.locator("#share-dialog");
    const hint = dialog.getByText("This link opens on this computer only");
    await hint.waitFor();
    expect(await hint.textContent()).toContain("127.0.0.1");
  });
}
