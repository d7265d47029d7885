import { expect, test } from "vitest";
import { load, type ShotFile } from "../../../src/engine/index.ts";
import { firstContact } from "../../../src/app/pot/first-contact.ts";
import { hitName } from "../../../src/app/pot/pot-words.ts";

const engine = await load();

/** The first contact of a cue ball that passes ball 1 at `offset` (m) from full. */
function contact(offset: number, more: object = {}) {
  const file: ShotFile = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [
      { id: "cue", position: [0.6, 0.6] },
      { id: "1", position: [0.6 + offset, 1.2] },
    ],
    strike: { ball: "cue", speed: 2, azimuth_deg: 90, ...more },
  };
  return firstContact(engine.shot(file).simulate());
}

test("the fullness of a hit is what the player sees covered", () => {
  for (const fullness of [1, 0.75, 0.5, 0.25]) {
    // The centres pass at (1 − fullness) diameters.
    const found = contact((1 - fullness) * 0.05715)!;
    expect(found.ball).toBe("1");
    expect(found.fullness).toBeCloseTo(fullness, 3);
    expect(Math.sin((found.cut * Math.PI) / 180)).toBeCloseTo(1 - fullness, 3);
  }
});

test("a shot that meets no ball has no contact", () => {
  expect(contact(0, { azimuth_deg: 0, speed: 0.5 })).toBeNull();
});

test("hits have the players' names", () => {
  expect([1, 0.8, 0.5, 0.3, 0.02].map(hitName)).toEqual([
    "full hit",
    "three-quarter ball",
    "half ball",
    "quarter ball",
    "very thin cut",
  ]);
});
