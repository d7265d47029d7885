/** A warning before the shot: the aim hits a ball first that is not on. */

import type { Engine } from "../../../engine/index.ts";
import { objectName } from "../../common/shot-words.ts";
import { shownGuide } from "../../document/guide-extent.ts";
import type { Store } from "../../document/store.ts";
import { paragraph, sentence, t } from "../../words/translate.ts";
import { presentCall } from "../calling.ts";
import { standing, askedShot } from "../awaited-turn.ts";
import { callInWords, onInWords } from "../game-words.ts";

/**
 * The warning, with what is on; null if the first ball is on, or if the guide does not show which ball is
 * first. The short guide ends at the first cushion.
 */
export function wrongBall(store: Store, engine: Engine): string | null {
  const asked = askedShot(store, engine);
  const outcome = store.ghost.trace?.outcome;
  const guide = shownGuide(store);
  if (!asked || !outcome || guide === "none") return null;
  const { first_contact: first, rails_before_first_contact: rails } = outcome;
  if (first === null || (guide === "short" && rails.length > 0)) return null;
  const call = presentCall(store, engine);
  if (call?.kind === "push-out") return null;
  const nominated = call?.kind === "on" ? call.ball : undefined;
  const on = nominated === undefined ? asked.on : [nominated];
  if (on.length === 0 || on.includes(first)) return null;
  const { state, balls } = standing(store, engine)!.frame.state;
  const what =
    nominated === undefined
      ? onInWords(on, state, Object.keys(balls))
      : t("request.nominated", { call: callInWords(call) });
  const ball = objectName(first, outcome);
  return paragraph([t("guide.wrong-ball", { ball }), what && sentence(what)]);
}
