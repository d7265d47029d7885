/** Makes a puzzle in a worker, so that the page stays responsive. */

import { load } from "../../../engine/core.ts"; // without embedded WebAssembly: the page sends it
import type { FromMaker, ToMaker } from "./puzzle-protocol.ts";

const send = (message: FromMaker) => postMessage(message);

addEventListener("message", ({ data }: MessageEvent<ToMaker>) => {
  load(data.module)
    .then((engine) => send({ kind: "puzzle", puzzle: engine.puzzle(data.id) }))
    .catch((error: unknown) => send({ kind: "failed", message: String(error) }));
});
