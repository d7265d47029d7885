/** The buttons above the table: history, camera, theme, help. */

import { redo, undo } from "../document/undo.ts";
import type { Context } from "../common/context.ts";
import type { Camera, Theme } from "../document/document.ts";
import { h, icon } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";
import { mountChoice } from "../common/choice-row.ts";

const ICONS = {
  undo: "M8 4L4 8l4 4M4 8h10a5.5 5.5 0 0 1 0 11h-4",
  redo: "M16 4l4 4-4 4M20 8H10a5.5 5.5 0 0 0 0 11h4",
  top: "M4 6h16v12H4zM4 6l0 0M12 6v0M12 18v0M8 12h.01M15 12h.01",
  orbit: "M4 14l5-6h10l-4 8H4zM4 14v3h11v-1M15 17l4-7",
  cue: "M12 4a4 4 0 1 0 .01 0M12 12v8M9 20h6",
  reset: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
  auto: "M12 3a9 9 0 1 0 .01 0M12 3v18",
  light:
    "M12 8a4 4 0 1 0 .01 0M12 2v2M12 20v2M2 12h2M20 12h2M5 5l1.4 1.4M17.6 17.6L19 19M5 19l1.4-1.4M17.6 6.4L19 5",
  dark: "M20 14.5A8.5 8.5 0 1 1 9.5 4a7 7 0 0 0 10.5 10.5z",
  help: "M9 9a3 3 0 1 1 4.2 2.8c-.8.4-1.2 1-1.2 2M12 17.5h.01M12 3a9 9 0 1 0 .01 0",
} as const;

const CAMERAS: readonly Camera[] = ["top", "orbit", "cue"];

const THEMES: readonly Theme[] = ["auto", "light", "dark"];
type Button = HTMLButtonElement;

function iconButton(name: keyof typeof ICONS, label: string, onclick?: () => void): Button {
  const attributes = { type: "button", class: "button plain", "aria-label": label, title: label };
  return h("button", { ...attributes, onclick }, icon(ICONS[name]));
}

function name(button: Button, label: string): void {
  button.title = label;
  button.setAttribute("aria-label", label);
}

/** Undo and redo. A button without effect is marked as disabled but can still have the focus. */
export function mountHistory(root: HTMLElement, store: Store, context: Context): void {
  const back = iconButton("undo", t("history.undo"), () => undo(store, context));
  const again = iconButton("redo", t("history.redo"), () => redo(store, context));
  root.append(back, again);
  const show = () => {
    const { undoLabel, redoLabel } = store;
    name(
      back,
      undoLabel === null ? t("history.undo") : t("history.undo-change", { change: undoLabel }),
    );
    name(
      again,
      redoLabel === null ? t("history.redo") : t("history.redo-change", { change: redoLabel }),
    );
    back.setAttribute("aria-disabled", String(undoLabel === null));
    again.setAttribute("aria-disabled", String(redoLabel === null));
  };
  // What was done before the page was loaded again comes without a change of the document.
  let shown = "";
  store.subscribe(() => {
    const labels = JSON.stringify([store.undoLabel, store.redoLabel]);
    if (labels !== shown) show();
    shown = labels;
  });
  show();
}

export function mountCamera(root: HTMLElement, store: Store, context: Context): void {
  const choose = (mode: Camera) => {
    if (store.view.camera === mode) context.viewer.resetView();
    store.setView({ camera: mode });
    context.loop.invalidate();
  };
  const buttons = CAMERAS.map((name) => ({ name, button: iconButton(name, t(`camera.${name}`)) }));
  const show = mountChoice(root, buttons, choose);
  store.subscribe(({ view }) => {
    show(view.camera);
  });
  show(store.view.camera);
}

/** Theme and help. */
export function mountPageMenu(root: HTMLElement, store: Store, openHelp: () => void): void {
  const theme = iconButton("auto", t("theme.auto"), () => {
    const next = THEMES[(THEMES.indexOf(store.view.theme) + 1) % THEMES.length]!;
    store.setView({ theme: next });
  });
  root.append(theme, iconButton("help", t("page.help"), openHelp));
  const show = () => {
    const now = store.view.theme;
    name(theme, t(`theme.${now}`));
    theme.replaceChildren(icon(ICONS[now]));
  };
  store.subscribe((now, before) => {
    if (now.view.theme !== before.view.theme) show();
  });
  show();
}
