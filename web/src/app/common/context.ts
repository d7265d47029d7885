/** Services that every part of the page receives in addition to the store. */

import type { Engine } from "../../engine/index.ts";
import type { Viewer } from "../../viewer/index.ts";
import type { DrawLoop } from "./draw-loop.ts";

export interface Context {
  readonly engine: Engine;
  readonly viewer: Viewer;
  readonly loop: DrawLoop;
  /** Shows a sentence for some seconds; screen readers read it at once. */
  announce(sentence: string): void;
  /** Whether the user prefers reduced motion at present. */
  reducedMotion(): boolean;
}
