import { describe, expect, test } from "vitest";
import {
  type Analysis,
  CaromError,
  type Decision,
  type FrameRecord,
  load,
  type Perception,
  type PlayerOptions,
} from "../../../src/engine/index.ts";
import { read } from "./files.ts";

const engine = await load();

/** Options with the names of noise presets. */
type Options = Omit<PlayerOptions, "noise" | "opponentNoise"> & {
  readonly noise: string;
  readonly opponentNoise?: string;
};

type Written<T> = Omit<T, "interrupted" | "concession">;

interface Golden {
  readonly options: Options;
  readonly record: FrameRecord;
  readonly count?: number;
  readonly decision?: Written<Decision>;
  readonly analysis?: Written<Analysis>;
}

const GOLDENS = JSON.parse(read("goldens/decisions.json")) as Golden[];

const presets = engine.noisePresets;

function playerOf({ noise, opponentNoise, ...rest }: Options) {
  return engine.player({
    ...rest,
    noise: presets[noise]!,
    ...(opponentNoise !== undefined && { opponentNoise: presets[opponentNoise]! }),
  });
}

const NINE = engine.replay(GOLDENS.find(({ record }) => record.setup.game === "nine-ball")!.record);
const FEW: PlayerOptions = { noise: presets.club!, simulations: 300 };

describe("players decide and recommend as the native ones, to the bit", () => {
  const named = GOLDENS.map((golden) => {
    const { options, record, count } = golden;
    const what = count === undefined ? "chooses" : `recommends ${count}`;
    return [`${options.name ?? "carom"} ${what} in ${record.setup.game}`, golden] as const;
  });
  test.each(named)("%s", (_, { options, record, count, decision, analysis }) => {
    const [frame, player] = [engine.replay(record), playerOf(options)];
    if (count === undefined) {
      const concession = decision!.play === null && decision!.choice === null;
      expect(player.choose(frame)).toEqual({ ...decision, concession, interrupted: false });
    } else {
      expect(player.explain(frame, { count })).toEqual({ ...analysis, interrupted: false });
    }
    frame.free();
    player.free();
  });

  test("the goldens have every game, every player, a choice, and a search of several rounds", () => {
    const games = new Set(GOLDENS.map(({ record }) => record.setup.game));
    expect([...games].sort()).toEqual([...engine.ruleSets].sort());
    const names = GOLDENS.map(({ options }) => options.name?.split(":")[0] ?? "carom");
    expect([...new Set(names)].sort()).toEqual([...engine.players].sort());
    expect(GOLDENS.some(({ decision }) => decision?.choice)).toBe(true);
    expect(GOLDENS.some(({ decision }) => decision && decision.rounds > 1)).toBe(true);
  });
});

test("a decision can be played, and leaves its frame as it was", () => {
  const frame = NINE.copy();
  const before = frame.record;
  const { play } = engine.player(FEW).choose(frame);
  expect(frame.record).toEqual(before);
  expect(frame.play(play!, { noise: presets.club!, seed: 3 }).ruling).toBeDefined();
  expect(frame.record.moves).toHaveLength(before.moves.length + 1);
});

test("a search goes on round by round, and can be ended after any of them", () => {
  const player = engine.player({ ...FEW, simulations: 20_000 });
  const thought = player.beginChoice(NINE);
  expect(thought.progress).toEqual({ play: null, win_chance: null, simulations: 0, rounds: 0 });
  expect(thought.playRound()).toBe(true);
  const { progress } = thought;
  expect(progress.rounds).toBe(1);
  expect(progress.play?.strike.speed).toBeGreaterThan(0);
  expect(progress.win_chance).toBeGreaterThan(0);
  const decision = thought.end(true);
  expect(decision).toMatchObject({ rounds: 1, interrupted: true, play: progress.play });
  // The number of rounds repeats it.
  const again = engine.player({ ...FEW, simulations: 20_000, rounds: 1 }).choose(NINE);
  expect(again).toEqual({ ...decision, interrupted: false });
  expect(() => thought.playRound()).toThrow(/this thought was freed/);
});

test("a thought that is ended at once has no play to give", () => {
  const thought = engine.player(FEW).beginAnalysis(NINE);
  expect(thought.end().plays).toEqual([]);
});

test("a clock ends a search after a round, and the number of rounds repeats it", () => {
  const timed = engine.player({ noise: presets.club!, time: 1e-9 }).choose(NINE);
  expect(timed.rounds).toBe(1);
  const again = engine.player({ noise: presets.club!, rounds: 1 }).choose(NINE);
  expect(again).toEqual(timed);
});

test("without options it has the Olympiad's errors and 20 000 simulated shots", () => {
  const frame = engine.replay(GOLDENS[0]!.record);
  const plain = engine.player().choose(frame);
  const written = engine.player({ name: "carom:20000", noise: engine.olympiad(), seed: 0 });
  expect(plain).toEqual(written.choose(frame));
  expect(plain.simulations).toBeGreaterThan(10_000);
});

test("the errors of both players count", () => {
  const win = (options: PlayerOptions) =>
    engine.player({ ...FEW, ...options }).choose(NINE).win_chance;
  const usual = win({});
  expect(win({ opponentNoise: presets.club! })).toBe(usual);
  expect(win({ opponentNoise: presets.professional! })).not.toBe(usual);
  expect(win({ noise: presets.professional! })).not.toBe(usual);
});

test("invalid options and questions are refused with their place", () => {
  const place = (attempt: () => unknown) => {
    try {
      attempt();
      return null;
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      expect(error.message).toMatch(/^.+: .+; .+/);
      return error.place;
    }
  };
  const of = (options: unknown) => place(() => engine.player(options as PlayerOptions));
  const noise = presets.club!;
  expect(of({ name: "unknown" })).toBe("player");
  expect(of({ name: "carom:0" })).toBe("player");
  expect(of({ name: 3 })).toBe("name");
  expect(of({ name: "carom:100", simulations: 100 })).toBe("simulations");
  expect(of({ simulations: 0 })).toBe("simulations");
  expect(of({ simulations: 1e9 })).toBe("simulations");
  expect(of({ rounds: 0 })).toBe("rounds");
  expect(of({ rounds: 1.5 })).toBe("rounds");
  expect(of({ time: 0 })).toBe("time");
  expect(of({ time: NaN })).toBe("time");
  expect(of({ seed: -1 })).toBe("seed");
  expect(of({ noise: { speed: 1 } })).toBe("noise.azimuth");
  expect(of({ opponentNoise: { ...noise, speed: "much" } })).toBe("opponentNoise.speed");
  expect(of({ perception: {} })).toBe("perception.position");

  const asked = (options: PlayerOptions, frame = NINE) =>
    place(() => engine.player(options).choose(frame));
  expect(asked({ noise: { ...noise, azimuth: -1 } })).toBe("noise.azimuth");
  expect(asked({ perception: { position: -1 } })).toBe("perception.position");
  // A player of the literature plans with a number, not with a time.
  expect(asked({ name: "greedy", time: 1 })).toBe("simulations");
  const over = NINE.copy();
  over.concede();
  expect(asked(FEW, over)).toBe("frame");
  const choice = engine.replay(GOLDENS.find(({ decision }) => decision?.choice)!.record);
  expect(place(() => engine.player(FEW).explain(choice))).toBe("frame");
  expect(place(() => engine.player({ name: "greedy:50" }).explain(NINE))).toBe("player");
  expect(place(() => engine.player(FEW).explain(NINE, { count: 0 }))).toBe("count");
});

test("a perception has errors by ball and by direction", () => {
  const stated = (perception: Perception) =>
    engine.player({ ...FEW, perception }).choose(NINE).win_chance;
  const exact = stated({ position: 0 });
  const alike = { position: [0, 0], correlation: 0.5, balls: { cue: { position: 0 } } } as const;
  expect(stated(alike)).toBe(exact);
  expect(stated({ position: 0, balls: { cue: { position: [0.02, 0.01] } } })).not.toBe(exact);
});
