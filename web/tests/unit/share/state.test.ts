import { describe, expect, test } from "vitest";
import type { ShotFile } from "../../../src/engine/types.ts";
import { FIRST_SESSION, FIRST_VIEW } from "../../../src/app/document.ts";
import type { State } from "../../../src/app/store.ts";
import { LinkError, toFragment } from "../../../src/app/share/link.ts";
import { stateFromFragment, stateToFragment } from "../../../src/app/share/state.ts";
import { olympiad } from "../../../src/app/whatif/noise.ts";

const strike = { ball: "cue", speed: 2, azimuth_deg: 90 };
const shot = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [{ id: "cue", position: [0.5, 1] }],
  strike,
} satisfies ShotFile;

const state: State = {
  document: { shot, noise: null, seed: 0 },
  view: FIRST_VIEW,
  session: FIRST_SESSION,
};

describe("the state in a link", () => {
  test("is the shot alone where all else is as at first", () => {
    expect(stateToFragment(shot, state)).toBe(toFragment({ shot }));
    expect(stateFromFragment(stateToFragment(shot, state))).toStrictEqual({
      shot,
      noise: null,
      seed: 0,
      view: FIRST_VIEW,
      time: null,
    });
  });

  test("brings back noise, seed, view and the instant of the replay", () => {
    const noise = olympiad(1);
    const view = { theme: "dark", camera: "cue", units: "mph" } as const;
    const full: State = {
      document: { shot, noise, seed: 12345 },
      view,
      session: { ...FIRST_SESSION, mode: "replay", time: 1.234567890123456 },
    };
    expect(stateFromFragment(stateToFragment(shot, full))).toStrictEqual({
      shot,
      noise,
      seed: 12345,
      view,
      time: 1.234567890123456,
    });
  });

  test("is no link where the fragment is another's", () => {
    expect(stateFromFragment("")).toBeNull();
    expect(stateFromFragment("#help")).toBeNull();
  });

  test("without a shot, or with a noise that is none, is refused", () => {
    for (const data of [null, 3, [], {}, { shot: [] }]) {
      expect(() => stateFromFragment(toFragment(data))).toThrow(/no shot/);
    }
    for (const speed of [-1, "fast", undefined]) {
      const noise = { ...olympiad(1), speed };
      expect(() => stateFromFragment(toFragment({ shot, noise }))).toThrow(LinkError);
      expect(() => stateFromFragment(toFragment({ shot, noise }))).toThrow(/"speed"/);
    }
  });

  test("takes a view, a seed or a time that it does not know for the first one", () => {
    const odd = { shot, view: { theme: "pink", camera: "top", units: 7 }, seed: -3, time: "soon" };
    const read = stateFromFragment(toFragment(odd));
    expect(read?.view).toStrictEqual(FIRST_VIEW);
    expect(read?.seed).toBe(0);
    expect(read?.time).toBeNull();
  });
});
