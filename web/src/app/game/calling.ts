/** The call for the aimed shot: the player's, or the one that fits the aim. */

import type { Call, Engine, PocketName, ShotRequest, Trace } from "../../engine/index.ts";
import { guideOf } from "../document/stored-game.ts";
import type { Store } from "../document/store.ts";
import { drawn } from "../pot/magnet.ts";
import { askedShot } from "./awaited-turn.ts";
import { t } from "../words/translate.ts";

/**
 * The call with which the aimed shot would be played. If one is required, what the player has not called
 * is taken from the aim.
 */
export function presentCall(store: Store, engine: Engine): Call | null {
  const { game } = store.document;
  const asked = askedShot(store, engine);
  if (!game || !asked) return null;
  const { call } = game;
  if (asked.calls.includes("nothing") || (call && missingPart(call) === null)) return call;
  const intended = intendedCall(store, engine);
  if (!call) return intended;
  const fits = intended?.kind === "pocket" && (!call.ball || call.ball === intended.ball);
  return fits ? { ...intended, ...call } : call;
}

/**
 * The call that fits the aim: the pot to which the cue is locked, or the first ball and the pocket to which
 * it is sent. Null if the aim fits no call. With the full guide a ball that will fall goes first.
 */
export function intendedCall(store: Store, engine: Engine): Call | null {
  const asked = askedShot(store, engine);
  const { trace } = store.ghost;
  if (!asked || !trace) return null;
  if (asked.calls.includes("on")) {
    const { first_contact: first } = trace.outcome;
    return first !== null && asked.on.includes(first) ? { kind: "on", ball: first } : null;
  }
  if (!asked.calls.includes("pocket")) return null;
  const { lock } = store.session;
  if (lock) return { kind: "pocket", ball: lock.ball, into: lock.pocket };
  const falls = guideOf(store.document.game) === "full" ? fallen(trace, asked) : null;
  const sent = falls ?? drawn(trace);
  return sent && { kind: "pocket", ball: sent.ball, into: sent.pocket };
}

/** The first ball that will fall, before all one that is on. */
function fallen({ outcome }: Trace, { cue_ball, on }: ShotRequest) {
  const falls = outcome.pocketed.filter(([ball]) => ball !== cue_ball);
  const drop = falls.find(([ball]) => on.includes(ball)) ?? falls[0];
  return drop ? { ball: drop[0], pocket: drop[1] } : null;
}

/** What is missing in a call, with the remedy; null if the call is complete. */
export function missingPart(call: Call | null): string | null {
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
export function tapPocket(store: Store, engine: Engine, into: PocketName | null): boolean {
  const asked = askedShot(store, engine);
  if (!into || !asked?.calls.includes("pocket")) return false;
  const { call } = store.document.game!;
  const ball = call?.kind === "pocket" ? call.ball : undefined;
  announceCall(store, { kind: "pocket", ...(ball !== undefined && { ball }), into });
  return true;
}
