/** What the shots of a frame have cost: the chance to win before and after each of them. */

import type {
  Decision,
  Engine,
  FrameRecord,
  Noise,
  PlannedPlay,
  PlayerOptions,
  Seat,
} from "../../../engine/index.ts";
import type { Thinker } from "../../../engine/thinker-client.ts";
import { type Game, machineOf } from "../../document/stored-game.ts";
import { machineNoise } from "../machine/machine-levels.ts";
import type { Progress } from "../game-progress.ts";
import { isShot } from "./reviewed-shots.ts";

/** Simulated shots for each position: the standard error of a chance is then 1 to 3 %. */
const SIMULATIONS = 800;

/** The errors of a person for whom none are chosen. */
const USUAL = "club";

/** Shots that are listed as the costliest, and the least loss of one of them. */
const LISTED = 3;
const LEAST = 0.03;

/** The loss from which a shot is marked as a mistake. */
const GROSS = 0.1;

export interface Cost {
  /** Index of the move. */
  readonly index: number;
  readonly player: Seat;
  /** Whether a machine played it: its shots are in the curve, and not among the costliest. */
  readonly byMachine: boolean;
  /** Chance to win with the best play, and after what was played. */
  readonly before: number;
  readonly after: number;
  readonly best: PlannedPlay;
}

/**
 * The costs of all shots, in their order.
 *
 * @param watch Called before every position with the number of those that are done, and of all; false ends
 *   the search.
 * @returns Null if the search was ended.
 */
export async function costsOf(
  engine: Engine,
  game: Game,
  { frame, steps }: Progress,
  thinker: Pick<Thinker, "choose">,
  watch: (done: number, all: number) => boolean,
): Promise<Cost[] | null> {
  const { record } = frame;
  const noises = [0, 1].map((player) => noiseOf(engine, game, player === 0 ? 0 : 1));
  const shots = steps.flatMap((step, index) => (isShot(step) ? [index] : []));
  const needed = [...new Set(shots.flatMap((index) => [index, index + 1]))];
  const decisions = new Map<number, Decision>();
  for (const [done, made] of needed.entries()) {
    if (!watch(done, needed.length)) return null;
    const request = steps[made]?.before.request ?? frame.state.request;
    if (request.kind === "over") continue;
    const position: FrameRecord = { ...record, moves: record.moves.slice(0, made) };
    const options: PlayerOptions = {
      noise: noises[request.player]!,
      opponentNoise: noises[1 - request.player]!,
      simulations: SIMULATIONS,
      seed: made,
    };
    decisions.set(made, await thinker.choose(position, options));
  }
  return shots.flatMap((index): Cost[] => {
    const { player } = steps[index]!;
    const { win_chance: before = null, play = null } = decisions.get(index) ?? {};
    const next = steps[index + 1]?.before.request ?? frame.state.request;
    const after = chance(player, next, decisions.get(index + 1)?.win_chance ?? null);
    if (before === null || after === null || !play) return [];
    const byMachine = machineOf(game.setup, player) !== null;
    return [{ index, player, byMachine, before, after, best: play }];
  });
}

/** What a shot has cost: the loss of the chance to win. */
export function lossOf({ before, after }: Pick<Cost, "before" | "after">): number {
  return before - after;
}

/** How a shot is marked in the curve. */
export function gradeOf(cost: Pick<Cost, "before" | "after">): "good" | "slip" | "mistake" {
  const loss = lossOf(cost);
  return loss > GROSS ? "mistake" : loss > LEAST ? "slip" : "good";
}

/** The costliest shots of persons, if they cost enough; the costliest first. */
export function worstOf(costs: readonly Cost[]): readonly Cost[] {
  return costs
    .filter((cost) => !cost.byMachine && lossOf(cost) > LEAST)
    .sort((a, b) => lossOf(b) - lossOf(a))
    .slice(0, LISTED);
}

/** The chance of `player` to win, when the next player has the chance `win`. */
function chance(
  player: Seat,
  next: Progress["frame"]["state"]["request"],
  win: number | null,
): number | null {
  if (next.kind === "over") return next.winner === null ? null : Number(next.winner === player);
  if (win === null) return null;
  return next.player === player ? win : 1 - win;
}

function noiseOf(engine: Engine, { setup }: Game, player: Seat): Noise {
  const level = machineOf(setup, player);
  return level === null
    ? engine.noisePresets[setup.skills[player] ?? USUAL]!
    : machineNoise(engine, level);
}
