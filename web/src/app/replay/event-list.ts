/** The list of events, in text; a press on an event goes to its time. */

import type { Trace, TraceEvent } from "../../engine/index.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { momentsOf, seek } from "./replay-control.ts";
import { mark } from "./event-looks.ts";
import { latest, representatives } from "./event-moments.ts";
import type { Show } from "./replay-state.ts";
import { ballName } from "../common/shot-words.ts";
import { tracedEvent } from "./carom-touches.ts";
import { decimal, t } from "../words/translate.ts";

export function mountEvents(root: HTMLElement, store: Store): Show {
  const heading = h("h2", { id: uniqueId("events") }, t("events.heading"));
  const only = h("input", { type: "checkbox", id: uniqueId("only") });
  const onlyLabel = h("label", { for: only.id });
  const body = h("tbody");
  root.append(
    heading,
    h("div", { class: "row" }, only, onlyLabel),
    h("div", { class: "events" }, h("table", { "aria-labelledby": heading.id }, head(), body)),
  );
  let shown: Trace | null = null;
  /** The orientation of the picture as which rails and pockets are named. */
  let named = store.session.orientation;
  let filter: string | null = null;
  let current: readonly number[] = [];
  let shownBy: readonly number[] = [];
  only.addEventListener("change", () => store.setSession({})); // notifies all listeners

  const fill = (trace: Trace): void => {
    setText(heading, t("events.count", { count: trace.events.length }));
    shownBy = representatives(trace.events);
    const counts = new Map<number, number>();
    for (const by of shownBy) counts.set(by, (counts.get(by) ?? 0) + 1);
    body.replaceChildren(
      ...trace.events.map((event, i) => rowOf(store, trace, event, counts.get(i) ?? 1)),
    );
    current = [];
  };

  return (trace, ball, time) => {
    const { id } = trace.shot.balls[ball]!;
    setText(onlyLabel, t("events.only", { ball: ballName(id) }));
    const wanted = only.checked ? id : null;
    const orientation = store.session.orientation;
    const isSame = trace === shown && orientation === named;
    if (!isSame) fill(trace);
    const rows = body.rows;
    if (!isSame || wanted !== filter) {
      trace.events.forEach(({ balls }, i) => {
        rows[i]!.hidden = shownBy[i] !== i || (wanted !== null && !balls.includes(wanted));
      });
    }
    [shown, filter, named] = [trace, wanted, orientation];
    const moment = latest(momentsOf(trace), time)?.events ?? [];
    const now = moment.map((index) => shownBy[index]!);
    if (now.join() === current.join()) return;
    for (const index of current) rows[index]!.removeAttribute("aria-current");
    for (const index of now) rows[index]!.setAttribute("aria-current", "step");
    current = now;
    const row = rows[now[0] ?? 0];
    if (row) keepInView(row);
  };
}

function head(): HTMLElement {
  const [time, event] = [t("events.second"), t("events.event")].map((text) =>
    h("th", { scope: "col" }, text),
  );
  return h("thead", {}, h("tr", {}, time, event));
}

/** The row of `count` equal events, of which `event` is the first; a press goes to its time. */
function rowOf(store: Store, trace: Trace, event: TraceEvent, count: number): HTMLElement {
  const onclick = () => seek(store, event.time);
  const once = tracedEvent(trace, event);
  const said = count > 1 ? t("event.times", { event: once, count }) : once;
  const words = h("button", { type: "button", class: "go", onclick }, said);
  const kind = h("span", { class: "kind", title: t(`kind.${event.type}`) }, mark(event.type));
  const time = h("td", { class: "time" }, decimal(event.time, 3));
  return h("tr", {}, time, h("td", {}, h("div", { class: "event" }, kind, words)));
}

/** Scrolls the list, but not the page around it. */
function keepInView(row: HTMLElement): void {
  const list = row.closest<HTMLElement>(".events")!;
  const top = row.offsetTop;
  const bottom = top + row.offsetHeight;
  const head = list.querySelector("thead")!.offsetHeight;
  if (top - head < list.scrollTop) list.scrollTop = top - head;
  else if (bottom > list.scrollTop + list.clientHeight) list.scrollTop = bottom - list.clientHeight;
}
