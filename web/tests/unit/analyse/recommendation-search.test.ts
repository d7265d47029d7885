import { afterEach, expect, test } from "vitest";
import { load, type ShotFile } from "../../../src/engine/index.ts";
import type { ThinkerWorker } from "../../../src/engine/thinker-client.ts";
import { serve } from "../../../src/engine/thinker-server.ts";
import type { FromThinker, ThinkerPort, ToThinker } from "../../../src/engine/thinker-protocol.ts";
import {
  type Found,
  RecommendationSearch,
} from "../../../src/app/analyse/recommendation-search.ts";
import { gamesFor, positionOf } from "../../../src/app/analyse/analysed-position.ts";
import { shotOf } from "../../../src/app/analyse/aim-recommendation.ts";
import { documentOf } from "../../../src/app/document/shot-file.ts";
import { Store } from "../../../src/app/document/store.ts";
import { startGame } from "../../../src/app/game/game-actions.ts";
import { referee } from "../../../src/app/game/referee.ts";
import type { Context } from "../../../src/app/common/context.ts";

const engine = await load();

function file(ids: readonly string[], x = 0.2): ShotFile {
  const balls = ids.map((id, k) => ({ id, position: [x + 0.09 * k, 0.7 + 0.11 * k] as const }));
  return {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls,
    strike: { ball: ids[0]!, speed: 2, azimuth_deg: 60 },
  };
}

const storeOf = (shot: ShotFile) => new Store(referee(engine), documentOf(shot));

const open: RecommendationSearch[] = [];
afterEach(() => {
  for (const lines of open.splice(0)) lines.close();
});

/** A worker on this thread, with real messages. */
function worker(): ThinkerWorker {
  const { port1, port2 } = new MessageChannel();
  serve(port2 as unknown as ThinkerPort<FromThinker, ToThinker>);
  const terminate = () => port1.close();
  return Object.assign(port1, { onerror: null, terminate }) as unknown as ThinkerWorker;
}

/** RecommendationSearch with small budgets, and what they find until the last search of a position is done. */
function searching(): {
  readonly lines: RecommendationSearch;
  readonly all: Found[];
  readonly done: () => Promise<Found>;
} {
  const all: Found[] = [];
  let resolve: (found: Found) => void = () => undefined;
  const found = (result: Found) => {
    all.push(result);
    if (result.done) resolve(result);
  };
  const refused = (message: string) => {
    throw new Error(message);
  };
  const lines = new RecommendationSearch(worker, engine, { found, refused }, [300, 900]);
  open.push(lines);
  return { lines, all, done: () => new Promise((done) => (resolve = done)) };
}

test("a layout is valued in the game that fits it best", () => {
  const games = (...ids: string[]) => gamesFor(engine, engine.shot(file(ids)));
  expect(games("cue", "9", "1", "3")[0]).toBe("nine-ball");
  expect(games("cue", "8", "12", "3")).toEqual([
    "eight-ball",
    "straight-pool",
    "chinese-eight-ball",
  ]);
  expect(games("cue", "4", "5")).toEqual(["straight-pool"]);
  expect(games("cue", "4")).toEqual(["practice"]);
  expect(games("cue", "mine")).toEqual([]);
});

test("the search gives lines twice, the better counted ones last", async () => {
  const { lines, all, done } = searching();
  const position = positionOf(storeOf(file(["cue", "9", "1", "3"])), engine)!;
  const ended = done();
  lines.ask(position);
  const { plays } = await ended;
  expect(all.map((found) => found.done)).toEqual([false, true]);
  expect(plays.length).toBeGreaterThan(1);
  expect(plays[0]!.samples).toBeGreaterThan(all[0]!.plays[0]!.samples);
  const chances = plays.map(({ win_chance }) => win_chance);
  expect(chances).toEqual(chances.toSorted((a, b) => b - a));
  // The aim of a line is its play, to the bit.
  const store = storeOf(file(["cue", "9", "1", "3"]));
  const shot = engine.shot(shotOf(store.document.shot, plays[0]!.play));
  expect(shot.strike).toEqual(plays[0]!.play.strike);
});

test("after a change of the position only the new one is reported", async () => {
  const { lines, all, done } = searching();
  const [first, second] = [0.2, 0.3].map((x) =>
    positionOf(storeOf(file(["cue", "9", "1"], x)), engine)!,
  );
  const ended = done();
  lines.ask(first!);
  lines.ask(second!);
  await ended;
  expect(all.every(({ position }) => position === second)).toBe(true);
});

test("in a game the position is the frame's, and the strike does not change it", () => {
  const store = storeOf(file(["cue", "9", "1"]));
  const free = positionOf(store, engine)!;
  expect(free.record.setup.game).toBe("nine-ball");
  store.strike({ speed: 3 }, "speed");
  expect(positionOf(store, engine)!.key).toBe(free.key);
  store.setPart("analysis", { level: "professional" });
  expect(positionOf(store, engine)!.key).not.toBe(free.key);
  const context = { engine, announce: () => undefined } as unknown as Context;
  const setup = {
    rules: "eight-ball",
    options: { seed: 3 },
    from: null,
    names: ["A", "B"],
    skills: [null, null],
  } as const;
  expect(startGame(store, context, setup)).toBe(true);
  const position = positionOf(store, engine)!;
  expect(position.record.setup).toMatchObject({ game: "eight-ball", seed: 3 });
  expect(engine.replay(position.record).state.request.kind).toBe("shot");
});
