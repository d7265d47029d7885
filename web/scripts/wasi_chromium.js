/**
 * Runs a test program for WASI in Chromium, as cargo's runner: scripts/everywhere.sh.
 * usage: node wasi_chromium.js PROGRAM.wasm [arguments]
 * The program sees the folder tests/data of the working directory, at its own path.
 */

/* global URL, console -- of Node */
/* global WebAssembly, fetch, window -- inside the page */

import { readFile, readdir } from "node:fs/promises";
import { join, resolve } from "node:path";
import process from "node:process";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { requireChromium } from "./find_chromium.js";

// Nothing of it reaches the network: every request is answered below.
const HOST = "http://carom.invalid/";
const SHIM = fileURLToPath(import.meta.resolve("@bjorn3/browser_wasi_shim"));

const [program, ...rest] = process.argv.slice(2);
const folder = resolve("tests/data");
const names = await readdir(folder);
const files = await Promise.all(
  names.map(async (name) => [name, await readFile(join(folder, name), "latin1")]),
);

async function answer(route) {
  const path = new URL(route.request().url()).pathname.slice(1);
  if (path === "") return route.fulfill({ contentType: "text/html", body: "" });
  if (path === "program.wasm")
    return route.fulfill({ path: program, contentType: "application/wasm" });
  return route.fulfill({ path: join(SHIM, "..", path), contentType: "text/javascript" });
}

/** Runs the program inside the page; gives its exit status. */
async function start({ host, args, parts, contents }) {
  const { WASI, ConsoleStdout, Directory, File, OpenFile, PreopenDirectory } = await import(
    `${host}index.js`
  );
  const data = contents.map(([name, text]) => [
    name,
    new File(Uint8Array.from(text, (letter) => letter.charCodeAt(0))),
  ]);
  let tree = new Map(data);
  for (const part of parts.toReversed()) tree = new Map([[part, new Directory(tree)]]);
  const print = ConsoleStdout.lineBuffered((line) => window.print(line));
  const wasi = new WASI(
    args,
    [],
    [new OpenFile(new File([])), print, print, new PreopenDirectory("/", tree)],
  );
  const { instance } = await WebAssembly.instantiateStreaming(fetch(`${host}program.wasm`), {
    wasi_snapshot_preview1: wasi.wasiImport,
  });
  return wasi.start(instance);
}

const browser = await chromium.launch({
  executablePath: await requireChromium(),
  args: [
    "--no-sandbox",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-first-run",
  ],
});
try {
  const page = await browser.newPage();
  await page.route("**", answer);
  await page.exposeFunction("print", (line) => process.stdout.write(`${line}\n`));
  await page.goto(HOST);
  console.log(`Chromium ${browser.version()}:`);
  process.exitCode = await page.evaluate(start, {
    host: HOST,
    args: [program, ...rest],
    parts: folder.split("/").filter(Boolean),
    contents: files,
  });
} finally {
  await browser.close();
}
