/** Keeps what this tab does in the browser's storage, and brings back what was kept. */

import { CaromError, type Engine } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { freshId } from "../common/fresh-id.ts";
import { errorText } from "../common/refusals.ts";
import type { Slices } from "../common/slices.ts";
import type { Document } from "../document/document.ts";
import type { Setup } from "../document/stored-game.ts";
import type { Store } from "../document/store.ts";
import { progressOf } from "../game/game-progress.ts";
import { checkDocument, checkedGame } from "../share/address.ts";
import { type LinkState, stateFromFragment, stateToFragment } from "../share/link-state.ts";
import type { Practice } from "../train/practice.ts";
import { t } from "../words/translate.ts";
import { isEqual, KeptFault } from "./kept-fault.ts";
import type { KeptStorage } from "./kept-storage.ts";
import { type Kind, KINDS, packed, unpacked, type Work } from "./kept-work.ts";
import { claim, heldWorks } from "./work-locks.ts";

/** Time (ms) without a change after which a work is stored. */
const REST = 250;

/** Name in the storage of the tab: which works it writes, and which of them it shows. */
const OPEN = "carom-works";

/** A work that this tab writes. */
interface OwnWork {
  readonly id: string;
  /** Lets other tabs take it; does nothing without a lock. */
  readonly release: () => void;
}

/** What the storage has of works. */
export interface KeptWorks {
  /** Those that no tab shows and that have not ended, the newest first. */
  readonly works: readonly Work[];
  /** Entries that cannot be read, as they are stored. */
  readonly damaged: readonly unknown[];
}

export class WorkKeeper {
  readonly storage: KeptStorage;
  readonly #store: Store;
  readonly #context: Context;
  readonly #practice: Practice;
  /** The ids of games by their set-ups, which all states of a game share. */
  readonly #gameIds = new WeakMap<Setup, string>();
  readonly #own = new Map<Kind, OwnWork>();
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Whether there are changes that are not stored. */
  #isDue = false;
  /** Whether a drill was seen since the page was loaded. */
  #isPractised = false;
  /** Whether the works of before a reload are found: nothing is stored earlier. */
  #isReady = false;

  constructor(store: Store, context: Context, practice: Practice, storage: KeptStorage) {
    this.#store = store;
    this.#context = context;
    this.#practice = practice;
    this.storage = storage;
  }

  /**
   * Begins to keep what the tab does.
   *
   * @param reload What the page shows if it was loaded again: "whole", the document of before without its
   *   history; "lost", another one. Null: it was not loaded again.
   */
  async start(reload: "whole" | "lost" | null): Promise<void> {
    this.#store.subscribe((now, before) => {
      if (now.document !== before.document) this.#changed();
    });
    this.#practice.subscribe(() => this.#changed());
    addEventListener("pagehide", () => this.#leave());
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") this.#saveNow();
    });
    try {
      if (reload !== null) await this.#afterReload(reload);
    } finally {
      this.#isReady = true;
    }
    if (this.#isDue || this.#kind() === "game") this.#changed();
  }

  /** The id of the game with a set-up. */
  idOf = (setup: Setup): string => {
    const known = this.#gameIds.get(setup);
    if (known !== undefined) return known;
    const id = freshId();
    this.#gameIds.set(setup, id);
    return id;
  };

  /** Says that a set-up is that of a game with an id. */
  remember = (setup: Setup, id: string): void => {
    this.#gameIds.set(setup, id);
  };

  /** @param most The most works of each kind. */
  async works(most: number): Promise<KeptWorks> {
    const held = await heldWorks();
    const works: Work[] = [];
    const damaged: unknown[] = [];
    // This tab may store its first change while the storage is read.
    const isOwn = (id: string) => [...this.#own.values()].some((own) => own.id === id);
    for (const kind of KINDS) {
      const end = works.length + most;
      await this.storage.eachWork(kind, (data) => {
        const work = this.#read(data);
        if (!work) damaged.push(data);
        else if (!work.over && !held.has(work.id) && !isOwn(work.id)) works.push(work);
        return works.length < end;
      });
    }
    works.sort((a, b) => (a.changed < b.changed ? 1 : -1));
    return { works, damaged };
  }

  #read(data: unknown): Work | null {
    try {
      return unpacked(data, "work", this.remember);
    } catch (error) {
      if (error instanceof KeptFault) return null;
      throw error;
    }
  }

  /** Goes on with a work; one that is refused leaves everything as it is. @returns Whether it is open. */
  async open(work: Work): Promise<boolean> {
    const { engine } = this.#context;
    const store = this.#store;
    try {
      if ((await store.open(checkWork(engine, work))) === null) return false;
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      store.refuse(t("kept.refused", { why: errorText(error) }));
      return false;
    }
    this.#saveNow();
    const release = await claim(work.id);
    this.#giveBack();
    if (this.#practice.running) this.#practice.leave();
    if (!store.resume(work.steps)) {
      release?.();
      return false;
    }
    // Without the lock another tab may have the work: this one goes on with a copy.
    if (release) this.#own.set(work.kind, { id: work.id, release });
    const { practice, kind } = work;
    if (practice) this.#practice.resume({ ...practice.kept, shown: true }, practice.before);
    else store.setSession({ activity: kind === "game" ? "play" : "analyse" });
    if (store.document.study) store.setSession({ activity: "analyse" });
    this.#changed();
    this.#context.announce(t("kept.continued"));
    return true;
  }

  /** Lets other tabs take the works of this one, which begins new ones. */
  #giveBack(): void {
    for (const { release } of this.#own.values()) release();
    this.#own.clear();
  }

  /** What the tab shows; null if nothing of it is worth keeping. */
  #kind(): Kind | null {
    const { document: now, session, undoLabel, redoLabel } = this.#store;
    // A study is in the library, or in its link.
    if (session.lesson) return null;
    if (this.#practice.running) return "drill";
    if (now.game || now.study) return "game";
    // The first steps set shots of their own.
    if (session.attempt) return null;
    return undoLabel === null && redoLabel === null ? null : "analysis";
  }

  #changed(): void {
    this.#isDue = true;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#saveNow(), REST);
  }

  #saveNow(): void {
    if (!this.#isDue || !this.#isReady) return;
    clearTimeout(this.#timer);
    this.#isDue = false;
    this.#endDrill();
    const kind = this.#kind();
    if (kind === null) return;
    const isNew = !this.#own.has(kind);
    const { id } = this.#ownOf(kind);
    const work: Work = {
      id,
      kind,
      changed: new Date().toISOString(),
      over: this.#isOver(kind),
      steps: this.#store.steps,
      practice: kind === "drill" ? this.#practice.snapshot() : null,
    };
    const storing = this.storage.put("works", packed(work, this.idOf));
    if (isNew) void storing.then(() => this.#prune(kind));
  }

  async #prune(kind: Kind): Promise<void> {
    const own = [...this.#own.values()].map(({ id }) => id);
    await this.storage.prune(kind, new Set([...(await heldWorks()), ...own]));
  }

  #ownOf(kind: Kind): OwnWork {
    const own = this.#own.get(kind);
    if (own) return own;
    const id = freshId();
    const claimed = claim(id);
    const fresh = { id, release: () => void claimed.then((release) => release?.()) };
    this.#own.set(kind, fresh);
    return fresh;
  }

  /** Forgets a drill that was left: the document before it is back. */
  #endDrill(): void {
    if (this.#practice.running) this.#isPractised = true;
    const drill = this.#own.get("drill");
    // After a reload the drill comes back later than this.
    if (!drill || this.#practice.running || !this.#isPractised) return;
    drill.release();
    this.#own.delete("drill");
    void this.storage.remove("works", drill.id);
  }

  #isOver(kind: Kind): boolean {
    const { running } = this.#practice;
    if (kind === "drill") return running !== null && (running.result !== null || running.solved);
    const { game } = this.#store.document;
    if (!game) return false;
    return progressOf(this.#context.engine, game).frame.state.request.kind === "over";
  }

  /** Stores the last changes, and which works are open, for a reload of the tab. */
  #leave(): void {
    this.#isDue = true;
    this.#saveNow();
    const kind = this.#kind();
    const own = Object.fromEntries([...this.#own].map(([name, { id }]) => [name, id]));
    try {
      sessionStorage.setItem(OPEN, JSON.stringify({ kind, own }));
    } catch {
      // Some frames have no storage; the tab then begins new works.
    }
  }

  async #afterReload(reload: "whole" | "lost"): Promise<void> {
    const { kind, own } = takeOpen();
    const claims = Object.entries(own).map(async ([name, id]) => {
      const release = await claim(id, true);
      if (release) this.#own.set(name as Kind, { id, release });
    });
    const id = kind && own[kind];
    const data = id ? await this.storage.get("works", id) : undefined;
    const work = data === undefined ? null : this.#read(data);
    if (work) await this.#bringBack(work, reload);
    await Promise.all(claims);
  }

  /** Brings the history of a work back, and its document if the page shows another one. */
  async #bringBack({ steps: kept, practice }: Work, reload: "whole" | "lost"): Promise<void> {
    const { steps, at } = kept;
    const present = steps[at]!;
    if (reload === "lost" && !practice) {
      const checking = checkWork(this.#context.engine, { steps: kept });
      try {
        if ((await this.#store.open(checking)) !== null) this.#store.resume(kept);
      } catch (error) {
        if (!(error instanceof CaromError)) throw error;
      }
      return;
    }
    const shown = this.#store.steps.steps[0]!.state;
    const isSame = isEqual(this.#link(shown), this.#link(present.state));
    // The last change may not have been stored before the page was left.
    if (!isSame) this.#store.precede(steps.slice(0, at + 1), t("change.reload"), []);
    else this.#store.precede(steps.slice(0, at), present.label, steps.slice(at + 1));
  }

  /** What a link to a document has, with which the page was loaded again. */
  #link(document: Document): LinkState | null {
    const { view, session } = this.#store.state;
    const state = { document, view, session: { ...session, lesson: null } };
    return stateFromFragment(stateToFragment(document.shot, state));
  }
}

/**
 * Checks what the page shows of a work, and the levels and errors of its other states, whose shots are
 * checked when undo or redo comes to them.
 *
 * @throws CaromError if the engine or the referee refuses it.
 */
function* checkWork(
  engine: Engine,
  { steps: { steps, at }, practice }: Pick<Work, "steps"> & Partial<Pick<Work, "practice">>,
): Slices<true> {
  for (const { state } of steps) {
    if (state.noise) engine.checkNoise(state.noise);
    if (state.game) checkedGame(engine, state.game);
    if (state.study) checkedGame(engine, state.study.game);
  }
  yield* checkDocument(engine, steps[at]!.state);
  if (practice?.before) yield* checkDocument(engine, practice.before);
  return true;
}

/** Which works the tab had before it was loaded again. */
function takeOpen(): {
  readonly kind: Kind | null;
  readonly own: Readonly<Partial<Record<Kind, string>>>;
} {
  try {
    const data = JSON.parse(sessionStorage.getItem(OPEN) ?? "null") as Record<string, unknown>;
    sessionStorage.removeItem(OPEN);
    const kind = KINDS.find((name) => name === data.kind) ?? null;
    const ids = data.own as Record<string, unknown>;
    const own = KINDS.flatMap((name) => {
      const id = ids[name];
      return typeof id === "string" ? [[name, id] as const] : [];
    });
    return { kind, own: Object.fromEntries(own) };
  } catch {
    // Nothing was stored, or something else.
    return { kind: null, own: {} };
  }
}
