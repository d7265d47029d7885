/** The shot that the page aims. */

import type { ShotFile, StrikeEntry } from "../../engine/index.ts";

/** A shot file with a strike. */
export type AimedShot = ShotFile & { readonly strike: StrikeEntry };
