/** The position that the analysis looks at: a game's frame, or a free layout in a chosen game. */

import {
  CaromError,
  type Engine,
  type Frame,
  type FrameRecord,
  type Noise,
  type Shot,
} from "../../engine/index.ts";
import type { State, Store } from "../document/store.ts";
import { standing } from "../game/awaited-turn.ts";

export interface Position {
  /** Positions with equal keys have the same recommendations. */
  readonly key: string;
  /** The game by whose rules plays are judged. */
  readonly rules: string;
  /** The games that can go on from here. */
  readonly games: readonly string[];
  readonly record: FrameRecord;
  readonly noise: Noise;
}

/** The errors of the analysis: the document's, or else those of the chosen level. */
export function noiseOf(engine: Pick<Engine, "noisePresets">, { document, session }: State): Noise {
  return document.noise ?? engine.noisePresets[session.analysis.level] ?? engine.noisePresets.club!;
}

/** The last answer of `gamesFor`: a drag changes the places of the balls, and not their names. */
let last: { readonly key: string; readonly games: readonly string[] } | null = null;

/** The games that can start from the balls of a shot, the most fitting first. */
export function gamesFor(engine: Engine, shot: Shot): readonly string[] {
  const balls = shot.balls.map(({ id, radius, mass }) => [id, radius, mass]);
  const key = JSON.stringify([shot.geometry.dated_name, balls]);
  if (last?.key !== key) last = { key, games: fittingGames(engine, shot) };
  return last.games;
}

function fittingGames(engine: Engine, shot: Shot): readonly string[] {
  // The game that allows the fewest ids is preferred. A game for one fits nearly every layout.
  const all = Object.values(engine.gameFacts).sort((a, b) => a.balls - b.balls);
  const fitting = all.filter(({ name }) => {
    const frame = frameOf(engine, name, shot);
    frame?.free();
    return frame !== null;
  });
  const matches = fitting.filter(({ players }) => players > 1);
  return (matches.length > 0 ? matches : fitting).map(({ name }) => name);
}

/** The game from the balls of a shot; null if it cannot start there. */
function frameOf(engine: Engine, rules: string, shot: Shot): Frame | null {
  try {
    return engine.frameOf(rules, shot);
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}

/** Names of the games' moves, so that positions of games have short keys. */
const names = new WeakMap<object, string>();
let named = 0;

function nameOf(moves: object): string {
  let name = names.get(moves);
  if (name === undefined) names.set(moves, (name = `game ${++named}`));
  return name;
}

/** The present position; null if the game requires no shot, or no game can go on from it. */
export function positionOf(store: Store, engine: Engine): Position | null {
  const { document, session } = store;
  const noise = noiseOf(engine, store.state);
  if (document.game) {
    const progress = standing(store, engine)!;
    if (progress.frame.state.request.kind !== "shot") return null;
    const { rules } = document.game.setup;
    const key = JSON.stringify([nameOf(document.game.moves), noise]);
    return { key, rules, games: [rules], noise, record: progress.frame.record };
  }
  const games = gamesFor(engine, store.shot);
  const rules = games.find((name) => name === session.analysis.rules) ?? games[0];
  if (rules === undefined) return null;
  const { strike, ...layout } = document.shot;
  const frame = frameOf(engine, rules, store.shot);
  if (!frame) return null;
  const { request } = frame.state;
  const { record } = frame;
  frame.free();
  // The aimed ball may be none of the game's cue balls.
  if (request.kind !== "shot" || request.cue_ball !== strike.ball) return null;
  return { key: JSON.stringify([layout, strike.ball, rules, noise]), rules, games, noise, record };
}
