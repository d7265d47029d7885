/** Controls of the set-up's form. */

import { h, uniqueId } from "../../common/dom.ts";

export function select(
  options: readonly (readonly [value: string, text: string])[],
): HTMLSelectElement {
  const items = options.map(([value, text]) => h("option", { value }, text));
  return h("select", { id: uniqueId("choose") }, ...items);
}

export function number(value: number, min: number): HTMLInputElement {
  return h("input", { type: "number", id: uniqueId("number"), min, step: 1, value });
}

/** The whole number in a field; null if it is none, or too small. */
export function whole(input: HTMLInputElement, least: number): number | null {
  const value = Number(input.value);
  return input.value.trim() !== "" && Number.isSafeInteger(value) && value >= least ? value : null;
}

export function label(control: HTMLElement, text: string): HTMLElement {
  return h("label", { for: control.id }, text);
}

export function labelled(text: string, control: HTMLElement): HTMLElement {
  return h("div", { class: "labelled" }, label(control, text), control);
}
