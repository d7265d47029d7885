// Where the parts of a ball's state stand in the engine's array (see `STRIDE` there).

export const POSITION = 0;
export const VELOCITY = 3;
export const SPIN = 6;
export const MOTION = 13;
