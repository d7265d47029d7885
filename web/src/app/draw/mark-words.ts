/** A mark in words, for lists and screen readers. */

import type { DrawnMark } from "../../engine/index.ts";
import { t } from "../words/translate.ts";

export function markInWords(mark: DrawnMark): string {
  const words = { what: t(`draw.${mark.kind}`), color: t(`draw.${mark.color}`) };
  if (mark.kind !== "label") return t("draw.mark", words);
  return t("draw.mark-text", { ...words, text: mark.text });
}
