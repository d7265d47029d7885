/** The files of texts: a new one is added here, and each language has a file of the same name. */

export { texts as aim } from "./aim.ts";
export { texts as carom } from "./carom.ts";
export { texts as diagram } from "./diagram.ts";
export { texts as drills } from "./drills.ts";
export { texts as draw } from "./draw.ts";
export { texts as analyse } from "./analyse.ts";
export { texts as game } from "./game.ts";
export { texts as kept } from "./kept.ts";
export { texts as library } from "./library.ts";
export { texts as layout } from "./layout.ts";
export { texts as own } from "./own.ts";
export { texts as page } from "./page.ts";
export { texts as physics } from "./physics.ts";
export { texts as play } from "./play.ts";
export { texts as pot } from "./pot.ts";
export { texts as presets } from "./presets.ts";
export { texts as puzzle } from "./puzzle.ts";
export { texts as recorded } from "./recorded.ts";
export { texts as replay } from "./replay.ts";
export { texts as share } from "./share.ts";
export { texts as shot } from "./shot.ts";
export { texts as train } from "./train.ts";
export { texts as whatif } from "./whatif.ts";
