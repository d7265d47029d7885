/** The page's side of the worker that makes puzzles. */

import type { Engine, Puzzle } from "../../../engine/index.ts";
import type { FromMaker, ToMaker } from "./puzzle-protocol.ts";
import PuzzleWorker from "./puzzle-worker.ts?worker&inline";

/** Makes the puzzle of an id. The promise is rejected if this browser cannot run the worker. */
export function makePuzzle({ module }: Pick<Engine, "module">, id: string): Promise<Puzzle> {
  return new Promise((resolve, reject) => {
    const worker = new PuzzleWorker();
    worker.onmessage = ({ data }: MessageEvent<FromMaker>) => {
      worker.terminate();
      if (data.kind === "puzzle") resolve(data.puzzle);
      else reject(new Error(data.message));
    };
    worker.onerror = () => {
      worker.terminate();
      reject(new Error("the worker did not start"));
    };
    const message: ToMaker = { module, id };
    worker.postMessage(message);
  });
}
