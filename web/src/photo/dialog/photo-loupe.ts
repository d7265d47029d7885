/** A magnified part of the photo, beside the finger that covers it. */

import type { Point } from "../../engine/index.ts";
import { element } from "./element.ts";

/** Diameter, CSS pixels, and the distance of its centre from the finger. */
const SIDE = 124;
const AWAY = 96;
/** Magnification against the stage, and least size of a pixel of the photo, CSS pixels. */
const TIMES = 3;
const LEAST = 1.5;

export interface Magnified {
  readonly pixel: Point;
  /** Its place on the stage, CSS pixels. */
  readonly at: Point;
  /** CSS pixels of the stage per pixel of the photo. */
  readonly scale: number;
  /** An outline around the pixel, relative to it, pixels; empty: none. */
  readonly round: readonly Point[];
}

export class Loupe {
  readonly root: HTMLElement;
  readonly #canvas: HTMLCanvasElement;

  constructor() {
    this.#canvas = element("canvas", { width: 2 * SIDE, height: 2 * SIDE });
    this.root = element("div", { class: "photo-loupe", "aria-hidden": "true", hidden: true });
    this.root.append(this.#canvas);
  }

  hide(): void {
    this.root.hidden = true;
  }

  /** Shows the photo around a pixel. */
  show(photo: HTMLCanvasElement, { pixel, at, scale, round: outline }: Magnified): void {
    this.root.hidden = false;
    const above = at[1] > AWAY + SIDE / 2;
    const across = at[0] > AWAY + SIDE / 2 ? -AWAY : AWAY;
    const [x, y] = above ? [at[0], at[1] - AWAY] : [at[0] + across, at[1]];
    const room = (this.root.parentElement?.clientWidth ?? 0) - SIDE / 2;
    const left = Math.max(SIDE / 2, Math.min(room, x)) - SIDE / 2;
    this.root.style.transform = `translate(${left}px, ${Math.max(0, y - SIDE / 2)}px)`;
    const context = this.#canvas.getContext("2d")!;
    const times = 2 * Math.max(LEAST, TIMES * scale);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, 2 * SIDE, 2 * SIDE);
    context.setTransform(times, 0, 0, times, SIDE - times * pixel[0], SIDE - times * pixel[1]);
    context.imageSmoothingEnabled = times < 8;
    context.drawImage(photo, 0, 0);
    context.setTransform(1, 0, 0, 1, SIDE, SIDE);
    context.lineWidth = 2;
    context.strokeStyle = "#ffffff";
    context.shadowColor = "#000000";
    context.shadowBlur = 3;
    context.beginPath();
    for (const [dx, dy] of [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ] as const) {
      context.moveTo(8 * dx, 8 * dy);
      context.lineTo(30 * dx, 30 * dy);
    }
    outline.forEach(([u, v], k) => {
      if (k === 0) context.moveTo(times * u, times * v);
      else context.lineTo(times * u, times * v);
    });
    if (outline.length > 0) context.lineTo(times * outline[0]![0], times * outline[0]![1]);
    context.stroke();
    context.shadowBlur = 0;
  }
}
