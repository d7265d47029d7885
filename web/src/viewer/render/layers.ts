/** Layers of the scene, which the stage draws together or one by one. */

/** Balls, cue, lines and marks: the default of every object. */
export const MOVING = 0;
/** What rests while the camera rests: table and floor. */
export const STILL = 1;
/** The table as depth only, so that it hides what is behind it without its pixels drawn again. */
export const DEPTH = 2;
