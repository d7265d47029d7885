/** A recommended play as a shot on the table. */

import type { Engine, Play, PlannedPlay, Recommendation, Shot } from "../../engine/index.ts";
import { CaromError } from "../../engine/index.ts";
import { round4 } from "../common/angles.ts";
import type { AimedShot } from "../document/document.ts";
import { lockOf } from "../document/pot-lock.ts";
import type { Store } from "../document/store.ts";
import { recommendationText } from "./analyse-words.ts";
import { inSentence, t } from "../words/translate.ts";

/** The aimed shot with the strike of a play, and with its cue ball if that is in hand. */
export function shotOf(
  shot: AimedShot,
  { strike, cue_ball: place }: Pick<PlannedPlay, "strike" | "cue_ball">,
): AimedShot {
  const { speed, azimuth, elevation, side, height } = strike;
  const { ball, obstruction, miscue } = shot.strike;
  const policies = { ...(obstruction && { obstruction }), ...(miscue && { miscue }) };
  const balls = place
    ? shot.balls.map((entry) =>
        entry.id === ball
          ? { ...entry, position: [round4(place[0]), round4(place[1])] as const }
          : entry,
      )
    : shot.balls;
  return { ...shot, balls, strike: { ball, speed, azimuth, elevation, side, height, ...policies } };
}

/** The shot that a play plays; the caller frees it. Null if the engine refuses it. */
export function readShot(engine: Engine, shot: AimedShot, play: PlannedPlay): Shot | null {
  try {
    return engine.shot(shotOf(shot, play));
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}

/** Aims a recommendation. In a game it is called too. @returns Whether it was accepted. */
export function aimRecommendation(store: Store, recommendation: Recommendation): boolean {
  const { play, ball, pocket } = recommendation;
  const label = t("change.line", { line: inSentence(recommendationText(recommendation)) });
  const accepted = store.apply(
    ({ shot, game }) => ({
      shot: shotOf(shot, play),
      game: game && { ...game, call: callOf(play) },
    }),
    label,
  );
  if (accepted && ball !== null && pocket !== null) {
    const aim = store.shot.potAim(ball, pocket, { near: true });
    if (aim) store.setSession({ lock: lockOf(ball, pocket, aim), selected: ball });
  }
  return accepted;
}

function callOf({ call }: Play) {
  return call ?? null;
}
