/** The bar below the table during a replay: clock, steps, and the events against time. */

import "./timeline.css";
import type { Trace, TraceEvent } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import type { Session } from "../document/document.ts";
import { playsOn } from "../document/plays-on.ts";
import { h, icon, setText, shortened, svg } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { advance, LONGEST_FRAME, Pace, RATES } from "./replay-clock.ts";
import {
  leave,
  momentsOf,
  seek,
  stepBackwards,
  stepForwards,
  togglePlaying,
} from "./replay-control.ts";
import { LANES, LOOKS } from "./event-looks.ts";
import { latest } from "./event-moments.ts";
import { seconds } from "./replay-words.ts";
import { countText, tracedEvent } from "./carom-touches.ts";
import { t } from "../words/translate.ts";

const ICONS = {
  play: "M7 5l12 7-12 7z",
  pause: "M8 5v14M16 5v14",
  next: "M6 5l9 7-9 7zM18 5v14",
  previous: "M18 5l-9 7 9 7zM6 5v14",
};

/** Seconds that an arrow key moves the slider, without and with Shift. */
const STEP = 0.05;
const FINE_STEP = 0.005;

/** Distance (pixels) within which the pointer selects a mark. */
const REACH = 8;

/** Height of a lane of marks, pixels. */
const LANE_HEIGHT = 10;

const RATE_NAMES: Readonly<Record<number, string>> = {
  4: "4×",
  2: "2×",
  1: "1×",
  0.5: "½×",
  0.25: "¼×",
  0.1: "⅒×",
};

export function mountTimeline(root: HTMLElement, store: Store, context: Context): void {
  const play = h("button", {
    type: "button",
    class: "button primary",
    id: "play",
    onclick: () => togglePlaying(store),
  });
  const { slider, marks, now, tip } = scrubber(store);
  const present = h("span");
  const whole = h("span", { class: "whole" });
  const count = h("span", { class: "count" });
  const clock = h("p", { class: "clock" }, present, whole, count);
  const eventText = h("p", { class: "said" });
  const pace = new Pace();

  root.classList.add("timeline");
  root.append(
    h(
      "div",
      { class: "row" },
      button(t("replay.previous"), ICONS.previous, () => stepBackwards(store)),
      play,
      button(t("replay.next"), ICONS.next, () => stepForwards(store)),
      rates(store),
      clock,
      eventText,
      h("div", { class: "ways-on" }, leaveButton(store)),
    ),
    h("div", { class: "scrubber" }, marks, slider, now, tip),
  );

  store.subscribe(({ session }, { session: before }) => {
    if (session.replay.playing && !before.replay.playing)
      context.loop.animate((elapsed) => tick(store, elapsed));
    if (session.replay.trace !== before.replay.trace || session.selected !== before.selected) {
      drawMarks(marks, session);
    }
    if (session === before) return;
    point();
    if (!playsOn(session, before) || pace.due()) show();
  });

  /** Moves the line and its thumb to the present time, which paints nothing again. */
  function point(): void {
    const { trace, time } = store.session.replay;
    if (!trace) return;
    now.style.setProperty("--at", String(trace.duration > 0 ? time / trace.duration : 0));
  }

  function show(): void {
    const { trace, time, playing } = store.session.replay;
    if (!trace) return;
    const moment = latest(momentsOf(trace), time);
    const events = moment?.events.map((index) => trace.events[index]!) ?? [];
    const words = events.map((event) => tracedEvent(trace, event)).join(t("ruling.gap"));
    const ended = time >= trace.duration;
    showPlay(play, playing, ended);
    slider.max = String(trace.duration);
    slider.value = String(time);
    const times = { time: seconds(time), duration: seconds(trace.duration) };
    const read = words
      ? t("replay.time-of-last", { ...times, events: words })
      : t("replay.time-of", times);
    slider.setAttribute("aria-valuetext", read);
    setText(present, times.time);
    setText(whole, t("replay.whole", { duration: times.duration }));
    setText(eventText, moment ? at(moment.time, words) : "");
    setText(count, countText(trace, time));
  }
}

/** What the button does next: its name and its icon. */
function showPlay(play: HTMLButtonElement, playing: boolean, ended: boolean): void {
  const label = t(playing ? "replay.pause" : ended ? "replay.again" : "replay.play");
  if (play.getAttribute("aria-label") === label) return;
  play.setAttribute("aria-label", label);
  play.title = label;
  play.replaceChildren(icon(playing ? ICONS.pause : ICONS.play));
}

/** Events with their time, s. */
function at(time: number, events: string): string {
  return t("replay.at", { time: seconds(time), events });
}

function tick(store: Store, elapsed: number): boolean {
  const { trace, playing, stroke, time, rate } = store.session.replay;
  if (!trace || !playing) return false;
  if (stroke > 0) {
    store.setPart("replay", { stroke: Math.max(0, stroke - Math.min(elapsed, LONGEST_FRAME)) });
    return true;
  }
  const then = advance(time, elapsed, rate, trace.duration);
  const goesOn = then < trace.duration;
  store.setPart("replay", { time: then, playing: goesOn });
  return goesOn;
}

function button(label: string, path: string, onclick: () => void): HTMLButtonElement {
  const attributes = { type: "button", class: "button", "aria-label": label, title: label };
  return h("button", { ...attributes, onclick }, icon(path));
}

function leaveButton(store: Store): HTMLButtonElement {
  const name = t("replay.back");
  const attributes = { type: "button", class: "button", id: "leave-replay", "aria-label": name };
  const onclick = () => {
    leave(store);
  };
  return h("button", { ...attributes, onclick }, ...shortened(name, t("replay.back-short")));
}

function rates(store: Store): HTMLSelectElement {
  const select = h(
    "select",
    { class: "rate", "aria-label": t("replay.speed"), title: t("replay.speed") },
    ...RATES.map((rate) => h("option", { value: rate }, RATE_NAMES[rate])),
  );
  select.addEventListener("change", () => store.setPart("replay", { rate: Number(select.value) }));
  store.subscribe(({ session }) => {
    select.value = String(session.replay.rate);
  });
  return select;
}

interface Scrubber {
  slider: HTMLInputElement;
  marks: SVGSVGElement;
  /** The line and the thumb at the present time. */
  now: HTMLElement;
  /** Text beside the mark under the pointer. */
  tip: HTMLElement;
}

function scrubber(store: Store): Scrubber {
  const slider = h("input", { type: "range", min: 0, step: "any", "aria-label": t("replay.time") });
  slider.addEventListener("input", () => {
    seek(store, Number(slider.value));
  });
  slider.addEventListener("keydown", (event) => {
    const move = sliderKey(event);
    if (!move) return;
    event.preventDefault();
    event.stopPropagation();
    move(store);
  });
  const marks = svg("svg", {
    class: "marks",
    height: LANES * LANE_HEIGHT,
    "aria-hidden": "true", // screen readers read the list of events
  });
  const tip = h("div", { class: "event-tip", hidden: true, "aria-hidden": "true" });
  marks.addEventListener("pointermove", (event) => {
    const { trace } = store.session.replay;
    const found = nearest(marks, store.session, event);
    tip.hidden = !found;
    if (!found || !trace) return;
    setText(tip, at(found.event.time, tracedEvent(trace, found.event)));
    const box = marks.getBoundingClientRect();
    const half = tip.offsetWidth / 2;
    const x = found.share * box.width;
    tip.style.left = `${Math.min(Math.max(x, half), box.width - half)}px`;
  });
  marks.addEventListener("pointerleave", () => (tip.hidden = true));
  marks.addEventListener("click", (event) => {
    const { session } = store;
    const box = marks.getBoundingClientRect();
    const share = (event.clientX - box.left) / box.width;
    const found = nearest(marks, session, event);
    seek(store, found?.event.time ?? share * (session.replay.trace?.duration ?? 0));
  });
  const now = h("div", { class: "now", "aria-hidden": "true" });
  return { slider, marks, now, tip };
}

/** The action of a key on the slider; null for other keys. */
function sliderKey({ key, shiftKey }: KeyboardEvent): ((store: Store) => void) | null {
  const step = shiftKey ? FINE_STEP : STEP;
  const by = (change: number) => (store: Store) => {
    seek(store, store.session.replay.time + change);
  };
  switch (key) {
    case "ArrowRight":
    case "ArrowUp":
      return by(step);
    case "ArrowLeft":
    case "ArrowDown":
      return by(-step);
    case "PageUp":
      return stepForwards;
    case "PageDown":
      return stepBackwards;
    case "Home":
      return by(-Infinity);
    case "End":
      return by(Infinity);
    default:
      return null;
  }
}

function drawMarks(root: SVGSVGElement, { replay: { trace }, selected }: Session): void {
  const marks = trace?.events.map((event) => {
    const { shape, lane } = LOOKS[event.type];
    const other = selected !== null && !event.balls.includes(selected);
    // A nested SVG can have a position in percent of the width.
    return svg(
      "svg",
      {
        x: `${100 * shareOf(event, trace)}%`,
        y: (lane + 0.5) * LANE_HEIGHT,
        overflow: "visible",
        class: `mark ${event.type}${other ? " other" : ""}`,
      },
      svg("path", { d: shape }),
    );
  });
  root.replaceChildren(...(marks ?? []));
}

/** Position of an event on the timeline, 0 to 1. */
function shareOf(event: TraceEvent, { duration }: Trace): number {
  return duration > 0 ? event.time / duration : 0;
}

/** The event whose mark is nearest to the pointer, within `REACH`. */
function nearest(
  root: SVGSVGElement,
  { replay: { trace } }: Session,
  { clientX, clientY }: MouseEvent,
): { event: TraceEvent; share: number } | null {
  const box = root.getBoundingClientRect();
  let best: { event: TraceEvent; share: number } | null = null;
  let least = REACH;
  for (const event of trace?.events ?? []) {
    const share = shareOf(event, trace!);
    const x = box.left + share * box.width;
    const y = box.top + (LOOKS[event.type].lane + 0.5) * LANE_HEIGHT;
    const distance = Math.hypot(clientX - x, clientY - y);
    if (distance <= least) [best, least] = [{ event, share }, distance];
  }
  return best;
}
