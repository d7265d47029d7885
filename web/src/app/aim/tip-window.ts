/** The tip as a small window over the cue, beside the cue ball: it leaves the line of aim in view. */

import "./tip-window.css";
import type { Context } from "../common/context.ts";
import { button, h, icon } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { canAim } from "../game/awaited-turn.ts";
import { t } from "../words/translate.ts";
import { mountFace } from "./cue-ball-face.ts";

/** Distance (CSS pixels) of the window from the cue ball, and from the edges of the table's picture. */
const GAP = 22;
const MARGIN = 6;

/** Directions that are tried, as angles from the cue: the line of aim is opposite. */
const TURNS = [0, 0.8, -0.8, 1.6, -1.6, 2.4, -2.4];

type Spot = readonly [x: number, y: number];

/**
 * The upper left corner of a window beside a ball, inside the picture: on the side to which `back` points, or on the
 * next one that leaves the ball in view.
 */
export function besideBall(ball: Spot, back: Spot, size: Spot, picture: Spot): Spot {
  const places = TURNS.map((turn) => {
    const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
    const way: Spot = [back[0] * cos - back[1] * sin, back[0] * sin + back[1] * cos];
    return touching(ball, way, size, picture);
  });
  return places.find((corner) => away(ball, corner, size) > GAP / 2) ?? places[0]!;
}

/** The upper left corner of a window whose edge is `GAP` from a ball in a direction, moved into the picture. */
function touching(ball: Spot, [dx, dy]: Spot, size: Spot, picture: Spot): Spot {
  const reach = Math.min(
    dx === 0 ? Infinity : size[0] / 2 / Math.abs(dx),
    dy === 0 ? Infinity : size[1] / 2 / Math.abs(dy),
  );
  const inside = (at: number, length: number, whole: number) =>
    Math.max(MARGIN, Math.min(whole - length - MARGIN, at - length / 2));
  const [x, y] = [ball[0] + dx * (reach + GAP), ball[1] + dy * (reach + GAP)];
  return [inside(x, size[0], picture[0]), inside(y, size[1], picture[1])];
}

/** Distance of a ball from a window. */
function away([x, y]: Spot, [left, top]: Spot, [width, height]: Spot): number {
  const beyond = (at: number, low: number, length: number) =>
    Math.max(low - at, at - low - length, 0);
  return Math.hypot(beyond(x, left, width), beyond(y, top, height));
}

/** @returns Opens the window, or closes it. */
export function mountTipWindow(stage: HTMLElement, store: Store, context: Context): () => void {
  let root: HTMLElement | null = null;
  const close = (): void => {
    if (!root || root.hidden) return;
    const hadFocus = root.contains(document.activeElement);
    root.hidden = true;
    if (hadFocus) document.querySelector<HTMLElement>(".spin-button")?.focus();
  };
  const open = (): void => {
    root ??= stage.appendChild(windowOf(store, context, close));
    root.hidden = false;
    const place = placeOf(root, stage, store, context);
    if (place) [root.style.left, root.style.top] = place.map((at) => `${at}px`) as [string, string];
    root.querySelector<HTMLElement>(".face")!.focus();
  };
  store.subscribe(({ session }) => {
    if (session.mode !== "aim" || !canAim(store, context.engine)) close();
  });
  return () => {
    if (root && !root.hidden) close();
    else open();
  };
}

function windowOf(store: Store, context: Context, close: () => void): HTMLElement {
  const face = h("div", { class: "face-place" });
  const centre = button(t("aim.centre"), () => {
    store.strike({ side: 0, height: 0 }, t("change.centre"));
  });
  const name = t("aim.close-tip");
  const attributes = { type: "button", class: "button plain", "aria-label": name, title: name };
  const end = h(
    "button",
    { ...attributes, onclick: close, "data-back": true },
    icon("M6 6l12 12M18 6L6 18"),
  );
  const root = h("div", { class: "tip-window", role: "group", "aria-label": t("aim.tip") });
  root.append(face, centre, end);
  root.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    event.preventDefault();
    close();
  });
  mountFace(face, store, context);
  return root;
}

/** Null if the cue ball is behind the camera. */
function placeOf(
  root: HTMLElement,
  stage: HTMLElement,
  { shot }: Store,
  { viewer }: Context,
): Spot | null {
  const { struck, strike, balls } = shot;
  if (struck === null || !strike) return null;
  const [x, y, z] = balls[struck]!.position;
  const { radius } = balls[struck]!;
  const ball = viewer.project(x, y, z);
  const behind = viewer.project(
    x - radius * Math.cos(strike.azimuth),
    y - radius * Math.sin(strike.azimuth),
    z,
  );
  if (!ball || !behind) return null;
  const length = Math.hypot(behind[0] - ball[0], behind[1] - ball[1]) || 1;
  const back: Spot = [(behind[0] - ball[0]) / length, (behind[1] - ball[1]) / length];
  const area = stage.getBoundingClientRect();
  const from: Spot = [ball[0] - area.left, ball[1] - area.top];
  return besideBall(from, back, [root.offsetWidth, root.offsetHeight], [area.width, area.height]);
}
