/** Plays the moves of the machines: thinks while the last shot is replayed, and plays when the table rests. */

import { CaromError, type Decision, type Engine } from "../../../engine/index.ts";
import type { Thinker } from "../../../engine/thinker-client.ts";
import { errorText } from "../../common/refusals.ts";
import { machineOf, type Game } from "../../document/stored-game.ts";
import type { Store } from "../../document/store.ts";
import { standing } from "../awaited-turn.ts";
import { isNotable } from "../game-words.ts";
import { thinking } from "./machine-levels.ts";

/**
 * What is waited for: a machine's decision, the person who lets it play, or the person who reads the last
 * ruling.
 */
export type Waiting = "thinking" | "held" | "reading" | null;

/** Time (ms) that a ruling is shown before a machine plays on: enough to read two short sentences. */
export const READING = 1800;

/** The part of a thinker that plays. */
export type Decider = Pick<Thinker, "choose" | "stop">;

export interface TurnsListener {
  /** Plays a decision of the machine. */
  readonly play: (decision: Decision) => void;
  /** Called when what is waited for changes. */
  readonly changed: () => void;
}

export class Turns {
  readonly #store: Store;
  readonly #engine: Engine;
  readonly #decider: () => Promise<Decider>;
  readonly #listener: TurnsListener;
  readonly #time: number;
  /** The moves of the game that is thought about. */
  #moves: Game["moves"] | null = null;
  #decision: Decision | null = null;
  #waiting: Waiting = null;
  /** Whether a question waits for its answer. */
  #searching = false;
  #playing = false;
  /** The moves whose last ruling was shown long enough. */
  #read: Game["moves"] | null = null;
  #reading: ReturnType<typeof setTimeout> | undefined;

  /** @param time For how long (ms) a ruling is shown before a machine plays on. */
  constructor(
    store: Store,
    engine: Engine,
    decider: () => Promise<Decider>,
    listener: TurnsListener,
    time = READING,
  ) {
    this.#store = store;
    this.#engine = engine;
    this.#decider = decider;
    this.#listener = listener;
    this.#time = time;
    store.subscribe(() => this.consider());
  }

  get waiting(): Waiting {
    return this.#waiting;
  }

  /** Thinks, plays or waits, as the game requires. */
  consider(): void {
    if (this.#playing) return;
    const { game } = this.#store.document;
    const level = game && levelToMove(this.#store, this.#engine);
    if (!game || !level) {
      void this.#end();
      this.#moves = null;
      this.#decision = null;
      this.#wait(null);
    } else if (game.moves !== this.#moves) {
      void this.#end();
      this.#moves = game.moves;
      this.#decision = null;
      this.#stopReading();
      // After an undo the machine would at once repeat what was taken back.
      if (this.#store.redoLabel !== null) this.#wait("held");
      else void this.#think(game, level);
    } else if (this.#decision && this.#store.session.mode === "aim") {
      if (this.#isRead()) this.#play(this.#decision);
      else this.#wait("reading");
    }
    // A replay hides the ruling: the time to read it begins again.
    if (this.#store.session.mode === "replay" || !level) this.#stopReading();
    else this.#startReading();
  }

  /** Ends the time to read the last ruling: the machine may play at once. */
  readOn(): void {
    if (this.#reading === undefined) return;
    this.#stopReading();
    this.#read = this.#moves;
    this.consider();
  }

  #isRead(): boolean {
    const last = standing(this.#store, this.#engine)?.steps.at(-1);
    return this.#read === this.#moves || !last || !isNotable(last);
  }

  #startReading(): void {
    if (this.#reading !== undefined || this.#isRead()) return;
    this.#reading = setTimeout(() => this.readOn(), this.#time);
  }

  #stopReading(): void {
    clearTimeout(this.#reading);
    this.#reading = undefined;
  }

  /** Lets a machine play that waits after an undo. */
  resume(): void {
    const { game } = this.#store.document;
    const level = game && levelToMove(this.#store, this.#engine);
    if (game && level && this.#waiting === "held") void this.#think(game, level);
  }

  /** Ends the search: the machine plays the best that it has found. */
  stop(): void {
    void this.#end();
  }

  async #think(game: Game, level: string): Promise<void> {
    const { frame } = standing(this.#store, this.#engine)!;
    const { record } = frame;
    this.#wait("thinking");
    try {
      const decider = await this.#decider();
      if (game.moves !== this.#moves) return;
      this.#searching = true;
      const decision = await decider.choose(record, thinking(game, level));
      this.#searching = false;
      if (game.moves !== this.#moves) return;
      this.#decision = decision;
      this.consider();
    } catch (error) {
      this.#searching = false;
      if (!(error instanceof CaromError)) throw error;
      if (game.moves !== this.#moves) return;
      this.#wait("held");
      this.#store.refuse(errorText(error));
    }
  }

  async #end(): Promise<void> {
    if (!this.#searching) return;
    const decider = await this.#decider();
    decider.stop();
  }

  #play(decision: Decision): void {
    this.#decision = null;
    this.#wait(null);
    this.#playing = true;
    try {
      this.#listener.play(decision);
    } finally {
      this.#playing = false;
    }
    this.consider();
  }

  #wait(waiting: Waiting): void {
    if (waiting === this.#waiting) return;
    this.#waiting = waiting;
    this.#listener.changed();
  }
}

/** The level of the machine that the game waits for; null if it waits for a person or is over. */
export function levelToMove(store: Store, engine: Engine): string | null {
  const { game } = store.document;
  const request = standing(store, engine)?.frame.state.request;
  if (!game || !request || request.kind === "over") return null;
  return machineOf(game.setup, request.player);
}
