/** A layout from a photo of a real table. The photo never leaves the page. */

import "./photo.css";
import { PhotoDialog, type PhotoOptions } from "./dialog/photo-dialog.ts";
import { button, element } from "./dialog/element.ts";
import { setLanguage, TEXTS } from "./texts.ts";

export type { PhotoOptions } from "./dialog/photo-dialog.ts";
export { trayOf } from "./photo-draft.ts";
export { type Bed, bed } from "./geometry/settle.ts";

/** Adds the button that opens the dialog. */
export function mountPhoto(place: HTMLElement, options: PhotoOptions, language: string): void {
  setLanguage(language);
  const dialog = new PhotoDialog(options);
  document.body.append(dialog.root);
  const open = button(TEXTS.open, "", () => dialog.open());
  place.append(element("div", { class: "photo-entry" }, open));
}
