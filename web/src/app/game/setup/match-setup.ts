/** Race and shot clock in the set-up. */

import type { Engine } from "../../../engine/index.ts";
import { h, uniqueId } from "../../common/dom.ts";
import type { Setup } from "../../document/stored-game.ts";
import { LONGEST_RACE } from "../match/race.ts";
import { t } from "../../words/translate.ts";
import { isForOne } from "../game-words.ts";
import { label, labelled, number, select, whole } from "./setup-controls.ts";

/** Times of the shot clock that can be chosen, s. */
const TIMES = [20, 30, 45, 60] as const;

/** @returns The controls, and what reads them: null if the number of frames is not possible. */
export function mountMatch(engine: Engine): {
  readonly root: HTMLElement;
  readonly read: () => Pick<Setup, "race" | "clock"> | null;
  /** Whether the players lag for the break. */
  readonly lags: () => boolean;
  /** Shows what the rules of a game have. */
  readonly show: (rules: string) => void;
} {
  const frames = number(1, 1);
  frames.max = String(LONGEST_RACE);
  const breaks = select([
    ["alternate", t("race.alternate")],
    ["winner", t("race.winner")],
  ]);
  const clock = select([
    ["", t("clock.none")],
    ...TIMES.map((time): [string, string] => [String(time), t("clock.seconds", { seconds: time })]),
  ]);
  const hint = h("p", { class: "hint", hidden: true }, t("clock.hint"));
  const breaksRow = labelled(t("race.breaks"), breaks);
  const show = (): void => {
    hint.hidden = clock.value === "";
    breaksRow.hidden = !(Number(frames.value) > 1);
  };
  for (const control of [frames, clock]) control.addEventListener("input", show);
  show();
  const lag = h("input", { type: "checkbox", id: uniqueId("lag") });
  const lagRow = h("div", { class: "switch row" }, lag, label(lag, t("lag.label")));
  const root = h(
    "div",
    {},
    labelled(t("race.frames"), frames),
    breaksRow,
    lagRow,
    labelled(t("clock.label"), clock),
    hint,
  );
  const read = () => {
    const to = whole(frames, 1);
    if (to === null || to > LONGEST_RACE) return null;
    const rule = breaks.value === "winner" ? "winner" : "alternate";
    const race = { to, breaks: rule, won: [0, 0], turned: false } as const;
    return { ...(to > 1 && { race }), ...(clock.value !== "" && { clock: Number(clock.value) }) };
  };
  return {
    root,
    read,
    lags: () => lag.checked && !lagRow.hidden,
    show: (rules) => {
      root.hidden = isForOne(engine, rules);
      lagRow.hidden = !engine.gameFacts[rules]!.lag;
    },
  };
}
