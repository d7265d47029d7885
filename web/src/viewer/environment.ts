/** The environment that balls reflect: a dim room with a long lamp above the table. */

import { CubeTexture, SRGBColorSpace } from "three";

const SIDE = 64;
const WALL = "#33363a";

/** The six sides of the room, seen from the table. */
export function room(): CubeTexture {
  const walls = face(() => undefined);
  const ceiling = face((context) => {
    context.filter = "blur(2px)";
    context.fillStyle = "#fff6e4";
    context.fillRect(SIDE * 0.36, SIDE * 0.12, SIDE * 0.28, SIDE * 0.76);
  });
  const table = face((context) => {
    const gradient = context.createRadialGradient(32, 32, 0, 32, 32, 32);
    gradient.addColorStop(0, "#1d4038");
    gradient.addColorStop(1, WALL);
    context.fillStyle = gradient;
    context.fillRect(0, 0, SIDE, SIDE);
  });
  const texture = new CubeTexture([walls, walls, walls, walls, ceiling, table]);
  texture.colorSpace = SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}

function face(draw: (context: CanvasRenderingContext2D) => void): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = SIDE;
  const context = canvas.getContext("2d")!;
  context.fillStyle = WALL;
  context.fillRect(0, 0, SIDE, SIDE);
  draw(context);
  return canvas;
}
