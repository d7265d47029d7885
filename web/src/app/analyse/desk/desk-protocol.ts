/** The messages between the page and a desk: a worker that answers the questions of the analysis. */

import type {
  FrameRecord,
  LeaveAim,
  Noise,
  Play,
  PocketName,
  Point,
  ShotFile,
  Strike,
  Refusal,
} from "../../../engine/index.ts";
import type { FoundPot, PotQuestion } from "../../document/store.ts";

/** How often a strike does what it is meant to do. */
export interface ChanceJob {
  readonly kind: "chance";
  readonly noise: Noise;
  /** How many variants. */
  readonly count: number;
  readonly of:
    | {
        /** A shot file. The ball falls into the pocket, and the struck ball stays on the table. */
        readonly shot: string;
        readonly ball: string;
        readonly pocket: PocketName;
      }
    /** The player of a frame keeps the turn with a play, or wins. */
    | { readonly record: FrameRecord; readonly play: Play };
}

/** Variants so far, and those that do it. */
export interface ChancePart {
  readonly met: number;
  readonly count: number;
}

/** The strike that keeps a pot and stops the cue ball at a place. */
export interface LeaveJob {
  readonly kind: "leave";
  /** A shot file. */
  readonly shot: string;
  readonly ball: string;
  readonly pocket: PocketName;
  readonly place: Point;
  readonly noise: Noise;
}

/** From where on the table a ball is potted how often. */
export interface ZoneJob {
  readonly kind: "zone";
  /** A shot file without the balls that have fallen by then. */
  readonly shot: string;
  /** The ball that is to be potted next. */
  readonly ball: string;
  readonly noise: Noise;
}

/** A plan of some balls in a row. */
export interface PlanJob {
  readonly kind: "plan";
  /** A shot file. */
  readonly shot: string;
  /** The orders of balls among which one is chosen. */
  readonly orders: readonly (readonly string[])[];
  /** Balls in each order. */
  readonly length: number;
  readonly noise: Noise;
  /** How often the whole plan is played. */
  readonly runs: number;
}

/** One ball of a plan. */
export interface Leg {
  readonly ball: string;
  readonly pocket: PocketName;
  readonly strike: Strike;
  /** The shot, as it is if those before went exactly as planned. */
  readonly shot: ShotFile & { readonly strike: NonNullable<ShotFile["strike"]> };
  /** The chance of the pot alone, counted. */
  readonly chance: number;
  /** Where the cue ball stops in the variants in which the ball falls, m. */
  readonly stops: readonly Point[];
}

/** The first of some pockets into which a ball can be potted with the strike of a shot. */
export type PotJob = { readonly kind: "pot" } & PotQuestion;

export type Job = ChanceJob | LeaveJob | ZoneJob | PlanJob | PotJob;

/** What a job gives, perhaps several times. */
export interface Parts {
  readonly chance: ChancePart;
  /** Null if there is no line. */
  readonly pot: { readonly found: FoundPot | null };
  /** Null if no strike pots the ball. */
  readonly leave: { readonly aim: LeaveAim | null };
  /** Chances per cell, row by row from the bottom left; `share` of the cells is done. */
  readonly zone: {
    readonly columns: number;
    readonly rows: number;
    readonly values: Float32Array;
    readonly share: number;
  };
  /** The balls planned so far, and how many of `count` runs pot all of them. */
  readonly plan: { readonly legs: readonly Leg[]; readonly met: number; readonly count: number };
}

export type PartOf<J extends Job> = Parts[J["kind"]];

export type ToDesk =
  | { readonly kind: "engine"; readonly module: WebAssembly.Module }
  /** A new question replaces the one before. */
  | { readonly kind: "ask"; readonly id: number; readonly job: Job }
  | { readonly kind: "cancel"; readonly id: number };

export type FromDesk =
  | { readonly kind: "part"; readonly id: number; readonly part: Parts[keyof Parts] }
  | { readonly kind: "done"; readonly id: number }
  | { readonly kind: "failed"; readonly id: number; readonly refusal: Refusal };
