/** Pockets and rails are named as the picture shows them. */

import { afterEach, describe, expect, test } from "vitest";
import {
  followOrientation,
  seenPocket,
  seenRail,
  orientationOf,
} from "../../../src/app/common/seen.ts";

afterEach(() => {
  followOrientation(() => 0);
});

describe("the turn of the picture", () => {
  test("follows the direction in which the table's length points", () => {
    expect([
      orientationOf(0, -5),
      orientationOf(5, 1),
      orientationOf(1, 5),
      orientationOf(-5, 0),
    ]).toEqual([0, 1, 2, 3]);
  });
});

describe("an upright table", () => {
  test("has the engine's names", () => {
    expect([seenPocket("top-right"), seenPocket("left"), seenRail("left-lower")]).toEqual([
      "top-right",
      "left",
      "left-lower",
    ]);
  });
});

describe("a table that lies with its far end to the right", () => {
  test("has the far right pocket at the bottom right, and a side pocket at the top", () => {
    followOrientation(() => 1);
    expect(seenPocket("top-right")).toBe("bottom-right");
    expect(seenPocket("top-left")).toBe("top-right");
    expect(seenPocket("left")).toBe("top");
    expect(seenPocket("right")).toBe("bottom");
  });

  test("has the foot rail on the right, and the halves of a long rail left and right", () => {
    followOrientation(() => 1);
    expect(seenRail("top")).toBe("right");
    expect(seenRail("left")).toBe("top");
    expect(seenRail("left-lower")).toBe("top-left");
    expect(seenRail("right-upper")).toBe("bottom-right");
  });
});

describe("a table seen from its far end", () => {
  test("has all places on the other side", () => {
    followOrientation(() => 2);
    expect(seenPocket("top-right")).toBe("bottom-left");
    expect(seenRail("left-lower")).toBe("right-upper");
  });
});
