/** Games of the page as records of frames, `carom-frame/1`, and back. */

import type { Engine, FrameRecord } from "../../engine/index.ts";
import type { Document } from "../document/document.ts";
import type { Game } from "../document/game.ts";
import { firstAim } from "./aim.ts";
import { progressOf } from "./progress.ts";
import { t } from "../words/translate.ts";

/** The record of a game. It has every move, but not the names of the players. */
export function recordOf(engine: Engine, game: Game): FrameRecord {
  return progressOf(engine, game).frame.record;
}

/**
 * The game of a record, at its end.
 *
 * @throws CaromError that names the move, if the record is none or a move is not allowed.
 */
export function gameOfRecord(engine: Engine, record: FrameRecord): Pick<Document, "game" | "shot"> {
  const frame = engine.replay(record);
  // Written again, so that records of other programs have the form of this page.
  const { setup, moves } = frame.record;
  frame.free();
  const { game: rules, ...rest } = setup;
  const { shot: from = null, ...options } = "shot" in rest ? rest : { ...rest, shot: undefined };
  const names = [t("setup.player", { number: 1 }), t("setup.player", { number: 2 })] as const;
  const game: Game = {
    setup: { rules, options, from, names, skills: [null, null] },
    moves,
    call: null,
  };
  return { game, shot: firstAim(engine, game, progressOf(engine, game)) };
}
