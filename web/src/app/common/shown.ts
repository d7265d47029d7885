/** Dispatched on a tab's panel whenever it may have become visible. */
export const SHOWN = "carom:shown";

/** Mounts the content of a tab's panel when it is first shown. Most panels are not at the start. */
export function whenShown(panel: HTMLElement, mount: (panel: HTMLElement) => void): void {
  if (panel.hidden) panel.addEventListener(SHOWN, () => mount(panel), { once: true });
  else mount(panel);
}
