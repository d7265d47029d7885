/** The Aim tab: tip position, speed, elevation and direction of the cue, and the ball to strike. */

import { FINE, makeElevationAutomatic, turn } from "../document/strike.ts";
import { azimuthOf, elevationOf, isAutomatic } from "../document/strike-angles.ts";
import { AZIMUTH_DIGITS, wrap } from "../common/angles.ts";
import type { Context } from "../common/context.ts";
import { h, uniqueId } from "../common/dom.ts";
import { mountFace } from "./face.ts";
import { follow, mountField } from "../form/field.ts";
import type { Store } from "../document/store.ts";
import { round, speedFrom, speedIn, type SpeedUnit, SPEED_UNITS } from "../common/units.ts";

/** Range of the speed slider (m/s): from a soft roll to the hardest break. The number field takes up to 50. */
const SOFTEST = 0.1;
const HARDEST = 12;

/** Highest elevation of the slider (degrees). The number field takes more. */
const STEEPEST = 85;

/** Degrees by which an arrow button turns the cue. */
const TURN = 1;

export function mountAimPanel(root: HTMLElement, store: Store, context: Context): void {
  const tip = h("div", { class: "tip" });
  const face = h("div");
  const offsets = h("div", { class: "offsets" });
  tip.append(face, offsets);
  mountFace(face, store, context);
  mountOffsets(offsets, store, context);
  root.append(
    h("h2", {}, "Tip"),
    tip,
    h(
      "p",
      { class: "hint", id: "face-hint" },
      "Click the ball, or use the arrow keys: left and right for English, up for follow, down for draw. Outside the dashed circle the cue miscues.",
    ),
    h("h2", {}, "Stroke"),
  );
  mountSpeed(root, store, context);
  mountElevation(root, store, context);
  mountDirection(root, store, context);
  mountStruck(root, store);
}

function mountOffsets(root: HTMLElement, store: Store, context: Context): void {
  const field = (label: string, key: "side" | "height") => {
    mountField(root, store, context, {
      label,
      unit: "R",
      spoken: "ball radii",
      digits: 3,
      min: () => -1,
      max: () => 1,
      step: 0.01,
      slider: false,
      read: () => store.document.shot.strike[key] ?? 0,
      write: (value, group) => store.strike({ [key]: value }, "move the tip", group),
    });
  };
  field("Side", "side");
  field("Height", "height");
  const center = () => store.strike({ side: 0, height: 0 }, "centre the tip");
  root.append(h("button", { type: "button", class: "button", onclick: center }, "Centre"));
}

function mountSpeed(root: HTMLElement, store: Store, context: Context): void {
  const units = h("select", { "aria-label": "Unit of speed" });
  for (const unit of Object.keys(SPEED_UNITS)) units.append(h("option", { value: unit }, unit));
  units.addEventListener("change", () => {
    store.setView({ units: units.value as SpeedUnit });
  });
  store.subscribe(({ view }) => {
    units.value = view.units;
  });
  units.value = store.view.units;
  mountField(root, store, context, {
    label: "Cue speed",
    unit: units,
    spoken: "",
    digits: 3,
    min: () => round(speedIn(store.view.units, SOFTEST), 3),
    max: () => round(speedIn(store.view.units, HARDEST), 1),
    step: 0.05,
    read: () => speedIn(store.view.units, store.document.shot.strike.speed),
    write: (value, group) =>
      store.strike(
        { speed: round(speedFrom(store.view.units, value), 5) },
        "change the speed",
        group,
      ),
  });
}

function mountElevation(root: HTMLElement, store: Store, context: Context): void {
  mountField(root, store, context, {
    label: "Elevation",
    unit: "°",
    spoken: "degrees",
    digits: 3,
    min: () => 0,
    max: () => STEEPEST,
    step: 0.5,
    read: () => elevationOf(store.document.shot.strike, store.shot.strike?.elevation ?? 0),
    write: (value, group) => store.strike({ elevation_deg: value }, "raise the cue", group),
  });
  const button = h(
    "button",
    {
      type: "button",
      class: "button",
      title: "Automatic: the least elevation of a real stroke that clears the rails and the balls",
      onclick: () => {
        if (!isAutomatic(store.document.shot.strike)) makeElevationAutomatic(store);
      },
    },
    "Automatic",
  );
  button.setAttribute("aria-label", "Automatic elevation");
  const show = () => {
    button.setAttribute("aria-pressed", String(isAutomatic(store.document.shot.strike)));
  };
  store.subscribe(show);
  show();
  root.append(h("div", { class: "direction" }, button));
}

function mountDirection(root: HTMLElement, store: Store, context: Context): void {
  const row = h("div", { class: "direction" });
  const field = h("div");
  mountField(field, store, context, {
    label: "Direction",
    unit: "°",
    spoken: "degrees counter-clockwise from the direction of the short rails",
    digits: AZIMUTH_DIGITS,
    min: () => 0,
    max: () => 360,
    step: 0.1,
    slider: false,
    read: () => azimuthOf(store.document.shot.strike),
    write: (value, group) => store.strike({ azimuth_deg: wrap(value) }, "aim", group),
  });
  const degrees = () => TURN * (store.session.fine ? FINE : 1);
  const arrow = (way: string, sign: number) => {
    const onclick = () => {
      turn(store, sign * degrees(), `turn ${sign}`);
    };
    const button = h("button", { type: "button", class: "button", onclick });
    follow(store, button, () => (sign > 0 ? `‹ ${degrees()}°` : `${degrees()}° ›`));
    const name = () => {
      button.setAttribute("aria-label", `Turn the cue ${way} by ${degrees()}°`);
    };
    store.subscribe(name);
    name();
    return button;
  };
  const fine = h(
    "button",
    {
      type: "button",
      class: "button",
      title: "Fine adjustment: drags and keys have a tenth of their effect (F)",
      onclick: () => {
        store.setSession({ fine: !store.session.fine });
      },
    },
    "Fine",
  );
  const show = () => {
    fine.setAttribute("aria-pressed", String(store.session.fine));
  };
  store.subscribe(show);
  show();
  row.append(arrow("left", 1), arrow("right", -1), fine);
  root.append(field, row);
}

function mountStruck(root: HTMLElement, store: Store): void {
  const id = uniqueId("struck");
  const select = h("select", { id });
  select.addEventListener("change", () => {
    if (!store.strike({ ball: select.value }, "strike another ball")) show();
  });
  function show(): void {
    const { balls, strike } = store.document.shot;
    const ids = balls.map((ball) => ball.id);
    if (
      select.options.length !== ids.length ||
      ids.some((b, k) => select.options[k]!.value !== b)
    ) {
      select.replaceChildren(...ids.map((ball) => h("option", { value: ball }, ball)));
    }
    select.value = strike.ball;
  }
  store.subscribe(show);
  show();
  root.append(h("div", { class: "row struck" }, h("label", { for: id }, "Ball to strike"), select));
}
