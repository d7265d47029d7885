import { expect, test } from "vitest";
import { meet, position, project, ray } from "../../../src/photo/geometry/camera.ts";
import { outline } from "../../../src/photo/picture/ball-outline.ts";
import { lookAt } from "../../photo/views.ts";

const LENS = { focal: 900, center: [600, 450] as const };
const AIM = { eye: [0.4, -1.2, 1.1], target: [0.6, 1, 0], roll: 0.05 } as const;

for (const k1 of [-0.15, 0, 0.1]) {
  test(`a pixel leads back to its place with k1 = ${k1}`, () => {
    const camera = lookAt({ ...AIM, lens: { ...LENS, k1 } });
    for (const place of [
      [0, 0, 0],
      [1.27, 2.54, 0.028],
      [0.6, 1.2, 0.036],
    ] as const) {
      const [x, y] = meet(camera, project(camera, place)!, place[2])!;
      expect(x).toBeCloseTo(place[0], 9);
      expect(y).toBeCloseTo(place[1], 9);
    }
  });
}

test("the camera is where it was put", () => {
  const camera = lookAt({ ...AIM, lens: { ...LENS, k1: 0 } });
  position(camera).forEach((value, i) => {
    expect(value).toBeCloseTo(AIM.eye[i]!, 12);
  });
});

test("a ball seen as a point of the bed would be misplaced by centimetres", () => {
  const camera = lookAt({ ...AIM, lens: { ...LENS, k1: 0 } });
  const [x, y] = meet(camera, project(camera, [0.6, 2, 0.028575])!, 0)!;
  expect(Math.hypot(x - 0.6, y - 2)).toBeGreaterThan(0.05);
});

test("nothing behind the camera, above the horizon or beyond the fold is seen", () => {
  const camera = lookAt({ ...AIM, lens: { ...LENS, k1: -0.15 } });
  expect(project(camera, [0.4, -3, 0])).toBeNull();
  expect(meet({ ...camera, k1: 0 }, [600, -2000], 0)).toBeNull();
  expect(ray(camera, [600, -2000])).toBeNull();
});

test("the outline of a ball is where rays touch it", () => {
  const camera = lookAt({ ...AIM, lens: { ...LENS, k1: -0.1 } });
  const center = [0.3, 0.5, 0.028575] as const;
  const pixel = project(camera, center)!;
  const eye = position(camera);
  for (const { offset } of outline(camera, pixel, center[2])!) {
    const direction = ray(camera, [pixel[0] + offset[0], pixel[1] + offset[1]])!;
    const length = Math.hypot(...direction);
    const to = center.map((c, i) => c - eye[i]!);
    const along = to.reduce((sum, v, i) => sum + (v * direction[i]!) / length, 0);
    const beside = Math.sqrt(to.reduce((sum, v) => sum + v * v, 0) - along * along);
    expect(beside).toBeCloseTo(0.028575, 7);
  }
});
