/** The tip stays within the miscue limit. */

import { describe, expect, test } from "vitest";
import { withinLimit } from "../../../src/app/aim/cue-ball-face.ts";

const LIMIT = 0.5145;

describe("an offset of the tip", () => {
  test("stays where it is within the limit, to a thousandth of the radius", () => {
    expect(withinLimit([0.21649, -0.3], LIMIT)).toEqual([0.216, -0.3]);
  });

  test("beyond the limit goes to the limit in the same direction, and never beyond it", () => {
    for (let degrees = 0; degrees < 360; degrees += 7) {
      const angle = (degrees * Math.PI) / 180;
      const [side, height] = withinLimit([Math.cos(angle), Math.sin(angle)], LIMIT);
      const out = Math.hypot(side, height);
      expect(out).toBeLessThanOrEqual(LIMIT);
      expect(out).toBeGreaterThan(LIMIT - 0.002);
      expect(side * Math.sin(angle) - height * Math.cos(angle)).toBeCloseTo(0, 2);
    }
  });
});
