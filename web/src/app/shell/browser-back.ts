/**
 * The browser's Back closes what is open before it leaves the page: a dialog, a menu, or what has a control with
 * `data-back`, such as the handle of a sheet. Something that opens puts one entry on top of the tab's history; the
 * entry stays until Back takes it away.
 */

/** The states of the entry on top and of the one below it. An entry of an address that the user enters has none. */
const OPEN = "carom-open";
const BELOW = "carom-below";

/** @param writeAddress Writes the present address into the entry of the history. */
export function mountBack(writeAddress: () => void): void {
  let isOnTop = history.state === OPEN;
  const guard = (): void => {
    if (isOnTop || !closer()) return;
    try {
      history.replaceState(BELOW, "", location.href);
      history.pushState(OPEN, "", location.href);
      isOnTop = true;
    } catch {
      // In a notebook or another page's frame the history cannot be changed.
    }
  };
  // What a press or a key opens is open after its listeners.
  for (const type of ["click", "keyup"]) addEventListener(type, () => setTimeout(guard));
  addEventListener("popstate", () => {
    const wasOnTop = isOnTop;
    isOnTop = history.state === OPEN;
    const wasClosed = wasOnTop && history.state === BELOW;
    if (!wasClosed && (wasOnTop || !isOnTop)) return;
    // The entry below has the address of an earlier time.
    writeAddress();
    if (isOnTop) return;
    const close = closer();
    if (close) {
      close();
      guard();
    } else history.back();
  });
}

/** Closes what was opened last; null if nothing is open. */
function closer(): (() => void) | null {
  const dialog = [...document.querySelectorAll<HTMLDialogElement>("dialog[open]")].at(-1);
  if (dialog) {
    return () => {
      if (dialog.dispatchEvent(new Event("cancel", { cancelable: true }))) dialog.close();
    };
  }
  const menu = document.querySelector<HTMLElement>(":popover-open");
  if (menu) return () => menu.hidePopover();
  const controls = document.querySelectorAll<HTMLElement>("[data-back]");
  const control = [...controls].find((one) => one.getClientRects().length > 0);
  return control ? () => control.click() : null;
}
