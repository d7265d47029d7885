/** What every part of the page is given besides the store. */

import type { BallInfo, Engine, Geometry } from "../engine/index.ts";
import type { FrameLoop } from "./frame.ts";

/** The part of the viewer's class that the page relies on. */
export interface Viewer {
  camera: "top" | "orbit" | "cue";
  quality: "auto" | "low" | "high";
  readonly stats: { readonly frameMs: number };
  /** Whether the picture is older than what was set, or still on its way (a camera that glides). */
  readonly needsFrame: boolean;
  setTable(geometry: Geometry, balls: readonly BallInfo[]): void;
  /** `STRIDE` numbers per ball. */
  setBalls(states: Float64Array): void;
  setPaths(paths: { ball: number; points: Float64Array; style: "ghost" | "trace" }[]): void;
  setFan(points: Float64Array | null, paths?: Float32Array[]): void;
  setCue(cue: CuePose | null): void;
  setMarks(
    marks: { position: readonly [number, number, number]; kind: string; ball?: number }[],
  ): void;
  select(ball: number | null): void;
  setCamera(mode: "top" | "orbit" | "cue", instant?: boolean): void;
  resetView(): void;
  pick(clientX: number, clientY: number): { ball: number | null; point: [number, number] | null };
  render(): void;
  capture(): Promise<Blob>;
  dispose(): void;
}

export interface CuePose {
  ball: number;
  azimuth: number;
  elevation: number;
  side: number;
  height: number;
  pull: number;
}

export interface Context {
  readonly engine: Engine;
  readonly viewer: Viewer;
  readonly loop: FrameLoop;
  /** Says a sentence to everybody: on screen for a while, and to screen readers at once. */
  announce(sentence: string): void;
  /** Whether the user asks for less motion, at this moment. */
  reducedMotion(): boolean;
}
