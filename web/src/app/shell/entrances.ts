/** The entrances of the page: analyse, play, train, library. */

import { h } from "../common/dom.ts";
import type { Activity } from "../document/document.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";
import { mountChoice } from "../common/choice-row.ts";

const ACTIVITIES: readonly Activity[] = ["analyse", "play", "train", "library"];

export function mountEntrances(root: HTMLElement, store: Store): void {
  const buttons = ACTIVITIES.map((name) => ({
    name,
    button: h("button", { type: "button", class: "entrance" }, t(`activity.${name}`)),
  }));
  const show = mountChoice(root, buttons, (activity) => {
    store.setSession({ activity });
  });
  store.subscribe((now, before) => {
    if (now.session.activity !== before.session.activity) show(now.session.activity);
    const [plays, played] = [now, before].map(({ document }) => document.game !== null);
    if (plays === played) return;
    // A game that begins leads to its panels; the balls of one that ended are free.
    const { activity } = now.session;
    if (plays) store.setSession({ activity: "play" });
    else if (activity === "play") store.setSession({ activity: "analyse" });
  });
  if (store.document.game) store.setSession({ activity: "play" });
  show(store.session.activity);
}
