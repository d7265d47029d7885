import { load } from "../../../src/engine/index.ts";
import type { ShotFile } from "../../../src/engine/index.ts";
import type { Geometry } from "../../../src/viewer/viewer-types.ts";

const engine = await load();

/** The geometry of a table of a shot file. */
export function tableOf(table: ShotFile["table"]): Geometry {
  const balls = [{ id: "cue", position: [0.4, 0.4] as const }];
  return engine.shot({ format: "carom-shot/1", table, balls }).geometry;
}

/** Every table with rails: the presets and a plain rectangle. */
export const RAILED = [
  ...engine.tables,
  tableOf({ length: 2, width: 1, pockets: "none" }),
] as const;

export const UNBOUNDED = tableOf({ cloth: "unbounded" });

export function label({ name }: Geometry): string {
  return name ?? "a plain rectangle";
}
