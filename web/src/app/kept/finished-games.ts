/** Notes games that end, and opens them again for their review. */

import { CaromError, type Engine } from "../../engine/index.ts";
import { errorText } from "../common/refusals.ts";
import type { Slices } from "../common/slices.ts";
import type { Document } from "../document/document.ts";
import type { Game, Setup } from "../document/stored-game.ts";
import type { State, Store } from "../document/store.ts";
import { firstAim } from "../game/first-aim.ts";
import { progressOf, replayed } from "../game/game-progress.ts";
import { checkedGame } from "../share/address.ts";
import { t } from "../words/translate.ts";
import { type FinishedGame, finishedOf, GAME_FORMAT } from "./finished-game.ts";
import { isEqual, KeptFault } from "./kept-fault.ts";
import type { WorkKeeper } from "./work-keeper.ts";

/** What the storage has of games. */
export interface KeptGames {
  /** The newest first. */
  readonly games: readonly FinishedGame[];
  readonly hasMore: boolean;
  /** Entries that cannot be read, as they are stored. */
  readonly damaged: readonly unknown[];
}

export class FinishedGames {
  readonly #store: Store;
  readonly #engine: Engine;
  readonly #keeper: WorkKeeper;
  /** When the games ended that are stored, by their set-ups. */
  readonly #ended = new WeakMap<Setup, string>();
  readonly #listeners = new Set<() => void>();

  constructor(store: Store, engine: Engine, keeper: WorkKeeper) {
    this.#store = store;
    this.#engine = engine;
    this.#keeper = keeper;
    store.subscribe((now, before) => void this.#follow(now, before));
  }

  /** Calls `listener` when a game was stored or deleted. */
  subscribe(listener: () => void): void {
    this.#listeners.add(listener);
  }

  async list(most: number): Promise<KeptGames> {
    const games: FinishedGame[] = [];
    const damaged: unknown[] = [];
    let hasMore = false;
    await this.#keeper.storage.eachGame((data) => {
      hasMore = games.length >= most;
      if (hasMore) return false;
      const game = readGame(data);
      if (game) games.push(game);
      else damaged.push(data);
      return true;
    });
    return { games, hasMore, damaged };
  }

  /** Opens a game at its end, where its shots are reviewed. @returns Whether it is open. */
  async open({ game, id, ended }: FinishedGame): Promise<boolean> {
    try {
      const read = await this.#store.open(endOf(this.#engine, game));
      if (!read) return false;
      this.#keeper.remember(game.setup, id);
      this.#ended.set(game.setup, ended);
      return this.#store.apply({ ...read, study: undefined }, t("change.open-record"));
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      this.#store.refuse(t("kept.refused", { why: errorText(error) }));
      return false;
    }
  }

  async remove(id: string): Promise<void> {
    await this.#keeper.storage.remove("games", id);
    this.changed();
  }

  /** Tells the listeners that the stored games are others. */
  changed(): void {
    for (const listener of this.#listeners) listener();
  }

  async #follow({ document: now }: State, { document: before }: State): Promise<void> {
    const { game } = now;
    if (!game || game === before.game) return;
    const { scores, request } = progressOf(this.#engine, game).frame.state;
    if (request.kind !== "over" || !this.#isOwn(game, before)) return;
    const ended = this.#ended.get(game.setup) ?? new Date().toISOString();
    this.#ended.set(game.setup, ended);
    const id = this.#keeper.idOf(game.setup);
    const { version: engine } = this.#engine;
    const { winner } = request;
    const entry = { format: GAME_FORMAT, engine, id, ended, game, winner, scores } as const;
    if (await this.#keeper.storage.put("games", entry)) this.changed();
  }

  /** Whether a game that is over was played here: the game that was opened from a file was not. */
  #isOwn(game: Game, before: Document): boolean {
    if (this.#ended.has(game.setup)) return true;
    const earlier = before.game;
    if (!earlier) return false;
    // A friend's link goes on with the game that is shown.
    const isSame = earlier.setup === game.setup || isEqual(earlier.setup, game.setup);
    return isSame && progressOf(this.#engine, earlier).frame.state.request.kind !== "over";
  }
}

/** The stored game; null if it is damaged. */
export function readGame(data: unknown): FinishedGame | null {
  try {
    return finishedOf(data, "game");
  } catch (error) {
    if (error instanceof KeptFault) return null;
    throw error;
  }
}

/** The document that shows the end of a game. */
function* endOf(engine: Engine, game: Game): Slices<Pick<Document, "game" | "shot">> {
  const progress = yield* replayed(engine, checkedGame(engine, game));
  return { game, shot: firstAim(engine, game, progress) };
}
