/** The viewer: a table, its balls and what happens on it, in three dimensions. */

export { look, type Look } from "./balls/look";
export { STRIDE } from "./types";
export type { Area, BallPath, CameraMode, CuePose, Mark, Pick, Quality, Theme } from "./types";
export { Viewer, type ViewerOptions } from "./viewer";
