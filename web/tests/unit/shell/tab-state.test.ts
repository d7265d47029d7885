import { describe, expect, test } from "vitest";
import type { Session } from "../../../src/app/document/document.ts";
import type { Game } from "../../../src/app/document/stored-game.ts";
import {
  isPresent,
  type Situation,
  tabOfKey,
  TABS,
  tabsAfter,
  type TabState,
} from "../../../src/app/shell/tab-state.ts";

const GAME = {} as Game;
const ATTEMPT = {} as NonNullable<Session["attempt"]>;

const at = (session: Partial<Situation["session"]> = {}, game: Game | null = null): Situation => ({
  session: { activity: "analyse", mode: "aim", attempt: null, ...session },
  document: { game },
});

const STATE: TabState = { tab: "lines", isFolded: false, earlier: { tab: "aim", isFolded: false } };

const names = (now: Situation) => TABS.filter((tab) => isPresent(tab, now)).map(({ name }) => name);

describe("the tabs that are present", () => {
  test("are those of the activity", () => {
    expect(names(at())).toEqual(["aim", "lines", "tree", "layout", "physics", "whatif"]);
    expect(names(at({ activity: "play" }))).toEqual(["game", "aim"]);
    expect(names(at({ activity: "train" }))).toEqual(["train", "aim"]);
    expect(names(at({ activity: "library" }))).toEqual(["library", "aim"]);
  });

  test("in a replay are those that show something of it", () => {
    expect(names(at({ mode: "replay" }))).toEqual(["state", "aim", "layout", "physics", "whatif"]);
  });

  test("in a game are without its settings", () => {
    expect(names(at({}, GAME))).toEqual(["aim", "lines", "whatif"]);
  });
});

test("keys lead around the present tabs, and other keys nowhere", () => {
  const go = (key: string, from: "aim" | "lines" | "whatif") => tabOfKey(key, from, at({}, GAME));
  expect(go("ArrowRight", "aim")).toBe("lines");
  expect(go("ArrowRight", "whatif")).toBe("aim");
  expect(go("ArrowLeft", "aim")).toBe("whatif");
  expect(go("Home", "whatif")).toBe("aim");
  expect(go("End", "aim")).toBe("whatif");
  expect(go("Enter", "aim")).toBeNull();
});

describe("a replay", () => {
  const replayed = tabsAfter(STATE, at({ mode: "replay" }), at(), true);

  test("shows the state, folded if the panel is a sheet", () => {
    expect(replayed).toMatchObject({ tab: "state", isFolded: true });
    expect(tabsAfter(STATE, at({ mode: "replay" }), at(), false).isFolded).toBe(false);
  });

  test("is followed by the earlier tab, unfolded as it was", () => {
    const after = tabsAfter(replayed, at(), at({ mode: "replay" }), true);
    expect(after).toMatchObject({ tab: "lines", isFolded: false });
  });

  test("is followed by another tab if that was chosen during it", () => {
    const after = tabsAfter({ ...replayed, tab: "whatif" }, at(), at({ mode: "replay" }), true);
    expect(after.tab).toBe("whatif");
  });

  test("is followed by the first tab of an activity that was chosen during it", () => {
    const mode = "replay";
    const other = tabsAfter(replayed, at({ mode, activity: "play" }), at({ mode }), true);
    expect(other.tab).toBe("state");
    const before = at({ mode, activity: "play" });
    expect(tabsAfter(other, at({ activity: "play" }), before, true).tab).toBe("game");
  });
});

describe("another activity", () => {
  const to = (activity: Session["activity"], game: Game | null, isSheet = true) =>
    tabsAfter(
      STATE,
      at({ activity }, game),
      at({ activity: activity === "play" ? "train" : "play" }),
      isSheet,
    );

  test("begins with its first tab", () => {
    expect(to("analyse", null).tab).toBe("aim");
    expect(to("play", null).tab).toBe("game");
    expect(to("train", null).tab).toBe("train");
  });

  test("folds a sheet for analysis and for a game", () => {
    expect(to("analyse", null).isFolded).toBe(true);
    expect(to("play", GAME).isFolded).toBe(true);
    expect(to("play", null).isFolded).toBe(false);
    expect(to("train", null).isFolded).toBe(false);
    expect(to("analyse", null, false).isFolded).toBe(false);
  });
});

test("a game that begins folds a sheet, and its moves do not", () => {
  const activity = "play";
  const begun = tabsAfter(STATE, at({ activity }, GAME), at({ activity }), true);
  expect(begun).toEqual({ ...STATE, isFolded: true });
  const moved = tabsAfter(STATE, at({ activity }, { ...GAME }), at({ activity }, GAME), true);
  expect(moved).toEqual(STATE);
});

describe("an attempt of a drill", () => {
  const activity = "train";
  const [none, some] = [at({ activity }), at({ activity, attempt: ATTEMPT })];

  test("folds a sheet, and its end unfolds it", () => {
    const begun = tabsAfter(STATE, some, none, true);
    expect(begun.isFolded).toBe(true);
    expect(tabsAfter(begun, none, some, true).isFolded).toBe(false);
  });

  test("that ends in a replay leaves the sheet of the replay, and unfolds it afterwards", () => {
    const mode = "replay";
    const state = { ...STATE, isFolded: true, earlier: { tab: "train", isFolded: true } } as const;
    const replayed = at({ activity, mode, attempt: ATTEMPT });
    const ended = tabsAfter(state, at({ activity, mode }), replayed, true);
    expect(ended.isFolded).toBe(true);
    expect(ended.earlier.isFolded).toBe(false);
  });

  test("of the first steps leaves the sheet as it is", () => {
    const [is, was] = [at({ attempt: ATTEMPT }), at()];
    expect(tabsAfter(STATE, is, was, true)).toEqual(STATE);
  });
});
