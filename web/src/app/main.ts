/**
 * Starts the page: engine, first document, viewer and draw loop. In tasks of their own, between which the page
 * paints and answers.
 */

import "./style.css";
import { load } from "../engine/index.ts";
import { Viewer } from "../viewer/index.ts";
import type { Context } from "./common/context.ts";
import { DrawLoop } from "./common/draw-loop.ts";
import { nextTask } from "../engine/next-task.ts";
import { inSlices } from "./common/slices.ts";
import { referee } from "./game/referee.ts";
import { makeInstallable } from "./install.ts";
import { mountNotices } from "./shell/notices.ts";
import { mountPage, place } from "./page.ts";
import { applyLanguage } from "./shell/language.ts";
import { followOrientation, orientationOf } from "./common/seen.ts";
import { FIRST_VIEW } from "./document/document.ts";
import { Scene } from "./scene.ts";
import { startOf } from "./start.ts";
import { Store } from "./document/store.ts";
import { shownTheme } from "./shell/theme-choice.ts";
import { errorText } from "./common/refusals.ts";
import { t } from "./words/translate.ts";

/** Distance (m) over which the direction of the table in the picture is measured. */
const ASIDE = 0.1;

const REDUCED_MOTION = matchMedia("(prefers-reduced-motion: reduce)");

async function start(): Promise<void> {
  applyLanguage();
  // The engine compiles while the name of the page is painted and the viewer starts.
  const loading = load();
  await painted();
  const table = place("table") as HTMLCanvasElement;
  // Hidden until its first picture is drawn: the browser would wait for that on the main thread.
  table.style.visibility = "hidden";
  let draw = () => false;
  const loop = new DrawLoop(() => draw());
  const viewer = new Viewer(table, {
    theme: shownTheme(FIRST_VIEW.theme),
    reducedMotion: REDUCED_MOTION.matches,
    onChange: () => {
      loop.invalidate();
    },
  });
  await nextTask();
  await inSlices(viewer.compile());
  const engine = await loading;
  await nextTask();
  const first = await startOf(engine);
  await nextTask();
  const store = new Store(referee(engine), first.document, first.view);
  followOrientation(() => store.session.orientation);
  const context: Context = {
    engine,
    viewer,
    loop,
    announce: mountNotices(place("notice")),
    reducedMotion: () => REDUCED_MOTION.matches,
  };
  await nextTask();
  viewer.setTable(store.shot.geometry, store.shot.balls);
  await nextTask();
  const scene = new Scene(store, context);
  scene.update();
  await nextTask();
  const mountParts = mountPage(store, context, first);
  window.carom = { store, engine, viewer, scene };
  await nextTask();
  viewer.resize();
  scene.update();
  viewer.render();
  const drawn = viewer.finished();
  // The texts that the parts make at once already name the pockets as the picture shows them.
  readOrientation(store, viewer);
  // The parts are mounted while another process draws the first picture.
  await inSlices(mountParts());
  first.begin(store, context);
  await drawn;
  table.style.visibility = "";
  draw = () => {
    scene.update();
    if (viewer.needsPicture) viewer.render();
    readOrientation(store, viewer);
    return viewer.needsPicture;
  };
  loop.invalidate();
  makeInstallable();
  // The page is usable once the first picture is drawn. Tests wait for this mark; a benchmark reads it.
  requestAnimationFrame(() => performance.mark("carom:interactive"));
}

/** Time (ms) after which the page starts even if the browser paints nothing, as for a hidden tab. */
const UNPAINTED = 100;

/** Resolves when the browser has painted what the page contains so far. */
function painted(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => void nextTask().then(resolve));
    setTimeout(resolve, UNPAINTED);
  });
}

/** Reads how the picture shows the table, for the names of pockets and rails; behind the cue they stay. */
function readOrientation(store: Store, viewer: Viewer): void {
  const { size } = store.shot.geometry;
  if (!size || store.view.camera === "cue" || viewer.flying) return;
  const [x, y] = [size[0] / 2, size[1] / 2];
  const aside = viewer.seen([x, y], [x, y + ASIDE]);
  if (!aside) return;
  const orientation = orientationOf(...aside);
  if (orientation !== store.session.orientation) store.setSession({ orientation });
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
