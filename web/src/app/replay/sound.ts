/** Sound of the replay. */

import { Speaker } from "../../sound/speaker.ts";
import type { Store } from "../document/store.ts";

/** Plays the impacts of a running replay while sound is switched on. */
export function mountSound(store: Store): void {
  const speaker = new Speaker();
  store.subscribe(({ session }, { session: before }) => {
    const { trace, playing, sound, time, rate } = session;
    if (playing && sound && trace) {
      // The click that shoots or plays is a gesture, within which browsers allow sound.
      if (!before.playing || !before.sound) speaker.wake();
      speaker.follow(trace, { time, rate });
    } else if (before.playing && before.sound) {
      speaker.silence();
    }
  });
}
