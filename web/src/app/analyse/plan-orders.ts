/** The orders of balls of a plan, and the interval of its chance. */

import type { GameFacts } from "../../engine/index.ts";

/** Balls that a proposal considers: the easiest ones. */
const CONSIDERED = 6;

/** A 95 % interval of a chance: Wilson's. */
export function interval(met: number, count: number): readonly [number, number] {
  const z = 1.96;
  const p = met / count;
  const middle = (p + z ** 2 / (2 * count)) / (1 + z ** 2 / count);
  const half =
    (z * Math.sqrt((p * (1 - p)) / count + (z / (2 * count)) ** 2)) / (1 + z ** 2 / count);
  return [Math.max(0, middle - half), Math.min(1, middle + half)];
}

/**
 * The balls from which a plan is made: the easiest ones and those that are wanted, or all if the lowest
 * comes first.
 */
export function considered(
  balls: readonly string[],
  wanted: readonly (string | null)[],
  objective: GameFacts["objective"] | null,
  ease: (ball: string) => number,
): readonly string[] {
  if (objective === "lowest-first") return balls;
  return [...balls]
    .sort((a, b) => ease(b) - ease(a))
    .filter((id, k) => k < CONSIDERED || wanted.includes(id));
}

/**
 * The orders of balls that a plan may have: those that agree with the chosen balls and with the game's
 * objective. The lowest ball comes first, or all are of one group.
 */
export function ordersOf(
  balls: readonly string[],
  chosen: readonly (string | null)[],
  objective: GameFacts["objective"] | null,
): string[][] {
  const rotation = objective === "lowest-first";
  const group = (id: string) => (Number(id) < 8 ? "solids" : "stripes");
  const groups = objective === "groups";
  const allowed = groups ? balls.filter((id) => id !== "8") : balls;
  const rising = [...allowed].sort((a, b) => Number(a) - Number(b));
  const isFree = chosen.every((ball) => ball === null);
  if (rotation && isFree) return [rising.slice(0, chosen.length)];
  let orders: string[][] = [[]];
  for (const wanted of chosen) {
    orders = orders.flatMap((order) =>
      (wanted === null ? allowed : [wanted])
        .filter((ball) => !order.includes(ball))
        .filter((ball) => !groups || !isFree || order.every((id) => group(id) === group(ball)))
        .map((ball) => [...order, ball]),
    );
  }
  return orders;
}
