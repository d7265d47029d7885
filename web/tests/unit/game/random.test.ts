import { expect, test } from "vitest";
import { type Call, load, type ShotRequest } from "../../../src/engine/index.ts";
import { documentOf } from "../../../src/app/document/shot-file.ts";
import type { Context } from "../../../src/app/common/context.ts";
import { announceCall } from "../../../src/app/game/calling.ts";
import { choose, playShot, startGame } from "../../../src/app/game/game-actions.ts";
import { canAim, standing } from "../../../src/app/game/awaited-turn.ts";
import { progressOf } from "../../../src/app/game/game-progress.ts";
import { referee } from "../../../src/app/game/referee.ts";
import { Store } from "../../../src/app/document/store.ts";

const engine = await load();
const context = { engine } as Context;

/** Moves per game: enough for fouls, balls in hand, choices and new racks. */
const MOVES = 60;

/** A sequence of numbers in [0, 1) that is the same every time (Lehmer 1951). */
function sequence(seed: number): () => number {
  let state = seed;
  return () => (state = (48271 * state) % 2147483647) / 2147483647;
}

function anyCall(
  { calls, on }: ShotRequest,
  balls: readonly string[],
  next: () => number,
): Call | null {
  const pick = <T>(list: readonly T[]): T => list[Math.floor(next() * list.length)]!;
  const kind = pick(calls);
  if (kind === "nothing") return null;
  if (kind === "on") return { kind, ball: pick(on) };
  if (kind === "pocket") return { kind, ball: pick(balls), into: "top-left" };
  return { kind };
}

test.each(engine.ruleSets)(
  "%s accepts every allowed move, and its moves replay to the same state",
  (rules) => {
    const next = sequence(7);
    const document = documentOf({
      format: "carom-shot/1",
      table: "wpa-9ft",
      balls: [{ id: "cue", position: [0.5, 0.6] }],
    });
    const store = new Store(referee(engine), document);
    const players = { names: ["Ann", "Bea"], skills: [null, "club"] } as const;
    startGame(store, context, { rules, options: { seed: 3 }, from: null, ...players });
    for (let made = 0; made < MOVES; made += 1) {
      const { request } = standing(store, engine)!.frame.state;
      if (request.kind === "over") break;
      if (request.kind === "choice") {
        choose(store, context, request.choices[Math.floor(next() * request.choices.length)]!);
      } else {
        expect(canAim(store, engine)).toBe(true);
        const others = store.shot.balls.map(({ id }) => id).filter((id) => id !== request.cue_ball);
        announceCall(store, anyCall(request, others, next));
        store.strike({ speed: 1 + 7 * next(), azimuth_deg: 360 * next() }, "aim");
        playShot(store, context, () => undefined);
      }
      expect(store.session.refusal?.message).toBeUndefined();
      expect(store.document.game!.moves).toHaveLength(made + 1);
    }
    const game = store.document.game!;
    const again = progressOf(engine, structuredClone(game));
    expect(again.frame.state).toEqual(standing(store, engine)!.frame.state);
  },
);
