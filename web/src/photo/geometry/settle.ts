/**
 * Makes a valid layout of balls whose places are known to some millimetres: balls that nearly touch touch,
 * balls that nearly touch a rail touch it, and balls that overlap are pushed apart.
 */

import type { Geometry, Point } from "../../engine/index.ts";

/**
 * Gaps up to this count as contacts, m: 6 mm, a tenth of a ball and about the error of a photo. With less,
 * frozen balls would stay apart; with more, separate balls would be moved together.
 */
export const CONTACT_GAP = 0.006;

/** Most rounds of the projections; a rack of fifteen balls needs fewer than a thousand. */
const ROUNDS = 4000;
/** Largest error of a contact at the end, m: a tenth of TOUCHING. */
const EXACT = 1e-10;
/** Gaps up to this count as contacts in the engine, m (TOUCH_TOLERANCE in crates/carom/src/table/place.rs). */
const TOUCHING = 1e-9;

/** What limits the centres of the balls. */
export interface Bed {
  /** Noses of the cushions, m; a ball's centre stays at least `reach` from them. */
  readonly noses: readonly Nose[];
  /** Horizontal distance of a centre from the nose that it touches, m. */
  readonly reach: number;
  /** m. */
  readonly radius: number;
}

interface Nose {
  /** 0: the nose is a line of constant x, 1: of constant y. */
  readonly axis: 0 | 1;
  /** Where on this axis, m. */
  readonly at: number;
  /** Direction of the bed along this axis. */
  readonly inward: 1 | -1;
  /** Its span along the other axis, m. */
  readonly from: number;
  readonly to: number;
}

/** Two balls that touch, or a ball that touches a nose. */
export type Contact = { readonly ball: number } & (
  { readonly other: number } | { readonly nose: Nose }
);

export interface Settled {
  readonly positions: readonly Point[];
  readonly contacts: readonly Contact[];
}

/**
 * The bed of a table for balls of one radius (m). A ball touches a nose at height h at the distance
 * √(R² − (h − R)²), as in the engine (crates/carom/src/detect/ball_cushion.rs).
 */
export function bed({ cushions, cushion_height: height }: Geometry, radius: number): Bed {
  const noses = cushions
    .filter(({ part }) => part === "nose")
    .map(({ start, end }): Nose => {
      const axis = Math.abs(end[0] - start[0]) > Math.abs(end[1] - start[1]) ? 1 : 0;
      const along = axis === 0 ? 1 : 0;
      // Counter-clockwise around the table, the bed is on the left.
      const inward = (axis === 1 ? end[0] > start[0] : end[1] < start[1]) ? 1 : -1;
      return {
        axis,
        at: start[axis],
        inward,
        from: Math.min(start[along], end[along]),
        to: Math.max(start[along], end[along]),
      };
    });
  return { noses, radius, reach: Math.sqrt(Math.max(0, radius ** 2 - (height - radius) ** 2)) };
}

/**
 * Moves balls by little, so that near contacts become exact and no balls overlap.
 *
 * Constraints are projected in turns (M. Müller et al., "Position based dynamics", Journal of Visual
 * Communication and Image Representation 18 (2007) 109–118, section 3.3). If contacts contradict each
 * other, the one with the largest gap is released until the rest is exact.
 */
export function settle(places: readonly Point[], bed: Bed): Settled {
  const pairs = possible(places.length, bed);
  const exact = pairs
    .filter((contact) => isNear(places, contact, bed, CONTACT_GAP))
    .sort((a, b) => gap(places, b, bed) - gap(places, a, bed));
  for (;;) {
    const positions = projected(places, pairs, new Set(exact), bed);
    if (positions || exact.length === 0) {
      const found = positions ?? places;
      return {
        positions: found,
        contacts: pairs.filter((contact) => isNear(found, contact, bed, TOUCHING)),
      };
    }
    exact.shift();
  }
}

/** Every contact that this number of balls can have. */
function possible(count: number, { noses }: Bed): Contact[] {
  return Array.from({ length: count }, (_, ball) => [
    ...noses.map((nose) => ({ ball, nose })),
    ...Array.from({ length: ball }, (_, other) => ({ ball, other })),
  ]).flat();
}

/** The positions after projection; null if the contacts contradict each other. */
function projected(
  places: readonly Point[],
  all: readonly Contact[],
  exact: ReadonlySet<Contact>,
  bed: Bed,
): Point[] | null {
  const positions = places.map(([x, y]): [number, number] => [x, y]);
  for (let round = 0; round < ROUNDS; round += 1) {
    let error = 0;
    for (const contact of all) {
      const off = gap(positions, contact, bed);
      if (off >= 0 && !exact.has(contact)) continue;
      correct(positions, contact, off);
      error = Math.max(error, Math.abs(off));
    }
    if (error < EXACT) return positions;
  }
  return null;
}

/** Closes a gap (m), or opens an overlap. */
function correct(positions: [number, number][], contact: Contact, gap: number): void {
  const place = positions[contact.ball]!;
  if ("nose" in contact) {
    place[contact.nose.axis] -= contact.nose.inward * gap;
    return;
  }
  const other = positions[contact.other]!;
  const [x, y] = [other[0] - place[0], other[1] - place[1]];
  const apart = Math.hypot(x, y);
  // Balls at one place are parted along the table's width.
  const [ux, uy] = apart > 0 ? [x / apart, y / apart] : [1, 0];
  place[0] += (gap / 2) * ux;
  place[1] += (gap / 2) * uy;
  other[0] -= (gap / 2) * ux;
  other[1] -= (gap / 2) * uy;
}

/** The gap of two balls or of a ball and a nose, m; infinite beside the ends of a nose. */
function gap(places: readonly Point[], contact: Contact, { radius, reach }: Bed): number {
  const place = places[contact.ball]!;
  if ("nose" in contact) {
    const { axis, at, inward, from, to } = contact.nose;
    const along = place[axis === 0 ? 1 : 0];
    return along < from || along > to ? Infinity : inward * (place[axis] - at) - reach;
  }
  const other = places[contact.other]!;
  return Math.hypot(other[0] - place[0], other[1] - place[1]) - 2 * radius;
}

function isNear(places: readonly Point[], contact: Contact, bed: Bed, most: number): boolean {
  return gap(places, contact, bed) <= most;
}
