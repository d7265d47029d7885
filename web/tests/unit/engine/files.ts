/** Files of the checkout. */
import { readFileSync } from "node:fs";

const ROOT = new URL("../../../../", import.meta.url);

export function read(path: string): string {
  return readFileSync(new URL(path, ROOT), "utf8");
}

export function shotFile(name: string): string {
  return read(`shots/${name}.json`);
}

export interface Golden {
  readonly events: number;
  readonly hash: string;
}

export const GOLDENS = JSON.parse(read("goldens/shots.json")) as Readonly<Record<string, Golden>>;
