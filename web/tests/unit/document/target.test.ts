/** The struck ball keeps its target when it is moved. */

import { describe, expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import type { AimedShot } from "../../../src/app/document/document.ts";
import { documentOf } from "../../../src/app/document/shot-file.ts";
import { placeBall } from "../../../src/app/document/layout-changes.ts";
import { Store } from "../../../src/app/document/store.ts";
import { targetOf } from "../../../src/app/document/target.ts";

const engine = await load();

const SHOT: AimedShot = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.635, 0.6] },
    { id: "1", position: [0.635, 1.9] },
    { id: "2", position: [0.3, 1.2] },
  ],
  strike: { ball: "cue", speed: 2, azimuth_deg: 89 },
};

const storeOf = (shot: AimedShot) =>
  new Store({ shot: (file) => engine.shot(file) }, documentOf(shot));

const first = (store: Store) => store.ghost.trace!.outcome.first_contact;

describe("the struck ball that is moved", () => {
  test("meets the same ball as full as before", () => {
    // Seen: it kept its direction, so that a break from the side missed everything at 8 m/s.
    const store = storeOf(SHOT);
    const before = targetOf(store)!;
    expect(before.ball).toBe("1");
    expect(placeBall(store, "cue", [0.2, 0.4], null)).toBe(true);
    expect(first(store)).toBe("1");
    expect(targetOf(store)!.offset).toBeCloseTo(before.offset, 5);
  });

  test("keeps its direction if it is aimed at no ball", () => {
    const store = storeOf({ ...SHOT, strike: { ...SHOT.strike, azimuth_deg: 180 } });
    placeBall(store, "cue", [0.2, 0.4], null);
    expect(store.document.shot.strike.azimuth_deg).toBe(180);
  });

  test("keeps the target of the drag's start while another ball is in the way", () => {
    const store = storeOf(SHOT);
    const target = targetOf(store);
    placeBall(store, "cue", [0.1, 0.75], "drag", { target });
    expect(first(store)).toBe("2");
    placeBall(store, "cue", [0.9, 0.6], "drag", { target });
    expect(first(store)).toBe("1");
  });

  test("points at the ball of a pot whose line is lost", () => {
    const store = storeOf(SHOT);
    const aim = store.shot.potAim("1", "top-right")!;
    store.takeAim("1", "top-right", aim, "aim");
    placeBall(store, "cue", [1.2, 2.3], null);
    const { lock } = store.session;
    if (lock?.solved === false) expect(first(store)).toBe("1");
    else expect(lock?.ball).toBe("1");
  });

  test("leaves the aim alone when another ball is moved", () => {
    const store = storeOf(SHOT);
    placeBall(store, "2", [0.4, 1.2], null);
    expect(store.document.shot.strike.azimuth_deg).toBe(89);
  });
});
