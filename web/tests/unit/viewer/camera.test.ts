import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, test } from "vitest";
import {
  apply,
  behind,
  between,
  type Box,
  oblique,
  poseOf,
  top,
} from "../../../src/viewer/camera/pose.ts";
import { label, RAILED } from "./tables.ts";

const ASPECTS = {
  desktop: 16 / 9,
  tablet: 4 / 3,
  square: 1,
  phone: 390 / 844,
  sliver: 0.3,
  strip: 4,
};

function boxOf(size: readonly [number, number], rail: number, height: number): Box {
  return { min: [-rail, -rail, 0], max: [size[0] + rail, size[1] + rail, height] };
}

/** Range of the box in the picture; its edges are −1 and 1. */
function extent(box: Box, camera: PerspectiveCamera): { x: [number, number]; y: [number, number] } {
  const places = [0, 1].flatMap((i) =>
    [0, 1].flatMap((j) =>
      [0, 1].map((k) =>
        new Vector3(
          (i ? box.max : box.min)[0],
          (j ? box.max : box.min)[1],
          (k ? box.max : box.min)[2],
        ).project(camera),
      ),
    ),
  );
  const range = (axis: "x" | "y"): [number, number] => [
    Math.min(...places.map((p) => p[axis])),
    Math.max(...places.map((p) => p[axis])),
  ];
  return { x: range("x"), y: range("y") };
}

describe.each(RAILED.map((table) => [label(table), table] as const))("%s", (_, table) => {
  const box = boxOf(table.size!, table.rail_width!, table.cushion_height);

  test.each(Object.entries(ASPECTS))("fills a %s screen and is completely visible", (_, aspect) => {
    for (const view of [top, oblique]) {
      const camera = new PerspectiveCamera();
      camera.aspect = aspect;
      apply(view(box, aspect), camera, 10);
      const { x, y } = extent(box, camera);
      expect(Math.max(-x[0], x[1], -y[0], y[1])).toBeLessThanOrEqual(1);
      expect(Math.max(x[1] - x[0], y[1] - y[0])).toBeGreaterThan(view === top ? 1.9 : 1.7);
      // Centred in both directions.
      expect(x[0] + x[1]).toBeCloseTo(0, view === top ? 6 : 0);
      expect(y[0] + y[1]).toBeCloseTo(0, view === top ? 6 : 0);
    }
  });

  test("is horizontal on wide screens and vertical on tall ones", () => {
    expect(top(box, ASPECTS.desktop).azimuth).toBe(0);
    expect(top(box, ASPECTS.phone).azimuth).toBe(-Math.PI / 2);
  });
});

test("from above, the table's long axis points right on wide screens and up on tall ones", () => {
  const box = boxOf([1.27, 2.54], 0.15, 0.036);
  for (const [aspect, axis] of [
    [2, "x"],
    [0.5, "y"],
  ] as const) {
    const camera = new PerspectiveCamera();
    camera.aspect = aspect;
    apply(top(box, aspect), camera, 10);
    const low = new Vector3(0.6, 0.1, 0).project(camera);
    const high = new Vector3(0.6, 2.4, 0).project(camera);
    expect(high[axis]).toBeGreaterThan(low[axis] + 1);
  }
});

test("from behind the cue, the ball is below the centre of the picture and its target above the ball", () => {
  const ball = new Vector3(0.6, 0.6, 0.0286);
  const camera = new PerspectiveCamera();
  camera.aspect = 16 / 9;
  apply(behind(ball, { azimuth: 1.2, elevation: 0 }, 16 / 9), camera, 10);
  const seen = ball.clone().project(camera);
  const ahead = ball
    .clone()
    .add(new Vector3(Math.cos(1.2), Math.sin(1.2), 0))
    .project(camera);
  expect(seen.x).toBeCloseTo(0, 6);
  expect(ahead.x).toBeCloseTo(0, 6);
  expect(seen.y).toBeLessThan(0);
  expect(ahead.y).toBeGreaterThan(seen.y);
});

test("the camera behind the cue is above the cue at every elevation", () => {
  const ball = new Vector3(0.6, 0.6, 0.0286);
  for (const elevation of [0, 0.3, 0.8, 1.3]) {
    const camera = new PerspectiveCamera();
    const pose = behind(ball, { azimuth: 1.2, elevation }, 16 / 9);
    apply(pose, camera, 10);
    const away = camera.position.clone().sub(ball);
    expect(Math.atan2(away.z, Math.hypot(away.x, away.y))).toBeGreaterThan(elevation);
  }
});

test("a flight starts and ends at its poses and turns by the smaller angle", () => {
  const box = boxOf([1.27, 2.54], 0.15, 0.036);
  const [a, b] = [top(box, 0.5), oblique(box, 2)];
  expect(between(a, b, 0).distance).toBeCloseTo(a.distance, 9);
  expect(between(a, b, 1)).toMatchObject({ polar: b.polar, fov: b.fov });
  const half = between({ ...a, azimuth: 3 }, { ...a, azimuth: -3 }, 0.5);
  expect(Math.abs(half.azimuth)).toBeCloseTo(Math.PI, 6);
});

test("the pose of a camera equals the pose that was applied", () => {
  const pose = oblique(boxOf([1.27, 2.54], 0.15, 0.036), 1.5);
  const camera = new PerspectiveCamera();
  apply(pose, camera, 10);
  const back = poseOf(camera, pose.target);
  expect(back.azimuth).toBeCloseTo(pose.azimuth, 9);
  expect(back.polar).toBeCloseTo(pose.polar, 9);
  expect(back.distance).toBeCloseTo(pose.distance, 9);
});
