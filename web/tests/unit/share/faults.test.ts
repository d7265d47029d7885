/** Damaged and hand-written files and links: what is wrong is a sentence for players in every language. */

import { afterEach, describe, expect, test } from "vitest";
import { CaromError, type FrameRecord, load } from "../../../src/engine/index.ts";
import { detailedText } from "../../../src/app/common/refusals.ts";
import { atOnce } from "../../../src/app/common/slices.ts";
import { ballsOf, cannotOpen, readFile } from "../../../src/app/document/shot-file.ts";
import { gameOfRecord } from "../../../src/app/game/game-record.ts";
import { readLink } from "../../../src/app/share/address.ts";
import { LinkError, toFragment } from "../../../src/app/share/link.ts";
import { type Language, LANGUAGES } from "../../../src/app/words/catalogue.ts";
import { setLanguage } from "../../../src/app/words/translate.ts";

const engine = await load();

afterEach(() => setLanguage("en"));

const FORMAT = "carom-shot/1";
const SHOT = {
  format: FORMAT,
  table: "wpa-9ft",
  physics: "pool",
  balls: [
    { id: "cue", position: [0.4, 0.6], radius: 0.028575, mass: 0.17 },
    { id: "3", position: [0.7, 1.5] },
  ],
  strike: {
    ball: "cue",
    speed: 2,
    azimuth_deg: 71,
    elevation_deg: 3,
    side: 0.1,
    height: 0,
    obstruction: "refuse",
    miscue: "refuse",
  },
} as const;
/** A shot with every number of its own. */
const WHOLE = {
  ...SHOT,
  table: { base: "wpa-9ft", length: 2.5, rail_width: 0.15 },
  physics: {
    ...engine.physics.pool,
  },
  cling: [{ contact: 0, friction: 0.1 }],
};
const MOVING = {
  format: FORMAT,
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.4, 0.6], velocity: [1, 0, 0], angular_velocity: [0, 0, 1] },
    { id: "3", position: [0.7, 1.5] },
  ],
};
const trace = JSON.parse(engine.shot(SHOT).simulate().json()) as object;
const record = (): FrameRecord => {
  const frame = engine.frame("nine-ball", { seed: 4 });
  frame.play({ strike: { speed: 8, azimuth: 1.5, elevation: 0.05, side: 0, height: 0 } });
  return JSON.parse(JSON.stringify(frame.record)) as FrameRecord;
};

/** How a file is refused; null if it opens. */
function refusal(text: string): string | null {
  try {
    const file = JSON.parse(text) as FrameRecord | null;
    if (file?.format === "carom-frame/1") atOnce(gameOfRecord(engine, file));
    else readFile(engine, text);
    return null;
  } catch (error) {
    if (!(error instanceof CaromError || error instanceof SyntaxError)) throw error;
    return cannotOpen(error, text);
  }
}

/** How a link is refused; null if it opens. */
function linkRefusal(data: object): string | null {
  try {
    atOnce(readLink(engine, toFragment(data)));
    return null;
  } catch (error) {
    if (!(error instanceof LinkError)) throw error;
    return error.message;
  }
}

/** Words of programmers: keys with an index, a dot or an underscore, and the engine's English. */
const TECHNICAL = /\w\[\d|[a-z]\.[a-z]|[a-z]_[a-z]|found |write |unknown key|undefined|null|\{|NaN/;

/** The sentences of a message without the details in parentheses. */
const spoken = (message: string): string => {
  const end = message.search(/ ?[(（](?=[\w.[\]]*:? ?\S)/);
  return end < 0 ? message : message.slice(0, end);
};

/** Sentences that were looked at. */
const seen = new Set<string>();

/** Looks at a message in every language, if its English sentence is a new one. */
function check(english: string, message: () => string, what: string): void {
  if (seen.has(spoken(english))) return;
  seen.add(spoken(english));
  const said = (Object.keys(LANGUAGES) as Language[]).map((language) => {
    setLanguage(language);
    const text = spoken(message());
    expect(text, `${what} in ${language}`).not.toMatch(TECHNICAL);
    expect(text, `${what} in ${language}`).toMatch(/[.。）)]$/);
    return text;
  });
  setLanguage("en");
  expect(new Set(said).size, `${what}: ${said.join(" | ")}`).toBe(said.length);
}

type Json = null | boolean | number | string | readonly Json[] | { readonly [key: string]: Json };

/** The values that replace each value of a file in turn; undefined: the key is missing. */
const WRONG: readonly (Json | undefined)[] = [
  undefined,
  null,
  "x",
  -1e9,
  1e300,
  0.5,
  true,
  [],
  [1, 2, 3, 4, 5, 6, 7],
  {},
  { odd_key: 1 },
];

/** A file with each of its values replaced in turn, with the change as text. */
function* damaged(file: Json, path: string): Generator<readonly [what: string, file: Json]> {
  for (const wrong of WRONG) {
    if (wrong !== undefined && path !== "") yield [`${path} = ${JSON.stringify(wrong)}`, wrong];
  }
  if (typeof file !== "object" || file === null) return;
  if (Array.isArray(file)) {
    // The items of a long list are alike.
    const items = file as readonly Json[];
    for (const [k, item] of items.slice(0, 2).entries()) {
      for (const [what, changed] of damaged(item, `${path}[${k}]`)) {
        yield [what, items.map((one, j) => (j === k ? changed : one))];
      }
    }
    return;
  }
  const fields = file as Readonly<Record<string, Json>>;
  yield [`${path} with another key`, { ...fields, odd_key: 1 }];
  for (const [key, value] of Object.entries(fields)) {
    const rest = Object.fromEntries(Object.entries(fields).filter(([one]) => one !== key));
    yield [`${path} without ${key}`, rest];
    for (const [what, changed] of damaged(value, path === "" ? key : `${path}.${key}`)) {
      yield [what, { ...fields, [key]: changed }];
    }
  }
}

describe.each([
  ["a shot", SHOT],
  ["a shot with its own table and physics", WHOLE],
  ["a shot with moving balls", MOVING],
  ["a trace", trace],
  ["the record of a game", record()],
] as const)("%s that is damaged anywhere", (_, file) => {
  test("is opened, or refused with a sentence for players", () => {
    let refused = 0;
    for (const [what, changed] of damaged(file as Json, "")) {
      const text = JSON.stringify(changed);
      const message = refusal(text);
      if (message === null) continue;
      refused += 1;
      check(message, () => refusal(text)!, what);
    }
    expect(refused).toBeGreaterThan(20);
  });
});

test("a link that is damaged anywhere is opened, or refused with a sentence for players", () => {
  const noise = engine.olympiad();
  const { setup, moves } = record();
  const { game: rules, ...options } = setup as { game: string };
  const own = { rules, options, from: null, names: ["Ann", "Bea"], skills: [null, null] };
  const tree = `[Carom "tree/1"]\n[Layout ${JSON.stringify({ ...SHOT, strike: undefined })}]\n1. "cue" speed=1 azimuth_deg=70\n`;
  const free = { shot: SHOT, noise, seed: 3, time: 0.5, tree };
  const played = { shot: SHOT, game: { setup: own, moves, call: null } };
  let refused = 0;
  for (const data of [free, played]) {
    for (const [what, changed] of damaged(JSON.parse(JSON.stringify(data)) as Json, "")) {
      const message = linkRefusal(changed as object);
      if (message === null) continue;
      refused += 1;
      check(message, () => linkRefusal(changed as object)!, what);
    }
  }
  expect(refused).toBeGreaterThan(100);
});

describe("a fault that is likely", () => {
  const text = (changes: object) => JSON.stringify({ ...SHOT, ...changes });
  const [cue, three] = SHOT.balls;
  test.each([
    ["not JSON", "{", "It is not a shot, a trace, a game or an analysis of carom."],
    [
      "a place without numbers",
      text({ balls: [cue, { id: "3", position: ["a", 1] }] }),
      "Ball 3, position: this value is of the wrong kind. (balls[1].position[0]: found the text",
    ],
    [
      "a ball without a place",
      text({ balls: [cue, { id: "3" }] }),
      "Ball 3, position: this value is missing. (balls[1].position: the key is missing",
    ],
    [
      "a ball without a name",
      text({ balls: [cue, { position: [1, 1] }] }),
      "Ball number 2 in the list, name: this value is missing. (balls[1].id: ",
    ],
    [
      "two balls with one name",
      text({ balls: [cue, three, { ...three, position: [0.2, 0.2] }] }),
      "Two balls have the name “3”: give each ball its own name. (balls[2].id: ",
    ],
    ["no balls", text({ balls: [] }), "This number of balls is not possible: 0. (balls: "],
    [
      "an unknown table",
      text({ table: "wpa-9tf" }),
      "The table: this page does not know “wpa-9tf”. (table: there is no table",
    ],
    [
      "an unknown key",
      text({ tabel: "wpa-9ft" }),
      "The file: there is an entry that this page does not know. (tabel: unknown key",
    ],
    [
      "a strike on a ball that is not there",
      text({ strike: { ball: "7", speed: 1, azimuth_deg: 0 } }),
      "The strike, ball: there is no ball “7”. (strike.ball: ",
    ],
    [
      "a number without end",
      text({ strike: { ball: "cue", speed: 1e300, azimuth_deg: 0 } }),
      "Cue speed: this number is not possible. (strike.speed: ",
    ],
    [
      "a game that the page does not have",
      JSON.stringify({ ...record(), setup: { game: "croquet" } }),
      "The game: this page does not know “croquet”. (game: ",
    ],
    [
      "a speed that is too high",
      text({ strike: { ball: "cue", speed: 900, azimuth_deg: 0 } }),
      "Cue speed: 900 is not possible. Write a number above 0, at most 50 m/s. (strike.speed: ",
    ],
    [
      "a key that occurs twice",
      text({}).replace('"id":"3"', '"id":"3","id":"4"'),
      "Ball 4, name: this is written twice. (balls[1].id: ",
    ],
    [
      "a trace that was changed",
      JSON.stringify({ ...trace, hash: "0000000000000000" }),
      "This recorded shot was changed after it was written: open its shot instead. (hash: ",
    ],
  ])("%s is named", (_, file, sentence) => {
    expect(refusal(file)).toContain(`This file cannot be opened. ${sentence}`);
  });

  test("has the key after its sentence also if players know the fault", () => {
    const overlapping = text({ balls: [cue, { id: "3", position: [0.4, 0.61] }] });
    expect(refusal(overlapping)).toMatch(
      /^This file .*Ball 3 overlaps the cue ball .*\(balls\[1\]/,
    );
  });

  test("has no English words of the engine outside the parentheses in German", () => {
    setLanguage("de");
    expect(refusal(text({ balls: [cue, { id: "3" }] }))).toMatch(
      /^Diese Datei .* Kugel 3, Position: Diese Angabe fehlt\. \(balls\[1\]\.position: /,
    );
  });
});

test("the balls of a file that is none are none", () => {
  expect(ballsOf(null)).toEqual([]);
  expect(ballsOf([1, { id: 2 }])).toEqual([{}, { id: 2 }]);
  expect(detailedText(new Error("x"))).toBe("Error: x");
});
