/** A small picture of a ball. */

import { look } from "../../viewer/index.ts";
import { svg } from "./dom.ts";

/** @param index Place of the ball among all balls: it colours balls that have no usual colour. */
export function swatch(id: string, index: number): SVGSVGElement {
  const { body, striped } = look(id, index);
  return svg(
    "svg",
    { viewBox: "0 0 16 16", class: "swatch", "aria-hidden": "true" },
    svg("circle", { cx: 8, cy: 8, r: 7, fill: striped ? "#f6f1e3" : body }),
    striped && svg("path", { d: "M1.9 4.6h12.2a7 7 0 0 1 0 6.8H1.9a7 7 0 0 1 0-6.8", fill: body }),
    svg("circle", { cx: 8, cy: 8, r: 7, class: "rim" }),
  );
}
