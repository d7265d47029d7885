// A film of the replay, encoded frame by frame: it does not stutter where drawing is slow.

import {
  BufferTarget,
  CanvasSource,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output,
  Quality,
  type VideoCodec,
  WebMOutputFormat,
} from "mediabunny";

/** What to film. */
export interface Film {
  /** Draws the shot at a time (s) into `canvas`, at once. */
  draw: (time: number) => void;
  canvas: HTMLCanvasElement;
  /** Seconds of the shot, and seconds of the shot per second of the film. */
  duration: number;
  rate: number;
  /** Frames per second of the film. */
  fps: number;
  /** Is told the share done, 0 to 1. */
  progress: (share: number) => void;
  signal: AbortSignal;
}

/** In the order in which players are likely to understand them. */
const CODECS: VideoCodec[] = ["avc", "vp9", "vp8"];

/** Seconds for which the last frame stands. */
const LAST_FRAME = 0.5;

/** Whether this browser can encode films at all. */
export function canFilm(): boolean {
  return "VideoEncoder" in globalThis;
}

/** How many frames a film has, both ends included. */
export function frameCount(duration: number, rate: number, fps: number): number {
  return Math.ceil((duration / rate) * fps) + 1;
}

/**
 * Encodes the film as MP4 or, where the browser lacks its encoder, WebM.
 *
 * @throws {DOMException} "AbortError" when `signal` is aborted.
 * @throws {Error} The browser can encode no film of this size.
 */
export async function film({ draw, canvas, ...film }: Film): Promise<Blob> {
  // Encoders want even sizes; WebGL's canvas may change its own while we film.
  const picture = document.createElement("canvas");
  picture.width = canvas.width & ~1;
  picture.height = canvas.height & ~1;
  const pen = picture.getContext("2d");
  const codec = canFilm()
    ? await getFirstEncodableVideoCodec(CODECS, { width: picture.width, height: picture.height })
    : null;
  if (!codec || !pen) {
    throw new Error(
      "This browser cannot encode a film: take a recent Chrome, Edge, Firefox or Safari.",
    );
  }
  const target = new BufferTarget();
  const format = codec === "avc" ? new Mp4OutputFormat() : new WebMOutputFormat();
  const output = new Output({ format, target });
  const source = new CanvasSource(picture, { codec, quality: new Quality("high") });
  output.addVideoTrack(source, { frameRate: film.fps });
  await output.start();
  const count = frameCount(film.duration, film.rate, film.fps);
  for (let i = 0; i < count; i++) {
    if (film.signal.aborted) {
      await output.cancel();
      film.signal.throwIfAborted();
    }
    // From drawing to copying without a pause: WebGL forgets its picture when the page is shown.
    draw(Math.min((i / film.fps) * film.rate, film.duration));
    pen.drawImage(canvas, 0, 0, picture.width, picture.height);
    await source.add(i / film.fps, i === count - 1 ? LAST_FRAME : 1 / film.fps);
    film.progress((i + 1) / count);
  }
  await output.finalize();
  return new Blob([target.buffer!], { type: format.mimeType });
}
