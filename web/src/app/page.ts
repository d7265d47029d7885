/** Mounts every part of the page. */

import { mountAimPanel } from "./aim/panel.ts";
import type { Context } from "./common/context.ts";
import { mountDock, mountTake } from "./aim/dock.ts";
import { mountFirstUse } from "./help/first-use.ts";
import { mountBar } from "./game/bar.ts";
import { mountGame } from "./game/panel.ts";
import { mountGestures } from "./input/gestures.ts";
import { mountCamera, mountHistory, mountPageMenu } from "./shell/header.ts";
import { mountHelp } from "./help/help.ts";
import { mountKeys } from "./input/keys.ts";
import { mountLayoutPanel } from "./layout/panel.ts";
import { mountRefusal } from "./shell/notices.ts";
import { mountPhysicsPanel } from "./physics/panel.ts";
import { mountState } from "./replay/panel.ts";
import { mountSound } from "./replay/sound.ts";
import { mountTimeline } from "./replay/timeline.ts";
import { mountAddress } from "./share/address.ts";
import { mountShare } from "./share/menu.ts";
import type { Store } from "./document/store.ts";
import { mountTabs } from "./shell/tabs.ts";
import { mountTheme } from "./shell/theme.ts";
import { mountWhatIf } from "./whatif/panel.ts";

/** The mount point with this id in index.html. */
export function place(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`index.html has no element "${id}"; add it`);
  return element;
}

/** @param welcome Whether to show the first steps. */
export function mountPage(store: Store, context: Context, welcome: boolean): void {
  const table = place("table") as HTMLCanvasElement;
  mountTheme(store, context);
  mountRefusal(place("refusal"), store);
  mountTabs(place("tabs"), store);
  mountAimPanel(place("panel-aim"), store, context);
  mountLayoutPanel(place("panel-layout"), store, context);
  mountPhysicsPanel(place("panel-physics"), store, context);
  mountState(place("panel-state"), store);
  mountTimeline(place("timeline"), store, context);
  mountSound(store);
  mountWhatIf(place("panel-whatif"), store, context);
  mountGame(place("panel-game"), store, context);
  mountBar(place("game-bar"), store, context);
  mountShare(place("share"), store, context);
  mountAddress(store, context);
  mountDock(place("shoot"), store, context);
  mountTake(place("leave-replay"), store, context);
  mountHistory(place("history"), store, context);
  mountCamera(place("camera"), store, context);
  const showSteps = mountFirstUse(place("first-use"), store, welcome);
  const openHelp = mountHelp(place("help") as HTMLDialogElement, store, context, showSteps);
  mountPageMenu(place("page-menu"), store, openHelp);
  mountGestures(table, store, context);
  mountKeys(table, { store, context, openHelp });
  store.subscribe((now, before) => {
    if (now.session.mode !== before.session.mode) document.body.dataset.mode = now.session.mode;
  });
}
