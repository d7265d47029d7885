/** The film of a shot: read with the shot file, and shown beside the simulation. */

import { beforeAll, expect, test } from "vitest";
import { filmOf, splitFilm } from "../../../src/app/document/filmed.ts";
import { readFile } from "../../../src/app/document/shot-file.ts";
import { filmedMarks, filmedPaths, placeAt } from "../../../src/app/replay/filmed-paths.ts";
import { type Engine, load, type ShotFile } from "../../../src/engine/index.ts";

let engine: Engine;
beforeAll(async () => {
  engine = await load();
});

const FILE: ShotFile = {
  format: "carom-shot/1",
  table: "carom-10ft",
  balls: [
    { id: "1", position: [0.5, 0.6] },
    { id: "2", position: [0.9, 2.2] },
  ],
  strike: { ball: "1", speed: 2, azimuth_deg: 60 },
  track: [
    {
      ball: "2",
      samples: [
        [-0.1, 0.9, 2.2],
        [1, 0.9, 2.2],
        [2, 1.1, 2.4],
      ],
    },
  ],
};

test("the engine checks the film, and the shot is kept apart from it", () => {
  const { shot, filmed } = readFile(engine, JSON.stringify(FILE));
  expect(shot).not.toHaveProperty("track");
  expect(filmed!.track).toEqual(FILE.track);
  expect(engine.shot(FILE).simulate().hash).toBe(engine.shot(shot).simulate().hash);
  const wrong = { ...FILE, track: [{ ball: "3", samples: [[0, 1, 1]] }] };
  expect(() => readFile(engine, JSON.stringify(wrong))).toThrow(/^track\[0\]\.ball: no ball/);
});

test("the film of a trace is that of its shot", () => {
  const { shot, filmed } = readFile(engine, engine.shot(FILE).simulate().json());
  expect(shot).not.toHaveProperty("track");
  expect(filmed!.track).toEqual(FILE.track);
});

test("a film belongs to the shot whatever its strike, until a ball lies elsewhere", () => {
  const { shot, filmed } = readFile(engine, JSON.stringify(FILE));
  expect(filmOf({ shot, filmed })).toEqual(FILE.track);
  expect(filmOf({ shot: { ...shot, strike: { ...shot.strike, speed: 3 } }, filmed })).toEqual(
    FILE.track,
  );
  const [first, second] = shot.balls;
  const placed = (position: readonly [number, number]) => ({
    ...shot,
    balls: [{ ...first!, position }, second!],
  });
  expect(filmOf({ shot: placed([0.5, 0.6]), filmed })).toEqual(FILE.track);
  expect(filmOf({ shot: placed([0.5, 0.61]), filmed })).toEqual([]);
  expect(filmOf({ shot })).toEqual([]);
});

test("a file without a film stays as it is", () => {
  const shot = { ...FILE, track: [] };
  expect(splitFilm(shot)).toEqual({ shot });
});

test("a filmed ball moves evenly between two pictures", () => {
  const { samples } = FILE.track![0]!;
  expect(placeAt(samples, -5)).toEqual([0.9, 2.2]);
  expect(placeAt(samples, 0.5)).toEqual([0.9, 2.2]);
  expect(placeAt(samples, 1.5)[0]).toBeCloseTo(1);
  expect(placeAt(samples, 1.5)[1]).toBeCloseTo(2.3);
  expect(placeAt(samples, 2)).toEqual([1.1, 2.4]);
  expect(placeAt(samples, 9)).toEqual([1.1, 2.4]);
  expect(placeAt([[0, 0.3, 0.4]], -1)).toEqual([0.3, 0.4]);
});

test("paths and rings are those of balls that are there, at the height of their centres", () => {
  const { balls } = engine.shot(FILE);
  const radius = balls[1]!.radius;
  const [path, ...others] = filmedPaths(FILE.track!, balls);
  expect(others).toEqual([]);
  expect(path).toMatchObject({ ball: 1, style: "filmed" });
  expect([...path!.points.slice(-4)]).toEqual([1.1, 2.4, radius, 2]);
  const marks = filmedMarks(FILE.track!, balls, 2);
  expect(marks).toEqual([{ ball: 1, kind: "filmed", position: [1.1, 2.4, radius] }]);
  expect(filmedPaths(FILE.track!, balls.slice(0, 1))).toEqual([]);
});
