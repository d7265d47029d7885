/**
 * Which table is in the photo, by the size of its balls. All tables are twice as long as wide, so that the
 * corners alone do not tell a table of 7 feet from one of 9.
 */

import type { Engine } from "../../engine/index.ts";
import { isDated } from "../dated-presets.ts";
import { tableOf, type TableOfPhoto } from "./photo-layout.ts";

/** Least number of balls whose median size is believed. */
export const ENOUGH = 4;

/**
 * Ratio of sizes up to which the table is believed: between those of neighbouring tables (1.09 for 8 and
 * 9 feet), which a photo does not tell apart, and 1.32 for 7 and 9 feet.
 */
const TOLERANCE = 1.17;

/** Whether balls of this relative size (1: as on the table) contradict the table. */
export function contradicts(size: number): boolean {
  return Math.abs(Math.log(size)) > Math.log(TOLERANCE);
}

/** The name of the preset whose balls look `size` times as large as those of `table`; null if none does. */
export function fittingPreset(engine: Engine, table: TableOfPhoto, size: number): string | null {
  const wanted = size * proportion(table);
  let best: { name: string; off: number } | null = null;
  for (const { name, size: area, pockets } of engine.tables) {
    const other = table.geometry.pockets.length !== pockets.length;
    if (name === null || !area || isDated(name) || other) continue;
    const ball = { id: "cue", position: [area[0] / 2, area[1] / 2] as const };
    const preset = tableOf(engine, { format: "carom-shot/1", table: name, balls: [ball] });
    const off = Math.abs(Math.log(wanted / proportion(preset)));
    if (!best || off < best.off) best = { name, off };
  }
  return best && !contradicts(Math.exp(best.off)) ? best.name : null;
}

/** Radius of a table's balls as a share of its width. */
export function proportion({
  geometry,
  radius,
}: Pick<TableOfPhoto, "geometry" | "radius">): number {
  return radius / (geometry.size?.[0] ?? 1);
}
