import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Page } from "playwright-core";
import { expect, test } from "./fixture.ts";
import { python } from "./python.ts";

/** A match of four frames, and its report. */
const PROGRAM = `
import sys, carom
from carom.arena.report import read_report
from carom.arena.report_page import report_html

class Straight:
    name = "straight"
    def choose(self, situation):
        request = situation.frame.request
        if request.kind == "choice":
            return request.choices[0]
        if situation.frame.to_dict()["shots"] >= 3:
            return "concede"
        place = (0.6, 0.5) if request.in_hand else None
        strike = carom.Strike(speed=6.0, azimuth=1.5, elevation=0.1)
        return carom.Decision(carom.Play(strike, cue_ball=place), win_chance=0.4)

class Twin(Straight):
    name = "twin"

folder = sys.stdin.read()
carom.play_match(Straight, Twin, game="nine-ball", pairs=2, secret="3" * 64, out=folder,
                 noise=carom.Noise.olympiad())
open(folder + "/report.html", "w").write(report_html(read_report(folder), title="Report"))
`;

let folder = "";

/** The folder of the match, which is played once. */
function match(): string {
  if (folder === "") {
    folder = mkdtempSync(join(tmpdir(), "carom-match-"));
    process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
    python(PROGRAM, folder);
  }
  return folder;
}

async function drop(page: Page, content: string): Promise<void> {
  const dataTransfer = await page.evaluateHandle((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "match.jsonl"));
    return data;
  }, content);
  for (const type of ["dragenter", "dragover", "drop"]) {
    await page.dispatchEvent("#stage", type, { dataTransfer });
  }
}

test("a record of a match that is dropped shows its frames, and one opens with its intentions", async ({
  open,
}) => {
  const page = await open();
  await drop(page, readFileSync(join(match(), "match.jsonl"), "utf8"));
  const dialog = page.getByRole("dialog", { name: "Match straight – twin" });
  expect(await dialog.getByRole("listitem").count()).toBe(4);
  await dialog.getByRole("button", { name: "Frame 2" }).click();
  await page.getByText("Shot 1 of 3, twin").waitFor();
  await page.getByRole("tab", { name: "Game" }).click();
  await page.getByRole("row", { name: /^intended 6/ }).waitFor();
  await page.getByRole("img", { name: /^Chance of twin to win/ }).waitFor();
  await page.getByRole("button", { name: "Frames of the match" }).click();
  await dialog.waitFor();
});

test("a damaged record is refused with its line", async ({ open }) => {
  const page = await open();
  const text = readFileSync(join(match(), "match.jsonl"), "utf8");
  await drop(page, text.replace('"scores"', '"stores"'));
  await page
    .locator("#refusal")
    .getByText(/line 2/)
    .waitFor();
});

test("a link of a report opens its frame, from a file without a server", async ({ open }) => {
  match();
  const url = pathToFileURL(join(folder, "report.html")).href;
  const page = await open();
  await page.goto(url);
  await page.getByRole("link", { name: "frame 3" }).click();
  const viewer = page.frameLocator("iframe");
  await viewer.getByText("Shot 1 of 3, straight").waitFor();
  await page.getByRole("button", { name: "Back to the report" }).click();
  await page.locator("iframe").waitFor({ state: "detached" });
});
