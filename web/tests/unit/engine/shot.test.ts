import { describe, expect, test, vi } from "vitest";
import {
  CaromError,
  load,
  OFF_TABLE,
  ON_TABLE,
  type RollingBand,
  type Shot,
  type ShotFile,
  type TraceFile,
} from "../../../src/engine/index.ts";
import { GOLDENS, shotFile } from "./files.ts";

const engine = await load();

function refusal(call: () => unknown): CaromError {
  try {
    call();
  } catch (error) {
    if (error instanceof CaromError) return error;
    throw error;
  }
  throw new Error("the call was not refused");
}

describe("a refusal names the place and the remedy", () => {
  const pot = JSON.parse(shotFile("half_ball_cut")) as { balls: object[]; strike: object };
  const but = (changes: object) => JSON.stringify({ ...pot, ...changes });
  test.each([
    ["{", "", /^not JSON: .*line 1, column 1/],
    [undefined as never, "", /^found null; write an object/],
    [but({ table: "wpa-10ft" }), "table", /wpa-9ft/],
    [
      but({ balls: [...pot.balls, { id: "8", position: [0.5, "x"] }] }),
      "balls[2].position[1]",
      /number/,
    ],
    [but({ strike: { ...pot.strike, side: 0.9 } }), "strike.side", /a miscue.*strike nearer/],
    [but({ strike: { ...pot.strike, spin: 1 } }), "strike.spin", /unknown|no such|remove/],
  ])("%#", (file, place, sentence) => {
    const error = refusal(() => engine.shot(file));
    expect(error.message).toMatch(sentence);
    expect(error.place).toBe(place);
    expect(error.message.startsWith(place)).toBe(true);
  });

  test("a shot at its cap of events carries its file", () => {
    const file = { ...engine.breakShot("eight-ball").file, max_events: 10 };
    const error = refusal(() => engine.shot(file).simulate());
    expect(error.message).toMatch(/^max_events: the shot was stopped at its cap of 10 events/);
    expect(JSON.parse(error.shot!)).toEqual(file);
    expect([error.kind, error.place]).toEqual(["too-many-events", "max_events"]);
    const trace = engine.traceToCap(error);
    expect([trace.events.length, trace.end, trace.outcome.events]).toEqual([10, "cap", 10]);
    expect(engine.trace(trace.json()).hash).toBe(trace.hash);
    expect(
      refusal(() => engine.traceToCap(new CaromError({ kind: "other", fault: "no" }))).message,
    ).toMatch(/simulate/);
  });

  // Seen: "raise the cap, or report", and nothing of what was computed, for motion without an end.
  test("motion that no friction stops asks for an end time", () => {
    const cloth = { sliding_friction: 0, rolling_friction: 0, spin_deceleration: 0 };
    const file: ShotFile = {
      format: "carom-shot/1",
      table: { length: 2, width: 1, pockets: "none" },
      physics: { base: "ideal", cloth },
      balls: [{ id: "cue", position: [0.5, 0.5], velocity: [1, 0.4, 0] }],
      max_events: 50,
    };
    const error = refusal(() => engine.shot(file).simulate());
    expect(error.place).toBe("until");
    expect(error.message).toMatch(/^until: no friction stops ball "cue".*write the time/);
    expect(engine.traceToCap(error).events).toHaveLength(50);
    const trace = engine.shot({ ...file, until: 4.5 }).simulate();
    expect([trace.end, trace.duration]).toEqual(["until", 4.5]);
    expect(trace.statesAt(9)).toEqual(trace.statesAt(4.5));
    expect([...trace.polyline(0, 1e-3)].at(-1)).toBe(4.5);
  });

  test("for unknown games and tables, and for invalid seeds", () => {
    expect(refusal(() => engine.breakShot("curling")).message).toMatch(
      /^game: there is no game "curling"; write one of eight-ball, nine-ball/,
    );
    expect(refusal(() => engine.breakShot("snooker", { seed: -1 })).place).toBe("seed");
    expect(refusal(() => engine.breakShot("snooker", { seed: 0.5 })).place).toBe("seed");
    expect(refusal(() => engine.breakShot("snooker", { table: "lawn" })).place).toBe("table");
  });
});

test("a shot has the values that its file leaves to the physics", () => {
  const shot = engine.shot(shotFile("snooker_pot"));
  expect(shot.geometry.name).toBe("snooker-12ft");
  expect(shot.geometry.pockets).toHaveLength(6);
  const cue = shot.balls[shot.struck!]!;
  expect(cue.radius).toBe(0.02625);
  expect(cue.position[2]).toBe(cue.radius);
  expect(shot.miscueLimit).toBeGreaterThan(0.4);
  expect(shot.miscueLimit).toBeLessThan(0.6);
  expect(engine.shot(shot.json()).json()).toBe(shot.json());
});

test("a shot may have an end time", () => {
  const shot = engine.shot(shotFile("half_ball_cut"));
  expect([shot.until, shot.simulate().end]).toEqual([null, "rest"]);
  const cut = shot.withUntil(0.75);
  expect([cut.until, cut.file.until, cut.withStrike(shot.strike!).until]).toEqual([
    0.75, 0.75, 0.75,
  ]);
  expect(cut.simulate().duration).toBe(0.75);
  const { final } = JSON.parse(cut.simulate().json()) as TraceFile;
  const { final_position } = engine.simulate([cut]);
  expect([...final_position]).toEqual(final.flatMap(({ position }) => [...position]));
  expect(cut.withUntil(null).json()).toBe(shot.json());
  for (const until of [0, -1, NaN, Infinity]) {
    expect(refusal(() => shot.withUntil(until)).place).toBe("until");
  }
});

test("a shot without a strike has no variants", () => {
  const { format, table, balls } = engine.shot(shotFile("half_ball_cut")).file;
  const shot = engine.shot({ format, table, balls });
  expect([shot.struck, shot.strike]).toEqual([null, null]);
  expect(refusal(() => shot.vary(engine.olympiad(), 1)).place).toBe("strike");
});

describe("leaveAim", () => {
  const noise = engine.noisePresets.club!;
  const file: ShotFile = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [
      { id: "cue", position: [0.42, 0.72] },
      { id: "9", position: [0.86, 1.74] },
    ],
    strike: { ball: "cue", speed: 2, azimuth_deg: 66.8 },
  };

  test("pots the ball and stops the cue ball at the place", () => {
    const shot = engine.shot(file);
    const aim = shot.leaveAim("9", "top-right", [0.5, 1.2], { noise })!;
    expect(aim.isReached).toBe(true);
    const trace = shot.withStrike(aim.strike).simulate();
    expect(trace.outcome.pocketed).toEqual([["9", "top-right"]]);
    const [x, y] = trace.statesAt(trace.duration);
    expect([x, y]).toEqual(aim.end);
    expect(Math.hypot(x! - 0.5, y! - 1.2)).toBeCloseTo(aim.distance, 12);
    expect(aim.distance).toBeLessThan(0.02);
    expect(aim.chance).toBeGreaterThan(0);
    expect(aim.chance).toBeLessThan(1);
  });

  test("refuses a place that is not two numbers, and an empty range of speeds", () => {
    const shot = engine.shot(file);
    const place = [0.5] as unknown as [number, number];
    expect(refusal(() => shot.leaveAim("9", "top-right", place)).place).toBe("place[1]");
    const options = { speed: [3, 1] as const };
    expect(refusal(() => shot.leaveAim("9", "top-right", [0.5, 1], options)).message).toBe(
      "speed: 3.0 to 1.0 m/s is not a range of speeds; give 0 < least < most <= 50",
    );
  });
});

describe("potAim", () => {
  const balls = [
    { id: "cue", position: [0.42, 0.72] },
    { id: "9", position: [0.86, 1.74] },
  ] as const;
  const aimless = { ball: "cue", speed: 2, azimuth_deg: 10, side: 0.4 };
  const file = { format: "carom-shot/1", table: "wpa-9ft", balls } as const;
  const struck: ShotFile = { ...file, strike: aimless };
  const shot = engine.shot(struck);

  test("turns the strike until the ball falls into the pocket", () => {
    const aim = shot.potAim("9", "top-right")!;
    expect([aim.kind, aim.route, aim.losesCueBall]).toEqual(["direct", "9", false]);
    const { speed, side, height } = shot.strike!;
    expect(aim.strike).toMatchObject({ speed, side, height });
    const into = (by: number) => {
      const turned = shot.withStrike({ ...aim.strike, azimuth: aim.strike.azimuth + by });
      return turned.simulate().outcome.pocketed;
    };
    for (const share of [-0.9, 0, 0.9]) {
      expect(into(share * aim.margin)).toEqual([["9", "top-right"]]);
    }
    for (const share of [-1.3, 1.3]) expect(into(share * aim.margin)).toEqual([]);
  });

  test("near lines are those that almost pot the ball", () => {
    expect(shot.potAim("9", "top-right", { near: true })).toBeNull();
    const { strike, margin } = shot.potAim("9", "top-right")!;
    const off = shot.withStrike({ ...strike, azimuth: strike.azimuth + 2.5 * margin });
    const back = off.potAim("9", "top-right", { near: true })!;
    expect(Math.abs(back.strike.azimuth - strike.azimuth)).toBeLessThan(0.2 * margin);
  });

  test("finds no line for a ball that is too slow", () => {
    const slow = shot.withStrike({ ...shot.strike!, speed: 0.1 });
    expect(slow.potAim("9", "top-right")).toBeNull();
  });

  test("refuses unknown balls and pockets", () => {
    expect(refusal(() => shot.potAim("8", "top-right")).message).toBe(
      'ball: there is no ball "8"; write one of cue, 9',
    );
    expect(refusal(() => shot.potAim("9", "middle")).place).toBe("pocket");
    expect(refusal(() => shot.potAim("cue", "left")).place).toBe("goal");
    const still = engine.shot(file);
    expect(refusal(() => still.potAim("9", "left")).place).toBe("strike");
  });
});

describe("withStrike", () => {
  const shot = engine.shot(shotFile("masse"));
  const strike = shot.strike!;

  test("gives the same shot as its file", () => {
    const turned = shot.withStrike({ ...strike, azimuth: strike.azimuth + 0.1, side: 0.2 });
    expect(engine.shot(turned.json()).simulate().hash).toBe(turned.simulate().hash);
    expect(turned.file.strike!.side).toBe(0.2);
    expect(turned.strike!.azimuth).toBeCloseTo(strike.azimuth + 0.1, 14);
    expect(shot.strike).toEqual(strike);
  });

  test("without an elevation has the default one, which its file names", () => {
    const { elevation, ...aim } = strike;
    expect([elevation > 1, shot.hasDefaultElevation]).toEqual([true, false]);
    const struck = shot.withStrike({ ...aim, side: 0 });
    expect(struck.hasDefaultElevation).toBe(true);
    expect(struck.strike!.elevation).toBeLessThan(elevation);
    const angles = (file: ShotFile) =>
      Object.keys(file.strike!).filter((key) => key.startsWith("elevation")).length;
    expect([angles(struck.file), angles(struck.source)]).toEqual([1, 0]);
    expect(engine.shot(struck.source).simulate().hash).toBe(struck.simulate().hash);
    expect(shot.source).toBe(shot.file);
    expect(refusal(() => shot.withStrike({ ...aim, elevation: NaN })).place).toBe(
      "strike.elevation",
    );
  });

  test("refuses what the engine refuses in a file", () => {
    const error = refusal(() => shot.withStrike({ ...strike, speed: 60 }));
    expect(error.message).toBe("strike.speed: 60.0 is out of range; write a number in (0, 50] m/s");
    expect(error.place).toBe("strike.speed");
  });

  // The page makes a shot in every frame in which the cue turns.
  test("neither writes nor reads the text of the shot", () => {
    const rack = engine.breakShot("snooker");
    const meant = rack.strike!;
    const spies = [
      vi.spyOn(JSON, "stringify"),
      vi.spyOn(JSON, "parse"),
      vi.spyOn(TextDecoder.prototype, "decode"),
    ];
    const calls = () => spies.map((spy) => spy.mock.calls.length);
    rack.withStrike({ ...meant, speed: 1 }).free();
    const ours = calls();
    JSON.stringify(JSON.parse(rack.json()));
    const all = calls();
    vi.restoreAllMocks();
    expect(ours).toEqual([0, 0, 0]);
    expect(Math.min(...all), "the spies count").toBeGreaterThan(0);
  });
});

describe("batches", () => {
  /** The final state of one shot, as in a row of a batch. */
  function ends(shot: Shot): { position: number[]; pocket: number[] } {
    const trace = shot.simulate();
    const names = shot.geometry.pockets.map((p) => p.name);
    const file = JSON.parse(trace.json()) as { final: { id: string; position: number[] }[] };
    const { pocketed, off_table } = trace.outcome;
    return {
      position: file.final.flatMap((b) => b.position),
      pocket: file.final.map(({ id }) => {
        const fell = pocketed.find(([ball]) => ball === id);
        if (fell) return names.indexOf(fell[1]);
        return off_table.includes(id) ? OFF_TABLE : ON_TABLE;
      }),
    };
  }

  test("of different shots have each shot's final state", () => {
    const shots = Object.keys(GOLDENS).map((name) => engine.shot(shotFile(name)));
    const batch = engine.simulate(shots);
    expect(batch.errors.size).toBe(0);
    expect(batch.shots).toBe(shots.length);
    shots.forEach((shot, k) => {
      const { position, pocket } = ends(shot);
      const [from, to] = [k * batch.balls, k * batch.balls + shot.balls.length];
      expect([...batch.final_position.subarray(3 * from, 3 * to)]).toEqual(position);
      expect([...batch.pocket.subarray(from, to)]).toEqual(pocket);
    });
  });

  test("of variants are the same when drawn in parts", () => {
    const shot = engine.shot(shotFile("half_ball_cut"));
    const whole = shot.vary(engine.olympiad(2), 30, { seed: 7 });
    const piece = shot.vary(engine.olympiad(2), 10, { seed: 7, first: 20 });
    expect(piece.strikes).toEqual(whole.strikes.subarray(100));
    expect(piece.final_position).toEqual(whole.final_position.subarray(60 * whole.balls));
  });

  test("have an error for each variant that cannot be played", () => {
    // The cue just clears the ball behind the cue ball. Lower, it would pass through it.
    const file = {
      format: "carom-shot/1",
      table: "wpa-9ft",
      balls: [
        { id: "cue", position: [0.635, 1.0] },
        { id: "1", position: [0.635, 0.9] },
      ],
      strike: { ball: "cue", speed: 2, azimuth_deg: 90, obstruction: "refuse" },
    } as const;
    const batch = engine.shot(file).vary(engine.olympiad(), 40, { seed: 1 });
    expect(batch.errors.size).toBeGreaterThan(5);
    expect(batch.errors.size).toBeLessThan(35);
    for (const [k, text] of batch.errors) {
      expect(text).toMatch(/the cue would pass through/);
      expect(batch.events[k]).toBe(0);
      expect(batch.final_position[3 * k * batch.balls]).toBeNaN();
    }
  });

  test("of a strike at the miscue limit are all played, within the limit", () => {
    const shot = engine.shot(shotFile("half_ball_cut"));
    const limit = 0.999 * shot.miscueLimit;
    const { errors, strikes } = shot
      .withStrike({ ...shot.strike!, side: limit })
      .vary(engine.olympiad(), 40, { seed: 1 });
    expect(errors.size).toBe(0);
    const offsets = Array.from({ length: 40 }, (_, k) =>
      Math.hypot(strikes[5 * k + 3]!, strikes[5 * k + 4]!),
    );
    expect(Math.max(...offsets)).toBeCloseTo(limit, 12);
    expect(offsets.filter((offset) => Math.abs(offset - limit) < 1e-12).length).toBeGreaterThan(5);
  });

  test("refuse invalid noise and counts", () => {
    const shot = engine.shot(shotFile("half_ball_cut"));
    const noise = { ...engine.olympiad(), speed: -1 };
    expect(refusal(() => shot.vary(noise, 1)).place).toBe("noise.speed");
    expect(refusal(() => shot.vary(engine.olympiad(), 1.5)).place).toBe("n");
  });
});

test("the engine has tables, physics, games and schemas", () => {
  expect(engine.version).toMatch(/^carom \d+\.\d+\.\d+$/);
  expect(engine.tables.map((t) => t.name)).toContain("carom-10ft");
  const presets = ["pool", "snooker", "english", "carom", "poolfiz", "ideal"];
  const conditions = ["new-cloth", "worn-cloth", "clean-balls", "dirty-balls"];
  const rails = ["gold-crown", "valley"];
  const older = ["pool", "snooker", "english", "carom"].map((name) => `${name}-2026-11`);
  expect(Object.keys(engine.physics).sort()).toEqual(
    [...presets, ...[...conditions, ...rails].map((name) => `pool-${name}`), ...older].sort(),
  );
  for (const game of engine.games)
    expect(engine.breakShot(game).simulate().duration).toBeGreaterThan(1);
  expect(engine.schema("shot")).toMatchObject({ title: "carom-shot/1" });
  expect(engine.schema("trace")).toMatchObject({ title: "carom-trace/1" });
});

test("rolling bands follow a measured law, within the errors of the options", () => {
  const bands = engine.rollingBands(0.041, 0.0142, { share: 0.01, least: 0.01 });
  // The preset `carom` has the bands of this law.
  const { rolling_friction } = engine.physics.carom!.cloth as { rolling_friction: RollingBand[] };
  expect(bands).toHaveLength(rolling_friction.length);
  (bands as readonly RollingBand[]).forEach(({ up_to, friction }, k) => {
    expect(friction).toBeCloseTo(rolling_friction[k]!.friction, 8);
    expect(up_to ?? Infinity).toBeCloseTo(rolling_friction[k]!.up_to ?? Infinity, 6);
  });
  const finer = engine.rollingBands(0.041, 0.0142) as readonly RollingBand[];
  expect(finer.length).toBeGreaterThan(rolling_friction.length);
  expect(engine.rollingBands(0.0981, 0, { gravity: 9.81 })).toBeCloseTo(0.01, 14);
  expect(() => engine.rollingBands(0, 0.01)).toThrow(/^a: 0.0 is out of range/);
  expect(() => engine.rollingBands(0.04, 0.01, { least: 0 })).toThrow(/^least: /);
  // @ts-expect-error not a number
  expect(() => engine.rollingBands("0.04", 0.01)).toThrow(/^a: found "0.04"; write a number/);
});

test("records have dated names of presets, which are read as the current ones", () => {
  const file = engine.breakShot("nine-ball", { preset: "rail" }).file;
  const record = engine.withDatedNames(file);
  expect(record).toEqual({ ...file, table: "wpa-9ft-2026-12" });
  expect(engine.shot(record).geometry).toEqual(engine.shot(file).geometry);
  expect(engine.shot(record).simulate().hash).toBe(engine.shot(file).simulate().hash);
  expect(engine.withDatedNames({ table: { cloth: "unbounded" } })).toEqual({
    table: { cloth: "unbounded" },
    physics: "pool-2026-12",
  });
  expect(engine.currentPresetName("carom-10ft-2026-12")).toBe("carom-10ft");
  expect(engine.currentPresetName("pool-worn-cloth-2026-12")).toBe("pool-worn-cloth");
  // Older values keep their date.
  expect(engine.currentPresetName("carom-10ft-2026-11")).toBe("carom-10ft-2026-11");
  expect(engine.currentPresetName("carom-2026-11")).toBe("carom-2026-11");
  expect(engine.currentPresetName("felt")).toBe("felt");
});

test("a break preset has its own place of the cue ball, and an unknown one is refused", () => {
  const [cue] = engine.breakShot("nine-ball", { preset: "rail" }).balls;
  expect(cue!.position[0]).toBeCloseTo(0.0889, 12);
  expect(() => engine.breakShot("nine-ball", { preset: "corner" })).toThrow(
    /^preset: nine-ball has no break preset "corner"/,
  );
});
