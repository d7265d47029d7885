import { describe, expect, test } from "vitest";
import { type DiamondReading, load, type Point, type ShotFile } from "../../../src/engine/index.ts";

const engine = await load();

/** The presets of validation/diamond_systems; its pool table has no pockets. */
const POOL = { table: "wpa-9ft", physics: "pool" };
const CAROM = { table: "carom-10ft", physics: "carom" };
type Cloth = typeof POOL | typeof CAROM;

/** Reflections of the table: across its width, along its length. */
type Turned = readonly [across: boolean, along: boolean];
const AS_IT_IS: Turned = [false, false];

function traced({ table, physics }: Cloth, start: Point, azimuth: number, side: number) {
  const shot = engine.shot({
    format: "carom-shot/1",
    table,
    physics,
    balls: [{ id: "cue", position: start }],
    strike: { ball: "cue", speed: 2.2, azimuth, side, height: 0.3 },
  } as unknown as ShotFile);
  return shot.simulate();
}

/**
 * The reading of a strike whose ball meets the first rail on the line through two sights, as in the rows of
 * the validation. Places in diamonds.
 */
function read(
  cloth: Cloth,
  [from, to]: readonly [Point, Point],
  side: number,
  [across, along]: Turned = AS_IT_IS,
): DiamondReading | null {
  const { geometry } = traced(cloth, [0.5, 0.5], 0, 0).shot;
  const [width, length] = geometry.size!;
  const unit = length / 8;
  const place = ([x, y]: Point): Point => [
    across ? width - x * unit : x * unit,
    along ? length - y * unit : y * unit,
  ];
  const [a, b] = [place(from), place(to)];
  const aim = Math.atan2(b[1] - a[1], b[0] - a[0]);
  const run = 0.3 / Math.abs(Math.cos(aim));
  const start: Point = [a[0] + run * Math.cos(aim), a[1] + run * Math.sin(aim)];
  const spin = across === along ? side : -side;
  const beside = (azimuth: number) => {
    const hit = traced(cloth, start, azimuth, spin).events.find(
      ({ type }) => type === "rail-collision",
    )!;
    const [x, y] = hit.before[0]!.position;
    return (y - a[1]) * Math.cos(aim) - (x - a[0]) * Math.sin(aim);
  };
  let [low, high] = [aim - 0.1, aim + 0.1];
  for (let k = 0; k < 40; k += 1) {
    const middle = (low + high) / 2;
    if (beside(middle) < 0) low = middle;
    else high = middle;
  }
  return traced(cloth, start, (low + high) / 2, spin).diamondReading(0);
}

/** The sights of a corner-five shot, as `corner_five_line` of the validation has them. */
function cornerFive(cloth: Cloth, start: number, first: number): readonly [Point, Point] {
  const { geometry } = traced(cloth, [0.5, 0.5], 0, 0).shot;
  const unit = geometry.size![1] / 8;
  const [back, width] = [geometry.sights!.setback / unit, geometry.size![0] / unit];
  return [
    [-back, 8 - 2 * (5 - start)],
    [width + back, first],
  ];
}

describe("corner five", () => {
  test.each([
    [CAROM, 5, 1],
    [CAROM, 5, 2],
    [CAROM, 5, 3],
    [CAROM, 5, 4],
    [CAROM, 4.5, 2],
    [CAROM, 4.5, 3],
    [CAROM, 4, 2],
    [CAROM, 4, 3],
    [POOL, 5, 2],
    [POOL, 4, 2],
  ] as const)("reads its numbers, and the engine agrees: %o from %d over %d", (cloth, S, F) => {
    const found = read(cloth, cornerFive(cloth, S, F), 0.3)!;
    expect(found.system).toBe("corner-five");
    expect(found.from).toBeCloseTo(S, 2);
    expect(found.over).toBeCloseTo(F, 2);
    expect(found.predicted).toBeCloseTo(S - F, 2);
    // The tolerance of the row DS-corner.
    expect(Math.abs(found.actual! - found.predicted)).toBeLessThan(0.5);
  });

  test("is the same on every reflected table", () => {
    const line = cornerFive(POOL, 5, 2);
    const whole = read(POOL, line, 0.3)!;
    for (const turned of [
      [true, false],
      [false, true],
      [true, true],
    ] as const) {
      const found = read(POOL, line, 0.3, turned)!;
      expect([found.from, found.over, found.predicted]).toEqual([
        expect.closeTo(whole.from, 2),
        expect.closeTo(whole.over, 2),
        expect.closeTo(whole.predicted, 2),
      ]);
      expect(found.actual).toBeCloseTo(whole.actual!, 2);
      const mirrored = (x: number, y: number) => [
        turned[0] ? 1.27 - x : x,
        turned[1] ? 2.54 - y : y,
      ];
      const [x, y] = whole.places.predicted;
      expect(found.places.predicted).toEqual(
        mirrored(x, y).map((v): unknown => expect.closeTo(v, 2)),
      );
    }
  });

  test("has its numbers at the diamonds", () => {
    const { numbers } = read(POOL, cornerFive(POOL, 5, 2), 0.3)!;
    const at = (x: number, y: number, scale: string) =>
      numbers.find(
        (one) =>
          one.scale === scale &&
          Math.sign(one.at[0] - 0.6) === Math.sign(x - 0.6) &&
          Math.abs(one.at[1] - y * 0.3175) < 1e-6,
      )?.number;
    expect(at(0, 7, "line")).toBe(4.5);
    expect(at(0, 8, "line")).toBe(5);
    expect(at(1.27, 3, "line")).toBe(3);
    expect(at(0, 3, "target")).toBe(3);
  });
});

/** The line of a plus shot, as `plus_line` of the validation has it. */
function plus(start: number, short: number): readonly [Point, Point] {
  const back = 0.0936625 / 0.3175;
  return [
    [-back, start],
    [(9 - short) / 2, -back],
  ];
}

test.each([
  [2, 3],
  [2, 4],
  [3, 3],
])("plus from %d over %d reads its numbers, and the engine agrees", (S, N) => {
  const found = read(POOL, plus(S, N), -0.2)!;
  expect(found.system).toBe("plus");
  expect(found.from).toBeCloseTo(S, 2);
  expect(found.over).toBeCloseTo(N, 2);
  expect(found.predicted).toBeCloseTo(S + N, 2);
  expect(Math.abs(found.actual! - found.predicted)).toBeLessThan(0.5);
});

test("two to one is the mirror image in the line of sights", () => {
  const back = 0.0936625 / 0.3175;
  const line = [
    [-back, 4],
    [4 + back, 2.5],
  ] as const;
  const found = read(POOL, line, 0)!;
  expect(found.system).toBe("two-to-one");
  expect([found.from, found.over, found.predicted]).toEqual([
    expect.closeTo(4, 2),
    expect.closeTo(2.5, 2),
    expect.closeTo(1, 2),
  ]);
  // A rolling ball comes off longer than the mirror says, but not by a diamond.
  expect(found.actual).not.toBeNull();
  expect(Math.abs(found.actual! - 1)).toBeLessThan(1);
});

test("the object ball of a bank has a reading from its contact on", () => {
  const file: ShotFile = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [
      { id: "cue", position: [0.5, 2.2] },
      { id: "3", position: [0.75, 2] },
    ],
    strike: { ball: "cue", speed: 2.5, azimuth: Math.atan2(-0.2, 0.25) },
  };
  const trace = engine.shot(file).simulate();
  const contact = trace.events.findIndex(({ type }) => type === "ball-collision");
  const found = trace.diamondReading(1, contact)!;
  expect(found.system).toBe("two-to-one");
  expect(found.predicted).toBeCloseTo(2 * found.over - found.from, 9);
});

test("a ball that meets no cushion has no reading", () => {
  const cue = { id: "cue", position: [0.635, 0.6] as const };
  const file: ShotFile = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [cue],
    strike: { ball: "cue", speed: 0.3, azimuth: Math.PI / 2 },
  };
  expect(engine.shot(file).simulate().diamondReading(0)).toBeNull();
});
