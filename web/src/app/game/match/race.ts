/** A race: who breaks the next frame, and who has won. */

import type { Seat } from "../../../engine/index.ts";
import {
  type Game,
  newGame,
  type Pair,
  type Race,
  type Setup,
  seedOf,
} from "../../document/stored-game.ts";

/** The most frames of a race. */
export const LONGEST_RACE = 25;

/** Frames of a race with the winner of the present one, who is null while it is played or if it is drawn. */
export function framesWon({ won }: Race, winner: Seat | null): Pair<number> {
  return [won[0] + Number(winner === 0), won[1] + Number(winner === 1)];
}

/** The player who has won the race with this frame; null if it goes on. */
export function raceWinner(race: Race, winner: Seat | null): Seat | null {
  return winner !== null && framesWon(race, winner)[winner] >= race.to ? winner : null;
}

/**
 * The next frame after one that is over: a new rack. In a race the breaker changes as agreed, and after its
 * end a new race begins. A frame without a winner is played again.
 */
export function nextFrame({ setup, here }: Game, winner: Seat | null): Game {
  const seed = seedOf(setup.options) + 1;
  const next: Setup = { ...setup, from: null, options: { ...setup.options, seed } };
  const { race } = setup;
  if (!race || winner === null) return newGame(next, here);
  const isEnd = raceWinner(race, winner) !== null;
  const won: Pair<number> = isEnd ? [0, 0] : framesWon(race, winner);
  const breaker = race.breaks === "winner" ? winner : 1;
  const game = newGame({ ...next, race: { ...race, won } }, here);
  return breaker === 1 ? turned(game) : game;
}

/** The same game with the players in the other order. */
export function turned(game: Game): Game {
  const { setup, here } = game;
  const { names, skills, machines, race } = setup;
  return {
    ...game,
    setup: {
      ...setup,
      names: swapped(names),
      skills: swapped(skills),
      ...(machines && { machines: swapped(machines) }),
      ...(race && { race: { ...race, won: swapped(race.won), turned: !race.turned } }),
    },
    ...(here !== undefined && { here: here === 0 ? 1 : 0 }),
  };
}

function swapped<T>([a, b]: Pair<T>): Pair<T> {
  return [b, a];
}
