/** Changes of the layout: add, move and remove balls, rack a game, choose a table. */

import { CaromError, type BallEntry, type Engine, type Point } from "../../engine/index.ts";
import { round4 } from "../common/angles.ts";
import type { AimedShot } from "./document.ts";
import { accepts, aimed } from "./shot-file.ts";
import type { Store } from "./store.ts";
import { changed } from "./strike-angles.ts";
import { azimuthAt, type Target, targetOf } from "./target.ts";
import { gameName } from "../common/preset-names.ts";
import { errorText } from "../common/refusals.ts";
import { ballName } from "../common/shot-words.ts";
import { inSentence, t } from "../words/translate.ts";

/** Intervals of the grid that is searched for a free place: across the table; twice as many along it. */
const PLACES = 12;

/** Suggested id of a new ball: "cue" if there is no cue ball, else the lowest free number. */
export function nextId(balls: readonly BallEntry[]): string {
  const taken = new Set(balls.map((ball) => ball.id));
  if (!taken.has("cue") && !taken.has("white")) return "cue";
  let number = 1;
  while (taken.has(String(number))) number += 1;
  return String(number);
}

/** Adds a ball at the free place nearest to a point, or else to the middle of the table. */
export function addBall(store: Store, engine: Engine, id: string, near?: Point | null): boolean {
  const { shot } = store.document;
  const trimmed = id.trim();
  if (trimmed === "") return refuse(store, t("layout.no-name"));
  if (shot.balls.some((ball) => ball.id === trimmed)) {
    return refuse(store, t("layout.name-taken", { id: trimmed }));
  }
  const size = store.shot.geometry.size ?? ([1, 2] as const);
  for (const position of places(size, near ?? [size[0] / 2, size[1] / 2])) {
    const next = { ...shot, balls: [...shot.balls, { id: trimmed, position }] };
    if (!accepts(engine, next)) continue;
    store.setSession({ selected: trimmed });
    return store.apply({ shot: next }, t("change.add", { ball: ballName(trimmed) }));
  }
  return refuse(store, t("layout.no-place"));
}

/** Adds a ball at a place, exactly. */
export function addBallAt(store: Store, id: string, position: Point, group: string): boolean {
  const { shot } = store.document;
  const next = { ...shot, balls: [...shot.balls, { id, position }] };
  if (!store.apply({ shot: next }, t("change.add", { ball: ballName(id) }), group)) return false;
  store.setSession({ selected: id });
  return true;
}

/** Removes a ball. If it was the struck ball, the first ball left becomes the struck one. */
export function removeBall(store: Store, id: string, group: string | null = null): boolean {
  const { shot } = store.document;
  const balls = shot.balls.filter((ball) => ball.id !== id);
  const first = balls[0];
  if (!first) return refuse(store, t("layout.last-ball"));
  const struck = shot.strike.ball === id ? first.id : shot.strike.ball;
  const next = { ...shot, balls, strike: { ...shot.strike, ball: struck } };
  if (!store.apply({ shot: next }, t("change.remove", { ball: ballName(id) }), group)) return false;
  if (store.session.selected === id) store.setSession({ selected: null });
  return true;
}

/** Racks a game on its usual table; the seed decides the order of the balls and the gaps. */
export function rack(store: Store, engine: Engine, game: string, seed: number): boolean {
  try {
    const { source } = engine.breakShot(game, { seed });
    return store.apply(
      { shot: aimed(source), seed },
      t("change.rack", { game: inSentence(gameName(game)) }),
    );
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    return refuse(store, errorText(error));
  }
}

export interface Placing {
  /** Whether the place keeps all its digits; otherwise it is rounded to 0.1 mm. */
  readonly exact?: boolean;
  /** At what the struck ball was aimed before it was moved; left out: at what it is aimed now. */
  readonly target?: Target | null | undefined;
}

/**
 * Puts a ball elsewhere on the cloth, if the engine accepts the place. The struck ball keeps its target, and
 * not its direction: a break from the side still meets the rack.
 */
export function placeBall(
  store: Store,
  id: string,
  position: Point,
  group: string | null,
  { exact = false, target }: Placing = {},
): boolean {
  const { shot } = store.document;
  const at: Point = exact ? position : [round4(position[0]), round4(position[1])];
  const balls = shot.balls.map((ball) => (ball.id === id ? { ...ball, position: at } : ball));
  const strike = id === shot.strike.ball ? keptAim(store, at, target) : shot.strike;
  const label = t("change.move", { ball: ballName(id) });
  return store.apply({ shot: { ...shot, balls, strike } }, label, group);
}

/** The strike aimed at its target from another place. A pot that is solved is solved again by the store. */
function keptAim(store: Store, at: Point, kept: Target | null | undefined): AimedShot["strike"] {
  const { strike } = store.document.shot;
  if (store.session.lock) return strike;
  const target = kept === undefined ? targetOf(store) : kept;
  const to = store.shot.balls.find((ball) => ball.id === target?.ball)?.position;
  const azimuth = target && to ? azimuthAt(at, [to[0], to[1]], target.offset) : null;
  return azimuth === null ? strike : changed(strike, { azimuth_deg: azimuth });
}

/**
 * Chooses another table. The balls keep their positions if the new table accepts them; otherwise the
 * positions are scaled to its size. The physics changes with the table, unless the user chose it.
 */
export function changeTable(store: Store, engine: Engine, name: string): boolean {
  const { shot } = store.document;
  const from = store.shot.geometry.size;
  const to = engine.tables.find((table) => table.name === name)?.size;
  const moved: AimedShot = { ...shot, table: name };
  const scaled: AimedShot = {
    ...moved,
    balls: shot.balls.map((ball) => ({ ...ball, position: scale(ball.position, from, to) })),
  };
  const next = !accepts(engine, moved) && accepts(engine, scaled) ? scaled : moved;
  return store.apply({ shot: next }, t("change.table"));
}

function scale(
  [x, y]: BallEntry["position"],
  from: Point | null,
  to: Point | null | undefined,
): Point {
  if (!from || !to) return [x, y];
  return [round4((x / from[0]) * to[0]), round4((y / from[1]) * to[1])];
}

/** A grid of places on the table, ordered by their distance from a point. */
function places([width, length]: Point, [u, v]: Point): Point[] {
  const found: Point[] = [];
  for (let i = 1; i < PLACES; i += 1) {
    for (let k = 1; k < 2 * PLACES; k += 1) {
      found.push([round4((width * i) / PLACES), round4((length * k) / (2 * PLACES))]);
    }
  }
  const distance = ([x, y]: Point) => Math.hypot(x - u, y - v);
  return found.sort((a, b) => distance(a) - distance(b));
}

function refuse(store: Store, message: string): false {
  store.refuse(message);
  return false;
}
