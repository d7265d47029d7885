/** Under Play: works to be continued, games that have ended, and the file with everything. */

import "./kept-views.css";
import type { Context } from "../common/context.ts";
import { button, h } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { download } from "../share/download.ts";
import { dayOf } from "../train/progress/practice-progress.ts";
import { dateAndTime, t } from "../words/translate.ts";
import { addBackup, backupOf, backupText, type Kept } from "./backup.ts";
import { damagedAlert } from "./damaged-alert.ts";
import type { FinishedGame } from "./finished-game.ts";
import type { KeptGames } from "./finished-games.ts";
import { continueButton } from "./kept-banner.ts";
import { KeptFault } from "./kept-fault.ts";
import { resultText } from "./kept-words.ts";
import type { KeptWorks } from "./work-keeper.ts";

/** Entries that are shown at first, of works and of games. */
const FEW = 3;
const SHOWN = 10;

export function mountKeptList(
  panel: HTMLElement,
  store: Store,
  context: Context,
  kept: Kept,
): void {
  const root = h("section", { class: "kept", id: "kept-list" });
  panel.append(root);
  new KeptList(root, store, context, kept);
}

class KeptList {
  readonly #root: HTMLElement;
  readonly #store: Store;
  readonly #context: Context;
  readonly #kept: Kept;
  readonly #input = h("input", {
    type: "file",
    accept: ".json,application/json",
    hidden: true,
    id: "kept-file",
    "aria-label": t("kept.import"),
  });
  #isWhole = false;
  /** Counts readings, so that an earlier one that ends later is not shown. */
  #reading = 0;

  constructor(root: HTMLElement, store: Store, context: Context, kept: Kept) {
    this.#root = root;
    this.#store = store;
    this.#context = context;
    this.#kept = kept;
    this.#input.addEventListener("change", () => {
      const file = this.#input.files?.[0];
      this.#input.value = ""; // the same file can be chosen again
      if (file) void this.#add(file);
    });
    const refresh = () => void this.#refresh();
    kept.games.subscribe(refresh);
    kept.works.storage.subscribe(refresh);
    // Another tab may have stored something meanwhile.
    document.addEventListener("visibilitychange", refresh);
    store.subscribe((now, before) => {
      const isOther =
        now.session.activity !== before.session.activity ||
        (now.document.game === null) !== (before.document.game === null);
      if (isOther) refresh();
    });
    refresh();
  }

  get #isShown(): boolean {
    const { document: now, session } = this.#store;
    return now.game === null && session.activity === "play";
  }

  async #refresh(): Promise<void> {
    this.#root.hidden = !this.#isShown;
    const reading = (this.#reading += 1);
    if (this.#root.hidden || document.visibilityState === "hidden") return;
    const [works, games] = await Promise.all([
      this.#kept.works.works(FEW),
      this.#kept.games.list(this.#isWhole ? Infinity : SHOWN),
    ]);
    if (reading === this.#reading) this.#show(works, games);
  }

  #show({ works, damaged }: KeptWorks, { games, hasMore, damaged: broken }: KeptGames): void {
    const { storage } = this.#kept.works;
    const unfinished = works.map((work) =>
      h(
        "li",
        {},
        continueButton(work, this.#context, "", () => void this.#kept.works.open(work)),
      ),
    );
    const finished = games.map((game) => this.#row(game));
    const all = [...damaged, ...broken];
    const more = () => {
      this.#isWhole = true;
      void this.#refresh();
    };
    const parts: (HTMLElement | false)[] = [
      h("h2", {}, t("kept.title")),
      unfinished.length > 0 && h("h3", {}, t("kept.unfinished")),
      unfinished.length > 0 && h("ul", {}, ...unfinished),
      h("h3", {}, t("kept.finished")),
      finished.length > 0 ? h("ul", {}, ...finished) : h("p", { class: "hint" }, t("kept.none")),
      hasMore && button(t("kept.more"), more),
      all.length > 0 && damagedAlert(all, (ids) => this.#removeDamaged(ids)),
      h("p", { class: "hint" }, t(storage.fault ? `kept.fault-${storage.fault}` : "kept.kept")),
      h(
        "div",
        { class: "row" },
        button(t("kept.export"), () => void this.#save()),
        button(t("kept.import"), () => this.#input.click()),
        this.#input,
      ),
    ];
    this.#root.replaceChildren(...parts.filter((part) => part !== false));
  }

  #row(game: FinishedGame): HTMLElement {
    const what = resultText(this.#context.engine, game);
    const open = button(t("kept.review"), () => void this.#kept.games.open(game));
    open.setAttribute("aria-label", t("kept.review-of", { what }));
    const end = button(t("kept.delete"), () => {
      const sure = button(t("kept.confirm"), () => void this.#kept.games.remove(game.id), "danger");
      end.replaceWith(sure);
      sure.focus();
    });
    end.setAttribute("aria-label", t("kept.delete-of", { what }));
    return h(
      "li",
      {},
      h("span", {}, what),
      h("span", { class: "when" }, dateAndTime(new Date(game.ended))),
      h("div", { class: "row" }, open, end),
    );
  }

  async #removeDamaged(ids: readonly string[]): Promise<void> {
    for (const id of ids) {
      for (const table of ["works", "games"] as const) {
        await this.#kept.works.storage.remove(table, id);
      }
    }
    await this.#refresh();
  }

  async #save(): Promise<void> {
    download(
      await backupText(this.#kept, this.#context.engine.version),
      `carom-${dayOf(new Date())}.json`,
    );
  }

  async #add(file: File): Promise<void> {
    let text: string;
    try {
      text = await file.text();
    } catch {
      this.#store.refuse(t("kept.unreadable", { file: file.name }));
      return;
    }
    await openBackup(this.#store, this.#context, this.#kept, { name: file.name, text });
    await this.#refresh();
  }
}

/** Adds the contents of a file to what is kept; a damaged one changes nothing. */
export async function openBackup(
  store: Store,
  context: Context,
  kept: Kept,
  { name: file, text }: { readonly name: string; readonly text: string },
): Promise<void> {
  try {
    const count = await addBackup(kept, backupOf(text));
    if (count === null) store.refuse(t("kept.import-full", { file }));
    else {
      // The refusal of an earlier file would contradict this one.
      store.setSession({ refusal: null });
      context.announce(t("kept.imported", { count }));
    }
  } catch (error) {
    if (!(error instanceof KeptFault)) throw error;
    const { place } = error;
    store.refuse(
      place === "" ? t("kept.not-backup", { file }) : t("kept.wrong-value", { file, place }),
    );
  }
}
