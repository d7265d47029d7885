/** The zones of a step: areas drawn on the table, with the points for a cue ball that stops in them. */

import type { Geometry, GoalArea, ZoneOf } from "../../../engine/index.ts";
import { markOf, sizeOf } from "../../common/area-outline.ts";
import { h } from "../../common/dom.ts";
import type { AimedShot } from "../../document/document.ts";
import { areasOfMarks, marksOf, withMarks } from "../../document/marks.ts";
import { beginDrawing } from "../../draw/draw-mode.ts";
import { t } from "../../words/translate.ts";
import { button, type Trainer } from "../train-parts.ts";
import { number } from "./condition-form.ts";

export type OwnZone = ZoneOf<GoalArea>;

/** Bounds of the format. */
const MOST_ZONES = 12;
export const MOST_POINTS = 1000;

/** Zones of areas: the smallest has the most points, the largest one point. */
export function zonesOf(areas: readonly GoalArea[], geometry: Geometry): OwnZone[] {
  const sorted = [...areas].sort((a, b) => sizeOf(a, geometry) - sizeOf(b, geometry));
  return sorted.map((area, k) => ({ area, points: sorted.length - k }));
}

/** Each area of a drawing once, those that are zones already with their points. */
export function withDrawn(
  zones: readonly OwnZone[],
  drawn: readonly GoalArea[],
  geometry: Geometry,
): OwnZone[] {
  const text = (area: GoalArea) => JSON.stringify(area);
  const known = new Map(zones.map(({ area, points }) => [text(area), points]));
  const unique = [...new Map(drawn.map((area) => [text(area), area])).values()];
  return zonesOf(unique, geometry).map(({ area, points }) => ({
    area,
    points: known.get(text(area)) ?? points,
  }));
}

/**
 * @param id The beginning of the ids of its elements.
 * @param layout The position of the step.
 */
export function zoneForm(
  { store }: Trainer,
  id: string,
  {
    zones,
    layout,
    geometry,
  }: {
    readonly zones: readonly OwnZone[];
    readonly layout: AimedShot;
    readonly geometry: Geometry;
  },
  set: (zones: readonly OwnZone[]) => void,
): HTMLElement {
  const draw = () => {
    const marks = zones.map(({ area }) => markOf(area, geometry));
    store.setSession({ activity: "analyse" });
    const change = { shot: withMarks(layout, marks), game: null, noise: null };
    if (store.apply(change, t("change.drill-step"))) beginDrawing(store);
  };
  const take = () => {
    const areas = areasOfMarks(marksOf(store.document.shot));
    if (areas.length === 0) store.refuse(t("own.nothing-drawn"));
    else if (areas.length > MOST_ZONES) store.refuse(t("own.many-zones", { most: MOST_ZONES }));
    else set(withDrawn(zones, areas, geometry));
  };
  return h(
    "fieldset",
    { class: "own-zones" },
    h("legend", {}, t("own.zones")),
    h("p", { class: "hint" }, t("own.zones-hint")),
    ...zones.map((zone, k) =>
      zoneRow(`${id}-${k}`, k, zone, (changed) => {
        set(zones.flatMap((other, at) => (at === k ? (changed ?? []) : other)));
      }),
    ),
    h(
      "div",
      { class: "row" },
      button(`${id}-draw`, t("own.draw-zones"), draw),
      button(`${id}-take`, t("own.take-zones"), take),
    ),
  );
}

/** @param set Changes the zone; null removes it. */
function zoneRow(
  id: string,
  index: number,
  zone: OwnZone,
  set: (zone: OwnZone | null) => void,
): HTMLElement {
  const name = { number: index + 1 };
  const points = number(`${id}-points`, t("own.zone", name), zone.points, 1, MOST_POINTS);
  points.control.addEventListener("change", () => {
    const value = points.control.valueAsNumber;
    const isRight = Number.isInteger(value) && value >= 1 && value <= MOST_POINTS;
    set(isRight ? { ...zone, points: value } : zone);
  });
  const remove = button(`${id}-remove`, t("own.remove-condition"), () => set(null));
  remove.setAttribute("aria-label", t("own.remove-zone", name));
  points.root.append(remove);
  points.root.classList.add("zone");
  return points.root;
}
