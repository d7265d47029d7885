/** Simulates variants in chunks. The worker runs this; tests call it directly. */

import { CaromError, refusalOf } from "../../engine/error.ts";
import type { Engine, Shot } from "../../engine/index.ts";
import type { Chunk, FromWorker, VariantsRequest } from "./variants-protocol.ts";

/**
 * Variants per chunk: about ten milliseconds for a mid-game shot. Between chunks the worker checks
 * whether the request is stale. Smaller chunks show the first picture sooner; larger ones need fewer
 * messages.
 */
const CHUNK = 100;

/** Greatest distance of a drawn path from the exact one, m: half a pixel of a table on a screen. */
const PATH_TOLERANCE = 2e-3;

/** Numbers of a polyline's point: x, y, z, t. */
const POINT = 4;

/** The worker's means of communication. */
export interface WorkerContext {
  send: (message: FromWorker, transfer: Transferable[]) => void;
  /** Whether a later request replaced this generation. */
  isStale: (generation: number) => boolean;
  /** Lets the worker receive messages. */
  pause: () => Promise<void>;
}

/** Simulates a request chunk by chunk, and stops when it becomes stale. */
export async function simulate(
  engine: Engine,
  request: VariantsRequest,
  { send, isStale, pause }: WorkerContext,
): Promise<void> {
  const { generation } = request;
  try {
    const shot = engine.shot(request.shot);
    try {
      for (let first = 0; first < request.count; first += CHUNK) {
        const count = Math.min(CHUNK, request.count - first);
        const chunk = vary(shot, request, first, count);
        send({ kind: "chunk", ...chunk }, [chunk.ends.buffer, chunk.pockets.buffer]);
        if (first === 0) {
          const paths = cueBallPaths(shot, request, Math.min(request.paths, count));
          send(
            { kind: "paths", generation, paths },
            paths.map(({ buffer }) => buffer),
          );
        }
        await pause();
        if (isStale(generation)) return;
      }
    } finally {
      shot.free();
    }
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    send({ kind: "refused", generation, refusal: refusalOf(error) }, []);
  }
}

function vary(
  shot: Shot,
  { generation, noise, seed }: VariantsRequest,
  first: number,
  count: number,
): Chunk {
  const batch = shot.vary(noise, count, { seed, first });
  const struck = shot.struck!;
  const ends = new Float64Array(2 * count);
  for (let k = 0; k < count; k++) {
    const at = 3 * (k * batch.balls + struck);
    ends.set(batch.final_position.subarray(at, at + 2), 2 * k);
  }
  const { pocket: pockets, refusals } = batch;
  return { generation, first, count, ends, pockets, refusals };
}

/** Paths of the struck ball in the first variants; failed variants have none. */
function cueBallPaths(shot: Shot, { noise, seed }: VariantsRequest, count: number): Float32Array[] {
  const paths: Float32Array[] = [];
  for (let k = 0; k < count; k++) {
    try {
      const varied = shot.variant(noise, k, { seed });
      const trace = varied.simulate();
      paths.push(withoutTimes(trace.polyline(shot.struck!, PATH_TOLERANCE)));
      trace.free();
      varied.free();
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
    }
  }
  return paths;
}

function withoutTimes(polyline: Float64Array): Float32Array {
  const path = new Float32Array((3 * polyline.length) / POINT);
  for (let from = 0, to = 0; from < polyline.length; from += POINT, to += 3) {
    path.set(polyline.subarray(from, from + 3), to);
  }
  return path;
}
