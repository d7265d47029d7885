/**
 * Diamond systems: where a ball arrives after cushions by a player's rule, and where it does arrive.
 *
 * A system counts diamonds where the lines of a ball cross the lines of sights, which lie behind the noses:
 *
 * - Corner five, long rail, short rail, long rail: from the number S of the starting rail over the number F
 *   of the first rail the ball heads for S − F, with running English (D. G. Alciatore, TP 7.2; B. Jewett,
 *   Billiards Digest, June 2010).
 * - Plus system, short rail, long rail, long rail: from the diamond S over the number N of the short rail
 *   the ball comes back to S + N, with a tip of English (N. Varner, Billiards Digest, February 2009).
 * - Two to one, one rail: from S over F of the opposite rail the ball comes back to 2F − S, which is the
 *   mirror image in the line of sights (D. G. Alciatore, The Illustrated Principles of Pool and Billiards,
 *   2004, chapter 6).
 *
 * The row DS-corner of the validation compares the first one with the engine.
 */

import type { Geometry, Point, Trace, TraceEvent } from "../../engine/index.ts";

export type SystemName = "corner-five" | "plus" | "two-to-one";

/** A number at a diamond, m. */
export interface DiamondNumber {
  readonly at: Point;
  readonly number: number;
  /** Numbers of a target are another scale than those of the lines. */
  readonly scale: "line" | "target";
}

/** What a system says of a shot, in diamonds. */
export interface Reading {
  readonly system: SystemName;
  /** Numbers where the first line crosses the lines of sights. */
  readonly from: number;
  readonly over: number;
  /** Where the ball arrives by the system, and by the engine; null if it falls or stops before. */
  readonly predicted: number;
  readonly actual: number | null;
  /** The diamonds with their numbers. */
  readonly numbers: readonly DiamondNumber[];
  /** Places of `from`, `over`, `predicted` and `actual` on the lines of sights, m. */
  readonly places: {
    readonly from: Point;
    readonly over: Point;
    readonly predicted: Point;
    readonly actual: Point | null;
  };
}

type Rail = "left" | "right" | "bottom" | "top";

const OPPOSITE: Readonly<Record<Rail, Rail>> = {
  left: "right",
  right: "left",
  bottom: "top",
  top: "bottom",
};

/** A place in diamonds of the long rail, from the bottom left corner of the noses. */
type Place = readonly [x: number, y: number];

/** What happens to a ball from its start on. */
interface Way {
  readonly start: Place;
  /** Its cushions, and where and how it moved before each. */
  readonly hits: readonly { readonly rail: Rail; readonly at: Place; readonly by: Place }[];
  /** How it moved when it met something else after its cushions; null if it stopped. */
  readonly last: { readonly at: Place; readonly by: Place } | null;
}

/** The line of sights of each rail, in diamonds. */
interface Cloth {
  readonly unit: number;
  readonly width: number;
  readonly length: number;
  readonly back: number;
}

function clothOf({ size, sights }: Geometry): Cloth | null {
  if (!size || !sights) return null;
  const unit = size[1] / sights.along_length;
  return { unit, width: size[0] / unit, length: sights.along_length, back: sights.setback / unit };
}

/** How far a ball that meets a cushion may be from the nose, ball radii: cushions give way. */
const NEAR_RAIL = 1.5;

/**
 * The way of a ball up to its first contact with another ball after its start.
 *
 * @param from The event behind which its way begins; null: the strike.
 */
function wayOf(trace: Trace, ball: number, from: TraceEvent | null, cloth: Cloth): Way {
  const { id, radius, position } = trace.shot.balls[ball]!;
  const scaled = ([x, y]: readonly number[]): Place => [x! / cloth.unit, y! / cloth.unit];
  const begun = from ? trace.events.indexOf(from) : -1;
  const first = from ? from.after[from.balls.indexOf(id)]!.position : position;
  const hits: { rail: Rail; at: Place; by: Place }[] = [];
  let last: Way["last"] = null;
  for (const event of trace.events.slice(begun + 1)) {
    const own = event.balls.indexOf(id);
    if (own < 0 || event.type === "cue-strike" || event.type === "motion-transition") continue;
    if (event.type === "slate-collision") continue;
    const before = event.before[own]!;
    const [at, by] = [scaled(before.position), scaled(before.velocity)];
    const rail = railAt(at, cloth, (NEAR_RAIL * radius) / cloth.unit);
    if (event.type === "rail-collision" && event.part === "nose" && rail) {
      hits.push({ rail, at, by });
      continue;
    }
    last = { at, by };
    break;
  }
  return { start: scaled(first), hits, last };
}

function railAt([x, y]: Place, { width, length }: Cloth, reach: number): Rail | null {
  const gaps: [Rail, number][] = [
    ["left", x],
    ["right", width - x],
    ["bottom", y],
    ["top", length - y],
  ];
  const [[rail, gap]] = gaps.sort((a, b) => a[1] - b[1]) as [[Rail, number]];
  return gap < reach ? rail : null;
}

/** Where the line through a place in a direction crosses the line of sights of a rail; null if nowhere. */
function crossing([x, y]: Place, [vx, vy]: Place, rail: Rail, cloth: Cloth): Place | null {
  const { width, length, back } = cloth;
  const isLong = rail === "left" || rail === "right";
  const line = { left: -back, right: width + back, bottom: -back, top: length + back }[rail];
  const speed = isLong ? vx : vy;
  if (speed === 0) return null;
  const time = (line - (isLong ? x : y)) / speed;
  return [x + time * vx, y + time * vy];
}

/**
 * What a system says of the way of a ball; null if no system fits it.
 *
 * @param trace A shot with sidespin for the first two systems: its cue ball alone.
 * @param from As in `wayOf`.
 */
export function readingOf(
  trace: Trace,
  ball: number,
  from: TraceEvent | null = null,
): Reading | null {
  const cloth = clothOf(trace.shot.geometry);
  if (!cloth) return null;
  const way = wayOf(trace, ball, from, cloth);
  const [first, second] = way.hits;
  if (!first) return null;
  const line: Place = [first.at[0] - way.start[0], first.at[1] - way.start[1]];
  const reads = (system: SystemName, last: number, home: Rail): Reading | null => {
    const own = crossing(way.start, line, home, cloth);
    const over = crossing(way.start, line, first.rail, cloth);
    return own && over && reading(system, cloth, way, { home, last, own, over });
  };
  if (!second) return reads("two-to-one", 1, OPPOSITE[first.rail]);
  if (second.rail === OPPOSITE[first.rail]) return reads("two-to-one", 1, second.rail);
  // The third cushion may be missed: the ball still heads for the rail.
  if (way.hits[2]?.rail === first.rail) return null;
  const isLong = first.rail === "left" || first.rail === "right";
  return isLong
    ? reads("corner-five", 2, OPPOSITE[first.rail])
    : reads("plus", 2, OPPOSITE[second.rail]);
}

interface Lines {
  /** The rail of the start and of the arrival. */
  readonly home: Rail;
  /** Index of the hit behind the last counted cushion. */
  readonly last: number;
  readonly own: Place;
  readonly over: Place;
}

function reading(
  system: SystemName,
  cloth: Cloth,
  way: Way,
  { home, last, own, over }: Lines,
): Reading | null {
  const [first, second] = way.hits;
  if (!first || (system !== "two-to-one" && !second)) return null;
  const { back, unit } = cloth;
  const scale = scaleOf(system, cloth, way.start, first, home);
  // The mirror image also holds for lines that come from beyond the rail.
  const from = scale.along(own);
  const isOnRail = from > -back && from <= scale.end + back + 1e-9;
  if (!isOnRail && system !== "two-to-one") return null;
  const count = { "corner-five": cornerFive, plus, "two-to-one": twoToOne }[system];
  const counted = count(scale, own, over);
  const next = way.hits[last] ?? (way.hits.length === last ? way.last : null);
  const towards = { left: [0, -1], right: [0, 1], bottom: [1, -1], top: [1, 1] } as const;
  const [axis, sign] = towards[home];
  const heads = next && next.by[axis] * sign > 0 ? crossing(next.at, next.by, home, cloth) : null;
  const metre = ([x, y]: Place): Point => [x * unit, y * unit];
  return {
    system,
    ...counted,
    actual: heads && scale.along(heads),
    places: {
      from: metre(own),
      over: metre(over),
      predicted: scale.placed(home, counted.predicted),
      actual: heads && metre(heads),
    },
  };
}

/** Diamonds along the rails that a ball meets. */
interface Scale {
  readonly home: Rail;
  readonly first: Rail;
  /** Diamonds of the home rail, of the first rail, and of the table's width. */
  readonly end: number;
  readonly firstEnd: number;
  readonly width: number;
  /** Along the home rail and the one opposite, and the place of a number there, m. */
  readonly along: (place: Place) => number;
  readonly placed: (rail: Rail, at: number) => Point;
  /** Along the short rail of the plus system, from the home rail, and the place of a number there, m. */
  readonly across: (place: Place) => number;
  readonly placedAcross: (at: number) => Point;
}

function scaleOf(
  system: SystemName,
  { width, length, back, unit }: Cloth,
  start: Place,
  first: Way["hits"][number],
  home: Rail,
): Scale {
  const isLong = (rail: Rail) => rail === "left" || rail === "right";
  const homeLong = isLong(home);
  /** Along a rail, from the end towards which the ball goes at first: 0 is there. */
  const forward = homeLong ? first.at[1] - start[1] < 0 : first.at[0] - start[0] < 0;
  const end = homeLong ? length : width;
  // Diamonds along the home rail; in the plus system they begin at the short rail that is met first.
  const isUp = system === "plus" ? first.rail === "top" : !forward;
  return {
    home,
    first: first.rail,
    end,
    firstEnd: isLong(first.rail) ? length : width,
    width,
    along: (place) => {
      const at = homeLong ? place[1] : place[0];
      return isUp ? end - at : at;
    },
    placed: (rail, at) => {
      const where = isUp && isLong(rail) === homeLong ? end - at : at;
      const line = { left: -back, right: width + back, bottom: -back, top: length + back }[rail];
      return isLong(rail) ? [line * unit, where * unit] : [where * unit, line * unit];
    },
    across: (place) => (home === "left" ? place[0] : width - place[0]),
    placedAcross: (at) => {
      const x = home === "left" ? at : width - at;
      const y = first.rail === "top" ? length + back : -back;
      return [x * unit, y * unit];
    },
  };
}

/** The diamonds between the ends of a rail. */
function between(count: number): number[] {
  const all: number[] = [];
  for (let at = 1; at < count; at += 1) all.push(at);
  return all;
}

type Counted = Pick<Reading, "from" | "over" | "predicted" | "numbers">;

/** The numbers of the first rail, which are those of the target too. */
function sameOnBoth({ first, home, placed }: Scale, count: number): DiamondNumber[] {
  return between(count).flatMap((at): DiamondNumber[] => [
    { at: placed(first, at), number: at, scale: "line" },
    { at: placed(home, at), number: at, scale: "target" },
  ]);
}

function cornerFive(scale: Scale, own: Place, over: Place): Counted {
  const { end, home, along, placed } = scale;
  // 5 is the corner from which the ball comes, and each diamond of the starting rail is half a number.
  const start = (at: number) => 5 - (end - at) / 2;
  const [from, number] = [start(along(own)), along(over)];
  const starts = between(end + 1).map((at): DiamondNumber => ({
    at: placed(home, at),
    number: start(at),
    scale: "line",
  }));
  const numbers = [...starts, ...sameOnBoth(scale, end)];
  return { from, over: number, predicted: from - number, numbers };
}

function plus(scale: Scale, own: Place, over: Place): Counted {
  const { end, home, width, along, placed, across, placedAcross } = scale;
  // The diamonds of the short rail have 7, 5 and 3, the lowest farthest away.
  const short = (at: number) => 9 - 2 * at;
  const [from, number] = [along(own), short(across(over))];
  const numbers = [
    ...between(width).map((at): DiamondNumber => ({
      at: placedAcross(at),
      number: short(at),
      scale: "line",
    })),
    ...between(end).map((at): DiamondNumber => ({
      at: placed(home, at),
      number: at,
      scale: "target",
    })),
  ];
  return { from, over: number, predicted: from + number, numbers };
}

function twoToOne(scale: Scale, own: Place, over: Place): Counted {
  const [from, number] = [scale.along(own), scale.along(over)];
  const numbers = sameOnBoth(scale, scale.firstEnd);
  return { from, over: number, predicted: 2 * number - from, numbers };
}
