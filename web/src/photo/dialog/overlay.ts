/** What is drawn over the photo: the table as it was found, the landmarks and the balls. */

import type { Point } from "../../engine/index.ts";
import { look } from "../../viewer/index.ts";
import { project } from "../geometry/camera.ts";
import { outline } from "../picture/ball-outline.ts";
import type { Session } from "../photo-session.ts";
import type { Stage } from "./photo-stage.ts";

/** Points per side of the table, so that a distorted side is drawn as a curve. */
const POINTS = 24;
/** Radius of the mark of a landmark, CSS pixels. */
const RING = 9;
/** Radii of a badge, CSS pixels: as large as the ball, unless it would hide others or be unreadable. */
const BADGE = [3.5, 9] as const;
/** The outline of a ball that is not yet confirmed, CSS pixels. */
const DASHES = [5, 4];
/** Least radius of a badge with a number. */
const READABLE = 6.5;

/**
 * Draws all marks.
 *
 * @param selected - Id of a ball that is being changed.
 * @param cross - The keyboard's cross, pixels of the photo.
 */
export function drawOverlay(
  context: CanvasRenderingContext2D,
  stage: Stage,
  session: Session,
  selected: string | null,
  cross: Point | null,
): void {
  context.lineJoin = "round";
  drawTable(context, stage, session);
  for (const pixel of session.draft.landmarks) {
    const [x, y] = stage.place(pixel);
    circle(context, [x, y], RING);
    stroke(context, "#ffffff", 2);
    circle(context, [x, y], 2);
    stroke(context, "#ffffff", 2);
  }
  drawBalls(context, stage, session, selected);
  if (!cross) return;
  const [x, y] = stage.place(cross);
  context.beginPath();
  for (const [dx, dy] of [
    [14, 0],
    [0, 14],
  ] as const) {
    context.moveTo(x - dx, y - dy);
    context.lineTo(x + dx, y + dy);
  }
  stroke(context, "#ffffff", 2);
}

/** The edge of the cushions and the holes, where the calibration sees them. */
function drawTable(context: CanvasRenderingContext2D, stage: Stage, session: Session): void {
  const { calibration, table } = session;
  const { size, cushion_height: height, pockets } = table.geometry;
  if (!calibration || !size) return;
  const [width, length] = size;
  const corners: readonly Point[] = [
    [0, 0],
    [width, 0],
    [width, length],
    [0, length],
  ];
  const sides = corners.flatMap((from, k) => {
    const to = corners[(k + 1) % 4]!;
    return Array.from({ length: POINTS }, (_, i): Point => {
      const share = i / POINTS;
      return [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
    });
  });
  const draw = (points: readonly Point[], z: number) => {
    const seen = points.map(([x, y]) => project(calibration.camera, [x, y, z]));
    if (seen.every((pixel) => pixel !== null))
      polygon(
        context,
        seen.map((p) => stage.place(p)),
      );
    stroke(context, calibration.fits ? "#7dffa8" : "#ff8a7a", 1.5);
  };
  draw(sides, height);
  for (const { center, radius } of pockets) {
    const rim = Array.from({ length: POINTS }, (_, k): Point => {
      const angle = (2 * Math.PI * k) / POINTS;
      return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)];
    });
    draw(rim, 0);
  }
}

function drawBalls(
  context: CanvasRenderingContext2D,
  stage: Stage,
  session: Session,
  selected: string | null,
): void {
  const { draft, calibration, table, tray } = session;
  if (!calibration) return;
  for (const { id, pixel, suggested } of draft.balls) {
    const points = outline(calibration.camera, pixel, table.radius);
    if (!points) continue;
    const places = points.map(({ offset }) =>
      stage.place([pixel[0] + offset[0], pixel[1] + offset[1]]),
    );
    polygon(context, places);
    context.setLineDash(suggested ? DASHES : []);
    stroke(context, "#ffffff", id === selected ? 3.5 : 1.5);
    context.setLineDash([]);
    const [top, bottom] = [Math.min, Math.max].map((end) => end(...places.map(([, y]) => y)));
    const size = Math.max(BADGE[0], Math.min(BADGE[1], 0.4 * (bottom! - top!)));
    badge(context, { id, index: tray.indexOf(id) }, [stage.place(pixel)[0], top! - size - 2], size);
  }
}

/** A ball's colour, and its number if there is room, above it. */
function badge(
  context: CanvasRenderingContext2D,
  { id, index }: { readonly id: string; readonly index: number },
  [x, y]: Point,
  size: number,
): void {
  const { body, label, striped } = look(id, Math.max(0, index));
  circle(context, [x, y], size);
  context.fillStyle = striped ? "#f6f1e3" : body;
  context.fill();
  stroke(context, body, size / 4);
  if (label === "" || size < READABLE) return;
  circle(context, [x, y], 0.75 * size);
  context.fillStyle = "#f6f1e3";
  context.fill();
  context.font = `600 ${1.2 * size}px sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = "#17181a";
  context.fillText(label, x, y + 0.5);
}

function polygon(context: CanvasRenderingContext2D, points: readonly Point[]): void {
  context.beginPath();
  points.forEach(([x, y], k) => {
    if (k === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.closePath();
}

function circle(context: CanvasRenderingContext2D, [x, y]: Point, radius: number): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
}

/** Strokes the path with a dark edge, so that it is visible on every photo. */
function stroke(context: CanvasRenderingContext2D, color: string, width: number): void {
  context.strokeStyle = "rgb(0 0 0 / 60%)";
  context.lineWidth = width + 2;
  context.stroke();
  context.strokeStyle = color;
  context.lineWidth = width;
  context.stroke();
}
