/** Messages: refusals stay beside the table until the next change, notices for some seconds. */

import { setText } from "../common/dom.ts";
import type { Store } from "../document/store.ts";

/** Time (ms) that a notice is shown: enough to read a line twice. */
const NOTICE = 4000;

/** @returns `announce`, which shows a sentence for some seconds. */
export function mountNotices(root: HTMLElement): (sentence: string) => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  return (sentence) => {
    setText(root, sentence);
    clearTimeout(timer);
    timer = setTimeout(() => {
      setText(root, "");
    }, NOTICE);
  };
}

/**
 * A refusal stays until the next change that is accepted.
 *
 * @param announce Shows a notice. An earlier one goes, so that it does not stand beside the refusal.
 */
export function mountRefusal(
  root: HTMLElement,
  store: Store,
  announce: (sentence: string) => void,
): void {
  const show = () => {
    const message = store.session.refusal?.message ?? "";
    root.hidden = message === "";
    setText(root, message);
    if (message !== "") announce("");
  };
  store.subscribe((now, before) => {
    if (now.session.refusal !== before.session.refusal) show();
  });
  show();
}
