import { spawnSync } from "node:child_process";
import { cpSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const SCRIPT = fileURLToPath(new URL("../../../scripts/find_chromium.js", import.meta.url));

function find(env: Record<string, string>, script = SCRIPT) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [script], {
    env,
    encoding: "utf8",
  });
  return { status, path: stdout.trim(), message: stderr };
}

test("CHROMIUM names the browser", () => {
  expect(find({ CHROMIUM: process.execPath })).toMatchObject({ status: 0, path: process.execPath });
});

test("a CHROMIUM that is not a program is an error, not a reason to search on", () => {
  const { status, message } = find({ CHROMIUM: "/no/such/chromium" });
  expect(status).toBe(1);
  expect(message).toMatch(/CHROMIUM is \/no\/such\/chromium, .*correct it/);
});

test("a browser is found on PATH, before npm ci too", () => {
  const folder = mkdtempSync(join(tmpdir(), "carom-chromium-"));
  try {
    const script = join(folder, "find_chromium.mjs");
    cpSync(SCRIPT, script);
    const browser = join(folder, "chromium");
    cpSync(process.execPath, browser);
    const found = find({ PATH: folder }, script);
    expect(found.status).toBe(0);
    expect(found.path).toMatch(/chrom/);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
