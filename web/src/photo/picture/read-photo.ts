/** Reads a photo from a file. Nothing leaves the page. */

import type { Pixels } from "./pixels.ts";

/** The largest file that is read, bytes: phones write 3 to 25 MB. */
const LARGEST = 80e6;
/** The longer side of the pixels that are kept: balls have 10 to 40 of them, and memory stays small. */
const LONGEST = 2400;
/** The least shorter side, pixels: below this a ball has fewer than five. */
export const LEAST = 400;

/** Why a file is refused. */
export type Refusal = "notPhoto" | "tooLarge" | "tooSmall";

export interface Photo {
  readonly canvas: HTMLCanvasElement;
  readonly pixels: Pixels;
}

/** A photo, upright as its camera notes it, or why there is none. */
export async function readPhoto(file: File): Promise<Photo | Refusal> {
  if (file.size > LARGEST) return "tooLarge";
  let bitmap: ImageBitmap;
  try {
    bitmap = await createImageBitmap(file, { imageOrientation: "from-image" });
  } catch {
    return "notPhoto";
  }
  const { width, height } = bitmap;
  if (Math.min(width, height) < LEAST) {
    bitmap.close();
    return "tooSmall";
  }
  const scale = Math.min(1, LONGEST / Math.max(width, height));
  const canvas = document.createElement("canvas");
  canvas.width = Math.round(width * scale);
  canvas.height = Math.round(height * scale);
  const context = canvas.getContext("2d", { willReadFrequently: true })!;
  context.imageSmoothingQuality = "high";
  context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
  bitmap.close();
  const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
  return {
    canvas,
    pixels: { left: 0, top: 0, width: canvas.width, height: canvas.height, data },
  };
}
