/** The close-up of the first contact while a finger turns the cue: ghost ball and object ball, in a free corner. */

import { LOUPE } from "../../viewer/index.ts";
import type { Context } from "../common/context.ts";
import { shownGuide } from "../document/guide-extent.ts";
import type { Store } from "../document/store.ts";
import { shownContact } from "../game/guide/shown-contact.ts";

/** Diameter of a ball in the close-up, CSS pixels: two that touch fill the disc. */
const BALL = 0.44 * LOUPE;

/** Bounds of the magnification. */
const LEAST = 2;
const MOST = 8;

/** Distance (CSS pixels) of the disc from the edges, and from what it must not cover. */
const MARGIN = 8;
const CLEAR = 24;

interface Spot {
  readonly x: number;
  readonly y: number;
}

interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/**
 * The centre of the disc: in the corner of the picture that is farthest from everything that it must not cover.
 * It stays in a corner until one of these comes near.
 */
export function closeUpPlace(box: Box, covered: readonly Spot[], before: Spot | null): Spot {
  const inset = MARGIN + LOUPE / 2;
  const room = (corner: Spot) =>
    Math.min(...covered.map(({ x, y }) => Math.hypot(x - corner.x, y - corner.y)));
  if (before && room(before) > LOUPE / 2 + CLEAR) return before;
  const corners = [box.top + inset, box.bottom - inset].flatMap((y) =>
    [box.left + inset, box.right - inset].map((x) => ({ x, y })),
  );
  return corners.reduce((best, one) => (room(one) > room(best) ? one : best));
}

export class AimCloseUp {
  readonly #store: Store;
  readonly #context: Context;
  readonly #boxOf: () => Box;
  #at: Spot | null = null;

  /** @param boxOf The part of the window in which the table is seen. */
  constructor(store: Store, context: Context, boxOf: () => Box) {
    this.#store = store;
    this.#context = context;
    this.#boxOf = boxOf;
  }

  /** Shows the contact of the present aim, if there is one. @param finger What the disc must not cover either. */
  show(finger: Spot): void {
    const { viewer } = this.#context;
    const { shot, ghost } = this.#store;
    const contact = ghost.trace && shownContact(ghost.trace, shownGuide(this.#store));
    const seen = contact && [contact.ghost, contact.other].map((place) => viewer.project(...place));
    const [own, other] = seen ?? [];
    if (shot.struck === null || !contact || !own || !other) {
      this.hide();
      return;
    }
    const point = { x: (own[0] + other[0]) / 2, y: (own[1] + other[1]) / 2 };
    const { radius, position } = shot.balls[shot.struck]!;
    const start = viewer.project(...position);
    const covered = [finger, point, ...(start ? [{ x: start[0], y: start[1] }] : [])];
    this.#at = closeUpPlace(this.#boxOf(), covered, this.#at);
    // Behind the cue, balls that are far away are small.
    const [x, y, z] = contact.ghost;
    const [left, above] = [viewer.project(x - radius, y, z), viewer.project(x, y - radius, z)];
    const reach = Math.max(...[left, above].map((at) => (at ? distance(at, own) : 0)));
    const zoom = Math.min(Math.max(BALL / (2 * reach), LEAST), MOST);
    viewer.loupe(point, { at: this.#at, zoom });
  }

  hide(): void {
    if (this.#at) this.#context.viewer.loupe(null);
    this.#at = null;
  }
}

function distance(
  [ax, ay]: readonly [number, number],
  [bx, by]: readonly [number, number],
): number {
  return Math.hypot(ax - bx, ay - by);
}
