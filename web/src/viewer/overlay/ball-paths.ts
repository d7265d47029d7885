/** The paths of balls: predictions, played shots, and flights, which are dotted over their shadows. */

import { Color, Group } from "three";
import type { Balls } from "../balls/drawn-balls.ts";
import { SLANT } from "../lighting.ts";
import { LAYER } from "../table/solid.ts";
import { type BallPath, VERTEX } from "../viewer-types.ts";
import { Lines } from "./pixel-lines.ts";
import { parts, trail } from "./trails.ts";

export class Paths {
  readonly group = new Group();
  readonly #ghosts = new Lines({ width: 1.8, opacity: 0.62, dash: [0.022, 0.014] });
  readonly #traces = new Lines({ width: 2.4, opacity: 0.92 });
  readonly #contactLines = new Lines({ width: 1.3, opacity: 0.5 });
  readonly #filmed = new Lines({ width: 2, opacity: 0.95, dash: [0.004, 0.012] });
  readonly #flights = new Lines({ width: 3, opacity: 0.95, dash: [0.007, 0.017] });
  readonly #shadows = new Lines({ width: 3.2, opacity: 0.42 });
  readonly #all = [
    this.#shadows,
    this.#contactLines,
    this.#ghosts,
    this.#traces,
    this.#filmed,
    this.#flights,
  ];
  readonly #color = new Color();
  #paths: readonly BallPath[] = [];
  /** Time of the replay, s; null: whole paths. */
  #time: number | null = null;

  constructor() {
    for (const lines of this.#all) this.group.add(lines.object);
  }

  set(paths: readonly BallPath[], balls: Balls, cloth: string): void {
    this.#paths = paths;
    this.#draw(balls, cloth);
  }

  /** Shows trails at a time (s). After the end of all paths, and for null, the paths are whole. */
  setTime(time: number | null, balls: Balls, cloth: string): void {
    const played = this.#paths.filter(({ style }) => style !== "filmed");
    const ends = Math.max(...played.map(({ points }) => points.at(-1)!));
    const shown = time !== null && time < ends ? time : null;
    if (shown === this.#time) return;
    this.#time = shown;
    this.#draw(balls, cloth);
  }

  dispose(): void {
    for (const lines of this.#all) lines.dispose();
  }

  #draw(balls: Balls, cloth: string): void {
    for (const lines of this.#all) lines.clear();
    for (const { ball, points, style } of this.#paths) {
      const color = balls.looks[ball]?.path ?? "#ffffff";
      const radius = ball < balls.count ? balls.info(ball).radius : 0;
      if (style !== "trace" || this.#time === null) this.#add(points, style, color, radius);
      else {
        for (const piece of trail(points, this.#time)) {
          this.#color.set(cloth).lerp(new Color(color), piece.strength);
          this.#add(piece.points, style, `#${this.#color.getHexString()}`, radius);
        }
      }
    }
    for (const lines of this.#all) lines.commit();
  }

  #lines(style: BallPath["style"]): Lines {
    if (style === "contact-line") return this.#contactLines;
    if (style === "filmed") return this.#filmed;
    return style === "ghost" ? this.#ghosts : this.#traces;
  }

  #add(points: ArrayLike<number>, style: BallPath["style"], color: string, radius: number): void {
    for (const part of parts(points, radius)) {
      if (part.flies) {
        this.#flights.add(part.points, VERTEX, color);
        this.#shadows.add(shadow(part.points, radius), VERTEX, "#000000");
      } else {
        this.#lines(style).add(part.points, VERTEX, color);
      }
    }
  }
}

/** The shadow of a flight on the cloth, in the direction of the balls' shadows. */
export function shadow(points: readonly number[], radius: number): number[] {
  return points.map((value, i) => {
    const axis = i % VERTEX;
    if (axis === 3) return value;
    if (axis === 2) return 2 * LAYER;
    return value + SLANT[axis as 0 | 1] * (points[i - axis + 2]! - radius);
  });
}
