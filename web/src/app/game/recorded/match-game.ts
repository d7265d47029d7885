/** A frame of a match between programs as a game, with what its players intended. */

import type { Engine, MatchHeader, MatchMove, MatchRecord, Seat } from "../../../engine/index.ts";
import { PageError } from "../../common/refusals.ts";
import type { Slices } from "../../common/slices.ts";
import type { Document } from "../../document/document.ts";
import { type Game, LONGEST_NAME, type MoveNote, type Pair } from "../../document/stored-game.ts";
import { firstAim } from "../first-aim.ts";
import { type Progress, replayed } from "../game-progress.ts";
import { t } from "../../words/translate.ts";

/** Whether a text is the record of a match: JSON on each line, of which the first names the format. */
export function isMatchText(text: string): boolean {
  // The format is the first key that is written.
  return /^\s{0,9}\{\s{0,9}"format"\s{0,9}:\s{0,9}"carom-match\//.test(text);
}

/** The names of the two players, which differ and fit into the score. */
export function namesOf({ players }: Pick<MatchHeader, "players">): Pair<string> {
  const [one, other] = [players[0].name, players[1].name];
  return one === other ? [short(`${one} (A)`), short(`${other} (B)`)] : [short(one), short(other)];
}

function short(name: string): string {
  if (name.length <= LONGEST_NAME) return name;
  // The end of a name tells more than its middle, such as "carom:2000".
  return `${name.slice(0, LONGEST_NAME - 9)}…${name.slice(-8)}`;
}

/**
 * Frame `number` of a match as a game, at its end.
 *
 * @throws CaromError if a shot does not end as the record says.
 */
export function* gameOfMatch(
  engine: Engine,
  record: MatchRecord,
  number: number,
): Slices<Pick<Document, "game" | "shot">> {
  const { record: frame, moves } = record.game(number);
  const { game: rules, ...options } = frame.setup;
  const players = namesOf(record.header);
  const entry = record.frames.find((one) => one.frame === number)!;
  const [first, second] = entry.seats;
  const game: Game = {
    setup: {
      rules,
      options,
      from: null,
      names: [players[first], players[second]],
      skills: [null, null],
    },
    moves: frame.moves,
    call: null,
    notes: {
      frame: number,
      moves: moves.map(noteOf),
      ...(entry.end && { end: { reason: entry.end.reason, why: entry.end.why } }),
    },
  };
  const hashes = new Map(moves.flatMap(({ index, trace }) => (trace ? [[index, trace]] : [])));
  const progress = yield* replayed(engine, game, (index, { trace }: Progress) => {
    const recorded = hashes.get(index);
    if (recorded === undefined || recorded === trace?.hash) return;
    const made = record.header.engine;
    const what = { number: index + 1, made, own: engine.version };
    throw new PageError(t("recorded.differs", what), `frame ${number}, moves[${index}].trace`);
  });
  return { game, shot: firstAim(engine, game, progress) };
}

/** What a game keeps of a move: it has the executed shot itself. */
function noteOf(move: MatchMove): MoveNote {
  const { seat, index, play, win_chance, luck, refused, late, failed } = move;
  return {
    seat,
    ...(index !== undefined && { index }),
    ...(play && index !== undefined && { play: playOf(play) }),
    ...(typeof win_chance === "number" && { chance: win_chance }),
    ...(luck && { luck: [luck.before, luck.expected, luck.after] as const }),
    ...(refused && { refused: `${refused.place}: ${refused.what}` }),
    ...(late && { lost: "late" }),
    ...(failed && { lost: failed.why }),
  };
}

function playOf({ strike, call }: NonNullable<MatchMove["play"]>): NonNullable<MoveNote["play"]> {
  if (!call) return { strike };
  const { pocket, ...rest } = call;
  return { strike, call: { ...rest, ...(pocket !== undefined && { into: pocket }) } };
}

/** The chance of the first player to win, if `seat` has `chance`. */
export function ofFirst(seat: Seat, chance: number): number {
  return seat === 0 ? chance : 1 - chance;
}
