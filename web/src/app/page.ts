/** Mounts every part of the page. */

import { mountDiamonds } from "./aim/diamond-overlay.ts";
import { mountAimPanel } from "./aim/aim-panel.ts";
import { mountChip } from "./analyse/chance-chip.ts";
import { mountLines } from "./analyse/analyse-panel.ts";
import { mountPots } from "./analyse/aim-at-pocket.ts";
import { mountTree } from "./analyse/tree-panel.ts";
import type { Context } from "./common/context.ts";
import { mountPresses } from "./common/press.ts";
import { whenShown } from "./common/shown.ts";
import type { Slices } from "./common/slices.ts";
import { mountDrawBar } from "./draw/draw-bar.ts";
import { mountDrawKeys } from "./draw/draw-keys.ts";
import { mountDrawMode } from "./draw/draw-mode.ts";
import { mountDock, mountTake } from "./aim/dock.ts";
import { mountTipWindow } from "./aim/tip-window.ts";
import { mountBar } from "./game/game-bar.ts";
import { mountGame } from "./game/game-panel.ts";
import { AimCloseUp } from "./input/aim-close-up.ts";
import { mountFineWheel } from "./input/fine-wheel.ts";
import { mountGestures } from "./input/gestures.ts";
import { mountCamera, mountHistory, mountPageMenu } from "./shell/header.ts";
import { mountEntrances } from "./shell/entrances.ts";
import { mountBack } from "./shell/browser-back.ts";
import { mountOpening } from "./help/opening.ts";
import { mountHelp } from "./help/help.ts";
import { mountKeys } from "./input/keys.ts";
import { mountLayoutPanel } from "./layout/layout-panel.ts";
import { mountRefusal } from "./shell/notices.ts";
import { mountPhysicsPanel } from "./physics/physics-panel.ts";
import { mountFilmLegend } from "./replay/film-legend.ts";
import { mountState } from "./replay/replay-panel.ts";
import { mountSound } from "./replay/replay-sound.ts";
import { mountTimeline } from "./replay/timeline.ts";
import { mountAddress } from "./share/address.ts";
import { copy } from "./share/clipboard.ts";
import { download } from "./share/download.ts";
import { mountFriend } from "./share/friend.ts";
import { mountReload } from "./share/reload.ts";
import { mountShare } from "./share/share-menu.ts";
import type { Store } from "./document/store.ts";
import type { Start } from "./start.ts";
import { mountKept } from "./kept/kept.ts";
import { KeptStorage } from "./kept/kept-storage.ts";
import { mountLibrary } from "./library/library-panel.ts";
import { isBesideTable, mountTabs } from "./shell/tabs.ts";
import { mountTools } from "./shell/header-tools.ts";
import { mountTheme } from "./shell/theme-choice.ts";
import { mountTrain } from "./train/train-panel.ts";
import { mountWhatIf } from "./whatif/whatif-panel.ts";

/** The mount point with this id in index.html. */
export function place(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`index.html has no element "${id}"; add it`);
  return element;
}

/** What the page opens with. */
type Opening = Pick<Start, "welcome" | "isPlain" | "reload">;

/**
 * Mounts header, tabs and dock, which leave the table its room.
 *
 * @returns Mounts everything else in slices, which take longer. The first picture is drawn meanwhile.
 */
export function mountPage(store: Store, context: Context, opening: Opening): () => Slices<void> {
  let openHelp = (): void => undefined;
  mountPresses(document);
  mountTheme(store, context);
  const openTab = mountTabs(place("tabs"), store);
  mountEntrances(place("entrances"), store);
  mountTimeline(place("timeline"), store, context);
  const toggleTip = mountTipWindow(place("stage"), store, context);
  mountDock(place("shoot"), store, context, () => {
    // A panel at the side has the tip in view; a sheet would cover the table.
    if (isBesideTable()) openTab("aim");
    else toggleTip();
  });
  mountChip(place("shoot-button"), store, context, () => {
    openTab("whatif");
  });
  mountTake(place("leave-replay"), store, context);
  mountHistory(place("history"), store, context);
  mountCamera(place("camera"), store, context);
  mountPageMenu(place("page-menu"), store, () => {
    openHelp();
  });
  mountTools(place("tools"), place("tools-button"));
  return function* () {
    openHelp = yield* mountParts(store, context, opening);
  };
}

/** @returns Opens the help. */
function* mountParts(store: Store, context: Context, opening: Opening): Slices<() => void> {
  const table = place("table") as HTMLCanvasElement;
  mountPots(store, context);
  mountRefusal(place("refusal"), store, (sentence) => {
    context.announce(sentence);
  });
  mountAimPanel(place("panel-aim"), store, context);
  yield;
  mountLines(place("panel-lines"), store, context);
  mountTree(place("panel-tree"), store, context, { copy, download });
  whenShown(place("panel-layout"), (panel) => mountLayoutPanel(panel, store, context));
  whenShown(place("panel-physics"), (panel) => mountPhysicsPanel(panel, store, context));
  yield;
  mountState(place("panel-state"), store);
  mountSound(store);
  mountWhatIf(place("panel-whatif"), store, context);
  yield;
  mountGame(place("panel-game"), store, context);
  mountBar(place("game-bar"), store, context);
  yield;
  // A page in the frame of another one keeps nothing.
  const storage = window === window.top ? new KeptStorage() : null;
  const training = mountTrain(place("panel-train"), store, context, storage);
  const kept = mountKept(store, context, training, storage, opening);
  const openStudy = mountLibrary(place("panel-library"), store, context, {
    library: kept.library,
    leavePractice: () => training.practice.leave(),
  });
  yield;
  mountShare(
    place("share"),
    store,
    context,
    (file) => training.openDrillFile(file) ?? kept.opener(file) ?? openStudy(file),
  );
  mountBack(mountAddress(store, context));
  mountFriend(place("game-bar"), store, context);
  mountReload(store);
  mountDiamonds(place("stage"), store, context);
  mountFilmLegend(place("stage"), store);
  yield;
  const showSteps = mountOpening(place("shoot-button"), store, context, opening.welcome);
  const openHelp = mountHelp(place("help") as HTMLDialogElement, store, showSteps);
  const closeUp = new AimCloseUp(store, context, () => table.getBoundingClientRect());
  mountDrawMode(store);
  mountDrawBar(place("draw"), place("draw-tool"), store);
  mountDrawKeys(table, store, context);
  mountGestures(table, store, context, closeUp);
  mountFineWheel(place("stage"), place("panel-aim"), store, context, closeUp);
  mountKeys(table, { store, context, openHelp });
  store.subscribe((now, before) => {
    if (now.session.mode !== before.session.mode) document.body.dataset.mode = now.session.mode;
  });
  return openHelp;
}
