import { Vector3 } from "three";
import { expect, test } from "vitest";
import { clearance, contactPoint } from "../../../src/viewer/overlay/cue.ts";
import { RAILED } from "./tables.ts";

const R = 0.028575;
const aimed = { ball: 0, azimuth: Math.PI / 2, elevation: 0, side: 0, height: 0, pull: 0 };

test("a level cue without offset touches the back of the ball", () => {
  const p = contactPoint(aimed, R);
  expect([p.x, p.y, p.z]).toEqual([0, -R, 0].map((v) => expect.closeTo(v, 12) as number));
});

test("side and height are positive to the right of and above the centre, for the shooter", () => {
  const p = contactPoint({ ...aimed, side: 0.3, height: 0.4 }, R);
  expect(p.x).toBeCloseTo(0.3 * R, 12);
  expect(p.z).toBeCloseTo(0.4 * R, 12);
  expect(p.length()).toBeCloseTo(R, 12);
});

test("the offset of an elevated cue is perpendicular to its axis", () => {
  const elevation = 0.6;
  const p = contactPoint({ ...aimed, elevation, height: 0.5 }, R);
  const axis = new Vector3(0, Math.cos(elevation), -Math.sin(elevation));
  expect(p.dot(axis)).toBeCloseTo(-Math.sqrt(0.75) * R, 12);
  expect(p.z).toBeCloseTo(
    (0.5 * Math.cos(elevation) + Math.sqrt(0.75) * Math.sin(elevation)) * R,
    12,
  );
});

test("the drawn cue is raised over a near rail, and not in the centre of the table", () => {
  const table = RAILED.find(({ name }) => name === "wpa-9ft")!;
  const near = clearance(Math.PI / 2, new Vector3(0.6, 0.2, R), table);
  expect(near).toBeGreaterThan(0.05);
  expect(Math.tan(near) * 0.2 + R).toBeGreaterThan(table.cushion_height);
  expect(clearance(Math.PI / 2, new Vector3(0.6, 2.2, R), table)).toBe(0);
});
