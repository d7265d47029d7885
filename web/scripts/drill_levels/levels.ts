/** What each level of play makes of each drill. */

import { createHash } from "node:crypto";
import type { Engine } from "../../src/engine/index.ts";
import { DRILLS, type Drill } from "../../src/app/train/drills/index.ts";
import type { DrillLevels } from "../../src/app/train/drill-levels.ts";
import { type Run, runChances } from "./runs.ts";
import { bestOf, chancesOf, refined, strikesOf } from "./strikes.ts";

export { load } from "../../src/engine/index.ts";
export { DRILLS };

/** Variants of a shot, and attempts of a run, from which a chance is counted. */
const VARIANTS = 400;
const RUNS = 60;
/** Seed of the variants that count; those that choose the strike have others. */
const SEED = 3;

/** Level whose errors sort the strikes before each level refines them. */
const MIDDLE = "club";

/** Changes with everything that the chances of a drill depend on: the drill, the table and its physics. */
export function fingerprint(engine: Engine, drill: Drill): string {
  const table = engine.tables.find(({ name }) => name === drill.table)!;
  const text = JSON.stringify([drill, table, engine.physics[table.physics!]]);
  return createHash("sha256").update(text).digest("hex").slice(0, 16);
}

export function levelsOf(engine: Engine, drill: Drill): DrillLevels {
  const names = Object.keys(engine.noisePresets).filter((name) => name !== "olympiad");
  const chances = Object.fromEntries(names.map((name): [string, number[][]] => [name, []]));
  for (const step of drill.steps) {
    const setting = { drill, step, attempt: 0 };
    const isRun = step.goal.kind === "run";
    const strikes = isRun ? [] : strikesOf(engine, setting, engine.noisePresets[MIDDLE]!);
    const noises = names.map((name) => engine.noisePresets[name]!);
    // Every level chooses among the strikes that were found for any of them.
    const found = isRun
      ? []
      : noises.flatMap((noise) => refined(engine, setting, strikes, noise) ?? []);
    for (const name of names) {
      const noise = engine.noisePresets[name]!;
      const strike = isRun ? null : bestOf(engine, setting, found, noise);
      if (!isRun && !strike) throw new Error(`${drill.id}: no strike was found for a step`);
      const shares = strike
        ? chancesOf(engine, setting, strike, noise, VARIANTS, SEED)
        : runChances(engine, setting as Run, noise, RUNS);
      chances[name]!.push(shares.map((share) => Math.round(share * 1e4) / 1e4));
    }
  }
  return { fingerprint: fingerprint(engine, drill), chances };
}
