/** An aim at a pocket in the words of players. */

import { ballName, placeName } from "../common/words.ts";
import type { PotLock } from "../document/document.ts";

/** Names of hits by how much of the ball is covered, each up to the middle to the next. */
const HITS: readonly (readonly [number, string])[] = [
  [0.97, "full hit"],
  [0.875, "nearly full hit"],
  [0.625, "three-quarter ball"],
  [0.375, "half ball"],
  [0.175, "quarter ball"],
  [0.06, "thin cut"],
  [0, "very thin cut"],
];

/** The players' name of a hit with this fullness, 1 (full) to 0. */
export function hitName(fullness: number): string {
  return HITS.find(([least]) => fullness >= least)![1];
}

/** The aim in a sentence, such as "Ball 9 to the top right pocket: half ball, a cut of 31°, ± 0.3°.". */
export function lockText(lock: PotLock, contact: { fullness: number; cut: number } | null): string {
  const name = ballName(lock.ball);
  const target = `${name.charAt(0).toUpperCase()}${name.slice(1)} to the ${placeName(lock.pocket)} pocket`;
  if (!lock.solved) return `${target}: no line with this stroke. Change the speed or the spin.`;
  const hit = contact ? `${hitName(contact.fullness)}, a cut of ${contact.cut.toFixed(0)}°` : "";
  const how = lock.kind === "direct" ? hit : lock.kind;
  return `${target}: ${how}, ± ${lock.margin.toFixed(2)}°.`;
}
