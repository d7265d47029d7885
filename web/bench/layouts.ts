/** The layouts of the benchmarks: those of `carom bench`. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gunzipSync } from "node:zlib";
import type { ShotFile } from "../src/engine/index.ts";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));

interface State {
  readonly balls: Readonly<Record<string, readonly [number, number]>>;
  readonly speed: number;
  readonly azimuth_deg: number;
  readonly elevation_deg: number;
  readonly side: number;
  readonly height: number;
}

/** Shot files of random layouts in the middle of a game, with random strikes. */
export function layouts(): string[] {
  const packed = readFileSync(`${ROOT}python/carom/data/bench_states.json.gz`);
  const { table, classes } = JSON.parse(gunzipSync(packed).toString()) as {
    table: string;
    classes: Record<string, State[]>;
  };
  return classes.random_eight_ball!.map(({ balls, ...strike }) => {
    const file: ShotFile = {
      format: "carom-shot/1",
      table,
      balls: Object.entries(balls).map(([id, position]) => ({ id, position })),
      strike: { ball: "cue", ...strike },
    };
    return JSON.stringify(file);
  });
}
