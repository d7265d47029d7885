/**
 * Documents as plain values that have every part a single time: the states of a history share most of theirs.
 * A document has the indices of its parts in lists.
 */

import type { BallEntry, Noise, ShotFile } from "../../engine/index.ts";
import { MOST_SAMPLES } from "../../engine/types.ts";
import type { AimedShot, Document } from "../document/document.ts";
import type { Filmed } from "../document/filmed.ts";
import type { Game, MatchNotes, Move, Setup } from "../document/stored-game.ts";
import { LONGEST_COMMENT, MOST_NODES, type Tree, type TreeNode } from "../document/shot-tree.ts";
import { gameOf, noiseOf, seedOf } from "../share/link-state.ts";
import { LinkError } from "../share/link.ts";
import {
  check,
  type Entries,
  entriesAt,
  KeptFault,
  listAt,
  textAt,
  wholeAt,
} from "./kept-fault.ts";

/** The most entries of a list: far beyond what a history has. */
const MOST = 1_000_000;
const MOST_BALLS = 128;
/** Longest id of a game, a work or a ball. */
const LONGEST_ID = 200;
const LARGEST_ID = Number.MAX_SAFE_INTEGER;

type KeptShot = Omit<AimedShot, "balls"> & { readonly balls: number };
type KeptGame = Omit<Game, "setup" | "moves" | "notes"> & {
  readonly setup: number;
  readonly moves: readonly number[];
  readonly notes?: number | undefined;
};

/** A document by the indices of its parts. */
export interface KeptDocument {
  readonly shot: number;
  readonly noise: Noise | null;
  readonly seed: number;
  readonly game: number | null;
  readonly tree?: number;
  readonly study?: {
    readonly game: number;
    readonly move: number;
    readonly shot: number;
    readonly tree?: number;
  };
  readonly filmed?: number;
}

/** The parts of documents, each of them once. */
export interface KeptParts {
  readonly balls: readonly (readonly BallEntry[])[];
  readonly shots: readonly KeptShot[];
  /** Set-ups of games, each with the id of the game. */
  readonly setups: readonly { readonly id: string; readonly setup: Setup }[];
  readonly moves: readonly Move[];
  readonly notes: readonly MatchNotes[];
  readonly games: readonly KeptGame[];
  readonly nodes: readonly (Omit<TreeNode, "shot"> & { readonly shot: number })[];
  readonly trees: readonly { readonly nodes: readonly number[]; readonly at: number | null }[];
  readonly films: readonly (Omit<Filmed, "balls"> & { readonly balls: number })[];
}

export const PARTS: readonly (keyof KeptParts)[] = [
  "balls",
  "shots",
  "setups",
  "moves",
  "notes",
  "games",
  "nodes",
  "trees",
  "films",
];

/** Gives each value an index; a value that is there already keeps its own. */
class Pool<T extends object, K> {
  readonly items: K[] = [];
  readonly #indices = new Map<T, number>();
  readonly #write: (value: T) => K;

  constructor(write: (value: T) => K) {
    this.#write = write;
  }

  indexOf(value: T): number {
    const known = this.#indices.get(value);
    if (known !== undefined) return known;
    const item = this.#write(value);
    const index = this.items.push(item) - 1;
    this.#indices.set(value, index);
    return index;
  }
}

/** Takes documents apart. */
export class Packer {
  readonly #balls = new Pool((balls: readonly BallEntry[]) => balls);
  // The keys keep their order, so that the shot has the same text again.
  readonly #shots = new Pool((shot: AimedShot): KeptShot => ({
    ...shot,
    balls: this.#balls.indexOf(shot.balls),
  }));
  readonly #setups: Pool<Setup, KeptParts["setups"][number]>;
  readonly #moves = new Pool((move: Move) => move);
  readonly #notes = new Pool((notes: MatchNotes) => notes);
  readonly #games = new Pool((game: Game): KeptGame => {
    const { setup, moves, notes } = game;
    const parts = {
      setup: this.#setups.indexOf(setup),
      moves: moves.map((move) => this.#moves.indexOf(move)),
    };
    return { ...game, ...parts, notes: notes && this.#notes.indexOf(notes) };
  });
  readonly #nodes = new Pool(({ shot, ...node }: TreeNode) => ({
    ...node,
    shot: this.#shots.indexOf(shot),
  }));
  readonly #trees = new Pool(({ nodes, at }: Tree) => ({
    nodes: nodes.map((node) => this.#nodes.indexOf(node)),
    at,
  }));
  readonly #films = new Pool(({ balls, track }: Filmed) => ({
    track,
    balls: this.#balls.indexOf(balls),
  }));

  /** @param idOf The id of the game with a set-up. */
  constructor(idOf: (setup: Setup) => string) {
    this.#setups = new Pool((setup: Setup) => ({ id: idOf(setup), setup }));
  }

  document({ shot, noise, seed, game, tree, study, filmed }: Document): KeptDocument {
    const treeOf = (one: Tree | undefined) => (one ? { tree: this.#trees.indexOf(one) } : {});
    return {
      shot: this.#shots.indexOf(shot),
      noise,
      seed,
      game: game && this.#games.indexOf(game),
      ...treeOf(tree),
      ...(study && {
        study: {
          game: this.#games.indexOf(study.game),
          move: study.move,
          shot: this.#shots.indexOf(study.shot),
          ...treeOf(study.tree),
        },
      }),
      ...(filmed && { filmed: this.#films.indexOf(filmed) }),
    };
  }

  get parts(): KeptParts {
    return {
      balls: this.#balls.items,
      shots: this.#shots.items,
      setups: this.#setups.items,
      moves: this.#moves.items,
      notes: this.#notes.items,
      games: this.#games.items,
      nodes: this.#nodes.items,
      trees: this.#trees.items,
      films: this.#films.items,
    };
  }
}

/**
 * Puts documents together again. The structure of everything is checked; shots, noises and games still need
 * the engine's check.
 */
export class Unpacker {
  readonly #place: string;
  readonly #shots: readonly AimedShot[];
  readonly #games: readonly Game[];
  readonly #trees: readonly Tree[];
  readonly #films: readonly Filmed[];

  /**
   * @param seen Called with each set-up and the id of its game.
   * @throws {KeptFault} A part is damaged.
   */
  constructor(data: Entries, place: string, seen: (setup: Setup, id: string) => void) {
    this.#place = place;
    const list = <T>(key: keyof KeptParts, read: (item: unknown, at: string) => T) =>
      listAt(data[key], `${place}.${key}`, MOST, read);
    const balls = list("balls", ballsAt);
    const shots = (this.#shots = list("shots", (item, at) => shotAt(item, at, balls)));
    const setups = list("setups", setupAt);
    // The games that have them check them.
    const moves = list("moves", (item) => item as Move);
    const notes = list("notes", (item) => item as MatchNotes);
    this.#games = list("games", (item, at) => gameAt(item, at, { setups, moves, notes }));
    for (const { id, setup } of setups) seen(setup, id);
    const nodes = list("nodes", (item, at) => nodeAt(item, at, shots));
    this.#trees = list("trees", (item, at) => treeAt(item, at, nodes));
    this.#films = list("films", (item, at) => filmAt(item, at, balls));
  }

  /** The document with these indices; `more` names further keys of theirs. */
  document(data: unknown, place: string, more: readonly string[] = []): Document {
    const keys = ["shot", "noise", "seed", "game", ...more];
    const { shot, noise, seed, game, tree, study, filmed } = entriesAt(data, place, keys, [
      "tree",
      "study",
      "filmed",
    ]);
    return {
      shot: one(this.#shots, shot, `${place}.shot`),
      noise: linked(`${place}.noise`, () => noiseOf(noise)),
      seed: linked(`${place}.seed`, () => seedOf(seed)),
      game: game === null ? null : one(this.#games, game, `${place}.game`),
      tree: this.#tree(tree, `${place}.tree`),
      study: study === undefined ? undefined : this.#study(study, `${place}.study`),
      filmed: filmed === undefined ? undefined : one(this.#films, filmed, `${place}.filmed`),
    };
  }

  #study(data: unknown, place: string): Document["study"] {
    const { game, move, shot, tree } = entriesAt(data, place, ["game", "move", "shot"], ["tree"]);
    const of = one(this.#games, game, `${place}.game`);
    return {
      game: of,
      move: wholeAt(move, `${place}.move`, 0, of.moves.length - 1),
      shot: one(this.#shots, shot, `${place}.shot`),
      tree: this.#tree(tree, `${place}.tree`),
    };
  }

  #tree(data: unknown, place: string): Tree | undefined {
    return data === undefined ? undefined : one(this.#trees, data, place);
  }

  get place(): string {
    return this.#place;
  }
}

/** The item of a list with an index. */
function one<T>(list: readonly T[], index: unknown, place: string): T {
  return list[wholeAt(index, place, 0, list.length - 1)]!;
}

/** What a reader of links gives, which refuses in its own way. */
function linked<T>(place: string, read: () => T): T {
  try {
    return read();
  } catch (error) {
    if (error instanceof LinkError) throw new KeptFault(place);
    throw error;
  }
}

function isObject(data: unknown): data is Entries {
  return typeof data === "object" && data !== null && !Array.isArray(data);
}

const isNumber = (value: unknown) => typeof value === "number" && Number.isFinite(value);

/** Balls of a shot file. The engine checks their other keys. */
function ballsAt(data: unknown, place: string): readonly BallEntry[] {
  return listAt(data, place, MOST_BALLS, (ball, at) => {
    check(isObject(ball), at);
    textAt(ball.id, `${at}.id`, LONGEST_ID);
    const { position } = ball;
    check(Array.isArray(position) && position.length >= 2, `${at}.position`);
    check(position.length <= 3 && position.every(isNumber), `${at}.position`);
    return ball as unknown as BallEntry;
  });
}

/** A shot file with its balls. The engine checks its other keys. */
function shotAt(data: unknown, place: string, balls: readonly (readonly BallEntry[])[]): AimedShot {
  check(isObject(data) && isObject(data.strike), place);
  textAt(data.strike.ball, `${place}.strike.ball`, LONGEST_ID);
  check(isNumber(data.strike.speed), `${place}.strike.speed`);
  return { ...(data as unknown as AimedShot), balls: one(balls, data.balls, `${place}.balls`) };
}

function setupAt(data: unknown, place: string): { id: string; setup: Setup } {
  const { id, setup } = entriesAt(data, place, ["id", "setup"]);
  check(isObject(setup), `${place}.setup`);
  return { id: textAt(id, `${place}.id`, LONGEST_ID), setup: setup as unknown as Setup };
}

/** A game with its parts, whose structure is checked as that of a link. */
function gameAt(
  data: unknown,
  place: string,
  parts: {
    readonly setups: readonly { readonly setup: Setup }[];
    readonly moves: readonly Move[];
    readonly notes: readonly MatchNotes[];
  },
): Game {
  const keys = ["setup", "moves", "call"];
  const { setup, moves, notes, ...game } = entriesAt(data, place, keys, [
    "here",
    "extended",
    "variations",
    "notes",
  ]);
  const whole = {
    ...game,
    setup: one(parts.setups, setup, `${place}.setup`).setup,
    moves: listAt(moves, `${place}.moves`, MOST, (index, at) => one(parts.moves, index, at)),
    ...(notes !== undefined && { notes: one(parts.notes, notes, `${place}.notes`) }),
  };
  const read = linked(place, () => gameOf(whole));
  check(read !== null, place);
  return read;
}

function nodeAt(data: unknown, place: string, shots: readonly AimedShot[]): TreeNode {
  const node = entriesAt(data, place, ["id", "parent", "shot", "comment"]);
  const { parent } = node;
  return {
    id: wholeAt(node.id, `${place}.id`, 0, LARGEST_ID),
    parent: parent === null ? null : wholeAt(parent, `${place}.parent`, 0, LARGEST_ID),
    shot: one(shots, node.shot, `${place}.shot`),
    comment: textAt(node.comment, `${place}.comment`, LONGEST_COMMENT),
  };
}

/** A tree in which every parent is before its children, so that there is no circle. */
function treeAt(data: unknown, place: string, nodes: readonly TreeNode[]): Tree {
  const { nodes: indices, at } = entriesAt(data, place, ["nodes", "at"]);
  const ids = new Set<number>();
  const list = listAt(indices, `${place}.nodes`, MOST_NODES, (index, where) => {
    const node = one(nodes, index, where);
    check(!ids.has(node.id) && (node.parent === null || ids.has(node.parent)), where);
    ids.add(node.id);
    return node;
  });
  check(at === null || (typeof at === "number" && ids.has(at)), `${place}.at`);
  return { nodes: list, at };
}

function filmAt(data: unknown, place: string, balls: readonly (readonly BallEntry[])[]): Filmed {
  const { track, balls: index } = entriesAt(data, place, ["track", "balls"]);
  const films = listAt(track, `${place}.track`, MOST_BALLS, (item, at) => {
    const { ball, samples } = entriesAt(item, at, ["ball", "samples"]);
    check(Array.isArray(samples) && samples.length > 0, `${at}.samples`);
    const read = listAt(samples, `${at}.samples`, MOST_SAMPLES, (sample, where) => {
      check(Array.isArray(sample) && sample.length === 3 && sample.every(isNumber), where);
      return sample as unknown as NonNullable<ShotFile["track"]>[number]["samples"][number];
    });
    return { ball: textAt(ball, `${at}.ball`, LONGEST_ID), samples: read };
  });
  return { balls: one(balls, index, `${place}.balls`), track: films };
}
