import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, test } from "vitest";
import { load, type Engine } from "../../../src/engine/index.ts";
import type { FromWorker, VariantsRequest } from "../../../src/app/whatif/variants-protocol.ts";
import { Tally } from "../../../src/app/whatif/variant-tally.ts";
import { simulate } from "../../../src/app/whatif/variants.ts";

const ROOT = new URL("../../../../", import.meta.url);
const read = (path: string): string => readFileSync(new URL(path, ROOT), "utf8");

interface Golden {
  shot: string;
  olympiad: number;
  seed: number;
  first: number;
  variants: { final: number[] }[];
}
const GOLDENS = JSON.parse(read("goldens/noise.json")) as Golden[];
const HALF_BALL = GOLDENS[0]!;

let engine: Engine;
beforeAll(async () => {
  engine = await load();
});

const request = (changes: Partial<VariantsRequest>): VariantsRequest => ({
  generation: 1,
  shot: read(`shots/${HALF_BALL.shot}.json`),
  noise: engine.olympiad(HALF_BALL.olympiad),
  seed: HALF_BALL.seed,
  count: 250,
  paths: 5,
  ...changes,
});

/** The answers to a request, which becomes stale after `patience` pauses. */
async function answers(
  changes: Partial<VariantsRequest> = {},
  patience = Infinity,
): Promise<FromWorker[]> {
  const sent: FromWorker[] = [];
  let pauses = 0;
  await simulate(engine, request(changes), {
    send: (message) => sent.push(message),
    isStale: () => pauses > patience,
    pause: () => {
      pauses += 1;
      return Promise.resolve();
    },
  });
  return sent;
}

const chunks = (sent: FromWorker[]) => sent.filter((message) => message.kind === "chunk");

describe("the variants of a request", () => {
  test("are the native engine's, to the bit", async () => {
    expect(HALF_BALL.first).toBe(0);
    const [chunk] = chunks(await answers());
    const expected = HALF_BALL.variants.flatMap(({ final }) => final.slice(0, 2));
    expect([...chunk!.ends.slice(0, expected.length)]).toStrictEqual(expected);
  });

  test("come in chunks, each once and in order", async () => {
    const all = chunks(await answers());
    expect(all.length).toBeGreaterThan(1);
    let next = 0;
    for (const { first, count } of all) {
      expect(first).toBe(next);
      next += count;
    }
    expect(next).toBe(250);
  });

  test("pocket each ball as often as one batch of them", async () => {
    const jump = read("shots/jump_shot.json");
    const shot = engine.shot(jump);
    const batch = shot.vary(engine.olympiad(HALF_BALL.olympiad), 250, { seed: HALF_BALL.seed });
    const tally = new Tally(shot.balls.length, 250);
    for (const chunk of chunks(await answers({ shot: jump }))) tally.add(chunk);
    const drops = shot.balls.map(
      (_, ball) => batch.pocket.filter((p, i) => p >= 0 && i % batch.balls === ball).length,
    );
    expect(shot.balls.map((_, ball) => tally.pocketed(ball).hits)).toStrictEqual(drops);
    expect(Math.max(...drops)).toBeGreaterThan(0);
  });

  test("come with paths of the cue ball that end at its final positions", async () => {
    const sent = await answers();
    const paths = sent.find((message) => message.kind === "paths")!.paths;
    const { ends } = chunks(sent)[0]!;
    expect(paths).toHaveLength(5);
    paths.forEach((path, k) => {
      const [x, y] = path.slice(-3);
      expect(Math.hypot(x! - ends[2 * k]!, y! - ends[2 * k + 1]!)).toBeLessThan(1e-6);
    });
  });

  test("stop when the request is stale", async () => {
    expect(chunks(await answers({}, 0))).toHaveLength(1);
  });

  test("are refused with the engine's message if the noise is invalid", async () => {
    const [answer] = await answers({ noise: { ...engine.olympiad(), speed: -1 } });
    expect(answer).toMatchObject({ kind: "refused", generation: 1 });
    expect(answer).toHaveProperty("refusal.message", expect.stringContaining("noise.speed"));
  });
});
