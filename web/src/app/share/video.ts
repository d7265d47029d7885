/** Encodes a film of the replay frame by frame, so that slow drawing does not make it stutter. */

import { PageError } from "../common/refusals.ts";
import { ArrayBufferTarget, Muxer } from "mp4-muxer";
import { t } from "../words/translate.ts";

/** The shot to film. */
export interface Film {
  /** Draws the shot at a time (s) into `canvas`, at once. */
  draw: (time: number) => void;
  canvas: HTMLCanvasElement;
  /** Duration of the shot, s, and seconds of the shot per second of the film. */
  duration: number;
  rate: number;
  /** Frames per second of the film. */
  fps: number;
  /** Called with the share of the frames that are done, 0 to 1. */
  progress: (share: number) => void;
  signal: AbortSignal;
}

/** Codecs for MP4, in the order of support among video players. */
const CODECS = [
  // H.264, high and baseline profile, level 5.1: up to 4096 × 2304.
  { encode: "avc1.640033", mux: "avc" },
  { encode: "avc1.420033", mux: "avc" },
  // VP9, profile 0, level 5.1, 8 bit.
  { encode: "vp09.00.51.08", mux: "vp9" },
] as const;

/** Bits per pixel and frame: plain cloth and few moving edges need little. */
const BITS_PER_PIXEL = 0.2;

/** Seconds between key frames, to which video players can jump. */
const KEY_FRAMES = 1;

/** Most frames that wait for the encoder. */
const QUEUE = 4;

/** Duration of the last frame, s. */
const LAST_FRAME = 0.5;

/** Whether this browser can encode films at all. */
export function canFilm(): boolean {
  return "VideoEncoder" in globalThis;
}

/** Number of frames of a film, with first and last. */
export function frameCount(duration: number, rate: number, fps: number): number {
  return Math.ceil((duration / rate) * fps) + 1;
}

/** The first codec that the browser encodes at this size. */
async function firstCodec(size: { width: number; height: number }, fps: number) {
  const bitrate = Math.round(size.width * size.height * fps * BITS_PER_PIXEL);
  for (const { encode, mux } of canFilm() ? CODECS : []) {
    const config = { codec: encode, ...size, bitrate, framerate: fps };
    if ((await VideoEncoder.isConfigSupported(config)).supported) return { config, mux };
  }
  throw new PageError(t("film.cannot"));
}

/** Microseconds, the unit of encoders. */
const micro = (seconds: number): number => Math.round(seconds * 1e6);

/**
 * Encodes the film as MP4.
 *
 * @throws {DOMException} "AbortError" when `signal` is aborted.
 * @throws {Error} The browser cannot encode a film of this size.
 */
export async function film({ draw, canvas, ...film }: Film): Promise<Blob> {
  // Encoders need even sizes, and the table's canvas may be resized during the export.
  const picture = document.createElement("canvas");
  const size = { width: canvas.width & ~1, height: canvas.height & ~1 };
  Object.assign(picture, size);
  const pen = picture.getContext("2d")!;
  const { config, mux } = await firstCodec(size, film.fps);
  const target = new ArrayBufferTarget();
  const video = { codec: mux, ...size, frameRate: film.fps };
  const muxer = new Muxer({ target, video, fastStart: "in-memory" });
  let failure: DOMException | undefined;
  const encoder = new VideoEncoder({
    output: (chunk, meta) => muxer.addVideoChunk(chunk, meta),
    error: (error) => (failure = error),
  });
  encoder.configure(config);
  try {
    const count = frameCount(film.duration, film.rate, film.fps);
    for (let i = 0; i < count; i++) {
      film.signal.throwIfAborted();
      if (failure) throw failure;
      // Copy in the same task: WebGL clears its canvas after the page was displayed.
      draw(Math.min((i / film.fps) * film.rate, film.duration));
      pen.drawImage(canvas, 0, 0, size.width, size.height);
      const last = i === count - 1;
      const frame = new VideoFrame(picture, {
        timestamp: micro(i / film.fps),
        duration: micro(last ? LAST_FRAME : 1 / film.fps),
      });
      encoder.encode(frame, { keyFrame: i % (KEY_FRAMES * film.fps) === 0 });
      frame.close();
      film.progress((i + 1) / count);
      await room(encoder);
    }
    await encoder.flush();
  } finally {
    if (encoder.state !== "closed") encoder.close();
  }
  muxer.finalize();
  return new Blob([target.buffer], { type: "video/mp4" });
}

/** Waits until the encoder takes another frame; the page handles its events meanwhile. */
async function room(encoder: VideoEncoder): Promise<void> {
  do await new Promise((done) => setTimeout(done));
  while (encoder.encodeQueueSize > QUEUE && encoder.state === "configured");
}
