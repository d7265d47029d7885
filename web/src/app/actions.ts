/** What a user can do, whatever it is done with: button, key, or finger. */

import type { BallEntry, Engine, Noise, ShotFile, StrikeEntry, Trace } from "../engine/index.ts";
import { wrap } from "./angles.ts";
import type { Context } from "./context.ts";
import type { AimedShot, Document } from "./document.ts";
import { playShot } from "./game/play.ts";
import type { Store } from "./store.ts";
import { ballName, errorText, obstruction, raised } from "./words.ts";

/** How many times finer everything is while fine adjustment is on. */
export const FINE = 0.1;

/** A shot that looks like a usual one when a file has none: softly along the table. */
const USUAL: Omit<StrikeEntry, "ball"> = { speed: 2, azimuth_deg: 90, elevation_deg: 0 };

/** Shots whose balls may not be struck, or have none, get a strike on their first ball at rest. */
export function aimed(file: ShotFile): AimedShot {
  if (file.strike) return { ...file, strike: file.strike };
  const cue = file.balls.find((ball) => ball.id === "cue") ?? file.balls[0];
  return { ...file, strike: { ball: cue?.id ?? "", ...USUAL } };
}

/** A document about a shot file. */
export function documentOf(file: ShotFile, noise: Noise | null = null, seed = 0): Document {
  return { shot: aimed(file), noise, seed, game: null };
}

/** Plays the ghost: the shot as it is aimed. */
export function shoot(store: Store, context: Context): void {
  if (store.session.mode === "replay") return;
  if (store.document.game) {
    // With less motion one sees at once what the game asks next; the shot can be watched again.
    playShot(store, context, (trace) => {
      if (!context.reducedMotion()) replay(store, trace);
    });
    return;
  }
  const { trace, error } = store.ghost;
  if (!trace) {
    store.refuse(`This cannot be shot. ${error ?? ""}`);
    return;
  }
  const still = context.reducedMotion();
  store.settle();
  replay(store, trace, still ? trace.duration : 0, !still);
}

/** Shows a trace from `time` on. */
export function replay(store: Store, trace: Trace, time = 0, playing = true): void {
  store.setSession({ mode: "replay", trace, time, playing, refusal: null });
}

/** Makes the end of the replayed shot the new layout. */
export function takeItFromHere(store: Store, context: Context): void {
  const { trace } = store.session;
  if (!trace || store.document.game) return;
  const left = trace.shot.balls.filter((_, index) => !gone(trace, index));
  const cue = store.document.shot.strike.ball;
  const struck = left.some(({ id }) => id === cue) ? cue : left[0]?.id;
  if (struck === undefined) {
    store.refuse("No ball is left on the table: undo, or rack anew.");
    return;
  }
  const { shot } = store.document;
  const entries = new Map(shot.balls.map((ball) => [ball.id, ball]));
  const balls = left.map(({ id }) => {
    const { mass, radius } = entries.get(id) ?? {};
    const [x, y] = endOf(trace, id);
    return { id, position: [x, y] as const, ...(mass && { mass }), ...(radius && { radius }) };
  });
  // The next shot starts with a level, centred cue: offsets rarely carry over.
  const strike = { ...shot.strike, ball: struck, elevation_deg: 0, side: 0, height: 0 };
  const taken = store.apply({ shot: { ...shot, balls, strike } }, "take it from here");
  if (taken && struck !== cue) {
    context.announce(`${ballName(cue)} is gone: now ${ballName(struck)} is struck.`);
  }
}

function endOf(trace: Trace, id: string): readonly [number, number] {
  const index = trace.shot.balls.findIndex((ball) => ball.id === id);
  const states = trace.statesAt(trace.duration);
  const stride = states.length / trace.shot.balls.length;
  return [states[index * stride]!, states[index * stride + 1]!];
}

function gone(trace: Trace, index: number): boolean {
  const { id } = trace.shot.balls[index]!;
  const { pocketed, off_table } = trace.outcome;
  return pocketed.some(([ball]) => ball === id) || off_table.includes(id);
}

/** Turns the cue by `degrees`. */
export function turn(store: Store, degrees: number, group: string): void {
  const { azimuth_deg } = store.document.shot.strike;
  store.strike({ azimuth_deg: wrap(azimuth_deg + degrees) }, "aim", group);
}

/** Raises the cue as far as it must be, where it has no clear way. */
export function clearTheCue(store: Store): void {
  const outcome = store.ghost.trace?.outcome;
  if (!outcome || obstruction(outcome) === null || outcome.least_elevation_deg === null) return;
  store.strike({ elevation_deg: raised(outcome.least_elevation_deg) }, "raise the cue");
}

export function undo(store: Store, context: Context): void {
  const label = store.undoLabel;
  context.announce(store.undo() ? `Undone: ${label ?? ""}` : "There is nothing to undo.");
}

export function redo(store: Store, context: Context): void {
  const label = store.redoLabel;
  context.announce(store.redo() ? `Done again: ${label ?? ""}` : "There is nothing to do again.");
}

/** What a file holds: a shot to aim, and what is to be watched first, if anything. */
export interface Held {
  readonly shot: AimedShot;
  readonly trace: Trace | null;
}

/**
 * Reads a shot file or a trace.
 *
 * @throws CaromError for what the engine refuses, SyntaxError for what is no JSON.
 */
export function held(engine: Engine, json: string): Held {
  const format = (JSON.parse(json) as { format?: unknown } | null)?.format;
  if (format === "carom-trace/1") {
    const trace = engine.trace(json);
    return { shot: startOf(trace.shot.file), trace };
  }
  const shot = engine.shot(json);
  const { file } = shot;
  const moving = file.balls.some((ball) => ball.velocity ?? ball.angular_velocity);
  if (!moving || file.strike) return { shot: aimed(file), trace: null };
  // Balls that move cannot be aimed at; one can watch them, and take it from where they end.
  return { shot: startOf(file), trace: shot.simulate() };
}

/** Why a file cannot be opened, in words. */
export function notOpened(error: unknown): string {
  const why = error instanceof SyntaxError ? `It is no JSON: ${error.message}` : errorText(error);
  return `This file cannot be opened. ${why}`;
}

/** Opens a shot file or a trace, from JSON. Refused files leave everything as it is. */
export function open(store: Store, engine: Engine, json: string): boolean {
  try {
    const { shot, trace } = held(engine, json);
    const opened = store.apply({ shot, game: null }, trace ? "open a trace" : "open a shot");
    if (opened && trace) replay(store, trace, 0, false);
    return opened;
  } catch (error) {
    store.refuse(notOpened(error));
    return false;
  }
}

/** The layout of a file whose balls may move, at rest. */
function startOf(file: ShotFile): AimedShot {
  const balls = file.balls.map((ball) => {
    const still: { -readonly [K in keyof BallEntry]: BallEntry[K] } = { ...ball };
    delete still.velocity;
    delete still.angular_velocity;
    return file.strike ? ball : still;
  });
  return aimed({ ...file, balls });
}
