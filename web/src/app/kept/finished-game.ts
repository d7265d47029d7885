/** A game that was played to its end, as the page keeps it. */

import type { Seat } from "../../engine/index.ts";
import type { Game, Pair } from "../document/stored-game.ts";
import { gameOf } from "../share/link-state.ts";
import { LinkError } from "../share/link.ts";
import { check, entriesAt, KeptFault, textAt, timeAt, wholeAt } from "./kept-fault.ts";

export const GAME_FORMAT = "carom-finished/1";

const LONGEST_ID = 200;
/** The largest score of a player: that of a game of many points. */
const MOST_POINTS = 1_000_000;

export interface FinishedGame {
  readonly format: typeof GAME_FORMAT;
  /** Name and version of the engine that played it; missing in a game of an older page. */
  readonly engine?: string;
  readonly id: string;
  /** When it ended: ISO 8601, UTC, with milliseconds. */
  readonly ended: string;
  readonly game: Game;
  /** Null: the game has no winner. */
  readonly winner: Seat | null;
  /** Points, in the order of the names. */
  readonly scores: Pair<number>;
}

/**
 * The game of plain values. Its structure is checked; the engine still has to play its moves.
 *
 * @throws {KeptFault} It is damaged.
 */
export function finishedOf(data: unknown, place: string): FinishedGame {
  const keys = ["format", "id", "ended", "game", "winner", "scores"];
  const { format, engine, id, ended, game, winner, scores } = entriesAt(data, place, keys, [
    "engine",
  ]);
  check(format === GAME_FORMAT, `${place}.format`);
  check(winner === null || winner === 0 || winner === 1, `${place}.winner`);
  check(Array.isArray(scores) && scores.length === 2, `${place}.scores`);
  const score = (k: 0 | 1) =>
    wholeAt(scores[k], `${place}.scores[${k}]`, -MOST_POINTS, MOST_POINTS);
  return {
    format: GAME_FORMAT,
    ...(engine !== undefined && { engine: textAt(engine, `${place}.engine`, LONGEST_ID) }),
    id: textAt(id, `${place}.id`, LONGEST_ID),
    ended: timeAt(ended, `${place}.ended`),
    game: gameAt(game, `${place}.game`),
    winner,
    scores: [score(0), score(1)],
  };
}

function gameAt(data: unknown, place: string): Game {
  try {
    const game = gameOf(data);
    check(game !== null, place);
    return game;
  } catch (error) {
    if (error instanceof LinkError) throw new KeptFault(place);
    throw error;
  }
}
