/** The turns of a lag: who plays, with which errors, and when it is decided or played again. */

import type { Engine, Noise, Seat } from "../../../engine/index.ts";
import { machineOf, seedOf, type Setup } from "../../document/stored-game.ts";
import { machineNoise } from "../machine/machine-levels.ts";
import { type Lag, type LagErrors, type LagTable, lagWinner } from "./lag.ts";

export interface LagTurns {
  /** How often the lag was played again. */
  readonly repeated: number;
  /** The lags of the players so far. */
  readonly lags: readonly Lag[];
}

/** Before the first lag. */
export const FIRST_TURN: LagTurns = { repeated: 0, lags: [] };

/** The player who lags now; null after both. */
export function lagging({ lags }: LagTurns): Seat | null {
  return lags.length === 0 ? 0 : lags.length === 1 ? 1 : null;
}

/** The turns after a lag, and the winner, if there is one. If both are equal or bad, they begin again. */
export function turnsAfter(
  { repeated, lags }: LagTurns,
  lag: Lag,
): { readonly turns: LagTurns; readonly winner: Seat | null } {
  const [first] = lags;
  const winner = first ? lagWinner([first, lag]) : null;
  const isAgain = first !== undefined && winner === null;
  const turns = isAgain ? { repeated: repeated + 1, lags: [] } : { repeated, lags: [...lags, lag] };
  return { turns, winner };
}

/** The table of the game with its physics. */
export function lagTable(engine: Engine, { from, options, rules }: Setup): LagTable {
  const { table, physics } = options;
  const usual = {
    table: table ?? engine.usualTable(rules),
    ...(physics !== undefined && { physics }),
  };
  return from ?? usual;
}

/** A player's errors; each lag is another variant of the game's seed. Null: none. */
export function lagErrors(
  engine: Engine,
  setup: Setup,
  { repeated }: LagTurns,
  player: Seat,
): LagErrors | null {
  const noise = noiseOf(engine, setup, player);
  return noise && { noise, index: 2 * repeated + player, seed: seedOf(setup.options) };
}

function noiseOf(engine: Engine, setup: Setup, player: Seat): Noise | null {
  const level = machineOf(setup, player);
  const skill = setup.skills[player];
  if (level !== null) return machineNoise(engine, level);
  return skill === null ? null : engine.noisePresets[skill]!;
}
