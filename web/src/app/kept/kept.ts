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
import { KeptStorage } from "./kept-storage.ts";
import { WorkKeeper } from "./work-keeper.ts";

/**
 * A page in the frame of another one keeps nothing.
 *
 * @param opening How the page was opened; see `Start`.
 * @returns Opens files with everything that a page keeps.
 */
export function mountKept(
  store: Store,
  context: Context,
  { practice, keeper: progress }: { readonly practice: Practice; readonly keeper: Keeper },
  opening: { readonly isPlain: boolean; readonly reload: "whole" | "lost" | null },
): Opener {
  if (window !== window.top) return () => null;
  const storage = new KeptStorage();
  const works = new WorkKeeper(store, context, practice, storage);
  const games = new FinishedGames(store, context.engine, works);
  const kept: Kept = { works, games, progress };
  void works.start(opening.reload);
  const offers = opening.isPlain && opening.reload === null;
  mountKeptBanner(document.getElementById("stage")!, store, context, works, offers);
  mountKeptList(document.getElementById("panel-game")!, store, context, kept);
  return (file) => (isBackupText(file.text) ? openBackup(store, context, kept, file) : null);
}
