import { describe, expect, test } from "vitest";
import { CaromError, type Refusal } from "../../../src/engine/index.ts";
import { OFF_TABLE, ON_TABLE, PADDING } from "../../../src/engine/types.ts";
import { Tally } from "../../../src/app/whatif/variant-tally.ts";

const MISCUE = new CaromError({ kind: "miscue", fault: "a miscue" });

const chunk = (
  first: number,
  pockets: number[],
  ends: number[],
  refusals: [number, Refusal][] = [],
) => ({
  generation: 1,
  first,
  count: pockets.length / 2,
  pockets: Int8Array.from(pockets),
  ends: Float64Array.from(ends),
  refusals: new Map(refusals),
});

describe("counting variants of a shot with two balls", () => {
  const tally = new Tally(2, 4);
  tally.add(chunk(0, [ON_TABLE, 5, 3, 0], [0.1, 0.2, 0.3, 0.4]));
  tally.add(chunk(2, [PADDING, PADDING, OFF_TABLE, 2], [NaN, NaN, 0.5, 0.6], [[0, MISCUE]]));

  test("counts the pocketed variants of each ball, for all pockets together", () => {
    expect(tally.pocketed(0)).toMatchObject({ hits: 1, count: 4, value: 0.25 });
    expect(tally.pocketed(1)).toMatchObject({ hits: 3, count: 4, value: 0.75 });
  });

  test("counts balls that leave the table separately", () => {
    expect(tally.off(0).hits).toBe(1);
    expect(tally.off(1).hits).toBe(0);
  });

  test("counts a failed variant as one without pocketed balls, and keeps its error", () => {
    expect(tally).toMatchObject({ count: 4, failed: 1, reason: { kind: "miscue" } });
  });

  test("keeps the final positions of the variants that were played", () => {
    expect([...tally.played()]).toStrictEqual([0.1, 0.2, 0.3, 0.4, 0.5, 0.6]);
  });
});
