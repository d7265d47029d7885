import { expect, test } from "vitest";
import { besideBall } from "../../../src/app/aim/tip-window.ts";

const SIZE = [168, 220] as const;
const PICTURE = [390, 620] as const;

/** Whether a point is in the window with this corner. */
const covers = ([x, y]: readonly [number, number], [px, py]: readonly [number, number]) =>
  px > x && px < x + SIZE[0] && py > y && py < y + SIZE[1];

test("the window of the tip is behind the cue ball and leaves the ball in view", () => {
  const ball = [200, 300] as const;
  for (let angle = 0; angle < 6.28; angle += 0.3) {
    const back = [Math.cos(angle), Math.sin(angle)] as const;
    const corner = besideBall(ball, back, SIZE, PICTURE);
    expect(covers(corner, ball), `${angle}`).toBe(false);
    const ahead = [ball[0] - 60 * back[0], ball[1] - 60 * back[1]] as const;
    expect(covers(corner, ahead), `${angle}`).toBe(false);
  }
});

test("the window of the tip leaves a ball in view that lies at the edge of the picture", () => {
  for (const ball of [
    [150, 590],
    [20, 20],
    [370, 300],
    [195, 610],
  ] as const) {
    for (let angle = 0; angle < 6.28; angle += 0.3) {
      const corner = besideBall(ball, [Math.cos(angle), Math.sin(angle)], SIZE, PICTURE);
      expect(covers(corner, ball), `${ball.join()} ${angle}`).toBe(false);
    }
  }
});

test("the window of the tip is inside the picture", () => {
  for (const back of [
    [1, 0],
    [0, 1],
    [-1, 0],
    [0.6, 0.8],
  ] as const) {
    const [x, y] = besideBall([150, 600], back, SIZE, PICTURE);
    expect(x >= 0 && x + SIZE[0] <= PICTURE[0] && y >= 0 && y + SIZE[1] <= PICTURE[1]).toBe(true);
  }
});
