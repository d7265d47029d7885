/**
 * The puzzle of a day: a layout and a task from the date alone, the same on every machine. A puzzle is
 * taken only if a strike was found that solves it with a margin.
 */

import type { Engine, PocketName, Shot, Strike, StrikeInput } from "../../../engine/index.ts";
import type { Condition, Diamonds, Drill, Step } from "../drills/index.ts";
import { judge, restOf } from "../drill-judge.ts";
import { layoutOf } from "../drill-layout.ts";
import { length } from "../../common/length.ts";
import { type Cloth, clothOf } from "../drill-places.ts";
import { randomOf } from "./seeded-random.ts";

/**
 * "leave": pot the 9 and leave the cue ball in a circle. "bank": pot it off a cushion. "combination": pot
 * it with the 1.
 */
export type Kind = "leave" | "bank" | "combination";

export interface Puzzle {
  /** "2026-11-23", UTC. */
  readonly date: string;
  readonly kind: Kind;
  readonly pocket: PocketName;
  /** The layout and its goal, as a drill of one step. */
  readonly drill: Drill;
  /** A strike that solves it. */
  readonly solution: Strike;
}

/** Kinds by chance: half of the days have a circle. */
const KINDS: readonly Kind[] = ["leave", "bank", "leave", "combination"];

const SPEEDS = [1.2, 1.5, 1.9, 2.4, 3] as const;
const HEIGHTS = [-0.3, -0.15, 0, 0.2, 0.35] as const;
const SIDES = [-0.3, 0, 0.3] as const;

/** Radius of the circle, and the least way of the cue ball from the ghost ball to it, in diamonds. */
const CIRCLE = 0.6;
const LEAST_WAY = 1.2;

/** Cosine of the thinnest cut that is tried: 60°. */
const LEAST_CUT = 0.5;

/** Least distance of two balls and of a ball from a cushion, in diamonds: no ball touches anything. */
const APART = 0.35;

/**
 * Changes of the solution that must solve it too, so that a careful player can: azimuth (rad), speed (as
 * a share), height and side (ball radii).
 */
const MARGINS: Readonly<Record<Kind, { readonly azimuth: number; readonly speed: number }>> = {
  leave: { azimuth: 0.003, speed: 0.04 },
  bank: { azimuth: 0.002, speed: 0.03 },
  combination: { azimuth: 0.0012, speed: 0.03 },
};
const TIP = 0.03;

/** Strikes that must not solve a puzzle with a circle: those of a player who thinks of the pot alone. */
const PLAIN_SPEEDS = [1.2, 1.9] as const;

/** Layouts that are tried; a puzzle is found after about 20. */
const LAYOUTS = 5000;

export function puzzleOf(engine: Engine, date: string): Puzzle {
  const random = randomOf(Number(date.replaceAll("-", "")));
  const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)]!;
  const kind = pick(KINDS);
  const cloth = clothOf(engine, "wpa-9ft");
  for (let k = 0; k < LAYOUTS; k += 1) {
    const { name: pocket, center } = pick(cloth.geometry.pockets);
    const hole: Diamonds = [center[0] / cloth.diamond[0], center[1] / cloth.diamond[1]];
    const balls = kind === "combination" ? row(random, hole) : scattered(random, kind, hole);
    const tip = { speed: pick(SPEEDS), height: pick(HEIGHTS), side: pick(SIDES) };
    const found = balls && tried(engine, cloth, { kind, balls, pocket, tip });
    if (found) return { date, kind, ...found };
  }
  throw new Error(`no puzzle was found for ${date}; try more layouts`);
}

/** The cue ball, the 9 and a ball in the way, anywhere; null if two of them are too near. */
function scattered(random: () => number, kind: Kind, hole: Diamonds): Trial["balls"] | null {
  const within = (most: number) => APART + random() * (most - 2 * APART);
  const anywhere = (): Diamonds => [within(4), within(8)];
  const [cue, nine, five] = [anywhere(), anywhere(), anywhere()];
  if (kind === "leave" && cut(cue, nine, hole) < LEAST_CUT) return null;
  return apart({ cue, "9": nine, "5": five });
}

/** Cosine of the angle between the cue ball's way to a ball and the ball's way to a place. */
function cut([x, y]: Diamonds, [u, v]: Diamonds, [p, q]: Diamonds): number {
  const [ax, ay, bx, by] = [u - x, v - y, p - u, q - v];
  return (ax * bx + ay * by) / (length(ax, ay) * length(bx, by));
}

/** The 9 near a pocket, the 1 behind it, and the cue ball behind both, nearly in a row; null as above. */
function row(random: () => number, hole: Diamonds): Trial["balls"] | null {
  const behind = (
    [x, y]: Diamonds,
    [u, v]: Diamonds,
    distance: number,
    aside: number,
  ): Diamonds => {
    const far = length(x - u, y - v);
    const [dx, dy] = [(x - u) / far, (y - v) / far];
    return [x + distance * dx - aside * dy, y + distance * dy + aside * dx];
  };
  const nine: Diamonds = [4 * random(), 8 * random()];
  if (length(nine[0] - hole[0], nine[1] - hole[1]) > 3) return null;
  const one = behind(nine, hole, 0.4 + 0.6 * random(), 0.2 * (random() - 0.5));
  const cue = behind(one, nine, 1 + 2 * random(), 2 * (random() - 0.5));
  return apart({ cue, "9": nine, "1": one });
}

/** The places with two decimals; null if two of them are too near, or one is near a cushion. */
function apart(places: Trial["balls"]): Trial["balls"] | null {
  const twentieth = (value: number) => Math.round(20 * value) / 20;
  const rounded = Object.entries(places).map(([id, [x, y]]): [string, Diamonds] => [
    id,
    [twentieth(x), twentieth(y)],
  ]);
  const isNear = rounded.some(
    ([, [x, y]], k) =>
      Math.min(x, 4 - x, y, 8 - y) < APART ||
      rounded.slice(k + 1).some(([, [u, v]]) => length(x - u, y - v) < APART),
  );
  return isNear ? null : Object.fromEntries(rounded);
}

interface Trial {
  readonly kind: Kind;
  readonly balls: Readonly<Record<string, Diamonds>>;
  readonly pocket: PocketName;
  readonly tip: Omit<StrikeInput, "azimuth">;
}

function tried(
  engine: Engine,
  cloth: Cloth,
  { kind, balls, pocket, tip }: Trial,
): Pick<Puzzle, "pocket" | "drill" | "solution"> | null {
  const goal = (needs: readonly Condition[]): Step => ({
    balls,
    goal: { kind: "shot", needs: [{ kind: "pot", ball: "9", pocket }, ...needs] },
  });
  const first = drillOf(goal([]));
  const shot = engine.shot(layoutOf(engine, { drill: first, step: first.steps[0]!, attempt: 0 }));
  try {
    const aimed = shot.withStrike({ ...shot.strike!, ...tip, elevation: undefined });
    const aim = aimed.potAim("9", pocket);
    aimed.free();
    const isKind = aim?.kind === (kind === "leave" ? "direct" : kind);
    if (!isKind || aim.losesCueBall || aim.margin < MARGINS[kind].azimuth) return null;
    const needs = needsOf(cloth, shot, kind, balls, aim.strike);
    if (!needs) return null;
    const drill = drillOf(goal(needs));
    const solves = (strike: StrikeInput) => isSolved(cloth, shot, drill, strike);
    if (!neighbours(aim.strike, kind).every(solves)) return null;
    if (kind === "leave" && plain(shot, pocket).some(solves)) return null;
    return { pocket, drill, solution: aim.strike };
  } finally {
    shot.free();
  }
}

/** What the shot must do besides the pot; null if it is too easy. */
function needsOf(
  { diamond }: Cloth,
  shot: Shot,
  kind: Kind,
  balls: Trial["balls"],
  strike: Strike,
): Condition[] | null {
  if (kind === "bank") return [{ kind: "cushions", ball: "9", cushions: 1 }];
  if (kind === "combination") return [{ kind: "first", ball: "1" }];
  const struck = shot.withStrike(strike);
  const trace = struck.simulate();
  const [x, y] = restOf(trace, "cue")!;
  trace.free();
  struck.free();
  const tenth = (metres: number, unit: number) => Math.round((10 * metres) / unit) / 10;
  const center: Diamonds = [tenth(x, diamond[0]), tenth(y, diamond[1])];
  const [u, v] = balls["9"]!;
  if (length(center[0] - u, center[1] - v) < LEAST_WAY) return null;
  return [{ kind: "stop", area: { center, radius: CIRCLE } }];
}

/** The strike, and the strikes with each of its numbers a little smaller and larger. */
function neighbours(strike: Strike, kind: Kind): StrikeInput[] {
  const { azimuth, speed } = MARGINS[kind];
  const changes = (sign: number): Partial<Strike>[] => [
    { azimuth: strike.azimuth + sign * azimuth },
    { speed: strike.speed * (1 + sign * speed) },
    { height: strike.height + sign * TIP },
    { side: strike.side + sign * TIP },
  ];
  return [{}, ...changes(1), ...changes(-1)].map((change) => ({ ...strike, ...change }));
}

/** Strikes without spin that pot the 9. */
function plain(shot: Shot, pocket: PocketName): StrikeInput[] {
  return PLAIN_SPEEDS.flatMap((speed) => {
    const aimed = shot.withStrike({ ...shot.strike!, speed, side: 0, height: 0 });
    const aim = aimed.potAim("9", pocket);
    aimed.free();
    return aim ? [aim.strike] : [];
  });
}

function isSolved(cloth: Cloth, shot: Shot, drill: Drill, strike: StrikeInput): boolean {
  const struck = shot.withStrike(strike);
  const trace = struck.simulate();
  const { fault } = judge(cloth, drill, drill.steps[0]!, trace);
  trace.free();
  struck.free();
  return fault === null;
}

function drillOf(step: Step): Drill {
  return {
    id: "puzzle",
    table: "wpa-9ft",
    cue: "cue",
    attempts: 1,
    order: "same",
    steps: [step],
    speed: 1.6,
  };
}
