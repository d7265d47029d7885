/** A sentence over the table that explains the filmed paths while they are shown. */

import { h } from "../common/dom.ts";
import { filmOf } from "../document/filmed.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";

export function mountFilmLegend(root: HTMLElement, store: Store): void {
  const legend = h("p", { class: "film-legend", id: "film-legend", hidden: true });
  root.append(legend);
  const show = () => {
    const { document, session } = store;
    legend.hidden = filmOf(document).length === 0;
    legend.textContent = t(session.mode === "replay" ? "film.seen-then" : "film.seen");
  };
  store.subscribe((now, before) => {
    if (now.document !== before.document || now.session.mode !== before.session.mode) show();
  });
  show();
}
