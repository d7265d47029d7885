/** The texture of a ball, drawn on a canvas. */

import { CanvasTexture, SRGBColorSpace, type Texture } from "three";
import { IVORY, type Look } from "./look";

/** Angular radius of a number's circle, of a dot, and half the width of a stripe, rad. */
const CIRCLE = 0.5;
const DOT = 0.105;
const STRIPE = 0.66;
/** Height of a label's digits as a share of its circle's diameter: one digit, two digits. */
const DIGITS = [0.8, 0.66] as const;

/**
 * The ball's skin in equirectangular projection, with the numbers at longitudes ±90° on the equator.
 *
 * @param size - Height of the texture, pixels; it is twice as wide.
 */
export function skin(look: Look, size: number): Texture {
  const canvas = document.createElement("canvas");
  canvas.width = 2 * size;
  canvas.height = size;
  const context = canvas.getContext("2d")!;
  paint(context, look, size);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.anisotropy = 4;
  return texture;
}

function paint(context: CanvasRenderingContext2D, look: Look, size: number): void {
  const radian = size / Math.PI;
  context.fillStyle = look.striped ? IVORY : look.body;
  context.fillRect(0, 0, 2 * size, size);
  if (look.striped) {
    context.fillStyle = look.body;
    context.fillRect(0, size / 2 - STRIPE * radian, 2 * size, 2 * STRIPE * radian);
  }
  if (look.dots) {
    context.fillStyle = look.dots;
    for (const quarter of [0, 1, 2, 3, 4])
      disc(context, (quarter * size) / 2, size / 2, DOT * radian);
    context.fillRect(0, 0, 2 * size, DOT * radian);
    context.fillRect(0, size - DOT * radian, 2 * size, DOT * radian);
  }
  if (look.label) {
    for (const place of [size / 2, (3 * size) / 2])
      label(context, look.label, place, size / 2, radian);
  }
}

function label(
  context: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  radian: number,
): void {
  context.fillStyle = IVORY;
  disc(context, x, y, CIRCLE * radian);
  context.fillStyle = "#17181a";
  const share = DIGITS[Math.min(text.length, DIGITS.length) - 1]!;
  const height = 2 * CIRCLE * radian * share;
  context.font = `600 ${height}px "Helvetica Neue", Arial, sans-serif`;
  context.textAlign = "center";
  // Centre the height of the digits, not of the font.
  const { actualBoundingBoxAscent: above, actualBoundingBoxDescent: below } =
    context.measureText(text);
  context.fillText(text, x, y + (above - below) / 2);
  // A line below distinguishes 6 and 9, as on real balls.
  if (text === "6" || text === "9") {
    context.fillRect(x - 0.28 * height, y + 0.46 * height, 0.56 * height, 0.075 * height);
  }
}

function disc(context: CanvasRenderingContext2D, x: number, y: number, radius: number): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}
