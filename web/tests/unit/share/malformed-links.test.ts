/** Links that are well formed but whose contents the engine refuses. */

import { describe, expect, test } from "vitest";
import { load, type Noise } from "../../../src/engine/index.ts";
import { atOnce } from "../../../src/app/common/slices.ts";
import { readLink } from "../../../src/app/share/address.ts";
import { LinkError, toFragment } from "../../../src/app/share/link.ts";

const engine = await load();

const shot = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [{ id: "cue", position: [0.5, 1] }],
};
const noise: Noise = engine.olympiad();
const setup = {
  rules: "nine-ball",
  options: { seed: 7 },
  from: null,
  names: ["Ann", "Bea"],
  skills: [null, null],
};
const strike = { speed: 8, azimuth: 1.5, elevation: 0, side: 0, height: 0 };

/** The message with which a link to `data` is refused. */
function refusal(data: object): string {
  try {
    atOnce(readLink(engine, toFragment(data)));
  } catch (error) {
    // A TypeError here left the page empty.
    expect(error).toBeInstanceOf(LinkError);
    return (error as LinkError).message;
  }
  throw new Error("the link was not refused");
}

const game = (changes: object) => ({ shot, game: { setup, moves: [], call: null, ...changes } });

describe("a link whose shot lacks balls or a strike", () => {
  test.each([
    [{}, /format/],
    [{ balls: 5 }, /format/],
    [{ balls: [null] }, /format/],
    [{ ...shot, balls: undefined }, /balls/],
    [{ ...shot, balls: 5 }, /balls/],
    [{ ...shot, balls: [null] }, /balls\[0\]/],
    [{ ...shot, balls: [] }, /balls/],
    [{ ...shot, balls: [{ id: 5, position: [0.5, 1] }] }, /balls\[0\]\.id/],
    [{ ...shot, strike: 5 }, /strike/],
    [{ ...shot, strike: { ball: "none", speed: 1, azimuth_deg: 0 } }, /strike\.ball/],
    [{ ...shot, table: null }, /table/],
  ])("%j is refused with the place", (broken, place) => {
    const message = refusal({ shot: broken });
    expect(message).toMatch(/^This link cannot be opened\. /);
    expect(message).toMatch(place);
  });

  test("gets a strike if only that is missing", () => {
    const contents = atOnce(readLink(engine, toFragment({ shot })))!;
    expect(contents.document.shot.strike.ball).toBe("cue");
  });
});

describe("a link with a noise out of range", () => {
  test.each(Object.keys(noise))("%s of 1e9 is refused with place and range", (key) => {
    const message = refusal({ shot, noise: { ...noise, [key]: 1e9 } });
    expect(message).toMatch(/^This link cannot be opened\. .*\(noise\./);
    expect(message).toMatch(/out of range; write a number/);
  });

  test("a negative σ is refused", () => {
    expect(refusal({ shot, noise: { ...noise, speed: -1 } })).toMatch(/noise\.speed: -1/);
  });

  test("a noise of a level of play is accepted", () => {
    const contents = atOnce(readLink(engine, toFragment({ shot, noise })))!;
    expect(contents.document.noise).toEqual(noise);
  });
});

describe("a link with a game that cannot be played", () => {
  test.each([
    ["no such game", game({ setup: { ...setup, rules: "croquet" } }), /croquet/],
    ["no such level", game({ setup: { ...setup, skills: ["constructor", null] } }), /constructor/],
    ["a table that is a number", game({ setup: { ...setup, options: { table: 5 } } }), /table/],
    ["a seed that is text", game({ setup: { ...setup, options: { seed: "7" } } }), /seed/],
    ["a shot to start from without balls", game({ setup: { ...setup, from: {} } }), /format/],
    ["a strike without numbers", game({ moves: [{ play: { strike: {} } }] }), /strike\.speed/],
    [
      "a cue ball whose place has a length of a billion",
      game({ moves: [{ play: { strike, cue_ball: { length: 1e9 } } }] }),
      /cue_ball\[0\]/,
    ],
    [
      "a call of a pocket that is a number",
      game({ moves: [{ play: { strike, call: { kind: "pocket", ball: "1", into: 5 } } }] }),
      /game in this link/,
    ],
    ["an unknown choice", game({ moves: [{ choice: "wish" }] }), /Move 1 .*choice/],
  ])("%s is refused, and the message names it", (_, data, words) => {
    expect(refusal(data)).toMatch(words);
  });
});
