/** The dimensions of a table as the form shows and writes them. */

import type { Geometry, Markings, Point } from "../../engine/index.ts";
import { round4 } from "../common/angles.ts";
import { withoutValue, withValue, type Values } from "../form/parameters.ts";

/** Keys that only affect the drawing and are not in the form. */
const DRAWN = ["sights", "markings"];

/** A table in the keys of a shot file; empty for unbounded cloth. */
export function tableValues({ dimensions, pockets }: Geometry): Values {
  if (!dimensions) return {};
  const values = dimensions.reduce<Values>((found, { key, value }) => {
    const path = key.split(".");
    return DRAWN.includes(path[0]!) ? found : withValue(found, path, value);
  }, {});
  if (pockets.length === 0) return { ...values, pockets: "none" };
  const model = pockets.some(({ mouth }) => mouth) ? "mouth-line" : "drop-circle";
  return { ...values, pockets: "six", pocket_model: model };
}

/**
 * `changes` with lines and spots moved in proportion to the new size of the table.
 *
 * @param from - The table before the change, with its markings.
 * @param base - The preset, if there is one; markings that equal its own are left out.
 */
export function withMarkings(changes: Values, from: Geometry, base: Geometry | undefined): Values {
  const [width, length] = base?.size ?? from.size ?? [1, 1];
  const to: Point = [Number(changes.width ?? width), Number(changes.length ?? length)];
  if (!from.size || !from.markings) return changes;
  const moved = scale(from.markings, [to[0] / from.size[0], to[1] / from.size[1]]);
  // By 1, so that the preset's own markings are rounded as the moved ones are.
  const usual = base?.markings && scale(base.markings, [1, 1]);
  return JSON.stringify(moved) === JSON.stringify(usual)
    ? withoutValue(changes, ["markings"])
    : { ...changes, markings: moved };
}

/** Markings as a shot file has them, of a table whose width and length are multiplied by `factors`. */
function scale({ head_string, d_radius, spots }: Markings, factors: Point): Values {
  const along = (axis: 0 | 1, value: number) => round4(value * factors[axis]);
  return {
    ...(head_string !== null && { head_string: along(1, head_string) }),
    ...(d_radius !== null && { d_radius }),
    spots: spots.map(({ name, position: [x, y] }) => ({
      name,
      position: [along(0, x), along(1, y)],
    })),
  };
}
