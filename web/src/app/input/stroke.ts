/** The stroke: a press on the cue, a pull that sets its speed, and a release that shoots. */

import { speedOfShare } from "../aim/power-bar.ts";
import { shoot } from "../aim/shoot.ts";
import type { Context } from "../common/context.ts";
import type { Store } from "../document/store.ts";
import { canAim } from "../game/awaited-turn.ts";
import { t } from "../words/translate.ts";

/** Pixels on either side of the cue within which a press takes it; a finger needs more than a mouse. */
const REACH = { mouse: 9, other: 20 };

/** Part of the cue that can be pressed: from the tip, m. */
const FROM = 0.05;
const LENGTH = 1.25;

/** Pixels of a pull that do nothing: a return to them cancels the stroke. */
const REST = 8;

/** Pixels of the longest pull. Near the edge of the window it is shorter, but no less than the other one. */
const FULL = 240;
const SHORTEST = 90;

/** A pointer on the page. */
type Pointed = Pick<PointerEvent, "clientX" | "clientY" | "pointerType">;

type Spot = readonly [x: number, y: number];

export class Stroke {
  readonly #store: Store;
  readonly #context: Context;
  #held: {
    readonly start: Spot;
    /** Direction of the pull on the page. */
    readonly back: Spot;
    readonly full: number;
    /** Cue speed before the stroke, m/s. */
    readonly speed: number;
    readonly group: string;
    pulled: boolean;
  } | null = null;

  constructor(store: Store, context: Context) {
    this.#store = store;
    this.#context = context;
  }

  /** Whether a point of the page is on the cue. */
  over(x: number, y: number, pointer: string): boolean {
    const line = this.#line();
    const reach = pointer === "mouse" ? REACH.mouse : REACH.other;
    return line !== null && distance([x, y], line) < reach;
  }

  /** Takes the cue. @returns Whether the point is on it. */
  press(event: Pointed, group: string): boolean {
    const line = this.#line();
    if (!line || !this.over(event.clientX, event.clientY, event.pointerType)) return false;
    const [[tx, ty], [bx, by]] = line;
    const length = Math.hypot(bx - tx, by - ty);
    const back = [(bx - tx) / length, (by - ty) / length] as const;
    const start = [event.clientX, event.clientY] as const;
    const full = Math.min(FULL, Math.max(SHORTEST, room(start, back)));
    const { speed } = this.#store.document.shot.strike;
    this.#held = { start, back, full, speed, group, pulled: false };
    return true;
  }

  /** Pulls the cue to a point of the page: the way along the cue sets the speed. */
  move(x: number, y: number): void {
    const held = this.#held;
    if (!held) return;
    const way = (x - held.start[0]) * held.back[0] + (y - held.start[1]) * held.back[1];
    held.pulled = way > REST;
    const share = (way - REST) / (held.full - REST);
    this.#set(held.pulled ? speedOfShare(share) : held.speed);
  }

  /** Shoots, unless the cue is back where it was pressed. */
  release(): void {
    const held = this.#held;
    this.#held = null;
    if (!held) return;
    this.#store.settle();
    if (held.pulled) shoot(this.#store, this.#context);
  }

  /** Gives the cue its speed back. */
  cancel(): void {
    if (this.#held?.pulled) this.#set(this.#held.speed);
    this.#held = null;
  }

  #set(speed: number): void {
    if (speed === this.#store.document.shot.strike.speed) return;
    this.#store.strike({ speed }, t("change.speed"), this.#held?.group ?? null);
  }

  /** The cue on the page, from near its tip to near its butt; null if none is shown. */
  #line(): readonly [Spot, Spot] | null {
    const { viewer, engine } = this.#context;
    const { shot, session } = this.#store;
    const { struck, strike } = shot;
    if (session.mode === "replay" || struck === null || !strike || !canAim(this.#store, engine)) {
      return null;
    }
    const { position, radius } = shot.balls[struck]!;
    const at = (away: number) => {
      const flat = Math.cos(strike.elevation) * away;
      return viewer.project(
        position[0] - flat * Math.cos(strike.azimuth),
        position[1] - flat * Math.sin(strike.azimuth),
        position[2] + Math.sin(strike.elevation) * away,
      );
    };
    const [tip, butt] = [at(radius + FROM), at(radius + FROM + LENGTH)];
    return tip && butt ? [tip, butt] : null;
  }
}

/** Distance of a point from a line segment, px. */
function distance([x, y]: Spot, [[ax, ay], [bx, by]]: readonly [Spot, Spot]): number {
  const [dx, dy] = [bx - ax, by - ay];
  const share = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
  const on = Math.min(Math.max(share, 0), 1);
  return Math.hypot(x - ax - on * dx, y - ay - on * dy);
}

/** Pixels from a point to the edge of the window in a direction. */
function room([x, y]: Spot, [dx, dy]: Spot): number {
  const across = dx > 0 ? (innerWidth - x) / dx : dx < 0 ? -x / dx : Infinity;
  const down = dy > 0 ? (innerHeight - y) / dy : dy < 0 ? -y / dy : Infinity;
  return Math.min(across, down);
}
