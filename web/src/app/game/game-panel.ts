/** The Game tab: the set-up of a game, then its calls and its record of shots. */

import { replay } from "../replay/replay-control.ts";
import type { Engine } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, icon, setText } from "../common/dom.ts";
import { gameName, levelName } from "../common/preset-names.ts";
import { changeUnpressed } from "../common/press.ts";
import { whenShown } from "../common/shown.ts";
import { mountField } from "../form/field.ts";
import { placeBall } from "../document/layout-changes.ts";
import { machineOf } from "../document/stored-game.ts";
import type { Store } from "../document/store.ts";
import { mountCalls } from "./call-controls.ts";
import { mountExplanation } from "./machine/machine-explanation.ts";
import { machineName } from "./machine/machine-levels.ts";
import { canConcede, concede, endGame } from "./game-actions.ts";
import { standing } from "./awaited-turn.ts";
import type { PlayedMove } from "./game-progress.ts";
import { mountCostliest } from "./review/costliest-shots.ts";
import { isShot, replayMove } from "./review/reviewed-shots.ts";
import { chancesAt, mountNotes } from "./recorded/match-notes.ts";
import { handOf } from "./referee.ts";
import { mountSetup } from "./setup/game-setup.ts";
import { countVariations, openStudy } from "./variations.ts";
import { callInWords, isForOne, rulingInWords } from "./game-words.ts";
import { t } from "../words/translate.ts";

/** A line that branches. */
const BRANCH_ICON = "M7 4v16M7 15c0-5 9-3 9-9M13 8l3-3 3 3";

export function mountGame(root: HTMLElement, store: Store, context: Context): void {
  const setup = h("div");
  const table = h("div");
  root.append(setup, table);
  whenShown(root, () => {
    mountSetup(setup, store, context);
  });
  mountHeading(table, store, context.engine);
  const hand = h("section");
  const calls = h("section");
  const reason = h("section");
  const costs = h("section");
  const notes = h("section");
  table.append(notes, hand, calls, costs, reason);
  mountNotes(notes, store, context);
  mountHand(hand, store, context);
  mountCalls(calls, store, context);
  mountCostliest(costs, store, context);
  mountExplanation(reason, store, context);
  mountSheet(table, store, context);

  const show = (): void => {
    setup.hidden = store.document.game !== null;
    table.hidden = !setup.hidden;
  };
  store.subscribe((now, before) => {
    if ((now.document.game === null) === (before.document.game === null)) return;
    const focused = root.contains(document.activeElement);
    show();
    root.scrollTop = 0;
    // The pressed button disappears with its form.
    if (focused) document.getElementById("table")?.focus();
  });
  show();
}

/** The game's name and its players. */
function mountHeading(root: HTMLElement, store: Store, engine: Engine): void {
  const title = h("h2");
  const hint = h("p", { class: "hint" });
  root.append(title, hint);
  store.subscribe(({ document: { game } }) => {
    if (!game) return;
    const { rules, options, from, names, skills } = game.setup;
    const all = names.map((name, k) => {
      const machine = machineOf(game.setup, k === 0 ? 0 : 1);
      const skill = skills[k];
      if (machine !== null) return t("table.player", { name, level: machineName(machine) });
      return skill ? t("table.player", { name, level: levelName(skill) }) : name;
    });
    const players = isForOne(engine, rules) ? all.slice(0, 1) : all;
    setText(title, gameName(rules));
    const [first = "", second] = players;
    const said = second === undefined ? first : t("table.against", { first, second });
    setText(hint, from ? said : t("table.with-rack", { players: said, seed: options.seed ?? 0 }));
  });
}

/** The position of a cue ball in hand as numbers, for users who do not drag it. */
function mountHand(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const hand = () => {
    const progress = standing(store, engine);
    const id = progress && handOf(progress);
    return store.shot.balls.find((ball) => ball.id === id);
  };
  const bounds = () => standing(store, engine)?.frame.handBounds;
  root.append(h("h2", {}, t("table.in-hand")), h("p", { class: "hint" }, t("table.in-hand-hint")));
  for (const [label, index] of [
    [t("layout.across"), 0],
    [t("layout.along"), 1],
  ] as const) {
    mountField(root, store, context, {
      label,
      unit: "m",
      spoken: t("unit.metres"),
      digits: 4,
      step: 0.001,
      slider: {
        min: () => bounds()?.[0][index] ?? 0,
        max: () => bounds()?.[1][index] ?? 1,
      },
      read: () => hand()?.position[index] ?? 0,
      write: (value, group) => {
        const ball = hand();
        if (!ball) return false;
        const [x, y] = ball.position;
        return placeBall(store, ball.id, index === 0 ? [value, y] : [x, value], group);
      },
    });
  }
  const show = (): void => {
    root.hidden = hand() === undefined;
  };
  store.subscribe(show);
  show();
}

/** The record: every move with its ruling, the last one first. */
function mountSheet(root: HTMLElement, store: Store, context: Context): void {
  const list = h("ol", { class: "record", reversed: true });
  const watch = h("button", { type: "button", class: "button" }, t("table.watch"));
  watch.addEventListener("click", () => {
    const trace = standing(store, context.engine)?.trace;
    if (!trace) return;
    const still = context.reducedMotion();
    replay(store, trace, still ? trace.duration : 0, !still);
  });
  const end = h("button", { type: "button", class: "button" }, t("table.end"));
  end.addEventListener("click", () => endGame(store));
  const give = h("button", { type: "button", class: "button" }, t("table.concede"));
  give.addEventListener("click", () => concede(store, context));
  const heading = h("h2", {}, t("table.shots"));
  const replayButton = (index: number) =>
    h(
      "button",
      {
        type: "button",
        class: "button plain again",
        "aria-label": t("review.replay", { number: index + 1 }),
        title: t("review.replay", { number: index + 1 }),
        onclick: () => replayMove(store, context.engine, index, context.reducedMotion()),
      },
      icon("M8 5.5v13l10-6.5z"),
    );
  const studyButton = (index: number) =>
    h(
      "button",
      {
        type: "button",
        class: "button plain again",
        "aria-label": t("study.open-move", { number: index + 1 }),
        title: t("study.open-move", { number: index + 1 }),
        onclick: () => void openStudy(store, context.engine, index),
      },
      icon(BRANCH_ICON),
    );
  root.append(heading, list, h("div", { class: "row" }, watch, give, end));

  const show = (): void => {
    const { game } = store.document;
    const progress = standing(store, context.engine);
    if (!game || !progress || store.session.mode === "replay") return;
    heading.hidden = list.hidden = progress.steps.length === 0;
    watch.hidden = progress.trace === null;
    give.hidden = !canConcede(store, context.engine);
    const items = progress.steps.map((step, index) =>
      h(
        "li",
        { "data-foul": String(!step.ruling.legal) },
        rulingInWords(step, game.setup.names),
        called(step),
        isShot(step) && replayButton(index),
        isShot(step) && studyButton(index),
        tried(game.variations?.[index]),
        chancesAt(game, index),
      ),
    );
    changeUnpressed(list, () => list.replaceChildren(...items.reverse()));
  };
  store.subscribe((now, before) => {
    const isSame =
      now.document.game === before.document.game &&
      now.session.mode === before.session.mode &&
      now.session.orientation === before.session.orientation;
    if (!isSame) show();
  });
  show();
}

/** How many variations a shot has. */
function tried(text: string | undefined): HTMLElement | false {
  const count = countVariations(text);
  return count > 0 && h("span", { class: "hint" }, t("study.count", { count }));
}

/** The called ball and pocket, or the nominated ball. The ruling mentions other calls. */
function called({ move }: PlayedMove): HTMLElement | false {
  const call = "play" in move ? move.play.call : undefined;
  if (call?.kind !== "pocket" && call?.kind !== "on") return false;
  return h("span", { class: "hint" }, t("table.called", { call: callInWords(call) }));
}
