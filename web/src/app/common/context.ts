/** What every part of the page is given besides the store. */

import type { Engine } from "../../engine/index.ts";
import type { Viewer } from "../../viewer/index.ts";
import type { FrameLoop } from "./frame-loop.ts";

export interface Context {
  readonly engine: Engine;
  readonly viewer: Viewer;
  readonly loop: FrameLoop;
  /** Says a sentence to everybody: on screen for a while, and to screen readers at once. */
  announce(sentence: string): void;
  /** Whether the user asks for less motion, at this moment. */
  reducedMotion(): boolean;
}
