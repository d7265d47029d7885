/** The viewer: draws a table, its balls and a shot in three dimensions. */

export { LOUPE } from "./render/stage.ts";
export { look, type Look } from "./balls/look.ts";
export { clothColor } from "./theme-colors.ts";
export { type Density, RAMP } from "./overlay/density.ts";
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
} from "./viewer-types.ts";
export { arrowHead, MARK_COLORS, MARK_HEIGHT } from "./overlay/drawn-marks.ts";
export { Viewer, type ViewerOptions } from "./viewer.ts";
