/** The state of the page: the document, the view and the session. */

import type { DrawnMark, Noise, PocketName, Trace } from "../../engine/index.ts";
import type { Area, Density } from "../../viewer/index.ts";
import type { Orientation } from "../common/seen.ts";
import type { SpeedUnit } from "../common/units.ts";
import type { AimedShot } from "./aimed-shot.ts";
import type { Filmed } from "./filmed.ts";
import type { Lesson } from "./open-study.ts";
import type { Drawing } from "./marks.ts";
import type { Game } from "./stored-game.ts";
import type { Tree } from "./shot-tree.ts";

export type { AimedShot };

/** Everything that undo can restore. Immutable. */
export interface Document {
  readonly shot: AimedShot;
  /** The player's execution errors; null: the what-if simulation is off. */
  readonly noise: Noise | null;
  /** Seed of racks and of the what-if simulation. */
  readonly seed: number;
  /** The game that is being played; null: free play. */
  readonly game: Game | null;
  /** The shots that were played in the analysis. */
  readonly tree?: Tree | undefined;
  /** The shot of a game that is analysed; the tree then has its variations. */
  readonly study?: Study | undefined;
  /** What a camera saw of a shot. */
  readonly filmed?: Filmed | undefined;
}

/** The analysis of a shot of a game, and what comes back at its end. */
export interface Study {
  readonly game: Game;
  /** Index of the move. */
  readonly move: number;
  /** Shot and tree of the page before. */
  readonly shot: AimedShot;
  readonly tree: Tree | undefined;
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
  readonly shot: AimedShot | null;
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

/** What the analysis shows on the table while the user looks at one of its results. */
export interface Preview {
  /** A shot that is shown in place of the aimed one; null: the aimed one. */
  readonly trace: Trace | null;
  readonly areas: readonly Area[];
  /** The shots of a plan, drawn in place of the aimed shot. */
  readonly marks?: readonly DrawnMark[];
}

/** What the page is used for; it decides which panels are shown. */
export type Activity = "analyse" | "play" | "train" | "library";

/** An attempt of a drill or a puzzle. While it is aimed, the page does not show how the shot ends. */
export interface Attempt {
  /** What to do, and how the last attempt went. */
  readonly text: string;
  /** Areas that are marked on the cloth. */
  readonly areas: readonly Area[];
  /** The pocket that is lit until the shot is changed. */
  readonly pocket?: PocketName;
  /** Errors that the strike gets when it is played; null: it is played as it is aimed. */
  readonly errors: Noise | null;
  /** Seed of the errors. */
  readonly seed: number;
}

/** The shot that is replayed, and how. */
export interface Replay {
  /** Null while aiming. */
  readonly trace: Trace | null;
  /** Seconds of wall time until the cue strikes the ball; 0 from then on. */
  readonly stroke: number;
  /** Time of the replay, s since the strike. */
  readonly time: number;
  readonly playing: boolean;
  /** Seconds of the replay per second of wall time. */
  readonly rate: number;
  readonly sound: boolean;
}

/** What the analysis asks and shows. */
export interface Analysis {
  /** Level of play, a preset of noise, unless the document has a noise. */
  readonly level: string;
  /** The game in which a free layout is valued; null: the one that fits it best. */
  readonly rules: string | null;
  readonly preview: Preview | null;
  /** Chances over the cloth, such as those of the next ball; null: none are shown. */
  readonly zone: Density | null;
}

/** Lines to aim by. */
export interface Overlays {
  /** The tangent line and the natural angle of the first contact. */
  readonly contact: boolean;
  /** The numbers of a diamond system. */
  readonly diamonds: boolean;
}

/** Temporary state: neither undone nor part of a link. */
export interface Session {
  readonly activity: Activity;
  readonly mode: "aim" | "replay";
  readonly replay: Replay;
  readonly analysis: Analysis;
  readonly overlays: Overlays;
  /** Id of the selected ball. */
  readonly selected: string | null;
  /** The pot at which the cue is aimed; null if it is aimed freely. */
  readonly lock: PotLock | null;
  readonly refusal: Refusal | null;
  readonly attempt: Attempt | null;
  /** The study that is open; null if none is. */
  readonly lesson: Lesson | null;
  /** How the picture shows the table; names of pockets and rails depend on it. */
  readonly orientation: Orientation;
  /** What is drawn next; null: gestures on the table do not draw. */
  readonly drawing: Drawing | null;
  /** Fine adjustment: drags and keys have a tenth of their effect. */
  readonly fine: boolean;
}

export const FIRST_VIEW: View = { theme: "auto", camera: "top", units: "m/s" };

export const FIRST_SESSION: Session = {
  activity: "analyse",
  mode: "aim",
  replay: { trace: null, stroke: 0, time: 0, playing: false, rate: 1, sound: true },
  analysis: { level: "club", rules: null, preview: null, zone: null },
  overlays: { contact: false, diamonds: false },
  selected: null,
  lock: null,
  refusal: null,
  attempt: null,
  lesson: null,
  orientation: 0,
  drawing: null,
  fine: false,
};
