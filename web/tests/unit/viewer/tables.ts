import type { Geometry } from "../../../src/viewer/types";
import tables from "./tables.json";

/** Every preset, a plain rectangle and endless cloth. */
export const TABLES = tables as unknown as readonly Geometry[];

/** Those with rails. */
export const RAILED = TABLES.filter((table) => table.size !== null);

export function label({ name, size }: Geometry): string {
  return name ?? (size ? "a plain rectangle" : "endless cloth");
}
