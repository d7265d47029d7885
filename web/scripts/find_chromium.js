/**
 * Finds the browser for the end-to-end tests, the benchmarks and the pictures.
 * usage: node web/scripts/find_chromium.js
 * Prints the path of Chromium or Chrome; exits with 1 and the remedies if there is none. Works before
 * `npm ci` too, but then it cannot find the browser that playwright-core installs.
 */

/* global console -- this is a script of Node */

import { accessSync, constants, realpathSync } from "node:fs";
import { delimiter, join } from "node:path";
import process from "node:process";
import { fileURLToPath } from "node:url";

/** Commands under which distributions install the browser. */
const COMMANDS = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/** Folders that are searched even if PATH lacks them. */
const FOLDERS = ["/usr/bin", "/usr/local/bin"];

const MAC_APPLICATIONS = [
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
];

export const REMEDY =
  "install your distribution's package chromium, or run `npx playwright-core install chromium` in web/, " +
  "or set CHROMIUM to the path of Chromium or Chrome";

function isExecutable(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/** Where `npx playwright-core install chromium` puts its browser; null before `npm ci`. */
async function installedByPlaywright() {
  try {
    const { chromium } = await import("playwright-core");
    return chromium.executablePath();
  } catch {
    return null;
  }
}

/** The path of the browser; null if none is found. CHROMIUM comes first, even if it is wrong. */
export async function findChromium() {
  const { CHROMIUM, PATH = "" } = process.env;
  if (CHROMIUM) return isExecutable(CHROMIUM) ? CHROMIUM : null;
  const folders = [...FOLDERS, ...PATH.split(delimiter).filter(Boolean)];
  const places = [
    ...folders.flatMap((folder) => COMMANDS.map((command) => join(folder, command))),
    ...MAC_APPLICATIONS,
  ];
  const found = places.find(isExecutable);
  if (found) return found;
  const installed = await installedByPlaywright();
  return installed && isExecutable(installed) ? installed : null;
}

/** The path of the browser, or an error with the remedies. */
export async function requireChromium() {
  const found = await findChromium();
  if (found) return found;
  const { CHROMIUM } = process.env;
  throw new Error(
    CHROMIUM
      ? `CHROMIUM is ${CHROMIUM}, which is not a program; correct it, or unset it`
      : `no Chromium was found; ${REMEDY}`,
  );
}

if (process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
  try {
    console.log(await requireChromium());
  } catch (error) {
    console.error(`carom: ${error.message}`);
    process.exitCode = 1;
  }
}
