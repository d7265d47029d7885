/** The package `carom-engine` as it is published. */
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { fileURLToPath } from "node:url";

const WEB = fileURLToPath(new URL("../../..", import.meta.url));

/** Compiles the package into `dist` of a new folder, and returns the folder. */
export function compiledPackage(): string {
  const folder = mkdtempSync(`${tmpdir()}/carom-engine-`);
  const [tsc, source] = [`${WEB}/node_modules/.bin/tsc`, `${WEB}/src/engine`];
  execFileSync(tsc, ["-p", source, "--outDir", `${folder}/dist`, "--declaration", "false"]);
  cpSync(`${source}/pkg`, `${folder}/dist/pkg`, { recursive: true });
  writeFileSync(`${folder}/package.json`, '{"type": "module"}');
  return folder;
}
