/** The address bar: it follows the document, and a link that is entered there is opened. */

import { CaromError, type Engine, type Shot } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { detailedText, PageError } from "../common/refusals.ts";
import type { Slices } from "../common/slices.ts";
import type { Document, View } from "../document/document.ts";
import { positionOf } from "../document/lesson.ts";
import type { Lesson } from "../document/open-study.ts";
import { splitFilm } from "../document/filmed.ts";
import { aimed, ballsOf } from "../document/shot-file.ts";
import { treeEngine } from "../document/balls-after.ts";
import type { Tree } from "../document/shot-tree.ts";
import { datedTree, treeReading } from "../document/tree-text.ts";
import type { Game, Setup } from "../document/stored-game.ts";
import type { State, Store } from "../document/store.ts";
import { isLevel } from "../game/machine/machine-levels.ts";
import { replayed } from "../game/game-progress.ts";
import { standing } from "../game/awaited-turn.ts";
import { referee } from "../game/referee.ts";
import { replay } from "../replay/replay-control.ts";
import { LinkError } from "./link.ts";
import {
  type LinkLesson,
  type LinkState,
  stateFromFragment,
  stateToFragment,
} from "./link-state.ts";
import { toJson } from "./literal.ts";
import { t } from "../words/translate.ts";

/**
 * Time (ms) without a change after which the address is updated. Browsers allow about a hundred
 * updates in half a minute.
 */
const REST = 400;

/** The contents of a link, accepted by the engine. */
export interface LinkContents {
  readonly document: Document;
  readonly view: View;
  /** Time of the replay (s) that the link shows; null if it shows none. */
  readonly time: number | null;
  /** The study that is open; null: none. */
  readonly lesson: Lesson | null;
}

/**
 * The contents of the link in the page's address; null if the address has none.
 *
 * @throws {LinkError} The link is damaged, of another version, or refused by the engine.
 */
export function readAddress(engine: Engine): Slices<LinkContents | null> {
  return readLink(engine, location.hash);
}

/**
 * The contents of the link in a fragment; null if it is not a link. A slice has one shot of a game or tree.
 *
 * @throws {LinkError} The link is damaged, of another version, or refused by the engine.
 */
export function* readLink(engine: Engine, fragment: string): Slices<LinkContents | null> {
  let state: LinkState | null = null;
  try {
    state = stateFromFragment(fragment);
    return state && (yield* checked(engine, state));
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    const why = detailedText(error, ballsOf(state?.shot.balls));
    throw new LinkError(t("link.refused", { why }), { cause: error });
  }
}

/** @throws CaromError if the engine or the referee refuses a part of the state. */
function* checked(engine: Engine, state: LinkState): Slices<LinkContents> {
  const { shot, noise, seed, game, view, time } = state;
  if (state.lesson) return ofLesson(engine, state.lesson, view);
  engine.shot(shot).free();
  function* treeOf(text: string | null): Slices<Tree | undefined> {
    return text === null ? undefined : yield* treeReading(text, treeEngine(engine));
  }
  const document = {
    ...splitFilm(aimed(shot)),
    noise,
    seed,
    game,
    tree: yield* treeOf(state.tree),
    study: state.study
      ? {
          ...state.study,
          shot: aimed(state.study.shot),
          tree: yield* treeOf(state.study.tree),
        }
      : undefined,
  };
  yield* checkDocument(engine, document);
  return { document, view, time, lesson: null };
}

/** @throws CaromError if the study is damaged. */
function ofLesson(engine: Engine, { study: data, chapter: index, id }: LinkLesson, view: View) {
  const study = engine.study(toJson(data));
  const chapter = Math.min(index, study.chapters.length - 1);
  const position = positionOf(study.chapters[chapter]!, treeEngine(engine).endOf);
  const document = { ...position, noise: null, seed: 0, game: null };
  return { document, view, time: null, lesson: { study, chapter, id } };
}

/**
 * Checks a document that comes from outside. A slice has one shot of its game.
 *
 * @throws CaromError if the engine or the referee refuses a part of it.
 */
export function* checkDocument(engine: Engine, document: Document): Slices<void> {
  const { shot, noise, game, study } = document;
  if (noise) engine.checkNoise(noise);
  for (const part of [{ shot, game }, ...(study ? [study] : [])]) {
    if (part.game) yield* replayed(engine, checkedGame(engine, part.game));
    referee(engine).shot(part.shot, part.game).free();
  }
}

/** @throws CaromError if there is no such level of play. */
export function checkedGame(engine: Engine, game: Game): Game {
  for (const skill of game.setup.skills) {
    if (skill === null || Object.hasOwn(engine.noisePresets, skill)) continue;
    throw new PageError(t("refused.level", { level: skill }), "game.setup.skills");
  }
  for (const level of game.setup.machines ?? []) {
    if (level === null || isLevel(level)) continue;
    throw new PageError(t("refused.level", { level }), "game.setup.machines");
  }
  return game;
}

/**
 * The page's address with its present state; null where the page has no address to share.
 *
 * @param state What to share in place of the present state; its shot is the present one.
 */
export function link(store: Store, engine: Engine, state: State = store.state): string | null {
  if (location.protocol === "about:") return null;
  return location.href.replace(/#.*$/s, "") + linkText(store, engine, state);
}

/** Whether the page is a file on this device, so that its address means nothing elsewhere. */
export function isLocal(): boolean {
  return location.protocol === "file:";
}

/** The host of this page, if only this computer reaches it; null otherwise. */
export function ownHost({
  protocol,
  hostname,
}: Pick<Location, "protocol" | "hostname"> = location) {
  if (protocol !== "http:" && protocol !== "https:") return null;
  const isOwn =
    hostname === "localhost" ||
    hostname.endsWith(".localhost") ||
    hostname.startsWith("127.") ||
    hostname === "0.0.0.0" ||
    hostname === "[::1]";
  return isOwn ? hostname : null;
}

/** What a link carries, as text: any carom page opens it. */
export function linkText(store: Store, engine: Engine, state: State = store.state): string {
  return fragment(engine, store.shot, state);
}

/** The fragment for a state. Presets have dated names, so that the link keeps their values. */
function fragment(engine: Engine, shot: Shot, state: State): string {
  const { game, tree, study } = state.document;
  const datedGame = <G extends Game | null>(one: G) =>
    one && { ...one, setup: datedSetup(engine, one.setup) };
  const ofTree = (one: Tree | undefined) => one && datedTree(engine, one);
  const document = {
    ...state.document,
    game: datedGame(game),
    tree: ofTree(tree),
    study: study && {
      ...study,
      game: datedGame(study.game),
      shot: engine.withDatedNames(study.shot),
      tree: ofTree(study.tree),
    },
  };
  const { lesson } = state.session;
  // The id names the study in the library of this browser alone.
  const session = { ...state.session, lesson: lesson && { ...lesson, id: null } };
  return stateToFragment(engine.withDatedNames(shot.file), { ...state, document, session });
}

function datedSetup(engine: Engine, setup: Setup): Setup {
  if (setup.from) return { ...setup, from: engine.withDatedNames(setup.from) };
  const { table = engine.usualTable(setup.rules), physics } = setup.options;
  const named = engine.withDatedNames({ table, ...(physics !== undefined && { physics }) });
  return { ...setup, options: { ...setup.options, ...named } };
}

/**
 * Updates the address after each change. A link that was refused stays until the first change.
 *
 * @returns Updates it at once.
 */
export function mountAddress(store: Store, context: Context): () => void {
  let written = "";
  let resting: ReturnType<typeof setTimeout> | undefined;
  const write = (): void => {
    clearTimeout(resting);
    resting = undefined;
    const aiming = { ...store.state, session: { ...store.session, mode: "aim" as const } };
    try {
      // Replaced, not pushed: the page has its own undo.
      history.replaceState(history.state, "", fragment(context.engine, store.shot, aiming));
      written = location.hash;
    } catch {
      // In a notebook or another page's frame the address cannot be changed.
    }
  };
  store.subscribe((now, before) => {
    const isSame = now.document === before.document && now.view === before.view;
    if (isSame && now.session.lesson === before.session.lesson) return;
    clearTimeout(resting);
    resting = setTimeout(write, REST);
  });
  addEventListener("pagehide", () => {
    if (resting !== undefined) write();
  });
  addEventListener("hashchange", () => {
    if (location.hash === written) return;
    clearTimeout(resting);
    resting = undefined;
    void openText(store, context, location.hash);
  });
  return write;
}

/** Opens the text of a link. A damaged one changes nothing. */
export async function openText(store: Store, context: Context, link: string): Promise<void> {
  try {
    const contents = await store.open(readLink(context.engine, link));
    if (contents) openLink(store, context, contents);
  } catch (error) {
    if (!(error instanceof LinkError)) throw error;
    store.refuse(error.message);
  }
}

/** Opens a link in the page as it stands, so that undo returns to the previous document. */
function openLink(store: Store, context: Context, contents: LinkContents): void {
  const { document, view, time, lesson } = contents;
  if (!store.apply(document, t("change.open-link"))) return;
  store.setView(view);
  store.setSession({ lesson, ...(lesson && { activity: "library" }) });
  showTime(store, context.engine, time);
  context.announce(t("open.link-opened"));
}

/** Shows the replay at the time (s) that a link carries. */
export function showTime(store: Store, engine: Engine, time: number | null): void {
  // In a game the link was made while its last shot was replayed.
  const trace = store.document.game ? standing(store, engine)?.trace : store.ghost.trace;
  if (time !== null && trace) replay(store, trace, Math.min(time, trace.duration), false);
}
