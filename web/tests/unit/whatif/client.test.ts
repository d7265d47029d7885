import { beforeEach, describe, expect, test } from "vitest";
import type { Shot } from "../../../src/engine/index.ts";
import { type Progress, Variants } from "../../../src/app/whatif/client.ts";
import type { FromWorker, ToWorker } from "../../../src/app/whatif/protocol.ts";

const json = '{"format": "carom-shot/1"}';
const noise = { speed: 0.1, azimuth: 0.002, elevation: 0.001, side_m: 0.0005, height_m: 0.0005 };
const shot = { json: () => json, balls: [{ id: "cue" }] } as unknown as Shot;

/** A worker that does nothing but note what it is told. */
class Silence {
  told: ToWorker[] = [];
  onmessage: ((event: MessageEvent) => void) | null = null;
  onerror: (() => void) | null = null;
  postMessage(message: ToWorker): void {
    this.told.push(message);
  }
  terminate(): void {
    this.told = [];
  }
  say(message: FromWorker): void {
    this.onmessage?.({ data: message } as MessageEvent);
  }
  get generation(): number {
    const last = this.told.at(-1);
    return last && "generation" in last ? last.generation : -1;
  }
}

const chunk = (generation: number, first: number, count: number): FromWorker => ({
  kind: "chunk",
  generation,
  first,
  count,
  ends: new Float64Array(2 * count),
  pockets: new Int8Array(count),
  errors: new Map(),
});

describe("asking a worker", () => {
  let worker: Silence;
  let heard: Progress[];
  let refused: string[];
  let variants: Variants;
  const module = {} as WebAssembly.Module;

  beforeEach(() => {
    worker = new Silence();
    heard = [];
    refused = [];
    variants = new Variants(
      worker,
      { module },
      {
        progress: (p) => heard.push(p),
        refused: (message) => refused.push(message),
      },
    );
    variants.ask(shot, noise, 7, 4, 2);
  });

  test("hands it the compiled engine first", () => {
    expect(worker.told[0]).toStrictEqual({ kind: "engine", module });
    expect(worker.told[1]).toMatchObject({
      kind: "simulate",
      seed: 7,
      count: 4,
      paths: 2,
      shot: json,
    });
  });

  test("tells of every chunk, and when all are in", () => {
    worker.say(chunk(worker.generation, 0, 2));
    expect(heard.map(({ done }) => done)).toStrictEqual([false]);
    worker.say(chunk(worker.generation, 2, 2));
    expect(heard.at(-1)).toMatchObject({ done: true });
    expect(heard.at(-1)?.tally.count).toBe(4);
  });

  test("does not hear what belongs to an earlier question", () => {
    const stale = worker.generation;
    variants.ask(shot, { ...noise, speed: 0.2 }, 7, 4, 2);
    worker.say(chunk(stale, 0, 4));
    worker.say({ kind: "refused", generation: stale, message: "no" });
    expect(heard).toStrictEqual([]);
    expect(refused).toStrictEqual([]);
    worker.say(chunk(worker.generation, 0, 1));
    expect(heard[0]?.tally.count).toBe(1);
  });

  test("hears nothing after it was cancelled", () => {
    const stale = worker.generation;
    variants.cancel();
    expect(worker.generation).toBeGreaterThan(stale);
    worker.say(chunk(stale, 0, 4));
    worker.say(chunk(worker.generation, 0, 4));
    expect(heard).toStrictEqual([]);
  });

  test("says so where no worker can be had", () => {
    worker.onerror?.();
    expect(refused).toHaveLength(1);
  });

  test("hands on why the engine refuses", () => {
    worker.say({ kind: "refused", generation: worker.generation, message: "no strike" });
    expect(refused).toStrictEqual(["no strike"]);
  });
});
