/** The five levels of the machine: their names, their errors, and how they think. */

import type { Engine, Noise, PlayerOptions } from "../../../engine/index.ts";
import { named } from "../../words/translate.ts";
import { type Game, seedOf } from "../../document/stored-game.ts";

/** The levels, the weakest first. */
export const LEVELS = ["level-1", "level-2", "level-3", "level-4", "level-5"] as const;

export function isLevel(name: unknown): boolean {
  return (LEVELS as readonly unknown[]).includes(name);
}

/** A level as players say it, such as "club player". */
export function machineName(level: string): string {
  return named("machine", level) ?? level;
}

const noises = new Map<string, Noise>();

/** The errors of a level's strikes. */
export function machineNoise(engine: Engine, level: string): Noise {
  let noise = noises.get(level);
  if (!noise) {
    const player = engine.player({ name: level });
    noise = player.noise;
    player.free();
    noises.set(level, noise);
  }
  return noise;
}

/** More than the moves of a frame. */
const MOVES = 10_000;

/**
 * How the machine thinks about its next move. The seed differs from that of its errors, so that it does
 * not know them. The same game gives the same decision.
 */
export function thinking({ setup, moves }: Game, level: string): PlayerOptions {
  const seed = seedOf(setup.options);
  return { name: level, seed: (seed % MOVES) * MOVES + moves.length + 1 };
}
