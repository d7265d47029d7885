/** The state of the page: the document, the view and the session. */

import type { Noise, PocketName, ShotFile, StrikeEntry, Trace } from "../../engine/index.ts";
import type { SpeedUnit } from "../common/units.ts";
import type { Game } from "./game.ts";

/** A shot file with a strike. */
export type AimedShot = ShotFile & { readonly strike: StrikeEntry };

/** Everything that undo can restore. Immutable. */
export interface Document {
  readonly shot: AimedShot;
  /** The player's execution errors; null: the what-if simulation is off. */
  readonly noise: Noise | null;
  /** Seed of racks and of the what-if simulation. */
  readonly seed: number;
  /** The game that is being played; null: free play. */
  readonly game: Game | null;
}

export type Theme = "auto" | "light" | "dark";
export type Camera = "top" | "orbit" | "cue";

/** How the document is shown. A link contains it; undo does not change it. */
export interface View {
  readonly theme: Theme;
  readonly camera: Camera;
  readonly units: SpeedUnit;
}

/** A change that was refused. */
export interface Refusal {
  /** Place, fault and remedy in one sentence. */
  readonly message: string;
  /** Key in the shot file, such as `balls[3].position`; empty if the refusal concerns no key. */
  readonly place: string;
  /** The refused shot, which the page shows until the gesture ends; null afterwards. */
  readonly attempt: AimedShot | null;
}

/** A ball that the cue stays aimed to pot. */
export interface PotLock {
  readonly ball: string;
  readonly pocket: PocketName;
  /** Whether a line was found for the present strike. */
  readonly solved: boolean;
  /** By how much the azimuth may be wrong on either side, degrees. */
  readonly margin: number;
  /** "direct", "bank" and so on, as `PotAim.kind`. */
  readonly kind: string;
  readonly losesCueBall: boolean;
}

/** Temporary state: neither undone nor part of a link. */
export interface Session {
  readonly mode: "aim" | "replay";
  /** The shot that is replayed; null while aiming. */
  readonly trace: Trace | null;
  /** Time of the replay, s since the strike. */
  readonly time: number;
  readonly playing: boolean;
  /** Seconds of the replay per second of wall time. */
  readonly rate: number;
  /** Id of the selected ball. */
  readonly selected: string | null;
  /** The pot at which the cue is aimed; null if it is aimed freely. */
  readonly lock: PotLock | null;
  readonly refusal: Refusal | null;
  /** Whether replays sound. */
  readonly sound: boolean;
  /** Fine adjustment: drags and keys have a tenth of their effect. */
  readonly fine: boolean;
}

export const FIRST_VIEW: View = { theme: "auto", camera: "top", units: "m/s" };

export const FIRST_SESSION: Session = {
  mode: "aim",
  trace: null,
  time: 0,
  playing: false,
  rate: 1,
  selected: null,
  lock: null,
  refusal: null,
  sound: true,
  fine: false,
};
