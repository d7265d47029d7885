/** A rendered photo as a PNG file. */

import { PNG } from "pngjs";
import type { Pixels } from "../../src/photo/picture/pixels.ts";

export function png({ width, height, data }: Pixels): Buffer {
  const image = new PNG({ width, height });
  image.data = Buffer.from(data);
  return PNG.sync.write(image);
}
