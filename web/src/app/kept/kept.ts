/** Keeps what is done on the page in the browser, and mounts what shows it. */

import type { Context } from "../common/context.ts";
import type { Store } from "../document/store.ts";
import type { Opener } from "../share/open-files.ts";
import type { Keeper } from "../train/progress/progress-keeper.ts";
import type { Practice } from "../train/practice.ts";
import { isBackupText, type Kept } from "./backup.ts";
import { FinishedGames } from "./finished-games.ts";
import { mountKeptBanner } from "./kept-banner.ts";
import { mountKeptList, openBackup } from "./kept-list.ts";
import type { KeptStorage } from "./kept-storage.ts";
import { Library } from "./library.ts";
import { WorkKeeper } from "./work-keeper.ts";

/**
 * @param storage Null if the page keeps nothing.
 * @param opening How the page was opened; see `Start`.
 * @returns Opens files with everything that a page keeps; and the library, null if the page keeps nothing.
 */
export function mountKept(
  store: Store,
  context: Context,
  { practice, keeper: progress }: { readonly practice: Practice; readonly keeper: Keeper },
  storage: KeptStorage | null,
  opening: { readonly isPlain: boolean; readonly reload: "whole" | "lost" | null },
): { readonly opener: Opener; readonly library: Library | null } {
  if (!storage) return { opener: () => null, library: null };
  const works = new WorkKeeper(store, context, practice, storage);
  const games = new FinishedGames(store, context.engine, works);
  const library = new Library(storage);
  const kept: Kept = { works, games, progress, library };
  void works.start(opening.reload);
  const offers = opening.isPlain && opening.reload === null;
  mountKeptBanner(document.getElementById("stage")!, store, context, works, offers);
  mountKeptList(document.getElementById("panel-game")!, store, context, kept);
  const opener: Opener = (file) =>
    isBackupText(file.text) ? openBackup(store, context, kept, file) : null;
  return { opener, library };
}
