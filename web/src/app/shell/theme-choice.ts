/** Light or dark: the system's setting unless the user chose one. */

import type { Context } from "../common/context.ts";
import type { Theme } from "../document/document.ts";
import type { Store } from "../document/store.ts";

const DARK = "(prefers-color-scheme: dark)";

/** The theme shown for the setting `theme`. */
export function shownTheme(theme: Theme): "light" | "dark" {
  if (theme !== "auto") return theme;
  return matchMedia(DARK).matches ? "dark" : "light";
}

export function mountTheme(store: Store, context: Context): void {
  const show = () => {
    const theme = shownTheme(store.view.theme);
    document.documentElement.dataset.theme = theme;
    context.viewer.setTheme(theme);
    context.loop.invalidate();
  };
  matchMedia(DARK).addEventListener("change", show);
  store.subscribe((now, before) => {
    if (now.view.theme !== before.view.theme) show();
  });
  show();
}
