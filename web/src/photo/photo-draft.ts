/** What a user has marked in a photo. Immutable; each change is a step that undo takes back. */

import type { Engine, Geometry, Point } from "../engine/index.ts";
import { undated } from "./dated-presets.ts";

export interface MarkedBall {
  readonly id: string;
  /** Its centre in the photo, pixels. */
  readonly pixel: Point;
  /** Whether this is the centre of its outline, not of the tap. */
  readonly refined: boolean;
  /** Its size in the photo, 1 as on the chosen table; null if its outline was not seen. */
  readonly size: number | null;
  /** Whether the page has found it and the user has neither confirmed, moved nor renamed it. */
  readonly suggested: boolean;
}

export interface Draft {
  /** Taps on the landmarks, pixels, in the order of the taps. */
  readonly landmarks: readonly Point[];
  /** Whether all landmarks that the user wants are there, so that taps are balls. */
  readonly marked: boolean;
  /** Whether the ends of the table are exchanged. */
  readonly turned: boolean;
  readonly balls: readonly MarkedBall[];
  /** Id of the ball that the next tap places; null: none is left. */
  readonly next: string | null;
}

/** Landmarks of a table, and of them corners. */
export const LANDMARKS = 6;
export const CORNERS = 4;

export function emptyDraft(tray: readonly string[]): Draft {
  return { landmarks: [], marked: false, turned: false, balls: [], next: tray[0] ?? null };
}

/** Adds a landmark; the last one ends them. */
export function addLandmark(draft: Draft, pixel: Point): Draft {
  const landmarks = [...draft.landmarks, pixel];
  return { ...draft, landmarks, marked: landmarks.length >= LANDMARKS };
}

export function moveLandmark(draft: Draft, index: number, pixel: Point): Draft {
  return { ...draft, landmarks: draft.landmarks.with(index, pixel) };
}

/** Places the next ball, or moves it there, and goes on to the next one of the tray. */
export function placeBall(draft: Draft, tray: readonly string[], ball: MarkedBall): Draft {
  const placed = moveBall(draft, ball);
  return { ...placed, next: following(placed, tray, ball.id) };
}

/** Adds balls that the page has found; those of the user stay. */
export function suggestBalls(
  draft: Draft,
  tray: readonly string[],
  found: readonly MarkedBall[],
): Draft {
  const balls = [...draft.balls.filter(({ suggested }) => !suggested), ...found];
  const next = tray.find((id) => !balls.some((ball) => ball.id === id)) ?? null;
  return { ...draft, balls, next };
}

/** The user agrees with a ball that the page has found. */
export function confirmBall(draft: Draft, id: string): Draft {
  const balls = draft.balls.map((ball) => (ball.id === id ? { ...ball, suggested: false } : ball));
  return { ...draft, balls };
}

/** Puts a ball elsewhere, without going on to the next one. */
export function moveBall(draft: Draft, ball: MarkedBall): Draft {
  const at = draft.balls.findIndex(({ id }) => id === ball.id);
  const balls = at < 0 ? [...draft.balls, ball] : draft.balls.with(at, ball);
  return { ...draft, balls };
}

/** Removes a ball, which is the next one then. */
export function removeBall(draft: Draft, id: string): Draft {
  return { ...draft, balls: draft.balls.filter((ball) => ball.id !== id), next: id };
}

/** Exchanges two ids if `to` is on the table already, so that no ball is lost. The first is confirmed. */
export function renameBall(draft: Draft, from: string, to: string): Draft {
  const names = new Map([
    [from, to],
    [to, from],
  ]);
  const balls = draft.balls.map((ball) => ({ ...ball, id: names.get(ball.id) ?? ball.id }));
  const next = draft.next === to && !balls.some(({ id }) => id === from) ? from : draft.next;
  return confirmBall({ ...draft, balls, next }, to);
}

/** The first ball after `id` in the tray that is not on the table; null if there is none. */
function following({ balls }: Draft, tray: readonly string[], id: string): string | null {
  const placed = new Set(balls.map((ball) => ball.id));
  const at = tray.indexOf(id);
  const order = [...tray.slice(at + 1), ...tray.slice(0, at + 1)];
  return order.find((one) => !placed.has(one)) ?? null;
}

/**
 * The ids of a table's balls: those of the game with the most balls that is usually played with the same
 * balls, in the order of the numbers.
 */
export function trayOf(engine: Engine, geometry: Geometry): string[] {
  const racks = engine.games.map((game) => engine.breakShot(game));
  const sets = racks.map(({ geometry: usual, balls }) => ({
    same: undated(usual.physics ?? "") === undated(geometry.physics ?? ""),
    pockets: usual.pockets.length === geometry.pockets.length,
    ids: balls.map(({ id }) => id),
  }));
  for (const rack of racks) rack.free();
  const most = (some: typeof sets) => [...some].sort((a, b) => b.ids.length - a.ids.length)[0]?.ids;
  const pool = sets.find(({ ids }) => ids.includes("15"));
  const ids =
    most(sets.filter(({ same }) => same)) ??
    (geometry.pockets.length > 0 ? pool?.ids : most(sets.filter(({ pockets }) => pockets))) ??
    [];
  return ids.toSorted((a, b) => (Number(a) || 0) - (Number(b) || 0));
}
