/**
 * Lists that change while the user presses one of their controls. A control that is replaced between press
 * and release gets no click, so the change waits until the release.
 */

/** What the pointer presses; null: nothing. */
let pressed: EventTarget | null = null;

/** The changes that wait, by the lists that they change. */
const waiting = new Map<Element, () => void>();

/** Follows the presses on the page. */
export function mountPresses(page: Document): void {
  // A finger's press becomes one of the mouse after its release; both move the focus.
  for (const type of ["pointerdown", "mousedown"] as const) {
    page.addEventListener(type, ({ target }) => (pressed = target), { capture: true });
  }
  for (const type of ["pointerup", "mouseup", "pointercancel", "dragend"] as const) {
    page.addEventListener(type, () => setTimeout(release), { capture: true });
  }
}

/** Makes the changes that have waited; the click of the release came before. */
function release(): void {
  pressed = null;
  const changes = [...waiting.values()];
  waiting.clear();
  for (const change of changes) change();
}

/** Changes a list at once, or after the release if one of its controls is pressed. The last change counts. */
export function changeUnpressed(list: Element, change: () => void): void {
  if (pressed instanceof Node && list.contains(pressed)) {
    waiting.set(list, change);
  } else {
    waiting.delete(list);
    change();
  }
}
