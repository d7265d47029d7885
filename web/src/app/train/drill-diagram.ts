/** A drill's layout as a picture, from its data: the table lies, with its head string on the left. */

import type { Engine } from "../../engine/index.ts";
import { svg } from "../common/dom.ts";
import type { Setting } from "./drill-layout.ts";
import { NUMERAL } from "../diagram/table-marks.ts";
import { marksOf } from "./diagram-marks.ts";
import { clothOf } from "./drill-places.ts";

export interface DiagramOptions {
  /** What the picture shows, for screen readers; without it they skip the picture. */
  readonly label?: string;
  /** Size of the balls over their size on the table. Default 1: exact. */
  readonly enlarged?: number;
  /** Whether the diamonds are numbered, and the picture has its exact size, 1 : `scale`. */
  readonly scale?: number;
}

/** Lengths in mm on the table; the picture's x is along the table, its y across it. */
export function diagram(
  engine: Engine,
  setting: Setting,
  { label, enlarged = 1, scale }: DiagramOptions = {},
): SVGSVGElement {
  const cloth = clothOf(engine, setting.drill.table);
  const [width, length] = cloth.size.map((metres) => 1000 * metres) as [number, number];
  const rail = 1000 * (cloth.geometry.rail_width ?? 0.15);
  const margin = rail + (scale === undefined ? 0 : NUMERAL);
  const box = [-margin, -margin, length + 2 * margin, width + 2 * margin];
  const size =
    scale === undefined ? {} : { width: `${box[2]! / scale}mm`, height: `${box[3]! / scale}mm` };
  return svg(
    "svg",
    {
      class: "diagram",
      viewBox: box.map((number) => Math.round(number * 10) / 10).join(" "),
      ...size,
      ...(label === undefined ? { "aria-hidden": "true" } : { role: "img", "aria-label": label }),
    },
    ...marksOf(engine, setting, { enlarged, numbered: scale !== undefined }).map(
      ([tag, attributes, number]) => svg(tag, attributes, number),
    ),
  );
}
