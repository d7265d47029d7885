import { describe, expect, test } from "vitest";
import {
  type Analysis,
  CaromError,
  type Decision,
  type EvaluateOptions,
  type Evaluation,
  type FrameRecord,
  load,
  type ShotFile,
  type TablePosterior,
} from "../../../src/engine/index.ts";
import { read } from "./files.ts";

const engine = await load();
const CLUB = engine.noisePresets.club!;

interface Question {
  readonly options: { readonly noise: string; readonly simulations: number; readonly seed: number };
  readonly record: FrameRecord;
  readonly count?: number;
  readonly decision?: Omit<Decision, "interrupted" | "concession">;
  readonly analysis?: Omit<Analysis, "interrupted">;
}

interface Golden {
  readonly learned: TablePosterior;
  readonly shot: ShotFile;
  readonly evaluations: readonly {
    readonly options: EvaluateOptions;
    readonly result: Omit<Evaluation, "by_table" | "cue_ball">;
  }[];
  readonly decisions: readonly Question[];
}

const GOLDENS = JSON.parse(read("goldens/learned.json")) as Golden[];
const [POOL, CAROM] = GOLDENS as [Golden, Golden];
/** As `goldens/learned.json` was asked. */
const [N, DRAWS] = [2000, 4];

function refusalOf(call: () => unknown): CaromError {
  try {
    call();
  } catch (error) {
    if (error instanceof CaromError) return error;
    throw error;
  }
  throw new Error("it was not refused");
}

describe("chances on learned tables are those of Python, to the bit", () => {
  const asked = GOLDENS.flatMap((golden) =>
    golden.evaluations.map((one) => [JSON.stringify(one.options), golden, one] as const),
  );
  test.each(asked)("%s", (_, { learned, shot }, { options, result }) => {
    const given = { ...options, posterior: learned };
    const { by_table, cue_ball, ...found } = engine.evaluate(engine.shot(shot), CLUB, N, given);
    expect(found).toEqual(result);
    expect(by_table).toHaveLength(result.tables);
    expect(by_table.reduce((sum, { n }) => sum + n, 0)).toBe(found.n);
    expect(found.balls[cue_ball]).toBe("cue");
  });

  const questions = GOLDENS.flatMap(({ learned, decisions }) =>
    decisions.map((one) => [one.record.setup.game, learned, one] as const),
  );
  test.each(questions)("a player in %s", (_, posterior, question) => {
    const { record, count, options, decision, analysis } = question;
    const player = engine.player({ ...options, noise: CLUB });
    const [frame, asked] = [engine.replay(record), { posterior, draws: DRAWS }];
    if (count === undefined) {
      const wanted = { ...decision, concession: false, interrupted: false };
      expect(player.choose(frame, asked)).toEqual(wanted);
    } else {
      expect(player.explain(frame, { count, ...asked })).toEqual({
        ...analysis,
        interrupted: false,
      });
    }
  });
});

test("without a posterior the chances are those of the shot's own table", () => {
  const shot = engine.shot(POOL.shot);
  const found = engine.evaluate(shot, CLUB, 500, { seed: 7 });
  const { pocket } = shot.vary(CLUB, 500, { seed: 7 });
  const fallen = pocket.filter((one, i) => i % 3 === 1 && one >= 0).length;
  expect(found.potted[1]!.reduce((a, b) => a + b, 0)).toBe(fallen);
  expect(found.tables).toBe(1);
  expect(found.by_table).toEqual([]);
  expect(found.legal).toBeNull();
  expect(Object.values(found.chances).every(({ spread }) => spread === undefined)).toBe(true);
});

test("a frame rules on the variants, and a posterior makes the interval wider", () => {
  const { learned, shot } = CAROM;
  const { table, physics } = learned;
  const frame = engine.frameOf("three-cushion", engine.shot({ ...shot, table, physics }));
  const asked = frame.shot({ strike: { ...engine.shot(shot).strike! } });
  const plain = engine.evaluate(asked, CLUB, 400, { frame });
  const drawn = engine.evaluate(asked, CLUB, 400, { frame, posterior: learned, draws: 12 });
  const width = ({ chances }: Evaluation) => chances.legal!.high - chances.legal!.low;
  expect(plain.turn_kept).not.toBeNull();
  expect(drawn.tables).toBeGreaterThan(6);
  expect(width(drawn)).toBeGreaterThan(width(plain));
});

test("errors name the option and what helps", () => {
  const { learned, shot } = POOL;
  const asked = (options: object, n = 100) =>
    refusalOf(() => engine.evaluate(engine.shot(shot), CLUB, n, options));
  const { draws, ...without } = learned;
  expect(asked({ posterior: without }).message).toMatch(/^posterior\.draws: .*carom learn table/);
  expect(asked({ posterior: { ...learned, draws: [{}, {}] }, draws: 2 }).place).toBe(
    "posterior.draws[0]",
  );
  expect(asked({ posterior: learned }).message).toMatch(
    /^draws: 32 tables are more than the 12 of the file; .*draws=/,
  );
  expect(asked({ posterior: learned, draws: 1 }).place).toBe("draws");
  expect(asked({ posterior: learned, draws: 4 }, 3).place).toBe("n");
  expect(asked({ posterior: { ...learned, table: "wpa" }, draws: 2 }).place).toBe(
    "posterior: table",
  );
  expect(asked({ watch: "1" }).place).toBe("watch");
  expect(asked({ call: { kind: "safety" } }).place).toBe("call");
  expect(asked({ level: 2 }).place).toBe("level");
  expect(asked({ Seed: 2 }).kind).toBe("unknown-key");
  expect(asked({}, 0).place).toBe("n");
  expect(draws).toHaveLength(12);
});

test("a frame on another table than the posterior is refused before the search", () => {
  const player = engine.player({ noise: CLUB });
  const asked = { posterior: POOL.learned, draws: DRAWS };
  const frame = engine.frame("nine-ball");
  expect(refusalOf(() => player.beginAnalysis(frame, asked)).place).toBe("frame");
  frame.free();
});
