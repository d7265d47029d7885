/** A field for a quantity: label, number, unit and slider, synchronized with the document. */

import type { Context } from "../common/context.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import { playsOn } from "../document/plays-on.ts";
import type { Store } from "../document/store.ts";
import { decimal, t } from "../words/translate.ts";
import { round } from "../common/units.ts";

export interface Quantity {
  readonly label: string;
  /** The text shown, or a control that chooses the unit. */
  readonly unit: string | HTMLElement;
  /** The unit for screen readers, if it differs from the text shown. */
  readonly spoken?: string;
  readonly digits: number;
  readonly step: number;
  /** Ends of the slider; without them there is none. */
  readonly slider?: { readonly min: () => number; readonly max: () => number };
  /** The present number in the unit shown. */
  readonly read: () => number;
  /** @returns Whether the number was accepted. */
  readonly write: (value: number, group: string) => boolean;
}

/** Mounts a field that follows the store. */
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
    spoken && h("span", { class: "unseen" }, t("field.in-unit", { unit: spoken })),
  );
  root.append(
    h(
      "div",
      { class: "field" },
      label,
      h("div", { class: "value" }, number, unit),
      q.slider !== undefined && range,
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
  // On "change", not on "input": a number that is half typed might be refused.
  number.addEventListener("change", () => {
    const value = number.value.trim() === "" ? NaN : Number(number.value);
    if (Number.isNaN(value)) store.refuse(t("field.not-a-number", { name: q.label }));
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
    if (q.slider) {
      range.min = String(q.slider.min());
      range.max = String(q.slider.max());
    }
    if (all || document.activeElement !== range) range.value = String(value);
    range.setAttribute("aria-valuetext", `${decimal(value)} ${spoken}`);
    // Do not overwrite the number while the user types it.
    if (all || document.activeElement !== number) {
      number.value = String(value);
      number.setAttribute("aria-invalid", "false");
    }
  }
  store.subscribe((now, before) => {
    // A running replay changes no quantity, and notifies at every picture.
    if (!playsOn(now.session, before.session)) show();
  });
  show(true);
}

/** Keeps the text of an element up to date with the store. */
export function follow(store: Store, element: Element, text: () => string): void {
  const show = () => {
    setText(element, text());
  };
  store.subscribe(show);
  show();
}
