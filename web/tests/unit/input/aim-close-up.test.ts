import { expect, test } from "vitest";
import { closeUpPlace } from "../../../src/app/input/aim-close-up.ts";

const BOX = { left: 0, top: 50, right: 390, bottom: 660 };

test("the close-up is in the corner that is farthest from the contact and the finger", () => {
  const [contact, finger] = [
    { x: 300, y: 120 },
    { x: 320, y: 600 },
  ];
  const { x, y } = closeUpPlace(BOX, [contact, finger], null);
  expect(x).toBeLessThan(100);
  expect(y === 124 || y === 586).toBe(true);
});

test("the close-up stays in its corner until the contact or the finger comes near", () => {
  const first = closeUpPlace(
    BOX,
    [
      { x: 300, y: 120 },
      { x: 300, y: 600 },
    ],
    null,
  );
  expect(
    closeUpPlace(
      BOX,
      [
        { x: 200, y: 300 },
        { x: 60, y: 350 },
      ],
      first,
    ),
  ).toBe(first);
  const moved = closeUpPlace(
    BOX,
    [
      { x: first.x + 20, y: first.y },
      { x: 60, y: 350 },
    ],
    first,
  );
  expect(Math.hypot(moved.x - first.x, moved.y - first.y)).toBeGreaterThan(150);
});
