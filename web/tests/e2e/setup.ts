/** Before all end-to-end tests: builds the page, serves it, and starts the browser that they share. */

import { readdirSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { extname } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { build } from "vite";
import type { TestProject } from "vitest/node";
import { requireChromium } from "../../scripts/find_chromium.js";

declare module "vitest" {
  interface ProvidedContext {
    /** Address of the served page. */
    page: string;
    /** The same page on disk. */
    file: string;
    /** Address at which the browser accepts connections. */
    browser: string;
  }
}

const TYPES: Readonly<Record<string, string>> = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".png": "image/png",
  ".webmanifest": "application/manifest+json",
};

const FLAGS = [
  // Chromium refuses to start as root with its sandbox, as in a container.
  "--no-sandbox",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];

/** The benchmarks measure the browser as it is on a computer without a graphics card. */
const BENCH_FLAGS = ["--disable-gpu"];

/** The tests draw in software whatever the computer has, and put their frames together without WebGL. */
const TEST_FLAGS = [
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-gpu-compositing",
];

export default async function setup({ name, provide }: TestProject): Promise<() => Promise<void>> {
  const root = fileURLToPath(new URL("../..", import.meta.url));
  const file = `${root}dist/index.html`;
  await build({ root, logLevel: "warn", configFile: `${root}vite.config.ts` });
  // Another path of the host is the page too: tests open it at addresses of their own.
  const files = new Map(readdirSync(`${root}dist`).map((name) => [`/${name}`, name]));
  const server = createServer(({ url = "/" }, response) => {
    const name = files.get(url) ?? "index.html";
    response.setHeader("content-type", TYPES[extname(name)]!);
    response.end(readFileSync(`${root}dist/${name}`));
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  const browser = await chromium.launchServer({
    executablePath: await requireChromium(),
    args: [...FLAGS, ...(name === "bench" ? BENCH_FLAGS : TEST_FLAGS)],
  });
  provide("page", `http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
  provide("file", file);
  provide("browser", browser.wsEndpoint());
  return async () => {
    await browser.close();
    server.close();
  };
}
