/** What the user has drawn on the table: lines, arrows, circles, areas and labels, over everything else. */

import { CanvasTexture, Group, Sprite, SpriteMaterial } from "three";
import { setCover } from "../render/extent.ts";
import type { DrawnMark, Point } from "../viewer-types.ts";
import { Areas } from "./marked-areas.ts";
import { Lines } from "./pixel-lines.ts";

/** The colours of marks, light enough for every cloth. */
export const MARK_COLORS: Readonly<Record<DrawnMark["color"], string>> = {
  white: "#ffffff",
  yellow: "#ffd23f",
  red: "#ff7468",
  blue: "#8fd0ff",
};

/** Behind every line, so that it can be read on cloth, wood and balls, and in grey. */
const EDGE = "#101413";

/** Height (m) of the marks: that of the balls' centres, at which the page reads places. */
export const MARK_HEIGHT = 0.0286;

/** Length (m) of the head of an arrow, and half its angle, rad. */
const HEAD = 0.05;
const SPREAD = 0.42;

/** Corners of a circle. */
const CORNERS = 64;

/** Height of a label, m; and of its picture, pixels. */
const LABEL = 0.085;
const PIXELS = 64;

/** Half the width of the cross at the keyboard's place, m. */
const CROSS = 0.035;

export class DrawnMarks {
  readonly group = new Group();
  readonly #edges = new Lines({ width: 5, opacity: 0.55, onTop: true });
  readonly #lines = new Lines({ width: 2.6, opacity: 1, onTop: true });
  readonly #areas = new Areas();
  #labels: Sprite[] = [];

  constructor() {
    this.#edges.object.renderOrder = 4;
    this.#lines.object.renderOrder = 5;
    this.group.add(this.#areas.group, this.#edges.object, this.#lines.object);
  }

  /** @param cursor The keyboard's place, which has a cross; null: none. */
  set(marks: readonly DrawnMark[], cursor: Point | null): void {
    this.#clear();
    for (const mark of marks) this.#add(mark);
    if (cursor) {
      const [x, y] = cursor;
      this.#stroke(
        [
          [x - CROSS, y],
          [x + CROSS, y],
        ],
        MARK_COLORS.white,
      );
      this.#stroke(
        [
          [x, y - CROSS],
          [x, y + CROSS],
        ],
        MARK_COLORS.white,
      );
    }
    const areas = marks.filter((mark) => mark.kind === "area");
    this.#areas.set(areas.map(({ outline, color }) => ({ outline, color: MARK_COLORS[color] })));
    this.#edges.commit();
    this.#lines.commit();
    if (this.#labels.length > 0) this.group.add(...this.#labels);
  }

  dispose(): void {
    this.#clear();
    this.#areas.dispose();
    this.#edges.dispose();
    this.#lines.dispose();
  }

  #add(mark: DrawnMark): void {
    const color = MARK_COLORS[mark.color];
    switch (mark.kind) {
      case "line": {
        this.#stroke([mark.from, mark.to], color);
        return;
      }
      case "arrow":
        this.#stroke([mark.from, mark.to], color);
        {
          this.#stroke(arrowHead(mark.from, mark.to), color);
          return;
        }
      case "circle": {
        this.#stroke(circle(mark.center, mark.radius), color);
        return;
      }
      case "area": {
        this.#stroke([...mark.outline, mark.outline[0]!], color);
        return;
      }
      case "label":
        this.#labels.push(label(mark.text, mark.at, color));
    }
  }

  #stroke(places: readonly Point[], color: string): void {
    const points = places.flatMap(([x, y]) => [x, y, MARK_HEIGHT]);
    this.#edges.add(points, 3, EDGE);
    this.#lines.add(points, 3, color);
  }

  #clear(): void {
    for (const sprite of this.#labels) {
      this.group.remove(sprite);
      sprite.material.map?.dispose();
      sprite.material.dispose();
    }
    this.#labels = [];
    this.#edges.clear();
    this.#lines.clear();
  }
}

/** The two strokes of an arrow's head, m. */
export function arrowHead([fx, fy]: Point, [x, y]: Point): Point[] {
  const back = Math.atan2(fy - y, fx - x);
  const length = Math.min(HEAD, Math.hypot(fx - x, fy - y));
  const end = (turn: number): Point => [
    x + length * Math.cos(back + turn),
    y + length * Math.sin(back + turn),
  ];
  return [end(SPREAD), [x, y], end(-SPREAD)];
}

function circle([x, y]: Point, radius: number): Point[] {
  return Array.from({ length: CORNERS + 1 }, (_, k): Point => {
    const angle = (2 * Math.PI * k) / CORNERS;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

/** A text that faces the camera. */
function label(text: string, [x, y]: Point, color: string): Sprite {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d")!;
  const font = `600 ${0.72 * PIXELS}px system-ui, sans-serif`;
  context.font = font;
  canvas.width = Math.ceil(context.measureText(text).width) + 16;
  canvas.height = PIXELS;
  // Another size has reset the context.
  Object.assign(context, { font, textAlign: "center", textBaseline: "middle", lineJoin: "round" });
  context.strokeStyle = EDGE;
  context.lineWidth = 9;
  context.strokeText(text, canvas.width / 2, PIXELS / 2);
  context.fillStyle = color;
  context.fillText(text, canvas.width / 2, PIXELS / 2);
  const map = new CanvasTexture(canvas);
  map.colorSpace = "srgb";
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, depthWrite: false }));
  const width = (LABEL * canvas.width) / PIXELS;
  sprite.scale.set(width, LABEL, 1);
  sprite.position.set(x, y, MARK_HEIGHT);
  sprite.renderOrder = 6;
  setCover(sprite, (add) => {
    add(sprite.position, sprite.position, Math.hypot(width, LABEL) / 2, 0);
  });
  return sprite;
}
