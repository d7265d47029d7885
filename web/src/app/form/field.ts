/** A quantity with a label, a unit, a slider and a number: each in step with the document. */

import type { Context } from "../common/context.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { round } from "../common/units.ts";

export interface Quantity {
  readonly label: string;
  /** As shown, or a control to choose it. */
  readonly unit: string | HTMLElement;
  /** What screen readers say of the unit, if it is not what is shown. */
  readonly spoken?: string;
  readonly digits: number;
  readonly min: () => number;
  readonly max: () => number;
  readonly step: number;
  /** Left out: only a number, no slider. */
  readonly slider?: boolean;
  /** The number that the document has, in the unit shown. */
  readonly read: () => number;
  /** @returns Whether it was accepted. */
  readonly write: (value: number, group: string) => boolean;
}

/** Mounts a field; it follows the store from then on. */
export function mountField(root: HTMLElement, store: Store, context: Context, q: Quantity): void {
  const id = uniqueId("field");
  const group = `field ${id}`;
  const number = h("input", { type: "number", id, step: q.step, inputmode: "decimal" });
  const unit = typeof q.unit === "string" ? h("span", { class: "unit" }, q.unit) : q.unit;
  const range = h("input", { type: "range", step: q.step, "aria-label": q.label });
  const spoken = q.spoken ?? (typeof q.unit === "string" ? q.unit : "");
  const label = h(
    "label",
    { for: id },
    q.label,
    spoken && h("span", { class: "unseen" }, ` in ${spoken}`),
  );
  root.append(
    h(
      "div",
      { class: "field" },
      label,
      h("div", { class: "value" }, number, unit),
      q.slider !== false && range,
    ),
  );

  range.addEventListener("input", () => {
    context.loop.input(range, () => {
      q.write(Number(range.value), group);
    });
  });
  range.addEventListener("change", () => {
    context.loop.flush();
    store.settle();
    show(true);
  });
  // A number counts when it is finished: halfway typed it is another one, and perhaps refused.
  number.addEventListener("change", () => {
    const value = number.value.trim() === "" ? NaN : Number(number.value);
    if (Number.isNaN(value)) store.refuse(`${q.label}: write a number.`);
    const accepted = !Number.isNaN(value) && q.write(value, group);
    if (accepted) show(true);
    else number.setAttribute("aria-invalid", "true");
  });
  number.addEventListener("blur", () => {
    store.settle();
    show(true);
  });

  function show(all = false): void {
    const value = round(q.read(), q.digits);
    range.min = String(q.min());
    range.max = String(q.max());
    if (all || document.activeElement !== range) range.value = String(value);
    range.setAttribute("aria-valuetext", `${value} ${spoken}`);
    // What one is typing is not corrected under one's fingers.
    if (all || document.activeElement !== number) {
      number.value = String(value);
      number.setAttribute("aria-invalid", "false");
    }
  }
  store.subscribe(() => {
    show();
  });
  show(true);
}

/** A text that follows the store. */
export function follow(store: Store, element: Element, text: () => string): void {
  const show = () => {
    setText(element, text());
  };
  store.subscribe(show);
  show();
}
