/** Names of the keys of a shot file, as the forms show them. */

import { capital, inSentence, named, t } from "../words/translate.ts";

/** Keys of a strike by their place in the file. */
const STRIKE = {
  "strike.speed": "aim.speed",
  "strike.side": "aim.side",
  "strike.height": "aim.height",
  "strike.azimuth": "aim.direction",
  "strike.azimuth_deg": "aim.direction",
  "strike.elevation": "aim.elevation",
  "strike.elevation_deg": "aim.elevation",
} as const;

/** `ball_ball` as a heading, `sliding_friction` as a label. */
export function title(key: string): string {
  // The items of the only list, rolling friction.
  if (/^\d+$/.test(key)) return t("parameter.band", { number: Number(key) + 1 });
  // A coefficient has the letter of its formula.
  if (key.length === 1) return key;
  // The unit is beside the number.
  const stem = key.replace(/_deg$/, "");
  return named("parameter", stem) ?? capital(stem.replaceAll("_", " "));
}

/** The keys of a path as a name within a sentence, "cloth sliding friction". */
export function nameOfPath(path: readonly string[]): string {
  return inSentence(path.map(title).join(" "));
}

/** The name of a place of a shot file; null if no form of the page has it. */
export function nameOf(place: string): string | null {
  if (place in STRIKE) return t(STRIKE[place as keyof typeof STRIKE]);
  const [part, ...path] = place.replaceAll(/\[(\d+)\]/g, ".$1").split(".");
  if ((part !== "physics" && part !== "table") || path.length === 0) return null;
  return capital(nameOfPath(path));
}
