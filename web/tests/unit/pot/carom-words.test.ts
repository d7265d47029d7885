import { expect, test } from "vitest";
import { load, type ShotFile } from "../../../src/engine/index.ts";
import { patternText, routeText } from "../../../src/app/pot/carom-words.ts";
import { readingInWords } from "../../../src/app/pot/diamond-words.ts";

const engine = await load();

/** A strike of a cue ball on the match table. */
function routeOf(struck: string, azimuth_deg: number, side: number) {
  const file = {
    format: "carom-shot/1",
    table: "carom-10ft",
    balls: [
      { id: struck, position: [0.4, 0.6] },
      { id: struck === "cue" ? "yellow" : "cue", position: [1.1, 0.5] },
      { id: "red", position: [0.9, 2.2] },
    ],
    strike: { ball: struck, speed: 4, azimuth_deg, side, height: 0.3 },
  } as unknown as ShotFile;
  return engine.shot(file).simulate().caromRoute();
}

test("a route has the words of players, with the sum of the system", () => {
  const route = routeOf("cue", 350.5, 0.3)!;
  expect(patternText(route)).toBe("Around the table, the yellow first");
  expect(routeText(route)).toBe(
    "three-quarter ball off the yellow, long, short, long, half ball on the red, running side",
  );
  expect(readingInWords(route.system!)).toBe(
    "Corner five: 3.2 − 0.1 = 3.1. The ball arrives there.",
  );
});

test("the white has its name where the yellow is struck", () => {
  expect(patternText(routeOf("yellow", 350.5, 0.3)!)).toBe("Around the table, the white first");
});

test("cushions before the first ball come before it", () => {
  const route = routeOf("cue", 319, -0.3)!;
  expect(patternText(route)).toBe("Umbrella: two cushions first, the yellow first");
  expect(routeText(route)).toMatch(/^short, long, half ball off the yellow, short, /);
});

test("a shot with fewer than two balls has no route", () => {
  expect(routeOf("cue", 90, 0)).toBeNull();
});
