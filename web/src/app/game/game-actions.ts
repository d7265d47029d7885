/** Actions of the players in a game. */

import {
  CaromError,
  type Choice,
  type Decision,
  type Engine,
  type Play,
  type Seat,
  type ShotFile,
  type Shot,
  type Strike,
  type Trace,
} from "../../engine/index.ts";
import { gameName } from "../common/preset-names.ts";
import { errorText } from "../common/refusals.ts";
import type { Context } from "../common/context.ts";
import type { Store } from "../document/store.ts";
import { firstAim } from "./first-aim.ts";
import { missingPart, presentCall } from "./calling.ts";
import {
  type Game,
  machineOf,
  type Move,
  newGame,
  seedOf,
  type Setup,
} from "../document/stored-game.ts";
import { machineNoise } from "./machine/machine-levels.ts";
import { nextFrame } from "./match/race.ts";
import { after, type Progress, progressOf, remember } from "./game-progress.ts";
import { askedShot, isPerson, standing } from "./awaited-turn.ts";
import { choiceInWords, isForOne, other } from "./game-words.ts";
import { inSentence, t } from "../words/translate.ts";

/** Starts a game that is set up, such as after a lag. */
export function startReady(store: Store, { engine }: Context, game: Game): boolean {
  return start(store, engine, game);
}

/** @param here The player at this page, if the other one is a friend. */
export function startGame(store: Store, { engine }: Context, setup: Setup, here?: Seat): boolean {
  return start(store, engine, newGame(setup, here));
}

function start(store: Store, engine: Engine, game: Game): boolean {
  try {
    const shot = firstAim(engine, game, progressOf(engine, game));
    return store.apply(
      { game, shot },
      t("change.start", { game: inSentence(gameName(game.setup.rules)) }),
    );
  } catch (error) {
    return refused(store, error);
  }
}

/** Ends the game. The balls keep their positions, and free play continues. */
export function endGame(store: Store): void {
  store.apply({ game: null }, t("change.end"));
}

/**
 * Plays the shot that is aimed.
 *
 * @param show Called with the trace of the shot after the document was updated.
 */
export function playShot(store: Store, { engine }: Context, show: (trace: Trace) => void): void {
  const { game } = store.document;
  const asked = askedShot(store, engine);
  if (!game || !asked) {
    store.refuse(t("refused.no-shot"));
    return;
  }
  const call = presentCall(store, engine);
  const incomplete = missingPart(call);
  if (incomplete) {
    store.refuse(incomplete);
    return;
  }
  const { shot } = store;
  const [x, y] = shot.balls[shot.struck!]!.position;
  try {
    const { obstruction, miscue } = store.document.shot.strike;
    const { strike, cling } = executed(engine, shot, game, asked);
    const play = {
      strike: {
        ...strike,
        ...(obstruction !== undefined && { obstruction }),
        ...(miscue !== undefined && { miscue }),
      },
      ...(cling && { cling }),
      ...(asked.in_hand !== null && { cue_ball: [x, y] as const }),
      ...(call && { call }),
    };
    const trace = shotMove(store, engine, play);
    if (trace) show(trace);
  } catch (error) {
    refused(store, error);
  }
}

/**
 * Makes the move that a machine has decided on; its shot gets the errors of its level.
 *
 * @param show As in `playShot`.
 */
export function playDecision(
  store: Store,
  { engine }: Context,
  { play, choice }: Pick<Decision, "play" | "choice">,
  show: (trace: Trace) => void,
): void {
  const { game } = store.document;
  const progress = standing(store, engine);
  const request = progress?.frame.state.request;
  if (!game || !progress || !request || request.kind === "over") return;
  try {
    if (choice) choiceMove(store, engine, choice);
    else if (!play) concedeMove(store, engine);
    else {
      const shot = progress.frame.shot(play);
      const { strike, cling } = executed(engine, shot, game, request);
      shot.free();
      const { obstruction, miscue } = play.strike;
      const policies = { ...(obstruction && { obstruction }), ...(miscue && { miscue }) };
      const drawn = { ...play, strike: { ...strike, ...policies }, ...(cling && { cling }) };
      const trace = shotMove(store, engine, drawn);
      if (trace) show(trace);
    }
  } catch (error) {
    refused(store, error);
  }
}

/** Plays a shot that is not the aimed one, without errors; the table shows its end. */
export function playMove(store: Store, { engine }: Context, play: Play): void {
  try {
    shotMove(store, engine, play);
  } catch (error) {
    refused(store, error);
  }
}

/** Starts the next frame after one that is over. */
export function startNext(store: Store, { engine }: Context, winner: Seat | null): void {
  const { game } = store.document;
  if (game) start(store, engine, nextFrame(game, winner));
}

/** @throws CaromError if the shot is not allowed. */
function shotMove(store: Store, engine: Engine, play: Play): Trace | null {
  return move(store, engine, { play }, (name) => t("change.shot", { name }))?.trace ?? null;
}

/** Makes a choice that the referee offers. */
export function choose(store: Store, { engine }: Context, choice: Choice): void {
  const request = standing(store, engine)?.frame.state.request;
  if (request?.kind !== "choice" || !isPerson(store, request.player)) return;
  try {
    choiceMove(store, engine, choice);
  } catch (error) {
    refused(store, error);
  }
}

function choiceMove(store: Store, engine: Engine, choice: Choice): void {
  move(store, engine, { choice }, (name, opponent) =>
    t("ruling.choice", { name, choice: choiceInWords(choice, opponent) }),
  );
}

/** Whether a person is at the table, who may concede. */
export function canConcede(store: Store, engine: Engine): boolean {
  const state = standing(store, engine)?.frame.state;
  if (!state || state.request.kind === "over" || isForOne(engine, state.game)) return false;
  return isPerson(store, state.request.player);
}

/** Concedes the frame for the person at the table. */
export function concede(store: Store, { engine }: Context): void {
  if (canConcede(store, engine)) concedeMove(store, engine);
}

function concedeMove(store: Store, engine: Engine): void {
  move(store, engine, { concede: true }, (name) => t("ruling.concedes", { name }));
}

/**
 * @param label The name of the change, from the names of the player at the table and of the opponent.
 * @throws CaromError if the move is not allowed.
 */
function move(
  store: Store,
  engine: Engine,
  made: Move,
  label: (name: string, opponent: string) => string,
): Progress | null {
  const game = store.document.game!;
  const progress = after(progressOf(engine, game), made);
  const next: Game = { ...game, moves: [...game.moves, made], call: null };
  remember(next, progress);
  store.settle();
  const { player } = progress.steps.at(-1)!;
  const { names } = game.setup;
  const change = { game: next, shot: firstAim(engine, next, progress) };
  return store.apply(change, label(names[player], names[other(player)])) ? progress : null;
}

/**
 * The aimed strike with the player's execution errors, and the contacts that cling: the variant whose index
 * is the number of moves so far. The engine draws no strike that cannot be played.
 */
function executed(
  engine: Engine,
  shot: Shot,
  game: Game,
  { player }: { readonly player: Seat },
): { readonly strike: Strike; readonly cling?: ShotFile["cling"] } {
  const [level, skill] = [machineOf(game.setup, player), game.setup.skills[player]];
  const own = skill === null ? undefined : engine.noisePresets[skill];
  const noise = level === null ? own : machineNoise(engine, level);
  // A game plays the aimed shot without the contacts that cling in its file.
  if (!noise) return { strike: shot.strike! };
  const seed = seedOf(game.setup.options);
  const variant = shot.variant(noise, game.moves.length, { seed });
  const drawn = { strike: variant.strike!, cling: variant.file.cling };
  variant.free();
  return drawn;
}

function refused(store: Store, error: unknown): false {
  if (!(error instanceof CaromError)) throw error;
  store.refuse(errorText(error));
  return false;
}
