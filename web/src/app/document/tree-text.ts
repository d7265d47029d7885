/**
 * Trees of shots as text, in the manner of chess games: `tree/1` (docs/analysis.md).
 *
 *     [Carom "tree/1"]
 *     [Layout {"format": "carom-shot/1", "table": "wpa-9ft", "balls": […]}]
 *     1. "cue" speed=2 azimuth_deg=66.8 {a comment}
 *     ( 1. "cue" speed=3 azimuth_deg=66.8 )
 *     2. "cue" speed=1 azimuth_deg=140
 *
 * The layout of a later shot is the end of the one before, which the engine computes. Numbers are written
 * so that they read back to the same bits.
 */

import type { BallEntry, Engine, ShotFile, StrikeEntry } from "../../engine/index.ts";
import { PageError } from "../common/refusals.ts";
import type { Slices } from "../common/slices.ts";
import { t } from "../words/translate.ts";
import type { AimedShot } from "./aimed-shot.ts";
import { STRIKE_NUMBERS } from "./strike-angles.ts";
import { childrenOf, LONGEST_COMMENT, MOST_NODES, type Tree, type TreeNode } from "./shot-tree.ts";

const FORMAT = "tree/1";

const POLICIES = ["obstruction", "miscue"] as const;

/** Whether a text is, or should be, a tree. */
export function isTreeText(text: string): boolean {
  return /^\s*\[Carom\b/.test(text);
}

/** The tree as text; the shot that is visited is marked with `*`. */
export function treeToText(tree: Tree): string {
  const parts = [`[Carom "${FORMAT}"]`];
  const roots = childrenOf(tree, null);
  for (const [layout, nodes] of byLayout(roots)) {
    parts.push(`[Layout ${layout}]`, line(tree, nodes, 1));
  }
  return `${parts.join("\n")}\n`;
}

/** The tree with dated names of presets, so that its text keeps their values. */
export function datedTree(engine: Pick<Engine, "withDatedNames">, tree: Tree): Tree {
  // Hundreds of first shots can have one layout, for which the engine is asked once.
  const known = new Map<string, AimedShot>();
  const datedShot = (shot: AimedShot): AimedShot => {
    const layout = JSON.stringify({ ...shot, strike: undefined });
    const found = known.get(layout) ?? engine.withDatedNames(shot);
    known.set(layout, found);
    return { ...found, strike: shot.strike };
  };
  // Later shots have the table of the first one.
  const dated = (node: TreeNode) =>
    node.parent === null ? { ...node, shot: datedShot(node.shot) } : node;
  return { ...tree, nodes: tree.nodes.map(dated) };
}

/** First shots by their layouts, which are written once each. */
function byLayout(roots: readonly TreeNode[]): Map<string, TreeNode[]> {
  const found = new Map<string, TreeNode[]>();
  for (const root of roots) {
    const layout = JSON.stringify({ ...root.shot, strike: undefined });
    found.set(layout, [...(found.get(layout) ?? []), root]);
  }
  return found;
}

/** The first of these shots with its comment, the others as variations, and then what follows the first. */
function line(tree: Tree, [main, ...others]: readonly TreeNode[], number: number): string {
  if (!main) return "";
  const said = main.comment === "" ? "" : ` {${main.comment.replace(/[\\}]/g, "\\$&")}}`;
  const at = main.id === tree.at ? " *" : "";
  const own = `${number}. ${strikeText(main.shot.strike)}${said}${at}`;
  const variations = others.map((other) => `( ${line(tree, [other], number)} )`);
  const rest = line(tree, childrenOf(tree, main.id), number + 1);
  return [own, ...variations, rest].filter(Boolean).join("\n");
}

function strikeText(strike: StrikeEntry): string {
  const numbers = STRIKE_NUMBERS.flatMap((key) => {
    const value = strike[key];
    return value === undefined ? [] : [`${key}=${Object.is(value, -0) ? "-0.0" : value}`];
  });
  const policies = POLICIES.flatMap((key) =>
    strike[key] === undefined ? [] : [`${key}=${strike[key]}`],
  );
  return [JSON.stringify(strike.ball), ...numbers, ...policies].join(" ");
}

/** What the engine does for a tree that is read. */
export interface TreeEngine {
  /** @throws CaromError if the engine refuses the shot. */
  readonly check: (shot: AimedShot) => void;
  /** The balls at the end of a shot; null if no shot can follow. */
  readonly endOf: (shot: AimedShot) => readonly BallEntry[] | null;
}

/**
 * The tree of a text; a slice reads one shot.
 *
 * @throws PageError that names the line, and CaromError for a shot that the engine refuses.
 */
export function treeReading(text: string, engine: TreeEngine): Slices<Tree> {
  return new Reader(text, engine).read();
}

type Kind = "tag" | "open" | "close" | "number" | "string" | "pair" | "comment" | "mark";

interface Token {
  readonly kind: Kind;
  readonly text: string;
  readonly line: number;
}

const TOKENS: readonly (readonly [Kind, RegExp])[] = [
  ["tag", /\[([^\n]*)\]/y],
  ["open", /\(/y],
  ["close", /\)/y],
  ["comment", /\{((?:\\[\\}]|[^}\\])*)\}/y],
  ["number", /(\d+\.)\s/y],
  ["mark", /\*/y],
  ["string", /"(?:[^"\\]|\\.)*"/y],
  ["pair", /\w+=[^\s(){}]+/y],
];

class Reader {
  readonly #tokens: readonly Token[];
  readonly #engine: TreeEngine;
  readonly #nodes: TreeNode[] = [];
  #at: number | null = null;
  #next = 0;

  constructor(text: string, engine: TreeEngine) {
    this.#tokens = tokensOf(text);
    this.#engine = engine;
  }

  *read(): Slices<Tree> {
    const first = this.#take();
    if (first?.kind !== "tag" || first.text !== `Carom "${FORMAT}"`) {
      throw new PageError(t("tree.no-tree", { format: `[Carom "${FORMAT}"]` }), "");
    }
    while (this.#peek()) {
      const tag = this.#take()!;
      if (tag.kind !== "tag") throw wrong(tag);
      // Other tags are for people: a title, a date.
      if (!tag.text.startsWith(LAYOUT)) continue;
      yield* this.#line(null, layoutOf(tag.text.slice(LAYOUT.length), tag));
    }
    return { nodes: this.#nodes, at: this.#at ?? this.#nodes.at(-1)?.id ?? null };
  }

  /** Reads shots and their variations from one layout on, up to the end of the line. */
  *#line(parent: number | null, layout: Omit<ShotFile, "strike"> | null): Slices<void> {
    let [before, from] = [parent, layout];
    while (this.#peek()?.kind === "number") {
      const start = this.#take()!;
      if (!from) throw new PageError(t("tree.no-layout", { line: start.line }), "");
      const node = this.#shot(before, from, start);
      while (this.#peek()?.kind === "open") {
        this.#take();
        yield* this.#line(before, from);
        const end = this.#take();
        if (end?.kind !== "close") throw wrong(end ?? start);
      }
      before = node.id;
      yield;
      const balls = this.#engine.endOf(node.shot);
      from = balls && { ...from, balls };
    }
  }

  #shot(parent: number | null, layout: Omit<ShotFile, "strike">, start: Token): TreeNode {
    if (this.#nodes.length >= MOST_NODES) {
      throw new PageError(t("tree.too-many", { most: MOST_NODES }), "");
    }
    const ball = this.#take();
    if (ball?.kind !== "string") throw wrong(ball ?? start);
    const strike: Record<string, unknown> = { ball: JSON.parse(ball.text) as string };
    while (this.#peek()?.kind === "pair") {
      const pair = this.#take()!;
      const [key, value] = pair.text.split("=") as [string, string];
      if ((POLICIES as readonly string[]).includes(key)) strike[key] = value;
      else if (
        (STRIKE_NUMBERS as readonly string[]).includes(key) &&
        Number.isFinite(Number(value))
      )
        strike[key] = Number(value);
      else throw wrong(pair);
    }
    const comments: string[] = [];
    const id = this.#nodes.length + 1;
    while (this.#peek()?.kind === "comment" || this.#peek()?.kind === "mark") {
      const token = this.#take()!;
      if (token.kind === "mark") this.#at = id;
      else comments.push(token.text.replace(/\\([\\}])/g, "$1"));
    }
    const shot = { ...layout, strike: strike as unknown as StrikeEntry };
    this.#engine.check(shot);
    const comment = comments.join(" ").slice(0, LONGEST_COMMENT);
    const node = { id, parent, shot, comment };
    this.#nodes.push(node);
    return node;
  }

  #peek(): Token | undefined {
    return this.#tokens[this.#next];
  }

  #take(): Token | undefined {
    return this.#tokens[this.#next++];
  }
}

function wrong({ text, line }: Token): PageError {
  return new PageError(t("tree.wrong", { text: text.slice(0, 40), line }), "");
}

function layoutOf(json: string, tag: Token): Omit<ShotFile, "strike"> {
  try {
    return JSON.parse(json) as ShotFile;
  } catch (error) {
    if (error instanceof SyntaxError) throw wrong(tag);
    throw error;
  }
}

/** What the tag of a layout begins with; JSON follows, in which an id may have any character. */
const LAYOUT = "Layout ";

const SPACE = /\s*/y;

function tokensOf(text: string): Token[] {
  const tokens: Token[] = [];
  let at = 0;
  let line = 1;
  const skip = (length: number) => {
    line += text.slice(at, at + length).split("\n").length - 1;
    at += length;
  };
  for (;;) {
    SPACE.lastIndex = at;
    skip(SPACE.exec(text)![0].length);
    if (at >= text.length) return tokens;
    const found = TOKENS.map(([kind, pattern]) => {
      pattern.lastIndex = at;
      return [kind, pattern.exec(text)] as const;
    }).find(([, match]) => match !== null);
    if (!found) throw wrong({ kind: "mark", text: text.slice(at, at + 20), line });
    const [kind, match] = found as readonly [Kind, RegExpExecArray];
    tokens.push({ kind, text: match[1] ?? match[0], line });
    skip(match[0].length);
  }
}
