/** What the game waits for, and whether a person at this page may answer. */

import type { Engine, Seat, ShotRequest } from "../../engine/index.ts";
import { machineOf } from "../document/stored-game.ts";
import type { Store } from "../document/store.ts";
import { type Progress, progressOf } from "./game-progress.ts";

/** The progress of the game; null in free play. */
export function standing(store: Store, engine: Engine): Progress | null {
  const { game } = store.document;
  return game && progressOf(engine, game);
}

/** The game's request if it is for a shot of a person, else null. */
export function askedShot(store: Store, engine: Engine): ShotRequest | null {
  const request = standing(store, engine)?.frame.state.request;
  return request?.kind === "shot" && isPerson(store, request.player) ? request : null;
}

/** Whether a person at this page plays for `player`. */
export function isPerson({ document: { game } }: Store, player: Seat): boolean {
  if (!game || machineOf(game.setup, player) !== null) return false;
  return game.here === undefined || game.here === player;
}

/** Whether the game waits for the friend at another page. */
export function waitsForFriend(store: Store, engine: Engine): boolean {
  const { game } = store.document;
  const request = standing(store, engine)?.frame.state.request;
  if (game?.here === undefined || !request || request.kind === "over") return false;
  return request.player !== game.here;
}

/** Whether the user can aim: in free play, and when the game requests a shot. */
export function canAim(store: Store, engine: Engine): boolean {
  return store.document.game === null || askedShot(store, engine) !== null;
}
