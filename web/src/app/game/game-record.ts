/** Games of the page as records of frames, `carom-frame/1`, and back. */

import {
  CaromError,
  type Engine,
  type Frame,
  type FrameRecord,
  moved,
} from "../../engine/index.ts";
import { replaySteps } from "../../engine/frame-record.ts";
import { errorText, PageError } from "../common/refusals.ts";
import type { Slices } from "../common/slices.ts";
import { treeEngine } from "../document/balls-after.ts";
import type { Document } from "../document/document.ts";
import { treeReading } from "../document/tree-text.ts";
import type { Game, Variations } from "../document/stored-game.ts";
import { firstAim } from "./first-aim.ts";
import { progressOf, replayed } from "./game-progress.ts";
import { t } from "../words/translate.ts";

/**
 * The record of a game. It has every move with its variations, but not the names of the players. The engine
 * passes over the variations.
 */
export function recordOf(engine: Engine, game: Game): FrameRecord {
  const { record } = progressOf(engine, game).frame;
  const moves = record.moves.map((move, index) => {
    const variations = game.variations?.[index];
    return variations !== undefined && "play" in move ? { ...move, variations } : move;
  });
  return { ...record, moves };
}

/** The record without variations, for programs. */
export function plainRecordOf(engine: Engine, game: Game): FrameRecord {
  return progressOf(engine, game).frame.record;
}

/**
 * The variations of a record, by the index of the move in the frame.
 *
 * @throws CaromError that names the move, if they cannot be read.
 */
function* variationsOf(
  engine: Engine,
  record: FrameRecord,
  moves: FrameRecord["moves"],
): Slices<Variations> {
  // A frame leaves out choices that it applies itself, but no play.
  const plays = moves.flatMap((move, index) => ("play" in move ? [index] : []));
  const found = record.moves.flatMap((move, index) => ("play" in move ? [{ move, index }] : []));
  const entries: [number, string][] = [];
  for (const [k, { move, index }] of found.entries()) {
    const text: unknown = move.variations;
    if (text === undefined) continue;
    try {
      if (typeof text !== "string") throw new PageError(t("tree.no-text"), "");
      yield* treeReading(text, treeEngine(engine));
      entries.push([plays[k]!, text]);
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      const place = `moves[${index}].variations`;
      throw new PageError(t("study.refused", { number: index + 1, why: errorText(error) }), place);
    }
  }
  return Object.fromEntries(entries);
}

/** The frame of a record. @throws PageError that names the move, if it is damaged or not allowed. */
function* frameOf(engine: Engine, record: FrameRecord): Slices<Frame> {
  const { setup, moves } = record as { readonly setup?: unknown; readonly moves?: unknown };
  if (typeof setup !== "object" || setup === null || !Array.isArray(moves)) {
    throw new PageError(t("error.game"), "record");
  }
  try {
    return yield* replaySteps(engine, record);
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    const [whole, index] = /^moves\[(\d+)\](?:\.|$)/.exec(error.place) ?? [];
    if (whole === undefined) throw error;
    const place = error.place.slice(whole.length);
    const why = errorText(moved(error, place));
    throw new PageError(t("link.move", { number: Number(index) + 1, why }), error.place);
  }
}

/**
 * The game of a record, at its end.
 *
 * @throws CaromError that names the move, if the record is none or a move is not allowed.
 */
export function* gameOfRecord(
  engine: Engine,
  record: FrameRecord,
): Slices<Pick<Document, "game" | "shot">> {
  const frame = yield* frameOf(engine, record);
  // Written again, so that records of other programs have the form of this page.
  const { setup, moves } = frame.record;
  frame.free();
  const variations = yield* variationsOf(engine, record, moves);
  const { game: rules, ...rest } = setup;
  const { shot: from = null, ...options } = "shot" in rest ? rest : { ...rest, shot: undefined };
  const names = [t("setup.player", { number: 1 }), t("setup.player", { number: 2 })] as const;
  const game: Game = {
    setup: { rules, options, from, names, skills: [null, null] },
    moves,
    call: null,
    ...(Object.keys(variations).length > 0 && { variations }),
  };
  return { game, shot: firstAim(engine, game, yield* replayed(engine, game)) };
}
