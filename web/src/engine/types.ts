/**
 * Data and objects of the engine, in SI units and radians; keys that end in `_deg` are in degrees.
 * Origin: the bottom left corner of the playing area, x along its width, y along its length, z up
 * from the slate.
 */

import type { CaromRoute, DiamondReading } from "./carom-route.ts";
import type { Refusal } from "./error.ts";
import type { Goal, ShotVerdict } from "./goal.ts";
import type { PocketName, Point, RailName, Vector } from "./places.ts";

export type { PocketName, Point, RailName, Vector } from "./places.ts";

/** A `carom-shot/1`. Its JSON Schema is `Engine.schema("shot")`. */
export interface ShotFile {
  readonly format: "carom-shot/1";
  /** A preset's name, `{cloth: "unbounded"}`, or a description from a base or a rectangle. */
  readonly table: string | Readonly<Record<string, unknown>>;
  /** A preset's name, or an object that is merged into its base key by key. */
  readonly physics?: string | Readonly<Record<string, unknown>>;
  readonly balls: readonly BallEntry[];
  readonly strike?: StrikeEntry;
  /** The contacts of two balls that cling, counted from 0 in the order of the shot. */
  readonly cling?: { readonly contacts: readonly number[]; readonly friction?: number };
  /** End time, s: the shot ends there, also if balls still move. */
  readonly until?: number;
  readonly max_events?: number;
  /** Where a camera saw the balls; it changes nothing in the shot. */
  readonly track?: readonly FilmedBall[];
  /** What is drawn on the table; it changes nothing in the shot. */
  readonly marks?: readonly DrawnMark[];
}

export type MarkColor = "white" | "yellow" | "red" | "blue";

/** A mark that somebody has drawn on the table; places are x, y in m. */
export type DrawnMark = { readonly color: MarkColor } & (
  | { readonly kind: "line" | "arrow"; readonly from: Point; readonly to: Point }
  | { readonly kind: "circle"; readonly center: Point; readonly radius: number }
  | { readonly kind: "area"; readonly outline: readonly Point[] }
  | { readonly kind: "label"; readonly at: Point; readonly text: string }
);

/** The most samples of a filmed ball. */
export const MOST_SAMPLES = 10_000;

/** Where a camera saw a ball. */
export interface FilmedBall {
  /** Id of the ball. */
  readonly ball: string;
  /** Time since the strike, s, and place of the centre, m. The times increase. */
  readonly samples: readonly (readonly [t: number, x: number, y: number])[];
}

export interface BallEntry {
  readonly id: string;
  /** Centre, m; without z the ball lies on the cloth. */
  readonly position: Point | Vector;
  /** m/s. */
  readonly velocity?: Vector;
  /** rad/s. */
  readonly angular_velocity?: Vector;
  /** The ball rolls at its velocity: its spin follows from it. Default false. */
  readonly rolling?: boolean;
  /** kg. */
  readonly mass?: number;
  /** m. */
  readonly radius?: number;
}

export interface StrikeEntry {
  /** Id of the struck ball. */
  readonly ball: string;
  /** Speed of the cue at contact, m/s. */
  readonly speed: number;
  /** Direction in which the cue moves, counter-clockwise from +x: in degrees or in radians. */
  readonly azimuth_deg?: number;
  readonly azimuth?: number;
  /**
   * Elevation of the butt: in degrees or in radians. By default the least angle of a real stroke at
   * which the cue clears the rails and the other balls.
   */
  readonly elevation_deg?: number;
  readonly elevation?: number;
  /** Contact point right of the ball's centre, in ball radii. */
  readonly side?: number;
  /** Contact point above the ball's centre, in ball radii. */
  readonly height?: number;
  readonly obstruction?: "report" | "refuse";
  readonly miscue?: "report" | "refuse";
}

/** A cue strike, in radians. */
export interface Strike {
  /** Speed of the cue at contact, m/s. */
  readonly speed: number;
  /** Direction in which the cue moves, counter-clockwise from +x, rad. */
  readonly azimuth: number;
  /** How far the butt is raised, rad. */
  readonly elevation: number;
  /** Contact point right of the ball's centre, in ball radii. */
  readonly side: number;
  /** Contact point above the ball's centre, in ball radii. */
  readonly height: number;
}

/**
 * A strike as a caller writes it: each angle in radians or, with the key of a shot file, in degrees; one
 * `azimuth` is required. Without an elevation it is the default one.
 */
export interface StrikeInput {
  /** Speed of the cue at contact, m/s. */
  readonly speed: number;
  /** Direction in which the cue moves, counter-clockwise from +x, rad. */
  readonly azimuth?: number | undefined;
  readonly azimuth_deg?: number | undefined;
  /** How far the butt is raised, rad. */
  readonly elevation?: number | undefined;
  readonly elevation_deg?: number | undefined;
  /** Contact point right of the ball's centre, in ball radii. Default 0. */
  readonly side?: number | undefined;
  /** Contact point above the ball's centre, in ball radii. Default 0. */
  readonly height?: number | undefined;
}

/** Coefficients of the physics that may depend on a speed or an angle. */
export type CoefficientKey =
  "cloth.rolling_friction" | "ball_ball.friction" | "cushion.restitution" | "cushion.friction";

/** A ball with all its values, including those that the file leaves to the physics. */
export interface BallInfo {
  readonly id: string;
  /** m. */
  readonly radius: number;
  /** kg. */
  readonly mass: number;
  /** Centre at time 0, m. */
  readonly position: Vector;
}

export type CushionPart = "nose" | "facing" | "point" | "top" | "liner";

export type Motion =
  "stationary" | "spinning" | "rolling" | "sliding" | "airborne" | "pocketed" | "off-table";

/** Motion states, indexed by the code in `Trace.statesAt`. */
export const MOTIONS: readonly Motion[] = [
  "stationary",
  "spinning",
  "rolling",
  "sliding",
  "airborne",
  "pocketed",
  "off-table",
];

/**
 * Numbers per ball in `Trace.statesAt`: position (m) 3, velocity (m/s) 3, spin (rad/s) 3,
 * orientation (unit quaternion x, y, z, w) 4, motion code 1.
 */
export const STRIDE = 14;

/** A table in metres. Cushions and liners are lines of the ground plan. */
export interface Geometry {
  /** The preset's name if the table is an unchanged preset; without a date if the values are the newest. */
  readonly name: string | null;
  /** The name under which these values remain available, such as "wpa-9ft-2026-12". */
  readonly dated_name: string | null;
  /** Playing area along x and y, nose to nose; null on unbounded cloth. */
  readonly size: Point | null;
  /** Height of the cushion nose above the slate. */
  readonly cushion_height: number;
  /** Counter-clockwise around the table from the left end of the bottom rail. */
  readonly cushions: readonly Cushion[];
  /** Walls of the pockets behind the facings. */
  readonly liners: readonly Cushion[];
  readonly pockets: readonly Pocket[];
  /** This and all keys below exist on every table with rails. */
  readonly cushion_width?: number;
  /** Includes the cushion. */
  readonly rail_width?: number;
  /** Physics preset that belongs to the table. */
  readonly physics?: string;
  readonly sights?: Sights;
  readonly markings?: Markings;
  readonly dimensions?: readonly Dimension[];
}

/** A line segment, or an arc of less than 180° if it has a centre and a radius. */
export interface Cushion {
  readonly rail: RailName;
  readonly part: CushionPart;
  readonly start: Point;
  readonly end: Point;
  readonly center?: Point;
  readonly radius?: number;
}

export interface Pocket {
  readonly name: PocketName;
  /** Of the hole in the slate. */
  readonly center: Point;
  readonly radius: number;
  /** The line from tip to tip, on tables where balls that cross it count as pocketed. */
  readonly mouth?: readonly [Point, Point];
}

export interface Sights {
  /** Intervals along the length. Ends (and with pockets the middle) have no sight. */
  readonly along_length: number;
  readonly along_width: number;
  /** From the nose line to the sight's centre. */
  readonly setback: number;
}

export interface Markings {
  /** From the bottom nose line. */
  readonly head_string: number | null;
  readonly d_radius: number | null;
  readonly spots: readonly { readonly name: string; readonly position: Point }[];
}

export interface Dimension {
  readonly key: string;
  readonly value: number | string | null;
  readonly unit: string | null;
  readonly source: string | null;
}

/** A ball's state in a trace file. */
export interface BallState {
  readonly id: string;
  /** Centre, m. */
  readonly position: Vector;
  /** m/s. */
  readonly velocity: Vector;
  /** rad/s. */
  readonly angular_velocity: Vector;
  readonly motion: Motion;
}

interface EventBase {
  /** Since the strike, s. */
  readonly time: number;
  /** Ids of the balls in it. */
  readonly balls: readonly string[];
  /** Just before, in the order of `balls`. */
  readonly before: readonly BallState[];
  /** Just after. */
  readonly after: readonly BallState[];
}

/** What an impact has besides. A saved trace of an early engine does not have it. */
interface ImpactBase {
  /** The change of each ball's momentum, N s, in the order of `balls`. */
  readonly impulses: readonly Vector[];
  /**
   * The points of contact, m: one of every two balls that touch; in a strike that of the tip comes
   * first.
   */
  readonly points: readonly Vector[];
}

export type TraceEvent = EventBase &
  (
    | (ImpactBase & {
        /** Its balls are the cue ball and those that it moves at the same instant. */
        readonly type: "cue-strike";
        /** How often the tip meets the cue ball; a trace of an early engine does not have it. */
        readonly tip_contacts?: number;
        /** Whether the cue ball, with the tip on it, meets a ball that it did not touch before. */
        readonly pushed?: boolean;
      })
    | (ImpactBase & { readonly type: "ball-collision" | "slate-collision" })
    | (ImpactBase & {
        readonly type: "rail-collision";
        readonly rail: RailName;
        readonly part: CushionPart;
      })
    | { readonly type: "off-table" }
    | { readonly type: "pocket-collision"; readonly pocket: PocketName }
    | { readonly type: "motion-transition"; readonly from: Motion; readonly to: Motion }
  );

/** The outcome of a shot, for a referee. Lists of contacts are in the order of time. */
export interface Outcome {
  /** The struck ball; without a strike the ball `cue`; null if there is none. */
  readonly cue_ball: string | null;
  /** The first ball that the cue ball touches; null if it touches none. */
  readonly first_contact: string | null;
  readonly pocketed: readonly (readonly [ball: string, pocket: PocketName])[];
  readonly cue_ball_scratched: boolean;
  readonly off_table: readonly string[];
  /** Balls at rest whose centre is nearer than a radius to the hole of a pocket. */
  readonly hanging: readonly (readonly [ball: string, pocket: PocketName])[];
  /** Balls that flew over another ball, without a contact of the two at either end of the flight. */
  readonly jumped: readonly (readonly [ball: string, over: string])[];
  /** Cushions that the cue ball touches before its first contact with a ball. */
  readonly rails_before_first_contact: readonly RailName[];
  /** Per ball, every contact with a cushion after that first contact. */
  readonly rails_after_first_contact: Readonly<Record<string, readonly RailName[]>>;
  /** Balls that touch a rail to which they were not frozen, or to which they come back. */
  readonly driven_to_rail: readonly string[];
  readonly cue_ball_touched: readonly ({ readonly ball: string } | { readonly rail: RailName })[];
  /** How often the tip meets the cue ball: more than once in a double hit; 0 without a strike. */
  readonly tip_contacts: number;
  /** Whether the cue ball, with the tip on it, meets a ball that it did not touch before. */
  readonly pushed: boolean;
  /** Balls that the cue ball meets during the strike, those included that touched it before. */
  readonly met_during_strike: readonly string[];
  /** Balls that no friction stops: their last path continues after the trace's duration. */
  readonly never_resting: readonly string[];
  /** Whether the tip offset is beyond the miscue limit. */
  readonly miscue: boolean;
  /** Id of the ball or name of the rail in the way of the cue. */
  readonly cue_obstructed: string | null;
  /**
   * Least elevation at which the cue passes through nothing. Null without a strike, or if there is
   * something in its way at every elevation.
   */
  readonly least_elevation_deg: number | null;
  readonly events: number;
}

/**
 * What ended a shot: nothing more can happen; its end time, at which a ball still moves; or its cap of
 * events, in the trace of an error.
 */
export type TraceEnd = "rest" | "until" | "cap";

/** A `carom-trace/1`. */
export interface TraceFile {
  readonly format: "carom-trace/1";
  readonly engine: string;
  readonly shot: ShotFile;
  /** From the strike to the end, s. */
  readonly duration: number;
  /** Traces of early versions do not have it. */
  readonly end?: TraceEnd;
  readonly events: readonly TraceEvent[];
  readonly final: readonly BallState[];
  readonly outcome: Outcome;
  readonly hash: string;
}

/** Five numbers about a strike: speed (m/s), azimuth (rad), elevation (rad), side (m), height (m). */
export type StrikeErrors = readonly [number, number, number, number, number];

/**
 * A player's execution errors, and cling. The Gaussian parts add up: the error is normal, its mean is the
 * bias, and its covariance is the sum of `covariance` and the squared standard deviations.
 */
export interface Noise {
  /** Of the contact point sideways, m. */
  readonly side_m: number;
  /** Of the contact point in height, m. */
  readonly height_m: number;
  /** rad. */
  readonly elevation: number;
  /** rad. */
  readonly azimuth: number;
  /** m/s. */
  readonly speed: number;
  /** Probability with which a contact of two balls clings, 0 to 1. Default 0. */
  readonly cling_probability?: number;
  /** Coefficient of friction of a contact that clings. Default 0.22. */
  readonly cling_friction?: number;
  /** Standard deviation of a further error of the speed, as a share of it, 0 to 1. Default 0. */
  readonly speed_relative?: number;
  /** Covariance of errors that depend on each other. */
  readonly covariance?: readonly StrikeErrors[];
  /** Mean of the error, executed minus intended. */
  readonly bias?: StrikeErrors;
  /** Measured errors in place of standard deviations and a covariance; each is equally likely. */
  readonly samples?: readonly StrikeErrors[];
}

/** Which variants `Shot.vary` draws. */
export interface VaryOptions {
  /** Of the random numbers, a whole number. Default 0. */
  readonly seed?: number;
  /** Number of the first variant. Default 0. */
  readonly first?: number;
}

/** Final states of many shots, without traces. Row k is shot k; failed shots have NaN positions. */
export interface Batch {
  /** Rows. */
  readonly shots: number;
  /** Columns: number of balls of the largest shot. */
  readonly balls: number;
  /** x, y, z (m) per ball and shot: `3 * (shot * balls + ball)`. */
  readonly final_position: Float64Array;
  /** @deprecated Old name of `final_position`. */
  readonly finalPosition?: Float64Array;
  /** Per ball and shot the index into `Geometry.pockets`, or `ON_TABLE`, `OFF_TABLE`, `PADDING`. */
  readonly pocket: Int8Array;
  /** Number of events of each shot. */
  readonly events: Int32Array;
  /** Error messages, by index of the shot. */
  readonly errors: ReadonlyMap<number, string>;
  /** The same errors with their kinds and parts. */
  readonly refusals: ReadonlyMap<number, Refusal>;
}

/** The `Batch` of the variants of a shot. */
export interface NoisyBatch extends Batch {
  /** The drawn strikes: speed, azimuth, elevation, side, height per variant, as in `Strike`. */
  readonly strikes: Float64Array;
}

/** `Batch.pocket` of a ball that is on the table at the end. */
export const ON_TABLE = -1;
/** `Batch.pocket` of a ball that left the table. */
export const OFF_TABLE = -2;
/** `Batch.pocket` of a ball that the shot does not have, and of a failed shot. */
export const PADDING = -3;

/** A strike that pots a ball. */
export interface PotAim {
  readonly strike: Strike;
  /** By how much the azimuth may be wrong on either side, rad; at most 3°. */
  readonly margin: number;
  /** "direct", "bank", "kick", "combination" and so on, joined by "+". */
  readonly kind: string;
  /** Rails and balls in the order in which they are met. */
  readonly route: string;
  /** Whether the cue ball falls into a pocket or leaves the table. */
  readonly losesCueBall: boolean;
}

/** A strike that pots a ball and leaves the cue ball near a place. */
export interface LeaveAim {
  readonly strike: Strike;
  /** Where the cue ball stops, m. */
  readonly end: Point;
  /** Its distance from the place, m. */
  readonly distance: number;
  /** Whether that is at most 2 cm. */
  readonly isReached: boolean;
  /** The share of variants in which the ball falls and the cue ball stops within 15 cm of `end`. */
  readonly chance: number;
}

export interface LeaveOptions {
  /** The errors under which strikes that reach the place are ranked. Default: the Olympiad's. */
  readonly noise?: Noise;
  /** Number of variants. Default 100. */
  readonly variants?: number;
  /** Least and greatest speed of the cue, m/s. Default 0.5 and 7. */
  readonly speed?: readonly [least: number, most: number];
  /** Largest tip offset, ball radii. Default 0.45. */
  readonly offset?: number;
}

/** A validated shot; immutable. */
export interface Shot {
  /** The shot file as a value, with the elevation that is used; parsed on first use. */
  readonly file: ShotFile;
  /** The shot file without an elevation that is the default, so that it follows changes. */
  readonly source: ShotFile;
  /** Whether the elevation was omitted, so that it is the default. */
  readonly hasDefaultElevation: boolean;
  /** The shot file as JSON; its numbers are exactly those that were read. */
  json(): string;
  readonly geometry: Geometry;
  /**
   * All values of the physics by their keys in a shot file. A coefficient that the file gives as a formula
   * or by the name of a surface keeps this form.
   */
  readonly physics: Readonly<Record<string, unknown>>;
  readonly balls: readonly BallInfo[];
  /** The struck ball's index, or null without a strike. */
  readonly struck: number | null;
  /** The strike, or null. */
  readonly strike: Strike | null;
  /**
   * The largest tip offset √(side² + height²) without a miscue, in ball radii.
   */
  readonly miscueLimit: number;
  /**
   * A coefficient of the shot's physics at a speed, m/s: of a rolling ball, of slip, or perpendicular to
   * the rail; `cushion.friction` at an angle of incidence, rad.
   * @throws CaromError for another key, and for a speed or angle that is negative or not finite.
   */
  coefficientAt(key: CoefficientKey, at: number): number;
  /**
   * Simulates the shot and judges it by a goal; `left` are the balls that a run still has to pot.
   * @throws CaromError for a damaged goal, one with a ball that the shot lacks, and a shot without a strike.
   */
  judge(goal: Goal, left?: readonly string[]): ShotVerdict;
  /**
   * The same shot with another strike; about a microsecond. Without an elevation it is the default.
   * @throws CaromError for a strike that the engine refuses in a file, and if the shot has no strike.
   */
  withStrike(strike: StrikeInput): Shot;
  /** End time, s since the strike; null if the shot ends when all balls are at rest. */
  readonly until: number | null;
  /**
   * The same shot with another end time, s since the strike; null for an end at rest.
   * @throws CaromError for a time that is not above 0, or not finite.
   */
  withUntil(until: number | null): Shot;
  /**
   * @throws CaromError if the cap of events is reached; `Engine.traceToCap` gives the trace so far. If no
   * friction stops a ball between the rails, its place is `until`.
   */
  simulate(): Trace;
  /**
   * The strike turned so that `ball` falls into `pocket`; speed, spin and elevation stay. If the shot pots
   * it already, the azimuth moves to the middle of those that do. Some milliseconds.
   * @param ball Id of an object ball.
   * @param pocket Name of a pocket, as in `Geometry.pockets`.
   * @param options `near`: whether the ball must almost fall already, which takes less than a
   * millisecond; otherwise all direct lines, banks, kicks and combinations are tried.
   * @returns null if no line was found.
   * @throws CaromError for an unknown ball or pocket, for the cue ball, and without a strike.
   */
  potAim(ball: string, pocket: string, options?: { readonly near?: boolean }): PotAim | null;
  /**
   * The strike that pots `ball` into `pocket` and leaves the cue ball nearest to a place; among those that
   * reach it, the most probable one. The line is that of the shot's own strike if its ball almost falls,
   * or else the straight one. Some tenths of a second: call it in a worker.
   * @returns null if no strike pots the ball.
   * @throws CaromError as `potAim`, and for an option out of range.
   */
  leaveAim(ball: string, pocket: string, place: Point, options?: LeaveOptions): LeaveAim | null;
  /**
   * Variant `index` of `vary` as an ordinary shot, with its strike and the contacts that cling.
   * @throws CaromError as `vary`, and if the drawn strike cannot be played.
   */
  variant(noise: Noise, index?: number, options?: { readonly seed?: number }): Shot;
  /**
   * Simulates `n` variants of this shot with execution noise, numbered from `first`. Variant k of a
   * seed is the same in every batch, and the same as in Python.
   * @throws CaromError without a strike, for a σ that is negative or out of range, and for more
   * variants than fit into memory.
   */
  vary(noise: Noise, n: number, options?: VaryOptions): NoisyBatch;
  /** @deprecated Old order of the arguments. */
  vary(noise: Noise, seed: number, first: number, count: number): NoisyBatch;
  /** Frees the memory at once instead of at garbage collection. The object is unusable afterwards. */
  free(): void;
}

/** A simulated shot with all its events; immutable. */
export interface Trace {
  /** From the strike to the end, s: to the last event, or to `until` if a ball still moves then. */
  readonly duration: number;
  readonly end: TraceEnd;
  /** Sixteen hexadecimal digits over the exact bits of all events and final states. */
  readonly hash: string;
  /** The simulated shot; it stays valid when the trace is freed. */
  readonly shot: Shot;
  /** A `carom-trace/1`. */
  json(): string;
  /** Parsed on first use. */
  readonly events: readonly TraceEvent[];
  readonly outcome: Outcome;
  /**
   * All balls at `time` (s, ≥ 0): `STRIDE` numbers per ball, exact to rounding. At the time of an event
   * these are the states after it; after the end, the final states.
   * @param out Array of `STRIDE` × balls numbers that is filled and returned.
   * @throws CaromError for a time that is not a number, negative or not finite, RangeError for an `out` of
   * another length.
   */
  statesAt(time: number, out?: Float64Array): Float64Array;
  /**
   * The path of a ball's centre: x, y, z (m), t (s) per point. The points lie on the exact path, one at
   * each event of the ball; no chord is further than `tolerance` (m) from the path.
   * @param ball Index into `Shot.balls`.
   * @throws RangeError for an unknown ball, or a tolerance that is not above 0.
   */
  polyline(ball: number, tolerance: number): Float64Array;
  /**
   * What a diamond system says of the way of ball number `ball` behind event number `event`, or from the beginning,
   * up to its contact with another ball; null if no system fits, and on tables without sights.
   */
  diamondReading(ball: number, event?: number): DiamondReading | null;
  /** The route of the cue ball to its second object ball; null if it meets fewer than two. */
  caromRoute(): CaromRoute | null;
  /**
   * What the cue ball touches up to its second object ball, as a referee of carom counts it: the number of each event
   * with the ball, or null for a cushion.
   */
  countedTouches(): readonly (readonly [event: number, ball: string | null])[];
  /** Frees the memory at once instead of at garbage collection. The object is unusable afterwards. */
  free(): void;
}
