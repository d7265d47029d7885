/** Actions of the players in a game. */

import {
  type Call,
  CaromError,
  type Choice,
  type Engine,
  type Point,
  type ShotFile,
  type Shot,
  type ShotRequest,
  type Strike,
} from "../../engine/index.ts";
import { gameName } from "../common/presets.ts";
import { errorText } from "../common/refusals.ts";
import type { Context } from "../common/context.ts";
import type { Store } from "../document/store.ts";
import { pocketAt } from "../pot/pockets.ts";
import { firstAim } from "./aim.ts";
import { type Game, type Move, newGame, type Setup } from "../document/game.ts";
import { after, type Progress, progressOf, remember } from "./progress.ts";
import { choiceInWords, other } from "./words.ts";
import { inSentence, t } from "../words/translate.ts";

/** The progress of the game; null in free play. */
export function standing(store: Store, engine: Engine): Progress | null {
  const { game } = store.document;
  return game && progressOf(engine, game);
}

/** The game's request if it is for a shot, else null. */
export function askedShot(store: Store, engine: Engine): ShotRequest | null {
  const request = standing(store, engine)?.frame.state.request;
  return request?.kind === "shot" ? request : null;
}

/** Whether the user can aim: in free play, and when the game requests a shot. */
export function canAim(store: Store, engine: Engine): boolean {
  return store.document.game === null || askedShot(store, engine) !== null;
}

export function startGame(store: Store, { engine }: Context, setup: Setup): boolean {
  const game = newGame(setup);
  try {
    const shot = firstAim(engine, game, progressOf(engine, game));
    return store.apply(
      { game, shot },
      t("change.start", { game: inSentence(gameName(setup.rules)) }),
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
export function playShot(
  store: Store,
  { engine }: Context,
  show: (trace: NonNullable<Progress["trace"]>) => void,
): void {
  const { game } = store.document;
  const asked = askedShot(store, engine);
  if (!game || !asked) {
    store.refuse(t("refused.no-shot"));
    return;
  }
  const incomplete = missingPart(game.call);
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
      ...(game.call && { call: game.call }),
    };
    const progress = move(
      store,
      engine,
      { play },
      t("change.shot", { name: game.setup.names[asked.player] }),
    );
    if (progress?.trace) show(progress.trace);
  } catch (error) {
    refused(store, error);
  }
}

/** Makes a choice that the referee offers. */
export function choose(store: Store, { engine }: Context, choice: Choice): void {
  const { game } = store.document;
  const request = standing(store, engine)?.frame.state.request;
  if (!game || request?.kind !== "choice") return;
  const { names } = game.setup;
  const said = choiceInWords(choice, names[other(request.player)]);
  try {
    move(
      store,
      engine,
      { choice },
      t("ruling.choice", { name: names[request.player], choice: said }),
    );
  } catch (error) {
    refused(store, error);
  }
}

/** Concedes the frame for the player at the table. */
export function concede(store: Store, { engine }: Context): void {
  const request = standing(store, engine)?.frame.state.request;
  if (!request || request.kind === "over") return;
  const { names } = store.document.game!.setup;
  move(store, engine, { concede: true }, t("ruling.concedes", { name: names[request.player] }));
}

/** @throws CaromError if the move is not allowed. */
function move(store: Store, engine: Engine, made: Move, label: string): Progress | null {
  const game = store.document.game!;
  const progress = after(progressOf(engine, game), made);
  const next: Game = { ...game, moves: [...game.moves, made], call: null };
  remember(next, progress);
  store.settle();
  return store.apply({ game: next, shot: firstAim(engine, next, progress) }, label)
    ? progress
    : null;
}

/**
 * The aimed strike with the player's execution errors, and the contacts that cling: the variant whose index
 * is the number of moves so far. The engine draws no strike that cannot be played.
 */
function executed(
  engine: Engine,
  shot: Shot,
  game: Game,
  { player }: ShotRequest,
): { readonly strike: Strike; readonly cling?: ShotFile["cling"] } {
  const skill = game.setup.skills[player];
  const noise = skill === null ? undefined : engine.noisePresets[skill];
  // A game plays the aimed shot without the contacts that cling in its file.
  if (!noise) return { strike: shot.strike! };
  const { seed = 0 } = game.setup.options;
  const variant = shot.variant(noise, game.moves.length, { seed });
  const drawn = { strike: variant.strike!, cling: variant.file.cling };
  variant.free();
  return drawn;
}

/** What is missing in a call, with the remedy; null if the call is complete. */
function missingPart(call: Call | null): string | null {
  if (call?.kind !== "pocket") return null;
  if (call.ball === undefined) return t("call.ball-missing");
  if (call.into === undefined) return t("call.pocket-missing");
  return null;
}

/** Sets the call for the aimed shot; null removes it. */
export function announceCall(store: Store, call: Call | null): void {
  const { game } = store.document;
  if (!game || JSON.stringify(game.call) === JSON.stringify(call)) return;
  store.apply({ game: { ...game, call } }, t(call ? "change.call" : "change.uncall"), "call");
}

/** Calls or nominates the tapped ball if the game requests it. */
export function tapBall(store: Store, engine: Engine, ball: string): void {
  const asked = askedShot(store, engine);
  if (!asked || ball === asked.cue_ball) return;
  if (asked.calls.includes("on") && asked.on.includes(ball)) {
    announceCall(store, { kind: "on", ball });
  } else if (asked.calls.includes("pocket")) {
    const { call } = store.document.game!;
    const into = call?.kind === "pocket" ? call.into : undefined;
    announceCall(store, { kind: "pocket", ball, ...(into && { into }) });
  }
}

/** Calls the tapped pocket if the game requests it. @returns Whether a pocket was called. */
export function tapPocket(store: Store, engine: Engine, point: Point): boolean {
  const asked = askedShot(store, engine);
  if (!asked?.calls.includes("pocket")) return false;
  const into = pocketAt(store.shot, point);
  if (!into) return false;
  const { call } = store.document.game!;
  const ball = call?.kind === "pocket" ? call.ball : undefined;
  announceCall(store, { kind: "pocket", ...(ball !== undefined && { ball }), into });
  return true;
}

/** The call that fits the predicted outcome; null if nothing predicted can be called. */
export function predictedCall(store: Store, engine: Engine): Call | null {
  const asked = askedShot(store, engine);
  const outcome = asked && store.ghost.trace?.outcome;
  if (!outcome) return null;
  const { first_contact: first } = outcome;
  if (asked.calls.includes("on")) {
    return first !== null && asked.on.includes(first) ? { kind: "on", ball: first } : null;
  }
  if (!asked.calls.includes("pocket")) return null;
  const falls = outcome.pocketed.filter(([ball]) => ball !== asked.cue_ball);
  const drop = falls.find(([ball]) => asked.on.includes(ball)) ?? falls[0];
  return drop ? { kind: "pocket", ball: drop[0], into: drop[1] } : null;
}

function refused(store: Store, error: unknown): false {
  if (!(error instanceof CaromError)) throw error;
  store.refuse(errorText(error));
  return false;
}
