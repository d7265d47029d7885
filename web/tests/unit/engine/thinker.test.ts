import { execFileSync } from "node:child_process";
import { rmSync, writeFileSync } from "node:fs";
import { afterEach, describe, expect, test } from "vitest";
import {
  CaromError,
  type FrameRecord,
  load,
  type PlayerOptions,
  type Progress,
  type TablePosterior,
} from "../../../src/engine/index.ts";
import {
  connectThinker,
  type Thinker,
  type ThinkerWorker,
} from "../../../src/engine/thinker-client.ts";
import { serve } from "../../../src/engine/thinker-server.ts";
import type { FromThinker, ThinkerPort, ToThinker } from "../../../src/engine/thinker-protocol.ts";
import { read } from "./files.ts";
import { compiledPackage } from "./package.ts";

const engine = await load();
const noise = engine.noisePresets.club!;
const RECORDS = (
  JSON.parse(read("goldens/decisions.json")) as { readonly record: FrameRecord }[]
).map(({ record }) => record);
const RECORD = RECORDS.find(({ setup }) => setup.game === "nine-ball")!;
const FEW: PlayerOptions = { noise, simulations: 300, seed: 4 };
const LONG: PlayerOptions = { noise, simulations: 1e7, seed: 4 };

/** A worker on this thread: both ends of a channel, with real messages between them. */
function channel(): { worker: ThinkerWorker; close: () => void } {
  const { port1, port2 } = new MessageChannel();
  serve(port2 as unknown as ThinkerPort<FromThinker, ToThinker>);
  const terminate = () => {
    // This thread goes on, unlike a worker.
    port1.postMessage({ kind: "stop", last: Infinity } satisfies ToThinker);
    port1.close();
  };
  const worker = Object.assign(port1, { onerror: null, terminate });
  return { worker: worker as unknown as ThinkerWorker, close: terminate };
}

const open: (() => void)[] = [];
afterEach(() => {
  for (const close of open.splice(0)) close();
});

function thinker(player: PlayerOptions = FEW): Promise<Thinker> {
  const { worker, close } = channel();
  open.push(close);
  return connectThinker(engine, worker, player);
}

async function refusal(question: Promise<unknown>): Promise<CaromError> {
  const error: unknown = await question.then(
    () => new Error("it was answered"),
    (reason: unknown) => reason,
  );
  if (error instanceof CaromError) return error;
  throw error;
}

test("a thinker takes what was learned about a table", async () => {
  const [{ learned: posterior, decisions }] = JSON.parse(read("goldens/learned.json")) as [
    {
      readonly learned: TablePosterior;
      readonly decisions: readonly {
        readonly options: { readonly simulations: number; readonly seed: number };
        readonly record: FrameRecord;
        readonly count?: number;
        readonly analysis?: object;
        readonly decision?: object;
      }[];
    },
  ];
  const { simulations, seed } = decisions[0]!.options;
  const asking = await thinker({ noise, simulations, seed });
  for (const { record, count, analysis, decision } of decisions) {
    const asked = { posterior, draws: 4 };
    const found =
      count === undefined
        ? await asking.choose(record, asked)
        : await asking.explain(record, { ...asked, count });
    expect(found).toMatchObject((analysis ?? decision)!);
  }
});

describe("a thinker", () => {
  test("answers as a player on this thread does", async () => {
    const asked = await thinker();
    const frame = engine.replay(RECORD);
    const player = engine.player(FEW);
    expect(await asked.choose(frame)).toEqual(player.choose(frame));
    expect(await asked.explain(RECORD, { count: 3 })).toEqual(player.explain(frame, { count: 3 }));
    const other = await asked.choose(RECORD, { seed: 5, simulations: 200 });
    expect(other).toEqual(engine.player({ noise, seed: 5, simulations: 200 }).choose(frame));
  });

  test("reports after every round, then answers", async () => {
    const rounds: Progress[] = [];
    const options = { simulations: 12_000, onProgress: (now: Progress) => rounds.push(now) };
    const decision = await (await thinker()).choose(RECORD, options);
    expect(rounds.map((now) => now.rounds)).toEqual([1, 2, 3, 4]);
    expect(decision.rounds).toBe(4);
    expect(rounds.at(-1)!.play).toEqual(decision.play);
    expect(rounds.at(-1)!.simulations).toBeLessThan(decision.simulations);
    expect(decision.interrupted).toBe(false);
  });

  test("gives the best play of the rounds until then when it is stopped", async () => {
    const asked = await thinker(LONG);
    const stop = ({ rounds }: Progress) => {
      if (rounds === 2) asked.stop();
    };
    const decision = await asked.choose(RECORD, { onProgress: stop });
    expect(decision.interrupted).toBe(true);
    const frame = engine.replay(RECORD);
    const again = engine.player({ ...LONG, rounds: decision.rounds }).choose(frame);
    expect({ ...decision, interrupted: false }).toEqual(again);
    // Later questions are not stopped.
    expect((await asked.explain(RECORD, { rounds: 1 })).interrupted).toBe(false);
  });

  test("stops every question that was asked before", async () => {
    const asked = await thinker(LONG);
    const questions = [asked.choose(RECORD), asked.explain(RECORD)];
    asked.stop();
    for (const result of await Promise.all(questions)) {
      expect(result).toMatchObject({ rounds: 1, interrupted: true });
    }
  });

  test("refuses with the errors of the engine, and goes on", async () => {
    const asked = await thinker();
    const unknown = await refusal(asked.choose(RECORD, { name: "unknown" }));
    expect(unknown.place).toBe("player");
    expect(unknown.message).toMatch(/there is no player "unknown"; write one of carom, /);
    const wrong = { ...RECORD, moves: [{ choice: "rebreak" as const }] };
    expect((await refusal(asked.choose(wrong))).place).toBe("moves[0].choice");
    expect((await refusal(asked.explain(RECORD, { count: 0 }))).place).toBe("count");
    expect((await asked.choose(RECORD)).play).not.toBeNull();
  });

  test("refuses open and later questions after it was closed", async () => {
    const asked = await thinker(LONG);
    const question = asked.choose(RECORD);
    asked.close();
    expect((await refusal(question)).place).toBe("thinker");
    expect((await refusal(asked.choose(RECORD))).message).toMatch(/closed; create another one/);
  });

  test("refuses if its worker does not start", async () => {
    const { worker } = channel();
    const connecting = connectThinker(engine, worker);
    worker.onerror!.call(worker as Worker, { message: "no such file" } as ErrorEvent);
    const error = await refusal(connecting);
    expect(error.place).toBe("worker");
    expect(error.message).toMatch(/it failed \(no such file\); give a worker/);
  });
});

test("in Node the package's thinker has a worker of its own", () => {
  const folder = compiledPackage();
  try {
    writeFileSync(`${folder}/record.json`, JSON.stringify(RECORD));
    writeFileSync(
      `${folder}/program.js`,
      `import { readFileSync } from "node:fs";
      import { load } from "./dist/index.js";
      import { createThinker } from "./dist/thinker.js";
      const engine = await load();
      const record = JSON.parse(readFileSync(new URL("record.json", import.meta.url), "utf8"));
      const thinker = await createThinker(engine, { simulations: 300, seed: 4 });
      let free = 0;
      const ticks = setInterval(() => (free += 1), 1);
      const decision = await thinker.choose(record, { noise: engine.noisePresets.club });
      clearInterval(ticks);
      const stopped = thinker.choose(record, { simulations: 1e7 });
      thinker.stop();
      const { interrupted } = await stopped;
      const place = await thinker.choose(record, { seed: -1 }).catch((error) => error.place);
      thinker.close();
      console.log(JSON.stringify({ decision, interrupted, place, free }));`,
    );
    const said = execFileSync(process.execPath, [`${folder}/program.js`], { encoding: "utf8" });
    const { decision, interrupted, place, free } = JSON.parse(said) as Record<string, unknown>;
    const frame = engine.replay(RECORD);
    expect(decision).toEqual(engine.player(FEW).choose(frame));
    expect([interrupted, place]).toEqual([true, "seed"]);
    expect(free, "the main thread went on").toBeGreaterThan(0);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
