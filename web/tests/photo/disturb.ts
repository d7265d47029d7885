/** What happens to photos outside a studio: light of a colour, shade, a moving hand, noise, and JPEG. */

import jpeg from "jpeg-js";
import type { Pixels } from "../../src/photo/picture/pixels.ts";
import type { Random } from "./random.ts";

/** Ranges of the disturbances. */
export const DISTURBANCES = {
  /** Mean brightness of the table that a camera aims at, of 255, and its standard deviation as ln. */
  brightness: 95,
  exposure: 0.2,
  /** Standard deviation of ln of the light's red and its blue against its green. */
  tint: 0.12,
  /** Light that the corners lose. */
  vignette: [0, 0.4],
  /** Light that a person's shadow takes from one side of the photo, in half of the photos. */
  shadow: [0.2, 0.5],
  /** Length of the trace of a moving hand, pixels. */
  motion: [0, 2.5],
  /** Standard deviation of the noise of the sensor, of 255. */
  noise: [2, 9],
  /** Of the JPEG file. */
  quality: [55, 95],
} as const;

/** A disturbed copy of a photo. */
export function disturbed(photo: Pixels, random: Random): Pixels {
  const lit = inOtherLight(photo, random);
  const moved = shaken(lit, random);
  const noise = random.uniform(...DISTURBANCES.noise);
  for (let at = 0; at < moved.data.length; at += 4) {
    if (moved.data[at + 3] === 0) continue;
    for (let k = at; k < at + 3; k += 1) moved.data[k] = moved.data[k]! + random.gaussian(noise);
  }
  const { width, height, data } = moved;
  const quality = Math.round(random.uniform(...DISTURBANCES.quality));
  const file = jpeg.encode({ width, height, data: Buffer.from(data.buffer) }, quality).data;
  const read = jpeg.decode(file, { useTArray: true });
  return { ...photo, data: new Uint8ClampedArray(read.data.buffer as ArrayBuffer) };
}

/** The photo with another strength and colour of the light, dark corners and the shadow of a person. */
function inOtherLight(photo: Pixels, random: Random): Pixels {
  const { width, height } = photo;
  const strength =
    (DISTURBANCES.brightness / brightness(photo)) *
    Math.exp(random.gaussian(DISTURBANCES.exposure));
  const gains = [
    strength * Math.exp(random.gaussian(DISTURBANCES.tint)),
    strength,
    strength * Math.exp(random.gaussian(DISTURBANCES.tint)),
  ];
  const corner = random.uniform(...DISTURBANCES.vignette);
  const shade = random.choice([0, random.uniform(...DISTURBANCES.shadow)]);
  const angle = random.uniform(0, 2 * Math.PI);
  const edge = random.uniform(-0.2, 0.5);
  const data = new Uint8ClampedArray(photo.data);
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const [u, v] = [(2 * x) / width - 1, (2 * y) / height - 1];
      const behind = (u * Math.cos(angle) + v * Math.sin(angle) - edge) / 0.15;
      const share = 1 / (1 + Math.exp(-behind));
      const light = (1 - (corner * (u * u + v * v)) / 2) * (1 - shade * share);
      const at = 4 * (y * width + x);
      for (let c = 0; c < 3; c += 1) data[at + c] = photo.data[at + c]! * gains[c]! * light;
    }
  }
  return { ...photo, data };
}

/** Mean brightest channel of the pixels that were rendered, of 255. */
function brightness({ data }: Pixels): number {
  let [sum, count] = [0, 0];
  for (let at = 0; at < data.length; at += 4) {
    if (data[at + 3] === 0) continue;
    sum += Math.max(data[at]!, data[at + 1]!, data[at + 2]!);
    count += 1;
  }
  return sum / count;
}

/** The photo as a hand that moved along a line took it. */
function shaken(photo: Pixels, random: Random): Pixels {
  const length = random.uniform(...DISTURBANCES.motion);
  const angle = random.uniform(0, Math.PI);
  const [dx, dy] = [length * Math.cos(angle), length * Math.sin(angle)];
  const { width, height } = photo;
  const data = new Uint8ClampedArray(photo.data);
  const steps = 1 + Math.ceil(length);
  const offsets = Array.from({ length: steps }, (_, k) => {
    const share = steps > 1 ? k / (steps - 1) - 0.5 : 0;
    return [Math.round(share * dx), Math.round(share * dy)] as const;
  });
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      if (data[4 * (y * width + x) + 3] === 0) continue;
      for (let c = 0; c < 3; c += 1) {
        let sum = 0;
        for (const [i, j] of offsets) {
          const column = Math.min(width - 1, Math.max(0, x + i));
          const row = Math.min(height - 1, Math.max(0, y + j));
          sum += photo.data[4 * (row * width + column) + c]!;
        }
        data[4 * (y * width + x) + c] = sum / offsets.length;
      }
    }
  }
  return { ...photo, data };
}
