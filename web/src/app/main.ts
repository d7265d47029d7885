/** Starts the page: engine, first document, viewer and frame loop. */

import "./style.css";
import { load } from "../engine/index.ts";
import { Viewer } from "../viewer/index.ts";
import type { Context } from "./common/context.ts";
import { FrameLoop } from "./common/frame-loop.ts";
import { referee } from "./game/referee.ts";
import { mountNotices } from "./shell/notices.ts";
import { mountPage, place } from "./page.ts";
import { applyLanguage } from "./shell/language.ts";
import { Scene } from "./scene.ts";
import { startOf } from "./start.ts";
import { Store } from "./document/store.ts";
import { shownTheme } from "./shell/theme.ts";
import { errorText } from "./common/refusals.ts";
import { t } from "./words/translate.ts";

const REDUCED_MOTION = matchMedia("(prefers-reduced-motion: reduce)");

async function start(): Promise<void> {
  applyLanguage();
  const engine = await load();
  const first = startOf(engine);
  const store = new Store(referee(engine), first.document, first.view);
  let draw = () => false;
  const loop = new FrameLoop(() => draw());
  const viewer = new Viewer(place("table") as HTMLCanvasElement, {
    theme: shownTheme(store.view.theme),
    reducedMotion: REDUCED_MOTION.matches,
    onChange: () => {
      loop.invalidate();
    },
  });
  const context: Context = {
    engine,
    viewer,
    loop,
    announce: mountNotices(place("notice")),
    reducedMotion: () => REDUCED_MOTION.matches,
  };
  const scene = new Scene(store, context);
  mountPage(store, context, first.welcome);
  first.then(store, context);
  draw = () => {
    scene.update();
    if (viewer.needsFrame) viewer.render();
    return viewer.needsFrame;
  };
  window.carom = { store, engine, viewer, scene };
  // The page is usable once the first picture is drawn. Tests wait for this mark; a benchmark reads it.
  loop.input("first picture", () =>
    requestAnimationFrame(() => performance.mark("carom:interactive")),
  );
}

declare global {
  interface Window {
    /**
     * For tests and experiments in the console: the state (`carom.store.strike({speed: 3}, "try")`), the
     * engine (`carom.engine.shot(json).simulate().hash`), the viewer, and the timings of the scene.
     */
    carom?: Pick<Context, "engine" | "viewer"> & { store: Store; scene: Scene };
  }
}

start().catch((error: unknown) => {
  const refusal = place("refusal");
  refusal.hidden = false;
  refusal.textContent = t("error.start", { why: errorText(error) });
  console.error(error);
});
