/** The native engine in Python. */

import { execFileSync } from "node:child_process";
import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";

/** `CAROM_PYTHON`, by default that of the checkout's virtual environment. */
const PYTHON =
  process.env.CAROM_PYTHON ?? fileURLToPath(new URL("../../../.venv/bin/python", import.meta.url));

/** The output of a program with `input` on its stdin. */
export function python(program: string, input = ""): string {
  if (!existsSync(PYTHON)) {
    throw new Error(`${PYTHON} is missing: run "make setup", or set CAROM_PYTHON.`);
  }
  return execFileSync(PYTHON, ["-c", program], { input, encoding: "utf8" });
}
