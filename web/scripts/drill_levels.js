/**
 * Computes what each level of play makes of each drill, into src/app/train/drill-levels.json. Drills that did not
 * change since are skipped; after each drill the file is written.
 * usage: node scripts/drill_levels.js [DRILL …]
 */

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import process from "node:process";
import { fileURLToPath, URL } from "node:url";
import { createServer } from "vite";

const ROOT = fileURLToPath(new URL("..", import.meta.url));
const OUT = `${ROOT}src/app/train/drill-levels.json`;
const FORMAT = "carom-drill-levels/1";

const vite = await createServer({
  root: ROOT,
  configFile: false,
  logLevel: "error",
  appType: "custom",
  server: { middlewareMode: true, hmr: false, ws: false, watch: null },
});
try {
  const { load, DRILLS, fingerprint, levelsOf } = await vite.ssrLoadModule(
    "/scripts/drill_levels/levels.ts",
  );
  const engine = await load();
  const commit = execFileSync("git", ["rev-parse", "--short=12", "HEAD"], { cwd: ROOT });
  const stored = existsSync(OUT) ? JSON.parse(readFileSync(OUT, "utf8")).drills : {};
  const wanted = process.argv.slice(2);
  for (const drill of DRILLS) {
    const isNew = stored[drill.id]?.fingerprint !== fingerprint(engine, drill);
    if (wanted.length > 0 ? !wanted.includes(drill.id) : !isNew) continue;
    const start = Date.now();
    stored[drill.id] = { commit: commit.toString().trim(), ...levelsOf(engine, drill) };
    const drills = Object.fromEntries(
      DRILLS.flatMap(({ id }) => (stored[id] ? [[id, stored[id]]] : [])),
    );
    const lines = Object.entries(drills).map(
      ([id, levels]) => `    ${JSON.stringify(id)}: ${JSON.stringify(levels)}`,
    );
    writeFileSync(
      OUT,
      `{\n  "format": "${FORMAT}",\n  "drills": {\n${lines.join(",\n")}\n  }\n}\n`,
    );
    process.stderr.write(`${drill.id}: ${Math.round((Date.now() - start) / 1000)} s\n`);
  }
} finally {
  await vite.close();
}
