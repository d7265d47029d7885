/** How a game stands: its moves played anew by the engine, each of them once. */

import {
  CaromError,
  type Call,
  type Engine,
  type Frame,
  type FrameState,
  type Player,
  type Ruling,
  type Shot,
  type ShotFile,
  type ShotRequest,
  type Strike,
  type Trace,
} from "../../engine/index.ts";
import type { Game, Move, Setup } from "../document/game.ts";

/** A move that was made, and what came of it. */
export interface Step {
  readonly move: Move;
  readonly player: Player;
  readonly before: FrameState;
  readonly after: FrameState;
  readonly ruling: Ruling;
  /** The object balls that fell, in this order. */
  readonly potted: readonly string[];
}

export interface Progress {
  /** Not to be played on: others hold it too. */
  readonly frame: Frame;
  /** The table, its physics, and every ball of the game, as they were at the start. */
  readonly start: ShotFile;
  readonly steps: readonly Step[];
  /** What happened in the last shot; null before the first. */
  readonly trace: Trace | null;
}

/** Any strike: to ask for a shot whose strike does not matter. */
const SOFTLY: Strike = { speed: 1, azimuth: 0, elevation: 0, side: 0, height: 0 };

/** History keeps games, and so keeps what is known of them. */
const known = new WeakMap<Game["moves"], Progress>();

/**
 * How `game` stands.
 *
 * @throws CaromError if its set-up makes no sense, or a move is not allowed.
 */
export function progressOf(engine: Engine, game: Game): Progress {
  let progress = known.get(game.moves);
  if (!progress) {
    progress = replayed(engine, game);
    known.set(game.moves, progress);
  }
  return progress;
}

function replayed(engine: Engine, { setup, moves }: Game): Progress {
  const frame = begun(engine, setup);
  let progress: Progress = { frame, start: startOf(engine, setup, frame), steps: [], trace: null };
  moves.forEach((move, index) => {
    const before = progress;
    try {
      progress = after(before, move);
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      throw new CaromError(`Move ${index + 1} of this game: ${error.message}`, error.place);
    }
    before.frame.free();
    if (before.trace !== progress.trace) before.trace?.free();
  });
  return progress;
}

function begun(engine: Engine, { rules, options, from }: Setup): Frame {
  if (from === null) return engine.frame(rules, options);
  const shot = engine.shot(from);
  try {
    return engine.frameOf(rules, shot, options);
  } finally {
    shot.free();
  }
}

/** Every ball of the game: those that are down at the start, too, for they can be racked again. */
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
 * How a game stands after one move more.
 *
 * @throws CaromError if it is not allowed.
 */
export function after({ frame, start, steps, trace }: Progress, move: Move): Progress {
  const { state: before } = frame;
  if (before.request.kind === "over") throw new CaromError("The game is over.", "play");
  const { player } = before.request;
  const next = frame.copy();
  try {
    if (!("play" in move)) {
      const ruling = "choice" in move ? next.choose(move.choice) : next.concede();
      const step = { move, player, before, after: next.state, ruling, potted: [] };
      return { frame: next, start, steps: [...steps, step], trace };
    }
    const { ruling, trace: shown } = next.play(move.play);
    const step = { move, player, before, after: next.state, ruling, potted: pottedIn(shown) };
    return { frame: next, start, steps: [...steps, step], trace: shown };
  } catch (error) {
    next.free();
    throw error;
  }
}

function pottedIn({ outcome }: Trace): string[] {
  return outcome.pocketed.map(([ball]) => ball).filter((ball) => ball !== outcome.cue_ball);
}

/** Makes known how `game` stands, so that nothing is played twice. */
export function remember(game: Game, progress: Progress): void {
  known.set(game.moves, progress);
}

/** A call that the request allows: for shots that are only tried. */
export function someCall({ calls, on }: ShotRequest): Call | undefined {
  if (calls.includes("nothing")) return undefined;
  if (calls.includes("on") && on[0] !== undefined) return { kind: "on", ball: on[0] };
  return { kind: "safety" };
}

/**
 * The shot that is asked, struck anyhow, with the cue ball at `place` if it is in hand.
 *
 * @throws CaromError where the cue ball must not be put there.
 */
export function anyShot(frame: Frame, place?: readonly [number, number]): Shot {
  const { request } = frame.state;
  if (request.kind !== "shot") throw new CaromError("No shot is asked now.", "play");
  const call = someCall(request);
  return frame.shot({
    strike: SOFTLY,
    ...(place && request.in_hand !== null && { cue_ball: place }),
    ...(call && { call }),
  });
}
