/** Checks that a change during a game is allowed. */

import {
  type BallEntry,
  CaromError,
  type Engine,
  type Point,
  type Shot,
  type ShotFile,
} from "../../engine/index.ts";
import type { AimedShot } from "../document/document.ts";
import { PageError } from "../common/refusals.ts";
import { ballName } from "../common/shot-words.ts";
import type { Game } from "../document/stored-game.ts";
import { anyShot, type Progress, progressOf } from "./game-progress.ts";
import { sentence, t } from "../words/translate.ts";

/** The engine with the game's checks, for the store. */
export function referee(engine: Engine): { shot(file: AimedShot, game: Game | null): Shot } {
  return {
    shot: (file, game) => {
      if (game) check(engine, file, progressOf(engine, game));
      const shot = engine.shot(file);
      if (game) checkHand(file, progressOf(engine, game));
      return shot;
    },
  };
}

function check(engine: Engine, file: AimedShot, progress: Progress): void {
  const { start, frame } = progress;
  const { request } = frame.state;
  // The shot of a link has dated names of presets, and the game's start has current ones.
  const equipment = ({ table, physics }: Pick<ShotFile, "table" | "physics">) =>
    engine.withDatedNames({ table, ...(physics !== undefined && { physics }) });
  if (!same(equipment(file), equipment(start))) {
    throw new PageError(t("refused.equipment"), "table");
  }
  const hand = handOf(progress);
  const there = file.balls.filter(({ id }) => id !== hand);
  const expected = layoutOf(progress).filter(({ id }) => id !== hand);
  const moved = expected.find((ball, k) => !same(there[k], ball));
  if (moved || there.length !== expected.length) {
    throw new PageError(
      hand === null ? t("refused.moved") : t("refused.moved-hand", { ball: ballName(hand) }),
      `balls[${file.balls.findIndex(({ id }) => id === moved?.id)}].position`,
    );
  }
  if (request.kind === "shot" && file.strike.ball !== request.cue_ball) {
    throw new PageError(t("refused.struck", { ball: ballName(request.cue_ball) }), "strike.ball");
  }
}

/** Checks that a cue ball in hand lies within its region. */
function checkHand(file: AimedShot, progress: Progress): void {
  const hand = handOf(progress);
  const ball = file.balls.find(({ id }) => id === hand);
  if (hand === null) return;
  if (!ball)
    throw new PageError(sentence(t("refused.place-hand", { ball: ballName(hand) })), "balls");
  const { position } = ball;
  const own = progress.start.balls.find(({ id }) => id === hand);
  if (!same(ball, { ...own, position })) {
    throw new PageError(t("refused.only-position", { ball: ballName(hand) }), "balls");
  }
  anyShot(progress.frame, [position[0], position[1]]).free();
}

/** The cue ball's id if it is in hand. */
export function handOf({ frame }: Progress): string | null {
  const { request } = frame.state;
  return request.kind === "shot" && request.in_hand !== null ? request.cue_ball : null;
}

/** The balls on the table, in the order of the shot file. */
export function layoutOf({ start, frame }: Progress): BallEntry[] {
  const { balls } = frame.state;
  const lying = start.balls.flatMap((ball) => {
    const position = balls[ball.id];
    return position ? [{ ...ball, position }] : [];
  });
  // A frame can end with an empty table, but a shot file needs a ball.
  return lying.length > 0 ? lying : [start.balls[0]!];
}

/** The free place for the cue ball that is nearest to its usual one; null if there is none. */
export function freePlace({ start, frame }: Progress, id: string): Point | null {
  const box = frame.handBounds;
  const usual = start.balls.find((ball) => ball.id === id)?.position;
  if (!box || !usual) return null;
  const distance = ([x, y]: Point) => Math.hypot(x - usual[0], y - usual[1]);
  const places = [[usual[0], usual[1]] as const, ...grid(box)];
  places.sort((a, b) => distance(a) - distance(b));
  return places.find((place) => accepts(frame, place)) ?? null;
}

/** Places tried along each side of the region. */
const TRIED = 16;

function grid([[left, bottom], [right, top]]: readonly [Point, Point]): Point[] {
  const steps = Array.from({ length: TRIED }, (_, k) => (k + 0.5) / TRIED);
  return steps.flatMap((s) =>
    steps.map((t) => [left + s * (right - left), bottom + t * (top - bottom)] as const),
  );
}

function accepts(frame: Progress["frame"], place: Point): boolean {
  try {
    anyShot(frame, place).free();
    return true;
  } catch (error) {
    if (error instanceof CaromError) return false;
    throw error;
  }
}

function same(a: unknown, b: unknown): boolean {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
}
