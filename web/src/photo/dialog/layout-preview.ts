/** A small drawing of the table and of the balls found so far. */

import type { Geometry } from "../../engine/index.ts";
import { look } from "../../viewer/index.ts";
import type { Layout } from "../geometry/photo-layout.ts";
import { fill, TEXTS } from "../texts.ts";
import { drawing } from "./element.ts";

/** Half the length of the mark of a contact, in radii. */
const MARK = 0.6;

/** The table from above, its length upwards, with the balls of a layout. */
export function preview(geometry: Geometry, radius: number, layout: Layout): SVGSVGElement {
  const [width, length] = geometry.size ?? [1, 2];
  const rail = geometry.rail_width ?? 0.1;
  const svg = drawing("svg", {
    class: "photo-preview",
    role: "img",
    "aria-label": fill(TEXTS.preview, { count: layout.balls.length }),
    viewBox: `${-rail} ${-rail} ${width + 2 * rail} ${length + 2 * rail}`,
  });
  const box = (out: number, kind: string) =>
    drawing("rect", {
      x: -out,
      y: -out,
      width: width + 2 * out,
      height: length + 2 * out,
      rx: out,
      class: kind,
    });
  svg.append(box(rail, "rail"), box(0, "cloth"));
  for (const { center, radius: hole } of geometry.pockets) {
    svg.append(
      drawing("circle", { cx: center[0], cy: length - center[1], r: hole, class: "hole" }),
    );
  }
  layout.balls.forEach(({ id, position }, index) => {
    const { body, striped } = look(id, index);
    const [x, y] = [position[0], length - position[1]];
    const ball = { cx: x, cy: y, r: radius };
    svg.append(drawing("circle", { ...ball, class: "ball", fill: striped ? "#f6f1e3" : body }));
    if (striped) svg.append(drawing("circle", { ...ball, r: 0.6 * radius, fill: body }));
  });
  for (const contact of layout.contacts) svg.append(mark(layout, contact, length, radius));
  return svg;
}

/** A short line across a contact. */
function mark(
  { balls }: Layout,
  contact: Layout["contacts"][number],
  length: number,
  radius: number,
): SVGElement {
  const [x, y] = balls[contact.ball]!.position;
  let across: readonly [number, number];
  let at: readonly [number, number];
  if ("nose" in contact) {
    const { axis, inward } = contact.nose;
    across = axis === 0 ? [0, 1] : [1, 0];
    at = axis === 0 ? [x - inward * radius, y] : [x, y - inward * radius];
  } else {
    const [u, v] = balls[contact.other]!.position;
    across = [(v - y) / (2 * radius), (x - u) / (2 * radius)];
    at = [(x + u) / 2, (y + v) / 2];
  }
  const half = MARK * radius;
  return drawing("line", {
    x1: at[0] - half * across[0],
    y1: length - at[1] + half * across[1],
    x2: at[0] + half * across[0],
    y2: length - at[1] - half * across[1],
    class: "contact",
  });
}
