/** Why a machine played a shot: the play of its analysis that it executed. */

import type { Engine, Noise, PlannedPlay, Play, Recommendation } from "../../../engine/index.ts";
import { machineOf, type Game } from "../../document/stored-game.ts";
import type { Progress } from "../game-progress.ts";
import { machineNoise, thinking } from "./machine-levels.ts";
import type { Thinker } from "../../../engine/thinker-client.ts";

/** More plays than a search has candidates. */
const ALL = 1000;

/**
 * Simulated shots of the analysis. It needs more than the decision, because counting the chances takes
 * shots from its search: with these it has 19 in 20 of the plays that the levels decide on.
 */
const SIMULATIONS: Readonly<Record<string, number>> = {
  "level-1": 480,
  "level-2": 1000,
  "level-3": 2400,
  "level-4": 6000,
  "level-5": 9600,
};

/** A drawn strike is nearer to the intended one than this, in standard deviations. */
const FARTHEST = 8;

/** Standard deviation of tip offsets for the comparison, ball radii: those of all levels are below. */
const SAME_TIP = 0.06;

export interface Reason {
  /** The play that was executed; null if the analysis does not have it among its best. */
  readonly meant: Recommendation | null;
  /** The best play with another aim; null if there is none. */
  readonly instead: Recommendation | null;
  /** The chance to win that the machine expected of its decision; null if it is in `meant`, or unknown. */
  readonly expected: number | null;
}

/** The last shot of a machine; null if there is none. */
export function lastByMachine({ setup }: Game, { steps }: Progress): number | null {
  const index = steps.findLastIndex(
    ({ move, player }) => "play" in move && machineOf(setup, player) !== null,
  );
  return index < 0 ? null : index;
}

/** Asks the machine again about the position before its shot. */
export async function reasonOf(
  engine: Engine,
  game: Game,
  { frame, steps }: Progress,
  index: number,
  thinker: Pick<Thinker, "choose" | "explain">,
): Promise<Reason | null> {
  const { player } = steps[index]!;
  const level = machineOf(game.setup, player);
  const { record } = frame;
  const move = record.moves[index]!;
  if (level === null || !("play" in move)) return null;
  const before = { ...record, moves: record.moves.slice(0, index) };
  const asked = thinking({ ...game, moves: game.moves.slice(0, index) }, level);
  const more = { ...asked, simulations: SIMULATIONS[level]!, count: ALL };
  const { plays } = await thinker.explain(before, more);
  const meant = found(plays, move.play, machineNoise(engine, level));
  const instead = plays.find((play) => !meant || !sameAim(play, meant)) ?? null;
  const expected = meant ? null : (await thinker.choose(before, asked)).win_chance;
  return { meant, instead, expected };
}

/** The play of an analysis from which a shot was drawn. */
function found(
  plays: readonly Recommendation[],
  played: PlannedPlay,
  noise: Noise,
): Recommendation | null {
  const near = plays
    .filter(({ play }) => sameTerms(play, played))
    .map((meant) => ({ meant, distance: distance(meant.play, played, noise) }))
    .sort((a, b) => a.distance - b.distance)[0];
  return near && near.distance < FARTHEST ? near.meant : null;
}

function sameAim(a: Recommendation, b: Recommendation): boolean {
  return a.kind === b.kind && a.ball === b.ball && a.pocket === b.pocket;
}

/** Whether call and place of the cue ball agree: errors do not change them. */
function sameTerms(a: Play, b: Play): boolean {
  const terms = ({ call, cue_ball }: Play) => [
    call?.kind ?? null,
    call?.ball ?? null,
    call?.into ?? null,
    cue_ball ?? null,
  ];
  return JSON.stringify(terms(a)) === JSON.stringify(terms(b));
}

/** Distance of two strikes in standard deviations of the errors. */
function distance({ strike: a }: PlannedPlay, { strike: b }: PlannedPlay, noise: Noise): number {
  const turned = a.azimuth - b.azimuth;
  return Math.max(
    Math.abs(a.speed - b.speed) / noise.speed,
    Math.abs(Math.atan2(Math.sin(turned), Math.cos(turned))) / noise.azimuth,
    Math.abs(a.side - b.side) / SAME_TIP,
    Math.abs(a.height - b.height) / SAME_TIP,
  );
}
