/** An aim at a pocket in the words of players. */

import { playedName, pocketName } from "../common/shot-words.ts";
import type { PotLock } from "../document/document.ts";
import { capital, decimal, list, named, sentence, t } from "../words/translate.ts";

/** Names of hits by how much of the ball is covered, each up to the middle to the next. */
const HITS = [
  [0.97, "full"],
  [0.875, "nearly-full"],
  [0.625, "three-quarter"],
  [0.375, "half"],
  [0.175, "quarter"],
  [0.06, "thin"],
  [0, "very-thin"],
] as const;

/** The players' name of a hit with this fullness, 1 (full) to 0. */
export function hitName(fullness: number): string {
  const [, name] = HITS.find(([least]) => fullness >= least)!;
  return t(`pot.hit.${name}`);
}

/** The aim in a sentence, such as "Ball 9 to the top right pocket: half ball, a cut of 31°, ± 0.30°.". */
export function lockText(lock: PotLock, contact: { fullness: number; cut: number } | null): string {
  const names = { ball: capital(playedName(lock.ball)), pocket: pocketName(lock.pocket) };
  if (!lock.solved) return t("pot.unsolved", names);
  const how = lock.kind === "direct" && contact ? cutText(contact) : kindText(lock.kind);
  return t("pot.aimed", { ...names, how, margin: decimal(lock.margin, 2) });
}

/** The hit as a sentence, such as "Half ball, a cut of 31°.". */
export function hitText(contact: { fullness: number; cut: number }): string {
  return sentence(cutText(contact));
}

/** A cut such as "half ball, a cut of 31°", or "full hit, straight". */
export function cutText({ fullness, cut }: { fullness: number; cut: number }): string {
  if (Math.round(cut) === 0) return t("pot.straight", { hit: hitName(fullness) });
  return t("pot.cut", { hit: hitName(fullness), degrees: decimal(cut, 0) });
}

/** A kind of `PotAim`, such as "jump+bank". */
function kindText(kind: string): string {
  return list(kind.split("+").map((name) => named("pot.kind", name) ?? name));
}
