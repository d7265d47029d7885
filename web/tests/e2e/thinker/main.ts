/** A page in one file with a thinker, whose worker is in the file too. */

import { load } from "../../../src/engine/index.ts";
import { connectThinker } from "../../../src/engine/thinker-client.ts";
import ThinkerWorker from "../../../src/engine/thinker-worker.ts?worker&inline";

window.thinking = load().then(async (engine) => {
  const noise = engine.noisePresets.club!;
  return connectThinker(engine, new ThinkerWorker(), { noise, simulations: 300, seed: 4 });
});
