import { beforeEach, describe, expect, test } from "vitest";
import { CaromError, refusalOf, type Shot } from "../../../src/engine/index.ts";
import { type VariantsProgress, Variants } from "../../../src/app/whatif/variants-client.ts";
import type { FromWorker, ToWorker } from "../../../src/app/whatif/variants-protocol.ts";

const json = '{"format": "carom-shot/1"}';
const noise = { speed: 0.1, azimuth: 0.002, elevation: 0.001, side_m: 0.0005, height_m: 0.0005 };
const shot = { json: () => json, balls: [{ id: "cue" }] } as unknown as Shot;

/** A worker that only records the messages it receives. */
class RecordingWorker {
  received: ToWorker[] = [];
  onmessage: ((event: MessageEvent) => void) | null = null;
  onerror: (() => void) | null = null;
  postMessage(message: ToWorker): void {
    this.received.push(message);
  }
  terminate(): void {
    this.received = [];
  }
  say(message: FromWorker): void {
    this.onmessage?.({ data: message } as MessageEvent);
  }
  get generation(): number {
    const last = this.received.at(-1);
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
  refusals: new Map(),
});

describe("requesting variants from a worker", () => {
  let worker: RecordingWorker;
  let results: VariantsProgress[];
  let refused: string[];
  let variants: Variants;
  const module = {} as WebAssembly.Module;

  beforeEach(() => {
    worker = new RecordingWorker();
    results = [];
    refused = [];
    variants = new Variants(
      worker,
      { module },
      {
        progress: (p) => results.push(p),
        refused: (message) => refused.push(message),
      },
    );
    variants.ask(shot, noise, 7, 4, 2);
  });

  test("sends the compiled engine first", () => {
    expect(worker.received[0]).toStrictEqual({ kind: "engine", module });
    expect(worker.received[1]).toMatchObject({
      kind: "simulate",
      seed: 7,
      count: 4,
      paths: 2,
      shot: json,
    });
  });

  test("reports every chunk, and when all have come", () => {
    worker.say(chunk(worker.generation, 0, 2));
    expect(results.map(({ done }) => done)).toStrictEqual([false]);
    worker.say(chunk(worker.generation, 2, 2));
    expect(results.at(-1)).toMatchObject({ done: true });
    expect(results.at(-1)?.tally.count).toBe(4);
  });

  test("ignores messages of an earlier request", () => {
    const stale = worker.generation;
    variants.ask(shot, { ...noise, speed: 0.2 }, 7, 4, 2);
    worker.say(chunk(stale, 0, 4));
    worker.say({
      kind: "refused",
      generation: stale,
      refusal: refusalOf(new CaromError({ kind: "miscue", fault: "no" })),
    });
    expect(results).toStrictEqual([]);
    expect(refused).toStrictEqual([]);
    worker.say(chunk(worker.generation, 0, 1));
    expect(results[0]?.tally.count).toBe(1);
  });

  test("ignores messages after it was cancelled", () => {
    const stale = worker.generation;
    variants.cancel();
    expect(worker.generation).toBeGreaterThan(stale);
    worker.say(chunk(stale, 0, 4));
    worker.say(chunk(worker.generation, 0, 4));
    expect(results).toStrictEqual([]);
  });

  test("refuses if no worker can be started", () => {
    worker.onerror?.();
    expect(refused).toHaveLength(1);
  });

  test("passes on the engine's refusal", () => {
    worker.say({
      kind: "refused",
      generation: worker.generation,
      refusal: refusalOf(new CaromError({ kind: "miscue", fault: "so far" })),
    });
    expect(refused).toStrictEqual([
      "So far from the centre the tip slips off, which is a miscue: move it into the dashed circle.",
    ]);
  });
});
