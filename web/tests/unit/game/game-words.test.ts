import { describe, expect, test } from "vitest";
import type { Frame, FrameState, Request, Ruling, ShotRequest } from "../../../src/engine/index.ts";
import type { PlayedMove } from "../../../src/app/game/game-progress.ts";
import { gameName } from "../../../src/app/common/preset-names.ts";
import {
  callInWords,
  choiceInWords,
  headline,
  requestInWords,
  rulingInWords,
} from "../../../src/app/game/game-words.ts";

const NAMES = ["Ann", "Bea"] as const;

const SHOT: ShotRequest = {
  kind: "shot",
  player: 0,
  cue_ball: "cue",
  in_hand: null,
  on: [],
  calls: ["nothing"],
};

const state = (request: Request, more: Partial<FrameState> = {}): FrameState => ({
  game: "nine-ball",
  request,
  scores: [0, 0],
  fouls_in_a_row: [0, 0],
  shots: 1,
  balls: { cue: [0.5, 0.5], "8": [0.5, 1] },
  state: {},
  ...more,
});

describe("a request", () => {
  test.each<[string, Partial<ShotRequest>, Partial<FrameState>]>([
    ["Ball 3 is on.", { on: ["3"] }, {}],
    ["The cue ball is in hand, anywhere on the table.", { in_hand: "anywhere" }, {}],
    ["A push-out is allowed.", { calls: ["nothing", "push-out"] }, {}],
    ["Call a ball and its pocket, or a safety.", { calls: ["pocket", "safety"] }, {}],
    ["The table is open.", {}, { state: { groups: [null, null] } }],
    [
      "Stripes (9 to 15) are on.",
      { on: ["9", "11"] },
      { state: { groups: ["stripes", "solids"] } },
    ],
    ["Ball 8 is on.", { on: ["8"] }, { state: { groups: ["stripes", "solids"] } }],
    ["A red is on.", { on: ["red-1", "red-2"] }, { state: { on: "red", free_ball: false } }],
    [
      "A colour is on. Nominate the ball on.",
      { on: ["pink", "black"], calls: ["on"] },
      { state: { on: "color", free_ball: false } },
    ],
    [
      "There is a free ball. Nominate the ball on.",
      { on: ["pink", "black"], calls: ["on"] },
      { state: { on: "red", free_ball: true } },
    ],
    ["", { on: ["red"] }, { state: { innings: [1, 0] } }],
  ])("%s", (words, shot, more) => {
    expect(requestInWords(state({ ...SHOT, ...shot }, more))).toBe(words);
  });

  test("shows the call in place of the request for one", () => {
    const asked = state({ ...SHOT, calls: ["pocket", "safety"] });
    const call = { kind: "pocket", ball: "3", into: "top-left" } as const;
    expect(requestInWords(asked, call)).toBe("Called: ball 3, top left pocket.");
    expect(callInWords({ kind: "pocket", ball: "3" })).toBe("ball 3, no pocket yet");
    expect(callInWords({ kind: "pocket", into: "left" })).toBe("no ball yet, left side pocket");
    expect(callInWords(null)).toBe("");
  });

  test("a headline names the player to shoot or to decide, or the winner", () => {
    expect(headline(SHOT, NAMES)).toBe("Ann to shoot");
    expect(headline({ kind: "choice", player: 1, choices: ["play-on"], why: "" }, NAMES)).toBe(
      "Bea decides",
    );
    expect(headline({ kind: "over", winner: 1, why: "" }, NAMES)).toBe("Bea wins");
    expect(headline({ kind: "over", winner: null, why: "" }, NAMES)).toBe("Nobody wins");
    expect(gameName("straight-pool")).toBe("Straight pool");
    expect(choiceInWords("pass-back", "Ann")).toBe("let Ann shoot");
  });
});

describe("a ruling", () => {
  const LEGAL: Ruling = { legal: true, fouls: [], points: [0, 0], spotted: [], racked: false };
  const strike = { speed: 1, azimuth: 0, elevation: 0, side: 0, height: 0 };
  const step = (ruling: Partial<Ruling>, more: Partial<PlayedMove> = {}): PlayedMove => ({
    move: { play: { strike } },
    player: 0,
    from: {} as Frame,
    before: state(SHOT),
    after: state(SHOT),
    ruling: { ...LEGAL, ...ruling },
    potted: [],
    ...more,
  });

  test("names the fouls, each with its rule where it has one", () => {
    const fouls = [
      { what: "no rail after contact", rule: "WPA 6.3" },
      { what: "a ball left the table", rule: "" },
    ];
    expect(rulingInWords(step({ legal: false, fouls, points: [0, 4] }), NAMES)).toBe(
      "Foul by Ann: no rail after contact (WPA 6.3); a ball left the table. Bea scores 4 points.",
    );
  });

  test("lists what was pocketed, scored, spotted and racked", () => {
    expect(rulingInWords(step({}), NAMES)).toBe("Ann: a legal shot, nothing pocketed.");
    const scored = step({ points: [1, -2], spotted: ["9"], racked: true }, { potted: ["3", "9"] });
    expect(rulingInWords(scored, NAMES)).toBe(
      "Ann: a legal shot, ball 3 and ball 9 pocketed. Ann scores 1 point. Bea loses 2 points. " +
        "Ball 9 is spotted. The balls are racked again.",
    );
    const many = step({ spotted: ["1", "2", "3", "4"] });
    expect(rulingInWords(many, NAMES)).toMatch(/4 balls are spotted/);
  });

  test.each([
    [{ balls: 0, cushions: 2, needed: 3 }, 0, "Ann: no ball touched, no point."],
    [{ balls: 1, cushions: 4, needed: 3 }, 0, "Ann: only one ball touched, 4 cushions, no point."],
    [{ balls: 1, cushions: 0, needed: 0 }, 0, "Ann: only one ball touched, no point."],
    [{ balls: 2, cushions: 2, needed: 3 }, 0, "Ann: 2 cushions before the second ball, no point."],
    [{ balls: 2, cushions: 0, needed: 3 }, 0, "Ann: 0 cushions before the second ball, no point."],
    [
      { balls: 2, cushions: 4, needed: 3 },
      1,
      "Ann: both balls touched, 4 cushions before the second. Ann scores 1 point.",
    ],
    [{ balls: 2, cushions: 0, needed: 0 }, 1, "Ann: both balls touched. Ann scores 1 point."],
    [
      { balls: 2, cushions: 0, needed: 0, stayed: true },
      0,
      "Ann: both balls touched, but they stayed in the corner, no point.",
    ],
  ])("counts balls and cushions in carom: %o", (carom, scored, words) => {
    const ruling = { carom: { stayed: false, ...carom }, points: [scored, 0] as const };
    expect(rulingInWords(step(ruling), NAMES)).toBe(words);
  });

  test("names a choice, a safety, and the end of the frame", () => {
    expect(rulingInWords(step({}, { move: { choice: "pass-back" } }), NAMES)).toBe(
      "Ann: let Bea shoot.",
    );
    const safety = step({}, { move: { play: { strike, call: { kind: "safety" } } } });
    expect(rulingInWords(safety, NAMES)).toBe("Ann: a legal shot, a safety, nothing pocketed.");
    const over = state({ kind: "over", winner: 0, why: "the last ball was pocketed" });
    expect(rulingInWords(step({}, { after: over, potted: ["9"] }), NAMES)).toBe(
      "Ann: a legal shot, ball 9 pocketed. Ann wins: the last ball was pocketed.",
    );
  });
});
