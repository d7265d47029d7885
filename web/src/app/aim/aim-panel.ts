/** The Aim tab: tip position, speed, elevation and direction of the cue, and the ball to strike. */

import { FINE, makeElevationAutomatic, turn } from "../document/strike-changes.ts";
import { azimuthOf, elevationOf, isAutomatic } from "../document/strike-angles.ts";
import { AZIMUTH_DIGITS, wrap } from "../common/angles.ts";
import type { Context } from "../common/context.ts";
import { h, uniqueId } from "../common/dom.ts";
import { mountFace } from "./cue-ball-face.ts";
import { follow, mountField } from "../form/field.ts";
import type { Store } from "../document/store.ts";
import { round, speedFrom, speedIn, type SpeedUnit, SPEED_UNITS, TIP } from "../common/units.ts";
import { ballName } from "../common/shot-words.ts";
import { capital, t } from "../words/translate.ts";

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
    h("h2", {}, t("aim.tip")),
    tip,
    h("p", { class: "hint", id: "face-hint" }, t("aim.tip-hint")),
    h("h2", {}, t("aim.stroke")),
  );
  mountSpeed(root, store, context);
  mountElevation(root, store, context);
  mountDirection(root, store, context);
  mountStruck(root, store);
  mountOverlays(root, store);
}

/** The switches of the tangent line with the natural angle, and of the diamond systems. */
function mountOverlays(root: HTMLElement, store: Store): void {
  for (const [key, shown] of [
    ["guides", "contact"],
    ["diamonds", "diamonds"],
  ] as const) {
    const box = h("input", { type: "checkbox", id: uniqueId(key), role: "switch" });
    box.addEventListener("change", () => {
      store.setPart("overlays", { [shown]: box.checked });
    });
    store.subscribe(({ session }) => {
      box.checked = session.overlays[shown];
    });
    root.append(
      h("div", { class: "switch row" }, box, h("label", { for: box.id }, t(`aim.${key}`))),
      h("p", { class: "hint" }, t(`aim.${key}-hint`)),
    );
  }
}

function mountOffsets(root: HTMLElement, store: Store, context: Context): void {
  const field = (label: string, key: "side" | "height") => {
    mountField(root, store, context, {
      label,
      unit: t("unit.tips-short"),
      spoken: t("unit.tips"),
      digits: 3,
      step: 0.1,
      read: () => (store.document.shot.strike[key] ?? 0) / TIP,
      write: (value, group) =>
        store.strike({ [key]: round(value * TIP, 5) }, t("change.tip"), group),
    });
  };
  field(t("aim.side"), "side");
  field(t("aim.height"), "height");
  const center = () => store.strike({ side: 0, height: 0 }, t("change.centre"));
  root.append(h("button", { type: "button", class: "button", onclick: center }, t("aim.centre")));
}

function mountSpeed(root: HTMLElement, store: Store, context: Context): void {
  const units = h("select", { "aria-label": t("aim.speed-unit") });
  for (const unit of Object.keys(SPEED_UNITS)) units.append(h("option", { value: unit }, unit));
  units.addEventListener("change", () => {
    store.setView({ units: units.value as SpeedUnit });
  });
  store.subscribe(({ view }) => {
    units.value = view.units;
  });
  units.value = store.view.units;
  mountField(root, store, context, {
    label: t("aim.speed"),
    unit: units,
    spoken: "",
    digits: 3,
    step: 0.05,
    // The bar beside Shoot is the slider.
    read: () => speedIn(store.view.units, store.document.shot.strike.speed),
    write: (value, group) =>
      store.strike(
        { speed: round(speedFrom(store.view.units, value), 5) },
        t("change.speed"),
        group,
      ),
  });
}

function mountElevation(root: HTMLElement, store: Store, context: Context): void {
  mountField(root, store, context, {
    label: t("aim.elevation"),
    unit: "°",
    spoken: t("unit.degrees"),
    digits: 3,
    step: 0.5,
    slider: { min: () => 0, max: () => STEEPEST },
    read: () => elevationOf(store.document.shot.strike, store.shot.strike?.elevation ?? 0),
    write: (value, group) => store.strike({ elevation_deg: value }, t("change.elevation"), group),
  });
  const button = h(
    "button",
    {
      type: "button",
      class: "button",
      title: t("aim.automatic-hint"),
      onclick: () => {
        if (!isAutomatic(store.document.shot.strike)) makeElevationAutomatic(store);
      },
    },
    t("aim.automatic"),
  );
  button.setAttribute("aria-label", t("aim.automatic-elevation"));
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
    label: t("aim.direction"),
    unit: "°",
    spoken: t("unit.azimuth"),
    digits: AZIMUTH_DIGITS,
    step: 0.1,
    read: () => azimuthOf(store.document.shot.strike),
    write: (value, group) => store.strike({ azimuth_deg: wrap(value) }, t("change.aim"), group),
  });
  const degrees = () => TURN * (store.session.fine ? FINE : 1);
  const arrow = (sign: number) => {
    const onclick = () => {
      turn(store, sign * degrees(), `turn ${sign}`);
    };
    const button = h("button", { type: "button", class: "button", onclick });
    follow(store, button, () => t(sign > 0 ? "aim.left" : "aim.right", { degrees: degrees() }));
    const name = () => {
      const key = sign > 0 ? "aim.turn-left" : "aim.turn-right";
      button.setAttribute("aria-label", t(key, { degrees: degrees() }));
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
      title: t("aim.fine-hint"),
      onclick: () => {
        store.setSession({ fine: !store.session.fine });
      },
    },
    t("aim.fine"),
  );
  const show = () => {
    fine.setAttribute("aria-pressed", String(store.session.fine));
  };
  store.subscribe(show);
  show();
  row.append(arrow(1), arrow(-1), fine);
  root.append(field, row);
}

function mountStruck(root: HTMLElement, store: Store): void {
  const id = uniqueId("struck");
  const select = h("select", { id });
  select.addEventListener("change", () => {
    if (!store.strike({ ball: select.value }, t("change.struck"))) show();
  });
  function show(): void {
    const { balls, strike } = store.document.shot;
    const ids = balls.map((ball) => ball.id);
    if (
      select.options.length !== ids.length ||
      ids.some((b, k) => select.options[k]!.value !== b)
    ) {
      select.replaceChildren(
        ...ids.map((ball) => h("option", { value: ball }, capital(ballName(ball)))),
      );
    }
    select.value = strike.ball;
  }
  store.subscribe(show);
  show();
  root.append(h("div", { class: "row struck" }, h("label", { for: id }, t("aim.struck")), select));
}
