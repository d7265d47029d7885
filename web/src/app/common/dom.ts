/** Helpers that create and change DOM elements. */

type Attributes = Readonly<Record<string, string | number | boolean | EventListener | undefined>>;
export type Child = Node | string | null | undefined | false;

/**
 * Creates an element with attributes and children.
 *
 * A function becomes a listener for the event named by its key without "on". `true` sets an attribute
 * without a value; `false` and `undefined` set none.
 */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  return dress(document.createElement(tag), attributes, children);
}

/** Creates an SVG element, as `h` does for HTML. */
export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  return dress(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}

function dress<E extends Element>(element: E, attributes: Attributes, children: Child[]): E {
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(key.replace(/^on/, ""), value);
    else if (value === true) element.setAttribute(key, "");
    else if (value !== undefined && value !== false) element.setAttribute(key, String(value));
  }
  element.append(
    ...children.filter((child) => child !== null && child !== undefined && child !== false),
  );
  return element;
}

/** @param kind Further classes, such as `primary`. */
export function button(text: string, onclick: () => void, kind = ""): HTMLButtonElement {
  return h("button", { type: "button", class: `button ${kind}`.trim(), onclick }, text);
}

/** A control below its label; the control has an id. */
export function labelled(text: string, control: HTMLElement): HTMLElement {
  return h("div", { class: "labelled" }, h("label", { for: control.id }, text), control);
}

let lastId = 0;

/** An id that no other element has, so that a label can refer to it. */
export function uniqueId(stem: string): string {
  lastId += 1;
  return `${stem}-${lastId}`;
}

/** An icon from a path on a 24 × 24 grid. Screen readers skip it: its button needs a label. */
export function icon(path: string): SVGSVGElement {
  return svg(
    "svg",
    { viewBox: "0 0 24 24", class: "icon", "aria-hidden": "true" },
    svg("path", { d: path }),
  );
}

/** Sets a text only if it differs, so that a live region is read only when it changes. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** A button's text in two versions: the style shows the short one where room is scarce. */
export function shortened(name: string, short: string): HTMLElement[] {
  return [h("span", { class: "long" }, name), h("span", { class: "short" }, short)];
}

/** Lets the keyboard scroll an element while its contents are higher than it is. */
export function focusWhileScrolling(element: HTMLElement, ...contents: readonly Element[]): void {
  const watcher = new ResizeObserver(() => {
    if (element.scrollHeight > element.clientHeight + 1) element.tabIndex = 0;
    else element.removeAttribute("tabindex");
  });
  for (const one of [element, ...contents]) watcher.observe(one);
}
