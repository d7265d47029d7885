/** What a camera saw of a shot: the `track` of a shot file, which the engine does not need. */

import type { BallEntry, FilmedBall, ShotFile } from "../../engine/index.ts";
import type { AimedShot } from "./aimed-shot.ts";

export interface Filmed {
  /** The balls as they lay when the film began. */
  readonly balls: readonly BallEntry[];
  readonly track: readonly FilmedBall[];
}

/** A shot apart from its film. Every read of a shot by the engine would check the samples again. */
export function splitFilm<S extends ShotFile>(file: S): { shot: S; filmed?: Filmed } {
  const { track, ...shot } = file;
  if (!track || track.length === 0) return { shot: file };
  return { shot: shot as unknown as S, filmed: { balls: shot.balls, track } };
}

/** The film of the shot; none while the balls lie elsewhere. */
export function filmOf({
  shot,
  filmed,
}: {
  readonly shot: AimedShot;
  readonly filmed?: Filmed | undefined;
}): readonly FilmedBall[] {
  if (!filmed) return [];
  const places = (balls: readonly BallEntry[]) =>
    JSON.stringify(balls.map(({ id, position }) => [id, position[0], position[1]]));
  const isSame = filmed.balls === shot.balls || places(filmed.balls) === places(shot.balls);
  return isSame ? filmed.track : [];
}
