/** The contents of a link: the document, the view, and the time of a replay. */

import { CaromError, type Noise, type ShotFile } from "../../engine/index.ts";
import { withNewKeys } from "../../engine/noise.ts";
import { FIRST_VIEW, type View } from "../document/document.ts";
import { type Game, GUIDES, LONGEST_NAME } from "../document/stored-game.ts";
import type { State } from "../document/store.ts";
import { LONGEST_RACE } from "../game/match/race.ts";
import { fromFragment, isLink, isTooLong, LinkError, toFragment } from "./link.ts";
import { MOST_CHAPTERS } from "../document/lesson.ts";
import type { Lesson } from "../document/open-study.ts";
import type { Tree } from "../document/shot-tree.ts";
import { treeToText } from "../document/tree-text.ts";
import { refusalText } from "../common/refusals.ts";
import { t } from "../words/translate.ts";

/** The state in a link. Its structure is checked; shot, noise and game still need the engine's check. */
export interface LinkState {
  readonly shot: ShotFile;
  readonly noise: Noise | null;
  readonly seed: number;
  readonly game: Game | null;
  /** The tree of the analysis as text; null: none. */
  readonly tree: string | null;
  /** The shot of a game that is analysed; null: none. */
  readonly study: LinkStudy | null;
  /** The study in chapters that is open; its shots take the place of all the others. */
  readonly lesson: LinkLesson | null;
  readonly view: View;
  /** Time of the replay (s); null while aiming. */
  readonly time: number | null;
}

/** The analysis of a shot of a game, as in the document, with its tree as text. */
export interface LinkStudy {
  readonly game: Game;
  readonly move: number;
  readonly shot: ShotFile;
  readonly tree: string | null;
}

/** A study that the engine has not checked, and the chapter that is shown. */
export interface LinkLesson {
  readonly study: unknown;
  readonly chapter: number;
  readonly id: string | null;
}

/** The settings of a view; a link leaves out the first choice of each. */
const CHOICES: { readonly [K in keyof View]: readonly View[K][] } = {
  theme: ["auto", "light", "dark"],
  camera: ["top", "orbit", "cue"],
  units: ["m/s", "km/h", "mph"],
};

/** What the noise of a link without these keys has: links of older versions have no cling. */
const CLING = { cling_probability: 0, cling_friction: 0.22 } as const;

const NOISE: readonly (keyof Noise)[] = [
  "speed",
  "azimuth",
  "elevation",
  "side_m",
  "height_m",
  "cling_probability",
  "cling_friction",
];

const STRIKE = ["speed", "azimuth", "elevation", "side", "height"] as const;

/** Kinds of calls, as the engine has them. */
const CALLS: readonly unknown[] = ["pocket", "on", "safety", "push-out"];

/** The longest text of a study, in characters, for which a link is tried: it would be too long. */
const LONGEST_STUDY = 500_000;

/** The most moves of a game that a link may have: the page replays them all when it opens. */
const MOST_MOVES = 2000;

/**
 * The link's fragment, with its `#`.
 *
 * @param shot The shot as the engine has it, which may differ from the document's by a rounding.
 */
export function stateToFragment(shot: ShotFile, { document, view, session }: State): string {
  return (
    lessonToFragment(session.lesson, view) ??
    toFragment({
      shot,
      ...(document.noise && { noise: document.noise }),
      ...(document.seed !== 0 && { seed: document.seed }),
      ...(document.game && { game: document.game }),
      ...treeText(document.tree),
      ...(document.study && {
        study: { ...document.study, tree: null, ...treeText(document.study.tree) },
      }),
      ...viewPart(view),
      ...(session.mode === "replay" && { time: session.replay.time }),
    })
  );
}

/** The fragment for an open study; null without one, and if it is too long for a link. */
export function lessonToFragment(lesson: Lesson | null, view: View): string | null {
  if (!lesson || JSON.stringify(lesson.study).length > LONGEST_STUDY) return null;
  const fragment = toFragment({ lesson, ...viewPart(view) });
  return isTooLong(fragment) ? null : fragment;
}

/** The settings of a view that are not the first ones. */
function viewPart(view: View): { readonly view?: Partial<View> } {
  const keys = Object.keys(CHOICES) as (keyof View)[];
  const changed = keys.filter((key) => view[key] !== FIRST_VIEW[key]);
  if (changed.length === 0) return {};
  return { view: Object.fromEntries(changed.map((key) => [key, view[key]])) };
}

function treeText(tree: Tree | undefined): { readonly tree?: string } {
  return tree && tree.nodes.length > 0 ? { tree: treeToText(tree) } : {};
}

/**
 * The state that a fragment carries; null if it is not a link.
 *
 * @throws {LinkError} The link is damaged, of another version, or has a part that cannot be read.
 */
export function stateFromFragment(fragment: string): LinkState | null {
  if (!isLink(fragment)) return null;
  const data = fromFragment(fragment);
  const lesson = isRecord(data) ? lessonOf(data.lesson) : null;
  if (!isRecord(data) || !(lesson || isRecord(data.shot))) {
    throw new LinkError(t("link.no-shot"));
  }
  return {
    shot: lesson ? NO_SHOT : (data.shot as ShotFile),
    noise: noiseOf(data.noise),
    seed: seedOf(data.seed),
    game: gameOf(data.game),
    tree: treeOf(data.tree),
    study: studyOf(data.study),
    lesson,
    view: viewOf(data.view),
    time: timeOf(data.time),
  };
}

/** A part of a link that cannot be read. */
function broken(place: string, found: unknown, remedy: string): LinkError {
  const [kind, value] =
    found === undefined
      ? (["missing", "nothing"] as const)
      : (["wrong-type", JSON.stringify(found)] as const);
  const message = `${place}: found ${value}; ${remedy}`;
  const why = refusalText(new CaromError({ kind, place, fault: value, remedy, message }));
  return new LinkError(t("link.refused", { why }));
}

export function noiseOf(data: unknown): Noise | null {
  if (data === undefined || data === null) return null;
  if (!isRecord(data)) throw broken("noise", data, "write an object with five standard deviations");
  const value: Readonly<Record<string, unknown>> = { ...CLING, ...withNewKeys(data).value };
  const entries = NOISE.map((key) => {
    const number = value[key];
    if (typeof number !== "number") throw broken(`noise.${key}`, number, "write a number");
    return [key, number] as const;
  });
  return Object.fromEntries(entries) as unknown as Noise;
}

export function seedOf(seed: unknown = 0): number {
  if (typeof seed === "number" && Number.isSafeInteger(seed) && seed >= 0) return seed;
  throw broken("seed", seed, `write a whole number from 0 to ${Number.MAX_SAFE_INTEGER}`);
}

function timeOf(time: unknown = null): number | null {
  if (time === null || (typeof time === "number" && time >= 0)) return time;
  throw broken("time", time, "write a time of the replay in seconds, at least 0");
}

function treeOf(tree: unknown = null): string | null {
  if (tree === null || isText(tree)) return tree;
  throw broken("tree", tree, "write a tree as text");
}

function studyOf(data: unknown): LinkStudy | null {
  if (data === undefined) return null;
  if (isRecord(data) && isRecord(data.shot)) {
    const game = gameOf(data.game);
    const { move, shot } = data;
    if (game && isWhole(move, 0, game.moves.length - 1)) {
      return {
        game,
        move: move as number,
        shot: shot as unknown as ShotFile,
        tree: treeOf(data.tree),
      };
    }
  }
  throw new LinkError(t("link.game"));
}

const NO_SHOT: ShotFile = { format: "carom-shot/1", table: "", balls: [] };

function lessonOf(data: unknown): LinkLesson | null {
  if (data === undefined) return null;
  if (isRecord(data) && isWhole(data.chapter, 0, MOST_CHAPTERS - 1)) {
    const { study, chapter, id = null } = data;
    if (isRecord(study) && (id === null || isText(id))) {
      return { study, chapter: chapter as number, id };
    }
  }
  throw broken("lesson", data, "write a study and the number of a chapter");
}

function isVariations(data: unknown, moves: number): boolean {
  return (
    isRecord(data) &&
    Object.entries(data).every(
      ([move, tree]) => isWhole(Number(move), 0, moves - 1) && isText(tree),
    )
  );
}

/** Checks a game's structure; the referee checks whether its moves are allowed. */
export function gameOf(data: unknown): Game | null {
  if (data === undefined || data === null) return null;
  const isPair = (value: unknown, type: (one: unknown) => boolean) =>
    Array.isArray(value) && value.length === 2 && value.every(type);
  const isName = (value: unknown) => isText(value) && value.length <= LONGEST_NAME;
  if (isRecord(data) && isRecord(data.setup) && Array.isArray(data.moves)) {
    const { rules, options, from, names, skills, machines, guide, race, clock } = data.setup;
    if (data.moves.length > MOST_MOVES) {
      throw new LinkError(t("link.moves", { moves: data.moves.length, most: MOST_MOVES }));
    }
    const isSound =
      isText(rules) &&
      isRecord(options) &&
      (from === null || isRecord(from)) &&
      isPair(names, isName) &&
      isPair(skills, (skill) => skill === null || isText(skill)) &&
      (machines === undefined || isPair(machines, (level) => level === null || isText(level))) &&
      (guide === undefined || (GUIDES as readonly unknown[]).includes(guide)) &&
      (race === undefined || isRace(race)) &&
      (clock === undefined || isWhole(clock, 5, 600)) &&
      (data.extended === undefined || isPair(data.extended, (used) => typeof used === "boolean")) &&
      (data.variations === undefined || isVariations(data.variations, data.moves.length)) &&
      (data.notes === undefined || isNotes(data.notes)) &&
      (data.here === undefined || data.here === 0 || data.here === 1) &&
      (data.call === null || isCall(data.call)) &&
      data.moves.every(isMove);
    if (isSound) return data as unknown as Game;
  }
  throw new LinkError(t("link.game"));
}

/** Whether this is what a match has beside its game. The engine reads the intended shots. */
function isNotes(notes: unknown): boolean {
  if (!isRecord(notes) || !Array.isArray(notes.moves)) return false;
  const { frame, end } = notes;
  const isEnd = end === undefined || (isRecord(end) && isText(end.reason) && isText(end.why));
  return isEnd && isWhole(frame, 0, Number.MAX_SAFE_INTEGER) && notes.moves.every(isNote);
}

function isNote(note: unknown): boolean {
  if (!isRecord(note)) return false;
  const { seat, index, play, chance, luck, refused, lost } = note;
  const isStrike = (strike: unknown) =>
    isRecord(strike) && STRIKE.every((key) => typeof strike[key] === "number");
  const isPlay = isRecord(play) && isStrike(play.strike);
  const isLuck =
    Array.isArray(luck) && luck.length === 3 && luck.every((one) => typeof one === "number");
  return (
    (seat === 0 || seat === 1) &&
    (index === undefined || isWhole(index, 0, MOST_MOVES)) &&
    (play === undefined || (isPlay && (play.call === undefined || isCall(play.call)))) &&
    (chance === undefined || typeof chance === "number") &&
    (luck === undefined || isLuck) &&
    [refused, lost].every((text) => text === undefined || isText(text))
  );
}

function isRace(race: unknown): boolean {
  if (!isRecord(race)) return false;
  const { to, breaks, won, turned } = race;
  return (
    isWhole(to, 1, LONGEST_RACE) &&
    (breaks === "alternate" || breaks === "winner") &&
    Array.isArray(won) &&
    won.length === 2 &&
    won.every((frames) => isWhole(frames, 0, LONGEST_RACE)) &&
    typeof turned === "boolean"
  );
}

export function isWhole(value: unknown, least: number, most: number): boolean {
  return Number.isInteger(value) && (value as number) >= least && (value as number) <= most;
}

function isMove(move: unknown): boolean {
  if (!isRecord(move)) return false;
  const { choice, concede, play } = move;
  if (isText(choice) || concede === true) return true;
  return isRecord(play) && isRecord(play.strike) && (play.call === undefined || isCall(play.call));
}

function isCall(call: unknown): boolean {
  const isOptionalText = (value: unknown) => value === undefined || isText(value);
  if (!isRecord(call) || !CALLS.includes(call.kind)) return false;
  if (call.kind === "on" && !isText(call.ball)) return false;
  return isOptionalText(call.ball) && isOptionalText(call.into);
}

/** Unknown choices of a view become the first ones: a link of a newer page still opens. */
function viewOf(data: unknown): View {
  if (!isRecord(data)) return FIRST_VIEW;
  const known = Object.entries(CHOICES).filter(([key, choices]) =>
    (choices as readonly unknown[]).includes(data[key]),
  );
  return { ...FIRST_VIEW, ...Object.fromEntries(known.map(([key]) => [key, data[key]])) };
}

function isText(value: unknown): value is string {
  return typeof value === "string";
}

export function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
