/** The progress of a game: the engine replays its moves, each of them once. */

import {
  CaromError,
  type Call,
  type Engine,
  type Frame,
  type FrameState,
  type Seat,
  type Ruling,
  type Shot,
  type ShotFile,
  type ShotRequest,
  type Strike,
  type Trace,
} from "../../engine/index.ts";
import { errorText, PageError } from "../common/refusals.ts";
import { atOnce, type Slices } from "../common/slices.ts";
import type { Game, Move, Setup } from "../document/stored-game.ts";
import { t } from "../words/translate.ts";

/** A move with its ruling. */
export interface PlayedMove {
  readonly move: Move;
  readonly player: Seat;
  /** The frame before the move. Shared: copy it before playing on it. */
  readonly from: Frame;
  readonly before: FrameState;
  readonly after: FrameState;
  readonly ruling: Ruling;
  /** The pocketed object balls, in order. */
  readonly potted: readonly string[];
}

export interface Progress {
  /** Shared: copy it before playing on it. */
  readonly frame: Frame;
  /** Table, physics and all balls of the game, as they were at the start. */
  readonly start: ShotFile;
  readonly steps: readonly PlayedMove[];
  /** The trace of the last shot; null before the first. */
  readonly trace: Trace | null;
}

/** A strike for shots whose strike does not matter. */
const ANY_STRIKE: Strike = { speed: 1, azimuth: 0, elevation: 0, side: 0, height: 0 };

/** Progress by the moves of a game. The history keeps the games, and so keeps these entries alive. */
const known = new WeakMap<Game["moves"], Progress>();

/**
 * The progress of `game`.
 *
 * @throws CaromError if its set-up is invalid, or a move is not allowed.
 */
export function progressOf(engine: Engine, game: Game): Progress {
  return known.get(game.moves) ?? atOnce(replayed(engine, game));
}

/**
 * Replays the moves of `game`, so that `progressOf` has its progress: a long game takes longer than a
 * picture.
 *
 * @param see Called after every move with its index.
 * @throws CaromError as `progressOf`.
 */
export function* replayed(
  engine: Engine,
  game: Game,
  see: (index: number, progress: Progress) => void = () => undefined,
): Slices<Progress> {
  const { setup, moves } = game;
  const frame = begun(engine, setup);
  let progress: Progress = { frame, start: startOf(engine, setup, frame), steps: [], trace: null };
  for (const [index, move] of moves.entries()) {
    yield;
    const before = progress;
    if (isApplied(move, moves[index - 1], before.frame.state)) continue;
    try {
      progress = after(before, move);
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      const why = errorText(error);
      throw new PageError(t("link.move", { number: index + 1, why }), error.place);
    }
    if (before.trace !== progress.trace) before.trace?.free();
    see(index, progress);
  }
  remember(game, progress);
  return progress;
}

/**
 * Whether the frame has already applied this choice of an older link: after a scratch on the break of
 * eight-ball, frames used to ask for a choice with this one option.
 */
function isApplied(move: Move, previous: Move | undefined, { game, request }: FrameState): boolean {
  return (
    "choice" in move &&
    move.choice === "play-from-hand" &&
    previous !== undefined &&
    "play" in previous &&
    game === "eight-ball" &&
    request.kind === "shot" &&
    request.in_hand === "behind-head-string"
  );
}

function begun(engine: Engine, { rules, options, from }: Setup): Frame {
  if (from === null) return engine.frame(rules, options);
  const { points, miss, patience, player = 0 } = options;
  const terms = {
    player,
    ...(points !== undefined && { points }),
    ...(miss !== undefined && { miss }),
    ...(patience !== undefined && { patience }),
  };
  const shot = engine.shot(from);
  try {
    return engine.frameOf(rules, shot, terms);
  } finally {
    shot.free();
  }
}

/** All balls of the game, including those pocketed at the start: a new rack brings them back. */
function startOf(engine: Engine, { rules, options, from }: Setup, frame: Frame): ShotFile {
  const file = fileOf(frame);
  if (from === null) return file;
  const { table, physics } = file;
  const racked = engine.frame(rules, {
    ...options,
    table,
    ...(physics !== undefined && { physics }),
  });
  const all = fileOf(racked).balls;
  racked.free();
  const there = new Map(file.balls.map((ball) => [ball.id, ball]));
  return { ...file, balls: all.map((ball) => there.get(ball.id) ?? ball) };
}

function fileOf(frame: Frame): ShotFile {
  const shot = anyShot(frame);
  const { file } = shot;
  shot.free();
  return file;
}

/**
 * The progress after one more move.
 *
 * @throws CaromError if the move is not allowed.
 */
export function after({ frame: from, start, steps, trace }: Progress, move: Move): Progress {
  const { state: before } = from;
  if (before.request.kind === "over") throw new PageError(t("refused.over"), "play");
  const { player } = before.request;
  const next = from.copy();
  try {
    if (!("play" in move)) {
      const ruling = "choice" in move ? next.choose(move.choice) : next.concede();
      const step = { move, player, from, before, after: next.state, ruling, potted: [] };
      return { frame: next, start, steps: [...steps, step], trace };
    }
    const { ruling, trace: shown } = next.play(move.play);
    const potted = pottedIn(shown);
    const step = { move, player, from, before, after: next.state, ruling, potted };
    return { frame: next, start, steps: [...steps, step], trace: shown };
  } catch (error) {
    next.free();
    throw error;
  }
}

function pottedIn({ outcome }: Trace): string[] {
  return outcome.pocketed.map(([ball]) => ball).filter((ball) => ball !== outcome.cue_ball);
}

/** Stores the progress of `game`, so that its moves are not replayed. */
export function remember(game: Game, progress: Progress): void {
  known.set(game.moves, progress);
}

/** A call that the request allows, for shots that are not played. */
export function someCall({ calls, on }: ShotRequest): Call | undefined {
  if (calls.includes("nothing")) return undefined;
  if (calls.includes("on") && on[0] !== undefined) return { kind: "on", ball: on[0] };
  return { kind: "safety" };
}

/**
 * The requested shot with any strike, and with the cue ball at `place` if it is in hand.
 *
 * @throws CaromError if the cue ball may not be placed there.
 */
export function anyShot(frame: Frame, place?: readonly [number, number]): Shot {
  const { request } = frame.state;
  if (request.kind !== "shot") throw new PageError(t("refused.no-shot"), "play");
  const call = someCall(request);
  return frame.shot({
    strike: ANY_STRIKE,
    ...(place && request.in_hand !== null && { cue_ball: place }),
    ...(call && { call }),
  });
}
