/** The form that adds a condition to the goal of a step. */

import type { ConditionOf, GoalArea, PocketName, Point } from "../../../engine/index.ts";
import { h } from "../../common/dom.ts";
import { ballName, pocketName } from "../../common/shot-words.ts";
import { capital, t } from "../../words/translate.ts";
import { button } from "../train-parts.ts";

export type OwnCondition = ConditionOf<GoalArea>;

/** What a condition is made from. */
export interface ConditionPlace {
  readonly balls: readonly string[];
  readonly cue: string;
  readonly pockets: readonly PocketName[];
  /** Where the aimed shot leaves the cue ball, m; null if it is lost. */
  readonly end: Point | null;
}

type Field = "ball" | "other" | "pocket" | "count" | "distance";

/** The fields of each kind, in the order of the list. */
const FIELDS: Readonly<Record<OwnCondition["kind"], readonly Field[]>> = {
  pot: ["ball", "pocket"],
  "pot-any": [],
  first: ["ball"],
  stop: ["distance"],
  cushions: ["ball", "count"],
  kick: ["count"],
  carom: ["count"],
  touch: ["ball", "other"],
  avoid: ["ball"],
  hidden: ["ball"],
  next: ["ball"],
  apart: ["ball", "other", "distance"],
  gather: ["distance"],
};

const KINDS = Object.keys(FIELDS) as OwnCondition["kind"][];

/** Kinds that need pockets, and balls besides the cue ball. */
const POCKETS: readonly string[] = ["pot", "pot-any", "next"];
const TWO: readonly string[] = ["carom", "touch", "apart"];

/** What the form shows first: a distance in cm. */
const DISTANCE = 20;
const MOST_CUSHIONS = 20;

/** Kept while the page is open, so that the next condition begins like the last one. */
let kind: OwnCondition["kind"] = "pot";

export function conditionForm(
  id: string,
  place: ConditionPlace,
  add: (condition: OwnCondition) => void,
): HTMLElement {
  const { balls, cue, pockets } = place;
  const objects = balls.filter((ball) => ball !== cue);
  const kinds = KINDS.filter(
    (name) =>
      (pockets.length > 0 || !POCKETS.includes(name)) &&
      (objects.length > 1 || !TWO.includes(name)) &&
      (objects.length > 0 || name === "stop"),
  );
  const shown = kinds.includes(kind) ? kind : kinds[0]!;
  const choose = select(`${id}-kind`, t("own.condition"), kinds, (name) => t(`kind.${name}`));
  choose.control.value = shown;
  const ball = select(`${id}-ball`, t("own.ball"), objects, (one) => capital(ballName(one)));
  const other = select(`${id}-other`, t("own.other"), objects, (one) => capital(ballName(one)));
  if (objects.length > 1) other.control.value = objects[1]!;
  const pocket = select(`${id}-pocket`, t("own.pocket"), ["", ...pockets], (name) =>
    name === "" ? t("own.any-pocket") : capital(pocketName(name)),
  );
  const count = number(`${id}-count`, t("own.cushions"), 1, 0, MOST_CUSHIONS);
  const distance = number(`${id}-distance`, t("own.distance"), DISTANCE, 1, 500);
  const fields = { ball, other, pocket, count, distance };
  const show = () => {
    kind = choose.control.value as OwnCondition["kind"];
    for (const [name, field] of Object.entries(fields)) {
      field.root.hidden = !FIELDS[kind].includes(name as Field);
    }
  };
  choose.control.addEventListener("change", show);
  show();
  const made = (): OwnCondition | null =>
    conditionOf(kind, place, {
      ball: ball.control.value,
      other: other.control.value,
      pocket: pocket.control.value,
      count: count.control.valueAsNumber,
      distance: distance.control.valueAsNumber / 100,
    });
  const press = button(`${id}-add`, t("own.add-condition"), () => {
    const condition = made();
    if (condition) add(condition);
  });
  return h(
    "fieldset",
    { class: "own-condition" },
    h("legend", {}, t("own.new-condition")),
    choose.root,
    ...Object.values(fields).map(({ root }) => root),
    h("div", { class: "row" }, press),
  );
}

/** The condition of the fields; null if a number is missing or out of range, or no place is known. */
function conditionOf(
  kind: OwnCondition["kind"],
  { end }: ConditionPlace,
  values: {
    readonly ball: string;
    readonly other: string;
    readonly pocket: string;
    readonly count: number;
    readonly distance: number;
  },
): OwnCondition | null {
  const { ball, other, pocket, count, distance } = values;
  const counts = Number.isInteger(count) && count >= (kind === "carom" ? 0 : 1);
  const isFar = distance > 0 && distance <= 5;
  switch (kind) {
    case "pot":
      return { kind, ball, ...(pocket !== "" && { pocket: pocket as PocketName }) };
    case "pot-any":
      return { kind };
    case "first":
    case "avoid":
    case "hidden":
    case "next":
      return { kind, ball };
    case "cushions":
      return counts ? { kind, ball, cushions: count } : null;
    case "kick":
    case "carom":
      return counts ? { kind, cushions: count } : null;
    case "touch":
      return { kind, balls: [ball, other] };
    case "apart":
      return isFar && ball !== other ? { kind, balls: [ball, other], distance } : null;
    case "gather":
      return isFar ? { kind, distance } : null;
    case "stop":
      return isFar && end ? { kind, area: { center: end, radius: distance } } : null;
  }
}

interface Control<T extends HTMLElement> {
  readonly root: HTMLElement;
  readonly control: T;
}

function labelled<T extends HTMLElement>(text: string, control: T): Control<T> {
  const label = h("label", { for: control.id }, text);
  return { root: h("div", { class: "labelled" }, label, control), control };
}

export function select<N extends string>(
  id: string,
  text: string,
  names: readonly N[],
  label: (name: N) => string,
): Control<HTMLSelectElement> {
  const options = names.map((name) => h("option", { value: name }, label(name)));
  return labelled(text, h("select", { id }, ...options));
}

export function number(
  id: string,
  text: string,
  value: number | null,
  min: number,
  max: number,
): Control<HTMLInputElement> {
  const attributes = { id, type: "number", min: String(min), max: String(max), step: "1" };
  const input = h("input", attributes);
  input.value = value === null ? "" : String(value);
  return labelled(text, input);
}
