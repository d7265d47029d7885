/** Games for the tests. */

import { load } from "../../../src/engine/index.ts";
import type { Context } from "../../../src/app/common/context.ts";
import { documentOf } from "../../../src/app/document/shot-file.ts";
import type { Setup } from "../../../src/app/document/stored-game.ts";
import { Store } from "../../../src/app/document/store.ts";
import { startGame } from "../../../src/app/game/game-actions.ts";
import { referee } from "../../../src/app/game/referee.ts";

export const engine = await load();

/** What the page has announced. */
export const said: string[] = [];

export const context = {
  engine,
  announce: (text: string) => said.push(text),
} as unknown as Context;

export const SHOT = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [{ id: "cue", position: [0.5, 0.6] }],
  strike: { ball: "cue", speed: 2, azimuth_deg: 80 },
} as const;

export function setup(rules: string, more: Partial<Setup> = {}): Setup {
  return {
    rules,
    options: { seed: 7 },
    from: null,
    names: ["Ann", "Bea"],
    skills: [null, null],
    ...more,
  };
}

/** A page on which a game has begun. */
export function begun(rules: string, more: Partial<Setup> = {}): Store {
  const store = new Store(referee(engine), documentOf(SHOT));
  if (!startGame(store, context, setup(rules, more))) {
    throw new Error(store.session.refusal?.message ?? "the game does not start");
  }
  return store;
}
