/** The frames of a match that was opened, and the dialog that opens one of them. */

import type { MatchFrame, MatchRecord } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { button, h, uniqueId } from "../../common/dom.ts";
import { gameName } from "../../common/preset-names.ts";
import { cannotOpen } from "../../document/shot-file.ts";
import type { Store } from "../../document/store.ts";
import { replayMove } from "../review/reviewed-shots.ts";
import { gameOfMatch, namesOf } from "./match-game.ts";
import { refereeText } from "../game-words.ts";
import { t } from "../../words/translate.ts";

/** The match that was opened last in a page. */
const opened = new WeakMap<Store, MatchRecord>();

/** Whether the page has the match of its game, so that another frame can be opened. */
export function hasMatch(store: Store): boolean {
  return opened.has(store);
}

/**
 * Reads the record of a match: shows its frames, or opens the only one.
 *
 * @returns Whether it was opened, so that the page can say so.
 * @throws CaromError if the record is damaged.
 */
export async function openMatch(store: Store, context: Context, text: string): Promise<boolean> {
  const record = context.engine.matchRecord(text);
  opened.get(store)?.free();
  opened.set(store, record);
  const [only, ...others] = record.frames;
  if (only && others.length === 0) return openFrame(store, context, only.frame);
  showFrames(store, context);
  return true;
}

/** Opens a frame of the match; a refused one leaves everything as it is. */
async function openFrame(store: Store, context: Context, number: number): Promise<boolean> {
  const record = opened.get(store);
  if (!record) return false;
  try {
    const game = await store.open(gameOfMatch(context.engine, record, number));
    if (!game || !store.apply(game, t("change.open-frame"))) return false;
    const first = game.game!.moves.findIndex((move) => "play" in move);
    if (first >= 0) replayMove(store, context.engine, first, context.reducedMotion());
    return true;
  } catch (error) {
    store.refuse(cannotOpen(error, ""));
    return false;
  }
}

/** Shows the frames of the match that was opened last. */
export function showFrames(store: Store, context: Context): void {
  const record = opened.get(store);
  if (!record) return;
  const { header, frames, isFinished } = record;
  const names = namesOf(header);
  const title = h("h2", { id: uniqueId("match") }, t("recorded.match", pair(names)));
  const close = (): void => dialog.close();
  const entry = (frame: MatchFrame) => {
    const open = (): void => {
      close();
      void openFrame(store, context, frame.frame);
    };
    return h(
      "li",
      {},
      button(t("recorded.frame", { number: frame.frame + 1 }), open),
      " ",
      summary(frame, names),
    );
  };
  const of = { game: gameName(header.game), count: frames.length };
  const dialog = h(
    "dialog",
    { class: "match-frames", "aria-labelledby": title.id, onclose: () => dialog.remove() },
    title,
    h("p", { class: "hint" }, t(isFinished ? "recorded.finished" : "recorded.goes-on", of)),
    h("ul", {}, ...frames.map(entry)),
    h("div", { class: "row" }, button(t("recorded.close"), close)),
  );
  document.body.append(dialog);
  dialog.showModal();
}

/** Who plays first, who won and why. */
function summary(frame: MatchFrame, names: readonly [string, string]): string {
  const { seats, shots, end } = frame;
  const players = t("recorded.players", pair([names[seats[0]], names[seats[1]]]));
  const ended = end === null ? "" : ` ${endText(end, names)}`;
  return `${players}${ended} ${t("recorded.shots", { count: shots })}`;
}

function endText(end: NonNullable<MatchFrame["end"]>, names: readonly [string, string]): string {
  const why = refereeText(end.why);
  if (end.winner === null) return t("recorded.no-winner", { why });
  return t("recorded.won", { name: names[end.winner], why });
}

function pair([first, second]: readonly [string, string]) {
  return { first, second };
}
