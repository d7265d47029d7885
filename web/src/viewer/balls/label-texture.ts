/** The labels of balls in one texture, a cell for each. */

import { CanvasTexture, LinearMipmapLinearFilter, type Texture } from "three";

/** Side of a cell, pixels; a power of two, so that the mip levels of neighbours stay apart. */
const CELL = 64;
/** Share of a cell that a label fills at most. */
const FILLED = 0.86;

export interface Labels {
  texture: Texture;
  /** Cells along each side of the texture. */
  cells: number;
}

/** Draws the labels white on black, row by row from the lower left. */
export function labelTexture(labels: readonly string[]): Labels {
  const cells = 2 ** Math.ceil(Math.log2(Math.max(1, Math.sqrt(labels.length))));
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = CELL * cells;
  const context = canvas.getContext("2d")!;
  context.fillStyle = "#000000";
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.fillStyle = "#ffffff";
  context.textAlign = "center";
  labels.forEach((text, index) => {
    const [column, row] = [index % cells, Math.floor(index / cells)];
    draw(context, text, (column + 0.5) * CELL, canvas.height - (row + 0.5) * CELL);
  });
  const texture = new CanvasTexture(canvas);
  texture.minFilter = LinearMipmapLinearFilter;
  texture.anisotropy = 4;
  return { texture, cells };
}

function draw(context: CanvasRenderingContext2D, text: string, x: number, y: number): void {
  // The digits fill the cell: its height if there is one, its width if there are two.
  const font = (size: number): string => `700 ${size}px "Helvetica Neue", Arial, sans-serif`;
  context.font = font(CELL);
  const full = context.measureText(text);
  const height = full.actualBoundingBoxAscent + full.actualBoundingBoxDescent;
  const size = (CELL * FILLED * CELL) / Math.max(height, full.width);
  context.font = font(size);
  // Centre the height of the digits, not of the font.
  const { actualBoundingBoxAscent: above, actualBoundingBoxDescent: below } =
    context.measureText(text);
  // A line below distinguishes 6 and 9, as on real balls.
  const underlined = text === "6" || text === "9";
  context.save();
  context.translate(x, y);
  if (underlined) {
    context.fillRect(-0.3 * CELL, 0.37 * CELL, 0.6 * CELL, 0.06 * CELL);
    context.translate(0, -0.08 * CELL);
    context.scale(0.84, 0.84);
  }
  context.fillText(text, 0, (above - below) / 2);
  context.restore();
}
