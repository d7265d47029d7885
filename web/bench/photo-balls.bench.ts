/**
 * Balls that are found in photos: random cameras, as people hold them, see random layouts of pool, snooker and
 * carom, in light of another colour, with the shadow of a person, a moving hand, noise and JPEG. Taps on the
 * table have Gaussian errors. Prints the results and writes them to benches/results/photo_balls.json.
 */
import { writeFileSync } from "node:fs";
import { expect, test } from "vitest";
import { TAP_ERROR } from "../src/photo/geometry/calibrate.ts";
import { DISTURBANCES } from "../tests/photo/disturb.ts";
import { CAMERAS } from "../tests/photo/views.ts";
import { commitAndDate } from "./commit.ts";
import { findIn, nothing, presetTable, type Tally } from "./found-balls.ts";
import { ROOT } from "./measure.ts";

/** Photos of each table. */
const PHOTOS = { "wpa-9ft": 120, "snooker-12ft": 40, "carom-10ft": 40 } as const;
/** Least share of balls that are seen, and of seen balls whose colour is right. */
const SEEN = 0.9;
const RIGHT = 0.9;
function shares({ balls, seen, right, extra, photos }: Tally) {
  const share = (part: number, whole: number) => Number((part / whole).toFixed(3));
  return {
    share_seen: share(seen, balls),
    share_right: share(right, seen),
    extra_per_photo: share(extra, photos),
  };
}

test("balls are found in disturbed photos", { timeout: 7_200_000 }, () => {
  // The commit that is measured, not the one at the end.
  const stamp = commitAndDate();
  const total = nothing();
  const tables = Object.entries(PHOTOS).map(([name, photos]) => {
    const table = presetTable(name);
    const tally = nothing();
    for (let seed = 0; seed < photos; seed += 1) findIn(table, seed, tally);
    for (const key of Object.keys(total) as (keyof Tally)[]) total[key] += tally[key];
    return [name, { ...tally, ...shares(tally) }] as const;
  });
  const result = {
    ...stamp,
    ...total,
    ...shares(total),
    tables: Object.fromEntries(tables),
    tap_deviation_of_width: TAP_ERROR,
    cameras: CAMERAS,
    disturbances: DISTURBANCES,
  };
  writeFileSync(`${ROOT}benches/results/photo_balls.json`, `${JSON.stringify(result, null, 2)}\n`);
  console.log(JSON.stringify(result, null, 2));
  expect(result.share_seen).toBeGreaterThanOrEqual(SEEN);
  expect(result.share_right).toBeGreaterThanOrEqual(RIGHT);
});
