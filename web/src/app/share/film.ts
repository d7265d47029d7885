/** Exports the replay as a film, with a progress bar and a button to cancel. */

import { STRIDE, type Trace } from "../../engine/types.ts";
import type { Context } from "../common/context.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import { RATES } from "../replay/replay-clock.ts";
import type { Store } from "../document/store.ts";
import { errorText } from "../common/refusals.ts";
import { download } from "./download.ts";
import { LOW } from "../../viewer/quality.ts";
import { canFilm, film } from "./video.ts";
import { decimal, t } from "../words/translate.ts";

/** Frames per second. */
const FPS = 30;

export function filmSection(store: Store, context: Context): HTMLElement {
  const rate = h(
    "select",
    { id: uniqueId("rate") },
    ...RATES.filter((r) => r <= 1).map((r) =>
      h("option", { value: r }, r === 1 ? t("film.normal") : t("film.slower", { count: 1 / r })),
    ),
  );
  const start = h("button", { type: "button", class: "button", id: "film" }, t("film.download"));
  const cancel = h("button", { type: "button", class: "button", hidden: true }, t("film.cancel"));
  const bar = h("progress", { max: 1, value: 0, hidden: true, "aria-label": t("film.encoded") });
  const said = h("p", { class: "hint", role: "status" });
  let abort: AbortController | null = null;

  const run = async (): Promise<void> => {
    const trace = store.session.replay.trace ?? store.ghost.trace;
    if (!trace || abort) return;
    abort = new AbortController();
    const { signal } = abort;
    start.disabled = true;
    cancel.hidden = bar.hidden = false;
    setText(said, t("film.encoding"));
    try {
      const blob = await record(trace, Number(rate.value), store, context, signal, (share) => {
        bar.value = share;
      });
      download(blob, "carom.mp4");
      setText(said, t("film.ready", { megabytes: decimal(blob.size / 1e6, 1) }));
    } catch (error) {
      setText(said, signal.aborted ? t("film.cancelled") : errorText(error));
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
    setText(said, t("film.cannot"));
  }
  return h(
    "section",
    {},
    h("h3", {}, t("film.heading")),
    h("div", { class: "row" }, h("label", { for: rate.id }, t("film.speed")), rate, start, cancel),
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
