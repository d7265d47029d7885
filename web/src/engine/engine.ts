/** The engine's interface: what `load` gives. */

import type { Frame, FrameOptions, FrameTerms } from "./rules.js";
import type { Batch, Geometry, Noise, Shot, ShotFile, Trace, TraceFile } from "./types.js";

export interface BreakOptions {
  /** Table preset; default: the game's. */
  readonly table?: string;
  /** Cue's speed, m/s; default: a usual one. */
  readonly speed?: number;
  /** Of the rack: which ball stands where, and the gaps. Default 0. */
  readonly seed?: number;
  /** Mean gap between touching balls, m; default: a usual one. */
  readonly gap?: number;
}

/** The engine, compiled and ready. */
export interface Engine {
  /** To be posted to a worker, which hands it to its own `load`. */
  readonly module: WebAssembly.Module;
  /** As in traces: `carom x.y.z`. */
  readonly version: string;
  /** Games that can be racked. */
  readonly games: readonly string[];
  /** Table presets. */
  readonly tables: readonly Geometry[];
  /** Physics presets by name: every parameter, as in a shot file. */
  readonly physics: Readonly<Record<string, Readonly<Record<string, unknown>>>>;
  /** @throws CaromError whose message names the place, what is wrong there, what would be right. */
  shot(file: string | ShotFile): Shot;
  /** Reads a saved trace. @throws CaromError as `shot`. */
  trace(file: string | TraceFile): Trace;
  /** The opening shot of a game. @throws CaromError for names that are not known. */
  breakShot(game: string, options?: BreakOptions): Shot;
  /** Simulates all shots, without traces. */
  simulate(shots: readonly Shot[]): Batch;
  /** The Computational Olympiad's noise times `multiplier`; its tournaments: 0.5, 1 and 2. */
  olympiad(multiplier?: number): Noise;
  /**
   * Presets of execution noise by name: levels of play from "beginner" to "professional" (estimated),
   * then "olympiad" (published).
   */
  readonly noisePresets: Readonly<Record<string, Noise>>;
  /**
   * Checks that a noise has every σ, each within its range.
   * @throws CaromError that names the σ.
   */
  checkNoise(noise: Noise): void;
  /** Games that have a referee here. */
  readonly ruleSets: readonly string[];
  /** The table that a game is played on if nothing else is said. @throws CaromError as `frame`. */
  usualTable(game: string): string;
  /** Racks a frame of one of the `ruleSets`. @throws CaromError for what makes no sense. */
  frame(game: string, options?: FrameOptions): Frame;
  /**
   * A frame that goes on with the balls of a shot, on its table: player 0 shoots from where the cue
   * ball lies, and balls that the shot does not have are down.
   * @throws CaromError if the game has no such balls, or would be over with them.
   */
  frameOf(game: string, shot: Shot, terms?: FrameTerms): Frame;
  /** The JSON Schema of a file. */
  schema(kind: "shot" | "trace"): object;
}
