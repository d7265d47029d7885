/** Sound of the replay. */

import { Speaker } from "../../sound/speaker.ts";
import { h, icon } from "../common/dom.ts";
import { hasFlag, setFlag } from "../common/flag.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";

const ICONS = {
  on: "M4 10v4h4l5 4V6L8 10zM16 9c1.5 1.5 1.5 4.5 0 6M18.5 6.5c3 3 3 8 0 11",
  off: "M4 10v4h4l5 4V6L8 10zM16 10l4 4M20 10l-4 4",
};

/** Name in the browser's storage under which it is kept that the user has switched the sound off. */
const SILENCED = "carom-sound-off";

/** Switches the sound on or off, also for later visits. */
export function switchSound(store: Store): void {
  const sound = !store.session.replay.sound;
  store.setPart("replay", { sound });
  setFlag("localStorage", SILENCED, !sound);
}

/** Plays the impacts of a running replay while sound is switched on. */
export function mountSound(store: Store): void {
  const speaker = new Speaker();
  if (hasFlag("localStorage", SILENCED, false)) store.setPart("replay", { sound: false });
  store.subscribe(({ session }, { session: { replay: before } }) => {
    const { trace, playing, sound, stroke, time, rate } = session.replay;
    if (playing && sound && trace) {
      // The click that shoots or plays is a gesture, soon after which browsers allow sound. In a task of its
      // own: the first time takes tens of milliseconds.
      if (!before.playing || !before.sound) setTimeout(() => speaker.wake());
      if (stroke === 0) speaker.follow(trace, { time, rate });
    } else if (before.playing && before.sound) {
      speaker.silence();
    }
  });
}

/** Switches the sound on and off. */
export function soundButton(store: Store): HTMLButtonElement {
  const onclick = () => switchSound(store);
  const made = h("button", { type: "button", class: "button", id: "sound", onclick });
  const show = () => {
    const { sound } = store.session.replay;
    made.setAttribute("aria-pressed", String(sound));
    made.replaceChildren(icon(sound ? ICONS.on : ICONS.off));
  };
  made.setAttribute("aria-label", t("replay.sound"));
  made.title = t("replay.sound");
  store.subscribe(({ session }, { session: before }) => {
    if (session.replay.sound !== before.replay.sound) show();
  });
  show();
  return made;
}
