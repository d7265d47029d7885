/** The viewer: draws a table, its balls and a shot in three dimensions. */

export { look, type Look } from "./balls/look";
export { type Density, RAMP } from "./overlay/density";
export { STRIDE } from "./types";
export type {
  Area,
  BallPath,
  CameraMode,
  CuePose,
  HitResult,
  Lit,
  Mark,
  PickResult,
  Quality,
  Theme,
} from "./types";
export { Viewer, type ViewerOptions } from "./viewer";
