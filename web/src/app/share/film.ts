/** Exports the replay as a film, with a progress bar and a button to cancel. */

import { STRIDE, type Trace } from "../../engine/types.ts";
import type { Context } from "../common/context.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import { RATES } from "../replay/clock.ts";
import type { Store } from "../document/store.ts";
import { errorText } from "../common/words.ts";
import { download } from "./download.ts";
import { LOW } from "../../viewer/quality.ts";
import { canFilm, film } from "./video.ts";

/** Frames per second. */
const FPS = 30;

export function filmSection(store: Store, context: Context): HTMLElement {
  const rate = h(
    "select",
    { id: uniqueId("rate") },
    ...RATES.map((r) => h("option", { value: r }, r === 1 ? "normal" : `${1 / r} times slower`)),
  );
  const start = h("button", { type: "button", class: "button", id: "film" }, "Download film");
  const cancel = h("button", { type: "button", class: "button", hidden: true }, "Cancel");
  const bar = h("progress", { max: 1, value: 0, hidden: true, "aria-label": "Film encoded" });
  const said = h("p", { class: "hint", role: "status" });
  let abort: AbortController | null = null;

  const run = async (): Promise<void> => {
    const trace = store.session.trace ?? store.ghost.trace;
    if (!trace || abort) return;
    abort = new AbortController();
    const { signal } = abort;
    start.disabled = true;
    cancel.hidden = bar.hidden = false;
    setText(said, "Encoding …");
    try {
      const blob = await record(trace, Number(rate.value), store, context, signal, (share) => {
        bar.value = share;
      });
      download(blob, "carom.mp4");
      setText(said, `The film is ready, ${(blob.size / 1e6).toFixed(1)} MB.`);
    } catch (error) {
      setText(said, signal.aborted ? "Cancelled." : errorText(error));
    } finally {
      abort = null;
      start.disabled = false;
      cancel.hidden = bar.hidden = true;
    }
  };
  start.addEventListener("click", () => void run());
  cancel.addEventListener("click", () => abort?.abort());
  if (!canFilm()) {
    start.disabled = true;
    setText(
      said,
      "This browser cannot encode films: use a recent Chrome, Edge, Firefox or Safari.",
    );
  }
  return h(
    "section",
    {},
    h("h3", {}, "Film of the shot"),
    h("div", { class: "row" }, h("label", { for: rate.id }, "Speed"), rate, start, cancel),
    bar,
    said,
  );
}

/** Films with the present camera, then restores the page's own picture. */
async function record(
  trace: Trace,
  rate: number,
  store: Store,
  { viewer, loop }: Context,
  signal: AbortSignal,
  progress: (share: number) => void,
): Promise<Blob> {
  const canvas = document.querySelector<HTMLCanvasElement>("#table")!;
  const states = new Float64Array(STRIDE * trace.shot.balls.length);
  const { quality } = viewer;
  // The same quality in all frames.
  if (quality === "auto") viewer.quality = viewer.stats.level < LOW ? "high" : "low";
  viewer.setCue(null);
  viewer.setMarks([]);
  try {
    return await film({
      canvas,
      duration: trace.duration,
      rate,
      fps: FPS,
      signal,
      progress,
      draw: (time) => {
        viewer.setBalls(trace.statesAt(time, states));
        viewer.render();
      },
    });
  } finally {
    viewer.quality = quality;
    store.setSession({}); // makes the scene show its own time again
    loop.invalidate();
  }
}
