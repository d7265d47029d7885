/** What the user has drawn on the table, on paper. */

import type { DrawnMark, MarkColor, Point } from "../../engine/index.ts";
import { arrowHead } from "../../viewer/index.ts";
import { type Mark, middle, numeral, tenth } from "./table-marks.ts";

/** The colours of marks, dark enough for lines on white; white would not be seen. */
const INKS: Readonly<Record<MarkColor, string>> = {
  white: "#000000",
  yellow: "#7a6000",
  red: "#b3261e",
  blue: "#1c5a9e",
};

/** Width of the lines and size of the labels, mm on the table. */
const LINE = 8;
const LABEL = 75;

/** The elements of the marks. */
export function paperMarks(marks: readonly DrawnMark[]): Mark[] {
  return marks.map((mark): Mark => {
    const ink = INKS[mark.color];
    const pen = { fill: "none", stroke: ink, "stroke-width": LINE, "stroke-linejoin": "round" };
    switch (mark.kind) {
      case "line":
        return ["path", { d: way([mark.from, mark.to]), ...pen }];
      case "arrow":
        return [
          "path",
          { d: way([mark.from, mark.to]) + way(arrowHead(mark.from, mark.to)), ...pen },
        ];
      case "circle":
        return ["circle", { ...middle(mark.center), r: tenth(1000 * mark.radius), ...pen }];
      case "area": {
        return ["path", { d: `${way(mark.outline)}Z`, ...pen, fill: ink, "fill-opacity": 0.12 }];
      }
      case "label": {
        const { cx, cy } = middle(mark.at);
        const [tag, attributes] = numeral("diagram-id", [cx, cy], LABEL, mark.text);
        const halo = { stroke: "#ffffff", "stroke-width": 3 * LINE, "paint-order": "stroke" };
        return [tag, { ...attributes, ...halo, "font-weight": 600 }, mark.text];
      }
    }
  });
}

function way(points: readonly Point[]): string {
  return points
    .map(middle)
    .map(({ cx, cy }, k) => `${k === 0 ? "M" : "L"}${cx} ${cy}`)
    .join("");
}
