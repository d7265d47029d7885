/** The header's tools: a row on wide screens, a menu on narrow ones. */

import { icon } from "../common/dom.ts";
import { t } from "../words/translate.ts";

const MENU_ICON = "M4 7h16M4 12h16M4 17h16";

/** Screens whose header has no room for the tools, as in style.css. */
const NARROW = matchMedia("(max-width: 880px)");

/** @param button Opens the menu; the style hides it on wide screens. */
export function mountTools(root: HTMLElement, button: HTMLElement): void {
  button.setAttribute("aria-label", t("page.tools"));
  button.title = t("page.tools");
  button.append(icon(MENU_ICON));
  const show = (): void => {
    root.popover = NARROW.matches ? "auto" : null;
  };
  NARROW.addEventListener("change", show);
  // A tool that opens a dialog ends the menu; the choice of a camera does not.
  root.addEventListener("click", ({ target }) => {
    const pressed = (target as Element).closest("button");
    if (pressed && pressed.role !== "radio" && root.popover !== null) root.hidePopover();
  });
  show();
}
