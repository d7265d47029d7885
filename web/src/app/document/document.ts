/** What a page is about: the document with its history, and the session around it. */

import type { Noise, ShotFile, StrikeEntry, Trace } from "../../engine/index.ts";
import type { SpeedUnit } from "../common/units.ts";
import type { Game } from "./game.ts";

/** A shot file that has a strike: what one can aim with. */
export type AimedShot = ShotFile & { readonly strike: StrikeEntry };

/** The work: everything that undo takes back. Immutable. */
export interface Document {
  readonly shot: AimedShot;
  /** Spread of the player's execution; null: none is shown. */
  readonly noise: Noise | null;
  /** Seed of the what-ifs' random numbers and of racks. */
  readonly seed: number;
  /** The game in which the shot is played; null: a free table. */
  readonly game: Game | null;
}

export type Theme = "auto" | "light" | "dark";
export type Camera = "top" | "orbit" | "cue";

/** How the work is looked at: part of a link, but not of the history. */
export interface View {
  readonly theme: Theme;
  readonly camera: Camera;
  readonly units: SpeedUnit;
}

/** A change that the engine did not accept. */
export interface Refusal {
  /** The engine's sentence: place, what is wrong, remedy. */
  readonly message: string;
  /** Key in the shot file, such as `balls[3].position`; empty if there is none. */
  readonly place: string;
  /** What was tried, so that the page can show it where it was tried; null once it is let go. */
  readonly attempt: AimedShot | null;
}

/** What goes on at the moment; never undone, never shared. */
export interface Session {
  readonly mode: "aim" | "replay";
  /** The shot that is replayed; null while aiming. */
  readonly trace: Trace | null;
  /** Time of the replay, s since the strike. */
  readonly time: number;
  readonly playing: boolean;
  /** Replay seconds per second. */
  readonly rate: number;
  /** Id of the selected ball. */
  readonly selected: string | null;
  readonly hovered: string | null;
  readonly refusal: Refusal | null;
  /** Fine adjustment: every turn and drag counts a tenth. */
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
  hovered: null,
  refusal: null,
  fine: false,
};
