/**
 * The state of the page and the only place where it changes.
 *
 * A document that the engine refuses never becomes the present one: `apply` then leaves the state as it
 * was and stores the reason in `session.refusal`. The present document is therefore valid, and so are the
 * states of the history, except those that another version of the page has kept.
 */

import {
  CaromError,
  type PocketName,
  type PotAim,
  type Shot,
  type StrikeEntry,
} from "../../engine/index.ts";
import {
  FIRST_SESSION,
  FIRST_VIEW,
  type AimedShot,
  type Document,
  type PotLock,
  type Session,
  type View,
} from "./document.ts";
import type { Game } from "./stored-game.ts";
import { errorText } from "../common/refusals.ts";
import { type Ghost, simulate } from "./ghost.ts";
import { inSlices, type Slices } from "../common/slices.ts";
import { azimuthOfAim, lockOf, steered } from "./pot-lock.ts";
import { History, type Step, type Steps } from "./history.ts";
import { anglesOf, changed, STRIKE_NUMBERS } from "./strike-angles.ts";

/** Reads a shot, or throws a `CaromError`: the engine, or in a game the referee. */
export interface Compiler {
  shot(file: AimedShot, game: Game | null): Shot;
}

export interface State {
  readonly document: Document;
  readonly view: View;
  readonly session: Session;
}

/** Called after every change. Parts that did not change are the same objects in both states. */
export type Listener = (now: State, before: State) => void;

/** The first of some pockets into which a ball can be potted. */
export interface PotQuestion {
  /** A shot file. */
  readonly shot: string;
  readonly ball: string;
  readonly pockets: readonly PocketName[];
}

/** A pocket, and the line on which the ball falls into it. */
export interface FoundPot {
  readonly pocket: PocketName;
  readonly aim: PotAim;
}

/** Answers the last question only; null if there is no line. */
export type PotSolver = (question: PotQuestion, answer: (found: FoundPot | null) => void) => void;

export class Store {
  readonly #compiler: Compiler;
  #history: History<Document>;
  readonly #listeners = new Set<Listener>();
  #view: View;
  #session: Session = FIRST_SESSION;
  #shot: Shot;
  #ghost: Ghost | null = null;
  #solver: PotSolver | null = null;
  /** What the user has opened last. */
  #opening: Slices<unknown> | null = null;

  /** @throws CaromError if the engine refuses `document`. */
  constructor(compiler: Compiler, document: Document, view: View = FIRST_VIEW) {
    this.#compiler = compiler;
    this.#shot = compiler.shot(document.shot, document.game);
    this.#history = new History(document);
    this.#view = view;
  }

  get document(): Document {
    return this.#history.present;
  }
  get view(): View {
    return this.#view;
  }
  get session(): Session {
    return this.#session;
  }
  get state(): State {
    return { document: this.document, view: this.#view, session: this.#session };
  }
  /** The document's shot as the engine read it. Valid until the document changes. */
  get shot(): Shot {
    return this.#shot;
  }
  get undoLabel(): string | null {
    return this.#history.undoLabel;
  }
  get redoLabel(): string | null {
    return this.#history.redoLabel;
  }

  /** The simulation of the present document; it runs once per document, on first use. */
  get ghost(): Ghost {
    this.#ghost ??= simulate(this.#shot);
    return this.#ghost;
  }

  /**
   * Replaces the document, or refuses to.
   *
   * @param label Name of the change for "Undo: …", such as "aim" or "move ball 3".
   * @param group Changes with the same group are one step of the history until `settle`.
   * @returns Whether the change was accepted; if not, `session.refusal` has the reason.
   */
  apply(
    change: Partial<Document> | ((now: Document) => Partial<Document>),
    label: string,
    group: string | null = null,
  ): boolean {
    return this.#change(change, (next) => this.#history.push(next, label, group));
  }

  /** As `apply`, but the change belongs to the present step of the history. */
  amend(change: Partial<Document>): boolean {
    return this.#change(change, (next) => this.#history.amend(next));
  }

  #change(
    change: Partial<Document> | ((now: Document) => Partial<Document>),
    keep: (next: Document) => void,
  ): boolean {
    const before = this.state;
    const patch = typeof change === "function" ? change(before.document) : change;
    const [next, lock] = this.#steer(withoutStudy({ ...before.document, ...patch }));
    if (isOtherShot(next, before.document) && !this.#compile(next)) {
      this.#notify(before);
      return false;
    }
    keep(next);
    this.#session = { ...aiming(this.#session), lock };
    this.#notify(before);
    if (next.shot !== before.document.shot) this.#solve();
    return true;
  }

  /**
   * Gives the searches for lines that may take long to `solver`, such as a worker. Without one they run at
   * once.
   */
  solvePotsWith(solver: PotSolver): void {
    this.#solver = solver;
  }

  /**
   * Aims the cue so that `ball` falls into `pocket`, and keeps the aim while the strike changes.
   *
   * @returns Whether a line was found.
   * @throws CaromError for an unknown ball or pocket, and for the struck ball.
   */
  aimAtPocket(ball: string, pocket: PocketName, label: string): boolean {
    const aim = this.#shot.potAim(ball, pocket);
    return aim !== null && this.takeAim(ball, pocket, aim, label);
  }

  /** As `aimAtPocket`, for a line that is known. @returns Whether it was accepted. */
  takeAim(
    ball: string,
    pocket: PocketName,
    aim: PotAim,
    label: string,
    group: string | null = null,
  ): boolean {
    if (!this.strike({ azimuth_deg: azimuthOfAim(aim) }, label, group)) return false;
    this.setSession({ lock: lockOf(ball, pocket, aim) });
    return true;
  }

  /** Searches a new line for a pot that the last change of the strike has lost. */
  #solve(): void {
    const { lock } = this.#session;
    const { shot } = this.document;
    if (!this.#solver || !lock || lock.solved) return;
    const { ball, pocket } = lock;
    this.#solver({ shot: this.#shot.json(), ball, pockets: [pocket] }, (found) => {
      // The user may have gone on meanwhile.
      if (!found || this.document.shot !== shot || this.#session.lock !== lock) return;
      const strike = changed(shot.strike, { azimuth_deg: azimuthOfAim(found.aim) });
      const { mode } = this.#session;
      if (mode !== "aim" || !this.amend({ shot: { ...shot, strike } })) return;
      this.setSession({ lock: lockOf(ball, pocket, found.aim) });
    });
  }

  /** Changes keys of the strike. */
  strike(patch: Partial<StrikeEntry>, label: string, group: string | null = null): boolean {
    return this.apply(
      ({ shot }) => ({ shot: { ...shot, strike: changed(shot.strike, patch) } }),
      label,
      group,
    );
  }

  /** Ends a gesture: the next change is a new step of the history, and a refused shot is dropped. */
  settle(): void {
    this.#history.settle();
    const { refusal } = this.#session;
    if (refusal?.shot) this.setSession({ refusal: { ...refusal, shot: null } });
  }

  undo(): boolean {
    return this.#travel(
      () => this.#history.undo(),
      () => this.#history.redo(),
    );
  }

  redo(): boolean {
    return this.#travel(
      () => this.#history.redo(),
      () => this.#history.undo(),
    );
  }

  /** All states that undo and redo can restore, and the present one. */
  get steps(): Steps<Document> {
    return this.#history.steps;
  }

  /**
   * Shows the present state of `steps`, with their undo and redo.
   *
   * @returns Whether the engine accepts it; if not, `session.refusal` has the reason.
   */
  resume(steps: Steps<Document>): boolean {
    const before = this.state;
    const isAccepted = this.#compile(steps.steps[steps.at]!.state);
    if (isAccepted) {
      this.#history = History.of(steps);
      this.#session = { ...aiming(this.#session), lock: null };
    }
    this.#notify(before);
    return isAccepted;
  }

  /** Adds what was done before the first state of this page; see `History.precede`. */
  precede(past: readonly Step<Document>[], label: string, future: readonly Step<Document>[]): void {
    this.#history.precede(past, label, future);
    this.#notify(this.state);
  }

  setView(patch: Partial<View>): void {
    const before = this.state;
    this.#view = { ...this.#view, ...patch };
    this.#notify(before);
  }

  setSession(patch: Partial<Session>): void {
    const before = this.state;
    this.#session = { ...this.#session, ...patch };
    this.#notify(before);
  }

  /** Changes a part of the session. */
  setPart<Part extends "replay" | "analysis" | "overlays">(
    part: Part,
    patch: Partial<Session[Part]>,
  ): void {
    this.setSession({ [part]: { ...this.#session[part], ...patch } });
  }

  /** Reads what the user opens; null if the user has opened something else meanwhile. */
  open<T>(slices: Slices<T>): Promise<T | null> {
    this.#opening?.return(null);
    this.#opening = slices;
    return inSlices<T | null>(slices);
  }

  /** Shows a refusal of something that was not tried. */
  refuse(message: string): void {
    this.setSession({ refusal: { message, place: "", shot: null } });
  }

  /** @returns A function that ends the subscription. */
  subscribe(listener: Listener): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** The document with its strike aimed again at the locked pot. */
  #steer(next: Document): readonly [Document, PotLock | null] {
    const { lock } = this.#session;
    const now = this.document;
    if (!lock || next.shot === now.shot) return [next, lock];
    if (next.game !== now.game) return [next, null];
    const read = (shot: AimedShot) => this.#read({ ...next, shot });
    // A search of all lines may take many pictures.
    const near = this.#solver !== null;
    const aimed = steered(lock, [now.shot, next.shot], read, near);
    return [{ ...next, shot: aimed.shot }, aimed.lock];
  }

  #compile(document: Document, read = () => this.#read(document)): boolean {
    try {
      this.#adopt(read());
      return true;
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      const message = errorText(error, document.shot.balls);
      const refusal = { message, place: error.place, shot: document.shot };
      this.#session = { ...this.#session, refusal };
      return false;
    }
  }

  /** Reads a document. If only the strike's numbers differ, the engine need not read the whole file. */
  #read({ shot: file, game }: Document): Shot {
    const now = this.document;
    if (game !== now.game || !sameButForStrike(now.shot, file)) {
      return this.#compiler.shot(file, game);
    }
    const { speed, side = 0, height = 0 } = file.strike;
    return this.#shot.withStrike({ speed, ...anglesOf(file.strike), side, height });
  }

  #adopt(shot: Shot): void {
    // The garbage collector does not see WebAssembly's memory, and each frame may make a ghost.
    // A ghost that is being replayed is kept; the session still uses it.
    const ghost = this.#ghost?.trace;
    if (ghost && ghost !== this.#session.replay.trace) ghost.free();
    this.#shot.free();
    this.#shot = shot;
    this.#ghost = null;
  }

  /** @param back Takes `step` back: a state of a history that was kept may be one that the engine refuses. */
  #travel(step: () => boolean, back: () => boolean): boolean {
    const before = this.state;
    if (!step()) return false;
    const now = this.document;
    const read = () => this.#compiler.shot(now.shot, now.game);
    if (isOtherShot(now, before.document) && !this.#compile(now, read)) {
      back();
      this.#notify(before);
      return false;
    }
    this.#session = { ...aiming(this.#session), lock: null };
    this.#notify(before);
    return true;
  }

  #notify(before: State): void {
    const now = this.state;
    for (const listener of [...this.#listeners]) listener(now, before);
  }
}

/** The session after a change: a replay would show the old document. */
function aiming(session: Session): Session {
  const replay = { ...session.replay, trace: null, stroke: 0, time: 0, playing: false };
  const analysis = { ...session.analysis, preview: null };
  return { ...session, mode: "aim", replay, analysis, refusal: null };
}

/** A game that begins or is opened ends the analysis of another one. */
function withoutStudy(next: Document): Document {
  return next.game && next.study ? { ...next, study: undefined } : next;
}

/** Whether the engine or the referee must check the document again. */
function isOtherShot(a: Document, b: Document): boolean {
  return a.shot !== b.shot || a.game !== b.game;
}

function sameButForStrike(a: AimedShot, b: AimedShot): boolean {
  const same = <T extends object>(x: T, y: T, except: readonly string[]) =>
    [...new Set([...Object.keys(x), ...Object.keys(y)])].every(
      (key) => except.includes(key) || x[key as keyof T] === y[key as keyof T],
    );
  return same(a, b, ["strike"]) && same(a.strike, b.strike, STRIKE_NUMBERS);
}
