import { describe, expect, test, vi } from "vitest";
import {
  CaromError,
  load,
  type Noise,
  type Play,
  type ShotFile,
} from "../../../src/engine/index.ts";
import { shotFile } from "./files.ts";

const engine = await load();
const shot = engine.shot(shotFile("half_ball_cut"));
const strike = shot.strike!;

function refusal(call: () => unknown): CaromError {
  try {
    call();
  } catch (error) {
    if (error instanceof CaromError) return error;
    throw error;
  }
  throw new Error("the arguments were not refused");
}

/** A value that the types forbid. */
const wrong = (value: unknown) => value as never;

describe("a freed object", () => {
  test("throws an error that names it as freed, not “null pointer passed to rust”", () => {
    const freed = engine.shot(shotFile("half_ball_cut"));
    const trace = freed.simulate();
    const frame = engine.frame("nine-ball");
    for (const object of [freed, trace, frame]) object.free();
    for (const use of [
      () => freed.simulate(),
      () => freed.json(),
      () => freed.withStrike(strike),
      () => freed.vary(engine.olympiad(), 1),
      () => engine.simulate([freed]),
      () => engine.frameOf("nine-ball", freed),
    ]) {
      expect(use).toThrow(/this shot was freed; call free\(\) after its last use/);
    }
    expect(() => trace.statesAt(0)).toThrow(/this trace was freed/);
    expect(() => trace.polyline(0, 1e-3)).toThrow(/this trace was freed/);
    expect(() => frame.play({ strike })).toThrow(/this frame was freed/);
    expect(() => frame.state).toThrow(/this frame was freed/);
  });

  test("can be freed again", () => {
    const freed = engine.shot(shotFile("half_ball_cut"));
    freed.free();
    expect(() => {
      freed.free();
    }).not.toThrow();
  });
});

test("an object of the engine that is cloned says that it cannot be, with the remedy", () => {
  // Seen: structuredClone(frame) and postMessage(frame) gave an empty object without an error.
  const [trace, frame] = [shot.simulate(), engine.frame("nine-ball")];
  for (const [object, remedy] of [
    [frame, /a frame of the engine, which cannot be cloned: send frame\.record/],
    [shot, /a shot of the engine, which cannot be cloned: send shot\.file/],
    [trace, /a trace of the engine, which cannot be cloned: send trace\.json\(\)/],
  ] as const) {
    expect(() => structuredClone(object)).toThrow(remedy);
    expect(() => structuredClone({ inside: [object] })).toThrow(remedy);
  }
  expect(engine.replay(structuredClone(frame.record)).hash).toBe(frame.hash);
});

describe("a strike may be written as in a shot file", () => {
  const inDegrees = shot.withStrike({ speed: 2, azimuth_deg: 62, elevation_deg: 5 });

  test("with degrees, and without side and height", () => {
    expect(inDegrees.strike).toEqual({
      speed: 2,
      azimuth: 62 * (Math.PI / 180),
      elevation: 5 * (Math.PI / 180),
      side: 0,
      height: 0,
    });
    const { balls, ...file } = shot.source;
    const written = {
      ball: shot.balls[shot.struck!]!.id,
      speed: 2,
      azimuth_deg: 62,
      elevation_deg: 5,
    };
    const edited: ShotFile = { ...file, balls, strike: written };
    const read = engine.shot(edited);
    expect(inDegrees.simulate().hash).toBe(read.simulate().hash);
    const { azimuth, elevation } = inDegrees.strike!;
    expect(shot.withStrike({ speed: 2, azimuth, elevation }).json()).toBe(inDegrees.json());
  });

  test("in the plays of frames too, whose records have radians", () => {
    const [one, other] = [engine.frame("nine-ball"), engine.frame("nine-ball")];
    one.play({ strike: { speed: 8, azimuth_deg: 90, elevation_deg: 4 } });
    const radians = { azimuth: Math.PI / 2, elevation: 4 * (Math.PI / 180) };
    other.play({ strike: { speed: 8, ...radians, side: 0, height: 0 } });
    expect(one.record).toEqual(other.record);
    expect(one.hash).toBe(other.hash);
    const next = one.shot({ strike: { speed: 1, azimuth_deg: 12 } });
    expect(next.strike!.azimuth).toBe(12 * (Math.PI / 180));
  });

  test("but not an angle in two units, no angle, or a key that is misspelt", () => {
    const place = (given: unknown) => refusal(() => shot.withStrike(wrong(given))).place;
    expect(place({ speed: 2, azimuth: 1, azimuth_deg: 62 })).toBe("strike.azimuth");
    expect(place({ speed: 2, azimuth: 1, elevation: 0, elevation_deg: 1 })).toBe(
      "strike.elevation",
    );
    expect(place({ speed: 2 })).toBe("strike.azimuth");
    expect(place({ speed: 2, azimuth_deg: "62" })).toBe("strike.azimuth_deg");
    expect(place({ speed: 2, azimuth_deg: 62, hight: 0.2 })).toBe("strike.hight");
    const frame = engine.frame("nine-ball");
    const play = { strike: { speed: 2, azimuth_deg: 62, spin: 1 } };
    expect(refusal(() => frame.play(wrong(play))).message).toMatch(/^strike.spin: unknown key; /);
  });

  test("degrees in the place of radians give a warning", async () => {
    const warn = vi.spyOn(console, "warn").mockReturnValue();
    // New modules, because a warning is given once per thread.
    vi.resetModules();
    const fresh = await (await import("../../../src/engine/index.ts")).load();
    const own = fresh.shot(shotFile("half_ball_cut"));
    own.withStrike({ speed: 2, azimuth: 6 });
    expect(warn).not.toHaveBeenCalled();
    own.withStrike({ speed: 2, azimuth: 90 });
    expect(warn).toHaveBeenCalledExactlyOnceWith(expect.stringMatching(/write azimuth_deg$/));
    warn.mockRestore();
  });
});

describe("invalid arguments are refused with their place", () => {
  test("counts of variants that do not fit into memory", () => {
    for (const n of [1e9, 2 ** 32 + 1, Number.MAX_SAFE_INTEGER]) {
      const error = refusal(() => shot.vary(engine.olympiad(), n));
      expect(error.place).toBe("n");
      expect(error.message).toMatch(/out of range; .* from 0 to \d+; .*in parts, with `first`/);
    }
    for (const n of [-1, 0.5, NaN, wrong("7"), wrong(undefined)]) {
      expect(refusal(() => shot.vary(engine.olympiad(), n)).place).toBe("n");
    }
    // The engine still works.
    expect(shot.vary(engine.olympiad(), 2).shots).toBe(2);
  });

  test("seeds and first variants that are not whole numbers", () => {
    const noise = engine.olympiad();
    expect(refusal(() => shot.vary(noise, 1, { seed: -1 })).place).toBe("seed");
    expect(refusal(() => shot.vary(noise, 1, { first: 1.5 })).place).toBe("first");
  });

  test("noise without a σ, or with one out of range", () => {
    const { speed, ...rest } = engine.olympiad();
    expect(refusal(() => shot.vary(wrong(rest), 1)).place).toBe("noise.speed");
    expect(refusal(() => shot.vary(wrong(null), 1)).place).toBe("noise");
    for (const value of [-speed, NaN, Infinity, 1e9]) {
      const noise: Noise = { ...rest, speed: value };
      expect(refusal(() => shot.vary(noise, 1)).place).toBe("noise.speed");
      expect(refusal(() => engine.checkNoise(noise)).place).toBe("noise.speed");
    }
    engine.checkNoise(engine.olympiad());
    for (const multiplier of [-1, NaN, 1e12]) {
      expect(() => engine.olympiad(multiplier)).toThrow(CaromError);
    }
    expect(refusal(() => engine.olympiad(wrong("2"))).place).toBe("multiplier");
  });

  test("strikes, games, tables and terms of a wrong type", () => {
    for (const [place, call] of [
      ["strike", () => shot.withStrike(wrong(undefined))],
      ["strike.side", () => shot.withStrike({ ...strike, side: wrong("0") })],
      ["strike.speed", () => shot.withStrike({ ...strike, speed: NaN })],
      ["game", () => engine.breakShot(wrong(5))],
      ["table", () => engine.breakShot("nine-ball", { table: wrong(5) })],
      ["speed", () => engine.breakShot("nine-ball", { speed: wrong("fast") })],
      ["gap", () => engine.breakShot("nine-ball", { gap: wrong(null) })],
      ["game", () => engine.usualTable(wrong(undefined))],
      ["options.points", () => engine.frame("straight-pool", { points: 2 ** 32 + 5 })],
      ["options.patience", () => engine.frame("nine-ball", { patience: -1 })],
      ["options.miss", () => engine.frame("snooker", { miss: wrong("yes") })],
      ["kind", () => engine.schema(wrong("table"))],
    ] as const) {
      expect(refusal(call).place, String(call)).toBe(place);
    }
  });

  test("plays of a wrong type", () => {
    const frame = engine.frame("nine-ball");
    for (const [place, play] of [
      ["play", undefined],
      ["strike", {}],
      ["strike.speed", { strike: {} }],
      ["cue_ball[0]", { strike, cue_ball: { length: 1e9 } }],
      ["cue_ball[1]", { strike, cue_ball: [0.5] }],
      ["call", { strike, call: "safety" }],
      ["call.kind", { strike, call: { kind: 5 } }],
      ["call.into", { strike, call: { kind: "pocket", ball: "1", into: 5 } }],
    ] as const) {
      expect(refusal(() => frame.play(play as unknown as Play)).place).toBe(place);
    }
    expect(refusal(() => frame.choose(wrong(5))).place).toBe("choice");
    expect(frame.state.shots).toBe(0);
  });

  test("misspelt keys of options, plays, noises and perceptions", () => {
    const noise = engine.olympiad();
    const frame = engine.frame("nine-ball");
    const play = { strike };
    for (const [place, call] of [
      ["options.sead", () => engine.breakShot("nine-ball", wrong({ sead: 1 }))],
      ["options.fast", () => engine.rollingBands(0.01, 0, wrong({ fast: 2 }))],
      ["options.tabel", () => engine.frame("nine-ball", wrong({ tabel: "bar-7ft" }))],
      ["options.pionts", () => engine.frameOf("straight-pool", shot, wrong({ pionts: 9 }))],
      ["options.simulation", () => engine.player(wrong({ simulation: 9 }))],
      ["options.cuont", () => engine.player().explain(frame, wrong({ cuont: 9 }))],
      ["options.close", () => shot.potAim("1", "top-left", wrong({ close: true }))],
      ["options.variant", () => shot.leaveAim("1", "top-left", [1, 1], wrong({ variant: 9 }))],
      ["options.fist", () => shot.vary(noise, 1, wrong({ fist: 9 }))],
      ["options.first", () => shot.variant(noise, 1, wrong({ first: 9 }))],
      ["options.sed", () => frame.successors(play, noise, 1, wrong({ sed: 9 }))],
      ["errors.nosie", () => frame.play(play, wrong({ nosie: noise }))],
      ["play.cueball", () => frame.play(wrong({ ...play, cueball: [0.5, 0.5] }))],
      ["call.pocket", () => frame.play(wrong({ ...play, call: { pocket: "top-left" } }))],
      ["noise.sped", () => shot.vary(wrong({ ...noise, sped: 1 }), 1)],
      ["opponentNoise.sped", () => engine.player(wrong({ opponentNoise: { ...noise, sped: 1 } }))],
      ["perception.sigma", () => engine.player({ perception: wrong({ position: 0, sigma: 1 }) })],
    ] as const) {
      const error = refusal(call);
      expect([error.kind, error.place], String(call)).toEqual(["unknown-key", place]);
    }
    expect(frame.state.shots).toBe(0);
  });

  test("the keys of a strike are those of a shot file", () => {
    const schema = engine.schema("shot") as {
      $defs: { strike: { properties: Record<string, unknown> } };
    };
    const { remedy } = refusal(() => shot.withStrike(wrong({ ...strike, sped: 1 })));
    const known = remedy.replace("the keys known here are ", "").split(", ");
    expect(known.sort()).toEqual(Object.keys(schema.$defs.strike.properties).sort());
  });

  test("numbers that JSON cannot write, which the engine would take for missing values", () => {
    const file = { ...shot.file, until: Infinity };
    expect(refusal(() => engine.shot(file)).message).toBe(
      "until: Infinity is not finite; write a finite number",
    );
    const [first, ...others] = shot.file.balls;
    const lost = { ...shot.file, balls: [{ ...first!, position: [NaN, 1] as const }, ...others] };
    expect(refusal(() => engine.shot(lost)).place).toBe("balls[0].position[0]");
    const biased = { ...engine.olympiad(), bias: [0, NaN, 0, 0, 0] as const };
    expect(refusal(() => shot.vary(biased, 1)).place).toBe("noise.bias[1]");
  });

  test("files that are not JSON values", () => {
    expect(() => engine.shot(wrong(() => 5))).toThrow(CaromError);
    expect(() => engine.trace(wrong(5))).toThrow(CaromError);
    expect(() => engine.simulate([wrong({})])).toThrow(/make it with Engine\.shot/);
    expect(() => shot.simulate().statesAt(0, wrong([]))).toThrow(/out has 0 numbers/);
  });
});

describe("old spellings work and warn once", () => {
  test("vary(noise, seed, first, count), the keys side and height, finalPosition, target", async () => {
    const warn = vi.spyOn(console, "warn").mockImplementation(() => undefined);
    try {
      // New modules, because a warning is given once per thread.
      vi.resetModules();
      const fresh = await import("../../../src/engine/index.ts");
      const own = await fresh.load();
      const cut = own.shot(shotFile("half_ball_cut"));
      const noise = own.olympiad();
      const { side_m, height_m, ...rest } = noise;
      const old = { ...rest, side: side_m, height: height_m } as unknown as Noise;
      const expected = cut.vary(noise, 4, { seed: 7, first: 2 });
      expect(warn).not.toHaveBeenCalled();
      for (let k = 0; k < 2; k += 1) {
        // eslint-disable-next-line @typescript-eslint/no-deprecated -- that it works is tested here
        const batch = cut.vary(old, 7, 2, 4);
        expect(batch).toEqual(expected);
        // eslint-disable-next-line @typescript-eslint/no-deprecated
        expect(batch.finalPosition).toBe(batch.final_position);
        const frame = own.frame("straight-pool", { target: 0x7f });
        expect(frame.state.request.kind).toBe("shot");
      }
      const said = warn.mock.calls.map(([text]) => String(text));
      expect(said).toHaveLength(5);
      for (const name of [
        "vary(noise, n, { seed, first })",
        "side_m",
        "height_m",
        "final_position",
        "points",
      ]) {
        expect(said.filter((text) => text.includes(name))).toHaveLength(1);
      }
    } finally {
      warn.mockRestore();
    }
  });

  test("a σ given under both its old and its new name is refused", () => {
    const twice = { ...engine.olympiad(), side: 0.001 };
    expect(refusal(() => shot.vary(twice, 1)).message).toMatch(/noise\.side: .*old name of side_m/);
  });
});
