import { describe, expect, test } from "vitest";
import {
  CaromError,
  type Choice,
  type FrameState,
  load,
  type Play,
  type Ruling,
  type Strike,
} from "../../../src/engine/index.ts";
import { read } from "./files.ts";

const engine = await load();

type Move = ({ readonly play: Play; readonly hash: string } | { readonly choice: Choice }) & {
  readonly ruling: Ruling;
  /** Hash of the frame after the move. */
  readonly frame: string;
};

interface Golden {
  readonly game: string;
  readonly seed: number;
  readonly moves: readonly Move[];
  readonly end: FrameState;
}

const GAMES = JSON.parse(read("goldens/games.json")) as Golden[];

const STRIKE: Strike = { speed: 8, azimuth: Math.PI / 2, elevation: 0, side: 0, height: 0 };

describe("the same moves get the native engine's rulings and traces, to the bit", () => {
  test.each(GAMES.map((golden) => [golden.game, golden] as const))("%s", (game, golden) => {
    const frame = engine.frame(game, { seed: golden.seed });
    for (const move of golden.moves) {
      if ("choice" in move) {
        expect(frame.choose(move.choice)).toEqual(move.ruling);
        expect(frame.hash).toBe(move.frame);
        continue;
      }
      const { ruling, trace } = frame.play(move.play);
      expect(ruling).toEqual(move.ruling);
      expect(trace.hash).toBe(move.hash);
      expect(frame.hash).toBe(move.frame);
      trace.free();
    }
    expect(frame.state).toEqual(golden.end);
  });

  test("the goldens have every game, and a choice", () => {
    expect(GAMES.map(({ game }) => game)).toEqual(engine.ruleSets);
    expect(GAMES.flatMap(({ moves }) => moves).some((move) => "choice" in move)).toBe(true);
  });
});

test("a copy is independent of its original", () => {
  const frame = engine.frame("nine-ball", { seed: 7 });
  const before = frame.state;
  const twin = frame.copy();
  twin.play({ strike: STRIKE });
  expect(twin.state.shots).toBe(1);
  expect(frame.state).toEqual(before);
});

test("a frame starts from the balls of a shot, and ends when a player concedes", () => {
  const shot = engine.shot({
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [
      { id: "cue", position: [0.5, 0.6] },
      { id: "9", position: [0.6, 1.6] },
    ],
  });
  const frame = engine.frameOf("nine-ball", shot);
  expect(frame.state.balls).toEqual({ cue: [0.5, 0.6], 9: [0.6, 1.6] });
  expect(frame.state.request).toMatchObject({ kind: "shot", player: 0, in_hand: null, on: ["9"] });
  expect(frame.concede().legal).toBe(true);
  expect(frame.state.request).toMatchObject({ kind: "over", winner: 1 });
  expect(() => frame.concede()).toThrow(CaromError);
  expect(() => engine.frameOf("snooker", shot)).toThrow(CaromError);
});

test("frame.shot gives the shot that frame.play plays", () => {
  const frame = engine.frame("eight-ball", { seed: 3 });
  const play: Play = { strike: STRIKE, cue_ball: [0.6, 0.5] };
  const shot = frame.shot(play);
  expect(shot.simulate().hash).toBe(frame.copy().play(play).trace.hash);
  // Its shot file is the same shot.
  expect(engine.shot(shot.json()).simulate().hash).toBe(shot.simulate().hash);
});

test("a play without an elevation has the default one", () => {
  const frame = engine.frame("eight-ball", { seed: 3 });
  const { elevation, ...aim } = STRIKE;
  const shot = frame.shot({ strike: aim, cue_ball: [0.6, 0.5] });
  expect([elevation, shot.strike!.elevation]).toEqual([0, 3 * (Math.PI / 180)]);
  expect(frame.play({ strike: aim, cue_ball: [0.6, 0.5] }).trace.hash).toBe(shot.simulate().hash);
});

test("a miscue and an obstructed cue are refused or reported as the strike says", () => {
  const refusal = (play: Play) => {
    try {
      engine.frame("nine-ball").play(play);
      return null;
    } catch (error) {
      return (error as CaromError).place;
    }
  };
  const slipping = { ...STRIKE, side: 0.55 };
  expect(refusal({ strike: slipping })).toBe("strike.side");
  const reported = { strike: { ...slipping, miscue: "report" } } as const;
  const { trace } = engine.frame("nine-ball").play(reported);
  expect(trace.outcome.miscue).toBe(true);
  expect(trace.shot.file.strike?.miscue).toBe("report");
  const level: Play = { strike: STRIKE, cue_ball: [0.6, 0.04] };
  expect(refusal(level)).toBeNull();
  expect(refusal({ ...level, strike: { ...STRIKE, obstruction: "refuse" } })).toBe(
    "strike.elevation_deg",
  );
  // @ts-expect-error not a policy
  expect(refusal({ strike: { ...STRIKE, miscue: "maybe" } })).toBe("strike.miscue");
});

test("contacts that cling are those of the play", () => {
  const frame = engine.frame("nine-ball", { seed: 7 });
  const [plain, clinging] = [undefined, { contacts: [0, 2], friction: 0.9 }].map((cling) => {
    const play = { strike: STRIKE, ...(cling && { cling }) };
    return frame.copy().play(play).trace;
  });
  expect(plain!.shot.file.cling).toBeUndefined();
  expect(clinging!.shot.file.cling).toEqual({ contacts: [0, 2], friction: 0.9 });
  expect(clinging!.hash).not.toBe(plain!.hash);
  const twice = { contacts: [1, 1] };
  expect(() => frame.play({ strike: STRIKE, cling: twice })).toThrow(/^cling.contacts\[1\]: /);
});

test("with a seed for each player the errors of one do not depend on the other", () => {
  const noise = engine.noisePresets.club!;
  const first = (seed: number | readonly [number, number]) => {
    const frame = engine.frame("practice", { seed: 7 });
    frame.play({ strike: STRIKE, cue_ball: [0.6, 0.5] }, { noise, seed });
    return frame.record.moves[0];
  };
  expect(first([3, 4])).toEqual(first([3, 5]));
  expect(first([3, 4])).toEqual(first(3));
  expect(first([4, 3])).not.toEqual(first(3));
  expect(() => first([3, -1])).toThrow(/^seed: /);
});

test("a frame has a text and a schema of its answers", () => {
  const frame = engine.frame("nine-ball", { seed: 7 });
  expect(frame.describe()).toMatch(/its centre may be put where y < 0.635 m/);
  expect(frame.answerSchema()).toHaveProperty(
    "properties.play.properties.strike.properties.azimuth_deg",
  );
});

test("a cue ball in hand is refused outside its region, whose box is known", () => {
  const pool = engine.frame("nine-ball");
  expect(pool.handBounds).toEqual([
    [0, 0],
    [1.27, 0.635],
  ]);
  const refusal = (cue_ball: readonly [number, number]) => {
    try {
      pool.play({ strike: STRIKE, cue_ball });
      return null;
    } catch (error) {
      return error as CaromError;
    }
  };
  expect(refusal([0.6, 0.7])).toMatchObject({ name: "CaromError", place: "cue_ball" });
  expect(refusal([0.6, 0.7])?.message).toMatch(/behind the head string/);
  expect(refusal([0.6, -0.1])).toBeInstanceOf(CaromError);
  expect(pool.state.shots).toBe(0);
  expect(engine.frame("three-cushion").handBounds).toBeNull();
  const [[left, bottom], [right, top]] = engine.frame("snooker").handBounds!;
  expect(right - left).toBeCloseTo(0.584, 12);
  expect(top - bottom).toBeCloseTo(0.292, 12);
});

test("invalid calls, choices and options are refused with their place", () => {
  const place = (attempt: () => unknown) => {
    try {
      attempt();
      return null;
    } catch (error) {
      return (error as CaromError).place;
    }
  };
  const nine = engine.frame("nine-ball");
  const straight = engine.frame("straight-pool");
  const pocket = (ball: string, into: "top-left") => ({ kind: "pocket", ball, into }) as const;
  expect(place(() => nine.play({ strike: STRIKE, call: { kind: "push-out" } }))).toBe("call");
  expect(place(() => straight.play({ strike: STRIKE }))).toBe("call");
  expect(place(() => straight.play({ strike: STRIKE, call: pocket("x", "top-left") }))).toBe(
    "call.ball",
  );
  expect(place(() => nine.choose("rebreak"))).toBe("choice");
  expect(place(() => engine.frame("croquet"))).toBe("game");
  expect(place(() => engine.frame("snooker", { table: "carom-match" }))).toBe("table");
  expect(place(() => engine.frame("snooker", { seed: -1 }))).toBe("seed");
  expect(place(() => engine.frame("three-cushion", { points: 0 }))).toBe("options.points");
  expect(place(() => engine.usualTable("croquet"))).toBe("game");
});

test("table and physics are those of a shot file", () => {
  const physics = { cloth: { sliding_friction: 0.3 } };
  const frame = engine.frame("nine-ball", { table: "wpa-8ft", physics, seed: 1 });
  const { file } = frame.shot({ strike: STRIKE });
  expect(file.table).toBe("wpa-8ft");
  expect(file.physics).toMatchObject(physics);
});

test("the presets of noise are the levels of play, then the Olympiad", () => {
  expect(Object.keys(engine.noisePresets)).toEqual([
    "beginner",
    "casual",
    "club",
    "advanced",
    "professional",
    "olympiad",
  ]);
  expect(engine.noisePresets.olympiad).toEqual(engine.olympiad());
});
