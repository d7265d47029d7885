import { describe, expect, test } from "vitest";
import { load, type PocketName, type ShotFile } from "../../../src/engine/index.ts";
import { Desk, type DeskWorker } from "../../../src/app/analyse/desk/desk-client.ts";
import type { ChancePart, Job, Parts } from "../../../src/app/analyse/desk/desk-protocol.ts";
import { within } from "../../../src/app/analyse/desk/desk-layout.ts";
import { considered, interval, ordersOf } from "../../../src/app/analyse/plan-orders.ts";
import { type DeskPort, serveDesk, steps } from "../../../src/app/analyse/desk/desk-server.ts";

const engine = await load();
const noise = engine.noisePresets.club!;
const exact = Object.fromEntries(
  Object.keys(noise).map((key) => [key, 0]),
) as unknown as typeof noise;

const FILE: ShotFile = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.42, 0.72] },
    { id: "9", position: [0.86, 1.74] },
    { id: "1", position: [0.35, 1.62] },
  ],
  strike: { ball: "cue", speed: 2, azimuth_deg: 66.8, height: -0.2 },
};
const pot = { ball: "9", pocket: "top-right" as PocketName };

function last<J extends Job>(job: J): Parts[J["kind"]] {
  return [...steps(engine, job)].at(-1) as Parts[J["kind"]];
}

describe("the chance of a pot", () => {
  const shot = engine.shot(FILE);

  test("counts the variants in which the ball falls and the cue ball stays", () => {
    const { met, count } = last({
      kind: "chance",
      noise,
      count: 130,
      of: { shot: shot.json(), ...pot },
    });
    const { balls, pocket } = shot.vary(noise, 130);
    const index = shot.geometry.pockets.findIndex(({ name }) => name === "top-right");
    let expected = 0;
    for (let k = 0; k < 130; k++)
      if (pocket[k * balls + 1] === index && pocket[k * balls] === -1) expected++;
    expect([met, count]).toEqual([expected, 130]);
    expect(met).toBeGreaterThan(20);
  });

  test("is all or nothing without errors", () => {
    const of = { shot: shot.json(), ...pot };
    const aimed = shot.withStrike(shot.potAim("9", "top-right")!.strike).json();
    expect(last({ kind: "chance", noise: exact, count: 10, of: { ...of, shot: aimed } }).met).toBe(
      10,
    );
    const left = { ...of, pocket: "left" as PocketName };
    expect(last({ kind: "chance", noise: exact, count: 10, of: left }).met).toBe(0);
  });
});

test("the chance to keep the turn is that of the frame's successors", () => {
  const frame = engine.frameOf("nine-ball", engine.shot(FILE));
  const play = { strike: { speed: 3, azimuth: 1.63, side: 0, height: 0 } };
  const { player, winner } = frame.successors(play, noise, 120);
  const kept = player.filter((seat, k) => seat === 0 || winner[k] === 0).length;
  const { met } = last({ kind: "chance", noise, count: 120, of: { record: frame.record, play } });
  expect(met).toBe(kept);
});

test("a stopping place is reached with the pot kept", () => {
  const shot = engine.shot(FILE).json();
  const { aim } = last({ kind: "leave", noise, shot, ...pot, place: [0.5, 1.2] });
  const trace = engine.shot(FILE).withStrike(aim!.strike).simulate();
  expect(trace.outcome.pocketed[0]).toEqual(["9", "top-right"]);
  expect(aim!.distance).toBeLessThan(0.02);
});

/** A desk on this thread, with real messages. */
function desk(): Desk {
  const { port1, port2 } = new MessageChannel();
  serveDesk(port2 as unknown as DeskPort);
  const worker = Object.assign(port1, { onerror: null, terminate: () => port1.close() });
  return new Desk(() => worker as unknown as DeskWorker, engine);
}

test("a new question replaces the one before, and a refusal is a sentence", async () => {
  const shot = engine.shot(FILE).json();
  const own = desk();
  const stale: ChancePart[] = [];
  own.ask(
    { kind: "chance", noise, count: 5000, of: { shot, ...pot } },
    { part: (part) => stale.push(part) },
  );
  const parts = await new Promise<ChancePart[]>((resolve) => {
    const all: ChancePart[] = [];
    own.ask(
      { kind: "chance", noise, count: 100, of: { shot, ...pot } },
      { part: (part) => all.push(part), done: () => resolve(all) },
    );
  });
  expect(stale).toEqual([]);
  expect(parts.map(({ count }) => count)).toEqual([50, 100]);
  const why = await new Promise<string>((refused) => {
    const job = { kind: "leave", noise, shot, ball: "7", pocket: "left", place: [0, 0] } as const;
    own.ask(job, { part: () => undefined, refused });
  });
  expect(why).toContain("7");
  own.close();
});

describe("the zone for the next ball", () => {
  const file = { ...FILE, balls: FILE.balls.filter(({ id }) => id !== "9") };

  test("is bright before the pocket on the ball's line, and dark behind the ball", () => {
    const job: Job = { kind: "zone", shot: JSON.stringify(file), ball: "1", noise };
    const { columns, rows, values, share } = last(job);
    expect([columns, rows, share]).toEqual([12, 24, 1]);
    // Ball 1 at (0.35, 1.62); the top left pocket at (0, 2.54). On its line, 40 cm behind the ball:
    const cell = (x: number, y: number) =>
      values[Math.floor((y / 2.54) * rows) * columns + Math.floor((x / 1.27) * columns)]!;
    expect(cell(0.49, 1.25)).toBeGreaterThan(0.6);
    expect(cell(0.49, 1.25)).toBeGreaterThan(cell(0.1, 0.1));
    expect(Math.max(...values)).toBeLessThanOrEqual(1);
    expect(cell(0.35, 1.62)).toBe(0); // no room
  });

  test("grows row by row", () => {
    const job: Job = { kind: "zone", shot: JSON.stringify(file), ball: "1", noise };
    const shares = [...steps(engine, job)].map((part) => (part as Parts["zone"]).share);
    expect(shares.length).toBe(24);
    expect(shares).toEqual(shares.toSorted((a, b) => a - b));
  });
});

describe("a plan of balls", () => {
  const job = (more: object = {}): Job & { kind: "plan" } => ({
    kind: "plan",
    shot: JSON.stringify(FILE),
    orders: [["1", "9"]],
    length: 2,
    noise,
    runs: 12,
    ...more,
  });

  test("pots its balls in order, and each shot begins where the one before ends", () => {
    const { legs, met, count } = last(job({ noise: exact }));
    expect(legs.map(({ ball }) => ball)).toEqual(["1", "9"]);
    for (const { shot, ball, pocket, chance } of legs) {
      expect(engine.shot(shot).simulate().outcome.pocketed).toContainEqual([ball, pocket]);
      expect(chance).toBe(1);
    }
    const [first, second] = legs.map(({ shot }) => shot);
    const trace = engine.shot(first!).simulate();
    const [x, y] = trace.statesAt(trace.duration);
    expect(second!.balls[0]!.position).toEqual([x, y]);
    // Without errors every run pots all of them.
    expect([met, count]).toEqual([12, 12]);
  });

  test("chooses the better one of two orders, and its chance is below that of each ball", () => {
    const { legs, met, count } = last(
      job({
        orders: [
          ["1", "9"],
          ["9", "1"],
        ],
      }),
    );
    expect(legs.length).toBe(2);
    expect(count).toBe(12);
    expect(met).toBeLessThanOrEqual(12);
    for (const { chance } of legs) expect(chance).toBeGreaterThan(0);
  });

  test("ends early where a ball has no line", () => {
    const blocked: ShotFile = {
      ...FILE,
      balls: [
        { id: "cue", position: [0.635, 0.1] },
        { id: "1", position: [0.635, 0.03] },
      ],
    };
    const parts = [
      ...steps(engine, job({ shot: JSON.stringify(blocked), orders: [["1"]], length: 1 })),
    ];
    expect(parts).toEqual([]);
  });
});

test("the chance that a normal error is within a tolerance", () => {
  expect(within(1, 1)).toBeCloseTo(0.682689, 6);
  expect(within(1.959964, 1)).toBeCloseTo(0.95, 6);
  expect(within(0.1, 0)).toBe(1);
});

test("orders agree with the game and with the balls that were chosen", () => {
  const any = [null, null, null];
  expect(ordersOf(["9", "3", "1", "5"], any, "lowest-first")).toEqual([["1", "3", "5"]]);
  expect(ordersOf(["9", "1"], ["9", null], "lowest-first")).toEqual([["9", "1"]]);
  const groups = ordersOf(["1", "8", "9", "10"], [null, null], "groups");
  expect(groups).toEqual([
    ["9", "10"],
    ["10", "9"],
  ]);
  expect(ordersOf(["1", "2", "3"], any, "any-ball").length).toBe(6);
  expect(ordersOf(["1", "2"], ["1", "1"], null)).toEqual([]);
});

test("a plan considers the six easiest balls, those that are wanted, and all if the lowest comes first", () => {
  const balls = ["1", "2", "3", "4", "5", "6", "7", "9"];
  const ease = (id: string) => Number(id);
  const any = [null, null, null];
  expect(considered(balls, any, "any-ball", ease)).toEqual(["9", "7", "6", "5", "4", "3"]);
  expect(considered(balls, ["1", null, null], null, ease)).toEqual([
    ...["9", "7", "6", "5", "4", "3"],
    "1",
  ]);
  expect(considered(balls, any, "lowest-first", ease)).toEqual(balls);
});

test("the interval of a chance is Wilson's", () => {
  const [low, high] = interval(30, 100);
  expect(low).toBeCloseTo(0.2189, 3);
  expect(high).toBeCloseTo(0.3958, 3);
  expect(interval(0, 10)[0]).toBe(0);
});

describe("a pot", () => {
  const question = { kind: "pot", shot: engine.shot(FILE).json(), ball: "9" } as const;

  test("is searched for the first pocket that a line reaches", () => {
    const aims = engine.shot(FILE).geometry.pockets.map(({ name }) => name);
    const reached = aims.filter((name) => engine.shot(FILE).potAim("9", name) !== null);
    const missed = aims.filter((name) => !reached.includes(name));
    const pockets = [...missed, ...reached];
    const { found } = last({ ...question, pockets });
    expect(found!.pocket).toBe(reached[0]);
    expect(found!.aim).toEqual(engine.shot(FILE).potAim("9", reached[0]!));
  });

  test("has no line with too soft a stroke", () => {
    const soft = { ...FILE, strike: { ...FILE.strike!, speed: 0.05 } };
    const shot = engine.shot(soft).json();
    expect(last({ ...question, shot, pockets: ["top-right"] }).found).toBeNull();
  });
});
