/** What the page says: refusals beside the table until they are settled, notices for a while. */

import { setText } from "../common/dom.ts";
import type { Store } from "../document/store.ts";

/** How long (ms) a notice stays: enough to read a line twice. */
const NOTICE = 4000;

/** @returns `announce`: shows a sentence for a while. */
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

/** A refusal stays until the next change that is accepted. */
export function mountRefusal(root: HTMLElement, store: Store): void {
  const show = () => {
    const message = store.session.refusal?.message ?? "";
    root.hidden = message === "";
    setText(root, message);
  };
  store.subscribe((now, before) => {
    if (now.session.refusal !== before.session.refusal) show();
  });
  show();
}
