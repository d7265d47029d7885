/**
 * The search for the best plays of a position, in workers.
 *
 * Two workers look at every position: one with a small budget, whose plays come first, and one with a
 * large budget, whose plays replace them. So a search that is no longer wanted, which ends only with its
 * round, never delays the first plays of the next position.
 */

import type { Analysis, Engine, Recommendation } from "../../engine/index.ts";
import { connectThinker, type Thinker, type ThinkerWorker } from "../../engine/thinker-client.ts";
import { errorText } from "../common/refusals.ts";
import type { Position } from "./analysed-position.ts";

/** Recommendations that are shown. */
export const SHOWN = 5;

/** Simulated shots of the two searches: about 50 ms, and 600 ms in the middle of a game. */
export const BUDGETS: readonly number[] = [600, 8000];

/** What is known of a position. */
export interface Found {
  readonly position: Position;
  readonly plays: readonly Recommendation[];
  /** Whether the search with the large budget has ended. */
  readonly done: boolean;
  /** Since the position was asked about, ms. */
  readonly elapsed: number;
}

export interface RecommendationListener {
  found: (found: Found) => void;
  refused: (message: string) => void;
}

export class RecommendationSearch {
  readonly #searches: readonly Search[];
  readonly #listener: RecommendationListener;
  #asked: { readonly position: Position; readonly at: number; depth: number } | null = null;

  /** @param start Starts a worker that runs the engine's thinker. */
  constructor(
    start: () => ThinkerWorker,
    engine: Pick<Engine, "module">,
    listener: RecommendationListener,
    budgets: readonly number[] = BUDGETS,
  ) {
    this.#listener = listener;
    this.#searches = budgets.map(
      (simulations, depth) =>
        new Search(connectThinker(engine, start(), { simulations }), {
          found: (analysis, position) => this.#receive(analysis, position, depth),
          refused: (error, position) => {
            if (position === this.#asked?.position) listener.refused(errorText(error));
          },
        }),
    );
  }

  /** Searches a position; the previous search is stopped. */
  ask(position: Position): void {
    if (position.key === this.#asked?.position.key) return;
    this.#asked = { position, at: performance.now(), depth: -1 };
    for (const search of this.#searches) search.ask(position);
  }

  /** Stops the search. */
  stop(): void {
    this.#asked = null;
    for (const search of this.#searches) search.ask(null);
  }

  close(): void {
    this.stop();
    for (const search of this.#searches) search.close();
  }

  #receive({ plays }: Analysis, position: Position, depth: number): void {
    const asked = this.#asked;
    if (position !== asked?.position || depth < asked.depth) return;
    asked.depth = depth;
    const done = depth === this.#searches.length - 1;
    this.#listener.found({ position, plays, done, elapsed: performance.now() - asked.at });
  }
}

interface SearchListener {
  found: (analysis: Analysis, position: Position) => void;
  refused: (error: unknown, position: Position) => void;
}

/** One worker: it searches the last position that it was asked about. */
class Search {
  readonly #thinker: Promise<Thinker>;
  readonly #listener: SearchListener;
  #wanted: Position | null = null;
  #busy = false;

  constructor(thinker: Promise<Thinker>, listener: SearchListener) {
    this.#thinker = thinker;
    this.#listener = listener;
    // A worker that does not start is reported to the first question.
    thinker.catch(() => undefined);
  }

  ask(position: Position | null): void {
    this.#wanted = position;
    if (this.#busy) void this.#thinker.then((thinker) => thinker.stop()).catch(() => undefined);
    else void this.#work();
  }

  close(): void {
    void this.#thinker.then((thinker) => thinker.close()).catch(() => undefined);
  }

  async #work(): Promise<void> {
    this.#busy = true;
    while (this.#wanted) {
      const position = this.#wanted;
      try {
        const { record, noise } = position;
        const thinker = await this.#thinker;
        const analysis = await thinker.explain(record, { noise, count: SHOWN });
        if (!analysis.interrupted || position === this.#wanted)
          this.#listener.found(analysis, position);
      } catch (error) {
        this.#listener.refused(error, position);
      }
      if (position === this.#wanted) this.#wanted = null;
    }
    this.#busy = false;
  }
}
