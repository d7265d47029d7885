/** What the dialog tells about the next step, and about the photo. */

import { ballText, fill, tableText, TEXTS } from "../texts.ts";
import type { Session } from "../photo-session.ts";

/** The dialog reports a lens that bends a rail by a larger share of its length: an eye sees it. */
const BENT = 0.01;

/** The next step, how exact the balls are, and whether the lens bends lines. */
export function hintText({ draft, table, accuracy, suggested, bow }: Session): string {
  if (!draft.marked) {
    const text = table.geometry.pockets.length > 0 ? TEXTS.pockets : TEXTS.corners;
    return fill(text, { count: draft.landmarks.length });
  }
  const next = draft.next === null ? TEXTS.all : fill(TEXTS.balls, { ball: ballText(draft.next) });
  const texts = [suggested > 0 ? fill(TEXTS.found, { count: suggested }) : next];
  if (accuracy !== null) {
    texts.push(fill(TEXTS.accuracy, { error: Math.max(1, Math.round(1000 * accuracy)) }));
  }
  if (bow !== null && bow > BENT) texts.push(fill(TEXTS.lens, { percent: (100 * bow).toFixed(0) }));
  return texts.join(" ");
}

/** What to do if the balls do not have the size of the table's; empty if they do. */
export function proportionText({ misproportion }: Session): string {
  if (!misproportion) return "";
  const { isLarge, preset } = misproportion;
  const text = isLarge ? TEXTS.ballsLarge : TEXTS.ballsSmall;
  return preset ? `${text} ${fill(TEXTS.looksLike, { table: tableText(preset) })}` : text;
}
