/** Routes of caroms in the words of players. */

import type { CaromRoute } from "../../engine/index.ts";
import { ballName } from "../common/shot-words.ts";
import { t } from "../words/translate.ts";
import { hitName } from "./pot-words.ts";

/** An object ball. The ball `cue` is one where the other cue ball is struck: it is the white. */
function objectBall(id: string): string {
  return id === "cue" ? t("ball.white") : ballName(id);
}

/** The pattern of a carom and its first ball: "Around the table, the red first". */
export function patternText({ pattern, first }: CaromRoute): string {
  return t("carom.heading", { pattern: t(`carom.pattern.${pattern}`), ball: objectBall(first) });
}

/** The route: "half ball off the red, long, short, long, thin cut on the yellow, running side". */
export function routeText(route: CaromRoute): string {
  const { first, second, cushions, cushions_first: before, fullness, side } = route;
  const rails = cushions.map((kind) => t(`carom.cushion.${kind}`));
  const met = (how: "off" | "on", id: string, covered: number | null) => {
    const ball = objectBall(id);
    if (covered === null) return t(`carom.met.${how}`, { ball });
    return t(`carom.met-hit.${how}`, { ball, hit: hitName(covered) });
  };
  return [
    ...rails.slice(0, before),
    met("off", first, fullness[0]),
    ...rails.slice(before),
    met("on", second, fullness[1]),
    t(`carom.side.${side}`),
  ].join(t("lines.gap"));
}
