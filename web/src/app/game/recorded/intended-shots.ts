/** What the players of a match intended: the shot before their errors. */

import { CaromError, type Engine, type Strike, type Trace } from "../../../engine/index.ts";
import type { Game, MoveNote } from "../../document/stored-game.ts";
import type { Store } from "../../document/store.ts";
import type { PlayedMove } from "../game-progress.ts";
import { standing } from "../awaited-turn.ts";
import { replayedMove } from "../review/reviewed-shots.ts";

/** Traces of intended shots; null for one that cannot be played. The history keeps the moves. */
const known = new WeakMap<PlayedMove, Trace | null>();

/** The note of a move of the game, if it comes from a match. */
export function noteAt(game: Game | null, index: number): MoveNote | undefined {
  return game?.notes?.moves.find((note) => note.index === index);
}

/** The intended and the executed strike of a move; null if the move has only one. */
export function strikesAt(
  game: Game,
  index: number,
): { readonly intended: Strike; readonly executed: Strike } | null {
  const intended = noteAt(game, index)?.play?.strike;
  const move = game.moves[index];
  if (!intended || !move || !("play" in move)) return null;
  return { intended, executed: move.play.strike as Strike };
}

/** The trace of the shot that was intended where `store` replays the executed one; null without it. */
export function intendedTrace(store: Store, engine: Engine): Trace | null {
  const { game } = store.document;
  if (!game?.notes) return null;
  const index = replayedMove(store, engine);
  const step = index === null ? undefined : standing(store, engine)?.steps[index];
  const play = index === null ? undefined : noteAt(game, index)?.play;
  if (!step || !play || !("play" in step.move)) return null;
  let found = known.get(step);
  if (found === undefined) known.set(step, (found = played(step, play)));
  return found;
}

/** The intended shot, played where the executed one was. */
function played({ from, move }: PlayedMove, play: NonNullable<MoveNote["play"]>): Trace | null {
  const { cue_ball } = "play" in move ? move.play : {};
  const frame = from.copy();
  try {
    return frame.play({ ...play, ...(cue_ball && { cue_ball }) }).trace;
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  } finally {
    frame.free();
  }
}
