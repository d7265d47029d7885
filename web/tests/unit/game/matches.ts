/** Records of matches for tests, which the engine of the test has played. */

import { type Engine, type FrameMove, load, type MatchMove } from "../../../src/engine/index.ts";
import { withNewKeys } from "../../../src/engine/noise.ts";

/** More bits than a number holds. */
const SEED = "9e3779b97f4a7c15";

const NO_NOISE = {
  speed: 0,
  azimuth: 0,
  elevation: 0,
  side_m: 0,
  height_m: 0,
  cling_probability: 0,
  cling_friction: 0.22,
};
const CLOCK = { simulations: 50, per: "decision" };

function header(engine: Engine): string {
  return JSON.stringify({
    format: "carom-match/1",
    engine: engine.version,
    players: [
      { name: "carom:2000", settings: {} },
      { name: "a player with a very long name", settings: {} },
    ],
    game: "nine-ball",
    options: engine.defaultTerms,
    table: engine.withDatedNames({ table: "wpa-9ft" }).table,
    physics: null,
    max_events: 100_000,
    noise: [withNewKeys(NO_NOISE).value, NO_NOISE],
    perception: [{ position: 0 }, { position: 0 }],
    clock: [CLOCK, CLOCK],
    breaker: "alternate",
    same_break: null,
    disclosure: "both",
    pairs: 1,
    test: null,
    secret_sha256: "0".repeat(64),
  });
}

const COST = { simulations: 50, rounds: 1 };

function strike(azimuth: number, speed = 8) {
  return { speed, azimuth, elevation: 0.02, side: 0, height: 0 };
}

/** A frame of three moves: a break after a refused answer, a choice of the ruling or a shot, and a concession. */
function frameLine(number: number, moves: readonly object[]): string {
  return JSON.stringify({
    frame: number,
    seats: number === 0 ? [0, 1] : [1, 0],
    seeds: { rack: SEED, errors: [SEED, SEED], sight: [SEED, SEED], decisions: [SEED, SEED] },
    moves,
    scores: [0, 0],
    end: { winner: 0, points: [1, 0], reason: "conceded", why: "the other player conceded" },
  });
}

const BREAK = {
  seat: 0,
  play: { strike: strike(1.57), cue_ball: [0.635, 0.5] },
  cost: COST,
  win_chance: 0.5,
  executed: { strike: strike(1.56, 8.1), cue_ball: [0.635, 0.5] },
  luck: { before: 0.5, expected: 0.6, after: 0.4 },
};

const REFUSED = {
  seat: 0,
  cost: COST,
  refused: { place: "play", what: "there is none", remedy: "write one" },
};

/** The record of a match of two frames that goes on. @param trace The hash of the break; null: the right one. */
export function recordOf(engine: Engine, trace: string | null = null): string {
  const text = (hash: string) =>
    [0, 1].map((number) =>
      frameLine(number, [
        REFUSED,
        { ...BREAK, ruling: {}, trace: hash },
        { seat: conceding(engine), concede: true, cost: COST, win_chance: 0.1 },
      ]),
    );
  return [header(engine), ...text(trace ?? breakHash(engine)), ""].join("\n");
}

let known: { hash: string; player: number } | undefined;

function breakOf(engine: Engine) {
  if (known) return known;
  const line = frameLine(0, [{ ...BREAK, ruling: {}, trace: "0".repeat(16) }]);
  const record = engine.matchRecord(`${header(engine)}\n${line}\n`);
  const { setup, moves } = record.game(0).record;
  record.free();
  const { game, ...options } = setup;
  const frame = engine.frame(game, options);
  const [first] = moves as readonly [FrameMove & { play: never }];
  const { trace } = frame.play(first.play);
  const { request } = frame.state;
  known = { hash: trace.hash, player: request.kind === "over" ? 0 : request.player };
  return known;
}

function breakHash(engine: Engine): string {
  return breakOf(engine).hash;
}

function conceding(engine: Engine): number {
  return breakOf(engine).player;
}

/** The moves of a frame as a record has them. */
export type Moves = readonly MatchMove[];

export { load };
