/** What folds the panel: a handle on top of a sheet, and a button beside the tabs of a panel at the side. */

import { h, icon } from "../common/dom.ts";
import { t } from "../words/translate.ts";

/** Dispatched on the panel when it is folded or unfolded. */
export const FOLDED = "carom:folded";

/** Pixels of a drag of the handle after which a release closes the sheet. */
const SWIPE = 40;

/** Pixels within which a press is a tap. */
const TAP = 8;

/** The handle of a sheet: a tap or a swipe down closes it. */
export function mountHandle(sheet: HTMLElement, close: () => void): void {
  const name = t("page.close-sheet");
  const attributes = { type: "button", class: "drawer-handle", "aria-label": name };
  const handle = h("button", { ...attributes, "data-back": true });
  sheet.prepend(handle);
  let from: number | null = null;
  const follow = (y: number): number => Math.max(0, y - (from ?? y));
  handle.addEventListener("pointerdown", ({ button, pointerId, clientY }) => {
    if (button !== 0) return;
    from = clientY;
    handle.setPointerCapture(pointerId);
  });
  handle.addEventListener("pointermove", ({ clientY }) => {
    if (from !== null) sheet.style.transform = `translateY(${follow(clientY)}px)`;
  });
  const end = ({ clientY, type }: PointerEvent): void => {
    if (from === null) return;
    const way = clientY - from;
    from = null;
    sheet.style.transform = "";
    if (type === "pointerup" && (Math.abs(way) < TAP || way > SWIPE)) close();
  };
  handle.addEventListener("pointerup", end);
  handle.addEventListener("pointercancel", end);
  // A browser makes no click of a tap soon after a swipe. Keys and Back press without a pointer.
  handle.addEventListener("click", ({ detail }) => {
    if (detail === 0) close();
  });
}

/** The button that hides a panel at the side of the table, and shows it again. */
export function sideButton(panel: HTMLElement, fold: () => void): HTMLElement {
  const attributes = { type: "button", class: "button plain fold", onclick: fold };
  const button = h("button", { ...attributes, "aria-controls": "drawer" });
  const show = (): void => {
    const isFolded = panel.dataset.folded !== undefined;
    const name = t(isFolded ? "page.show-panel" : "page.hide-panel");
    button.setAttribute("aria-label", name);
    button.setAttribute("aria-expanded", String(!isFolded));
    button.title = name;
    button.replaceChildren(icon(isFolded ? "M15 5l-7 7 7 7" : "M9 5l7 7-7 7"));
  };
  panel.addEventListener(FOLDED, show);
  show();
  return button;
}
