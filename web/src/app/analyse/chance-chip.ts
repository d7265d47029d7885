/**
 * The chip beside Shoot: the chance that the present aim makes its pot, or in a game keeps the turn, with
 * the errors of the chosen level. The number stays, dimmed, until the new one comes.
 */

import type { Play, PocketName } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, setText } from "../common/dom.ts";
import { levelName } from "../common/preset-names.ts";
import { playedName, pocketName } from "../common/shot-words.ts";
import type { State, Store } from "../document/store.ts";
import { presentCall } from "../game/calling.ts";
import { standing } from "../game/awaited-turn.ts";
import { isForOne } from "../game/game-words.ts";
import { presetOf, presetsOf } from "../whatif/noise-presets.ts";
import { Desk } from "./desk/desk-client.ts";
import type { ChanceJob } from "./desk/desk-protocol.ts";
import DeskWorker from "./desk/desk-worker.ts?worker&inline";
import { noiseOf } from "./analysed-position.ts";
import { percent } from "./analyse-words.ts";
import { inSentence, t } from "../words/translate.ts";

/** Variants that are counted: the standard error of a chance of one half is then 2 %. */
const COUNT = 600;

/** @param open Shows the tab What if. */
export function mountChip(
  button: HTMLElement,
  store: Store,
  context: Context,
  open: () => void,
): void {
  const { engine } = context;
  const value = h("b");
  const level = h("span");
  const chip = h(
    "button",
    { type: "button", class: "chance-chip", id: "chance-chip", onclick: open },
    value,
    " ",
    level,
  );
  button.before(chip);
  const known = presetsOf(engine);
  const desk = new Desk(() => new DeskWorker(), engine);

  function ask(): void {
    const question = store.session.mode === "aim" ? questionOf(store, context) : null;
    chip.hidden = store.session.activity !== "analyse";
    chip.dataset.empty = String(question === null);
    chip.disabled = question === null;
    if (!question) {
      desk.cancel();
      return;
    }
    chip.dataset.stale = "true";
    const { noise } = store.document;
    const name = noise
      ? (presetOf(noise, known)?.name ?? t("chip.own"))
      : levelName(store.session.analysis.level);
    desk.ask(question.job, {
      part: ({ met, count }) => {
        if (count < COUNT) return;
        const share = percent(met / count);
        setText(value, share);
        setText(level, inSentence(name));
        chip.setAttribute("aria-label", question.said(share, inSentence(name)));
        chip.title = chip.ariaLabel ?? "";
        delete chip.dataset.stale;
      },
      refused: () => (chip.dataset.empty = "true"),
    });
  }

  store.subscribe((now, before) => {
    if (matters(now, before)) context.loop.input(chip, ask);
  });
  ask();
}

function matters(now: State, before: State): boolean {
  return (
    now.document !== before.document ||
    now.session.mode !== before.session.mode ||
    now.session.activity !== before.session.activity ||
    now.session.analysis.level !== before.session.analysis.level ||
    now.session.orientation !== before.session.orientation ||
    now.session.lock !== before.session.lock
  );
}

interface Question {
  readonly job: ChanceJob;
  /** The answer in a sentence. */
  readonly said: (chance: string, level: string) => string;
}

/** What is asked about the present aim; null if it pots nothing. */
function questionOf(store: Store, { engine }: Context): Question | null {
  // In a game that is played, the chance would be advice.
  if (store.session.activity !== "analyse") return null;
  const noise = noiseOf(engine, store.state);
  const job = (of: ChanceJob["of"]): ChanceJob => ({ kind: "chance", noise, count: COUNT, of });
  // A single player keeps the turn with every shot: there the pot counts.
  const { game } = store.document;
  if (game && !isForOne(engine, game.setup.rules)) {
    const progress = standing(store, engine)!;
    const play = playOf(store, { engine });
    if (!play) return null;
    const { record } = progress.frame;
    return {
      job: job({ record, play }),
      said: (chance, level) => t("chip.keeps", { chance, level }),
    };
  }
  const pot = potOf(store);
  if (!pot) return null;
  const names = { ball: playedName(pot.ball), pocket: pocketName(pot.pocket) };
  return {
    job: job({ shot: store.shot.json(), ...pot }),
    said: (chance, level) => t("chip.pots", { chance, level, ...names }),
  };
}

/** The pot at which the cue is aimed, or else the first that the shot makes. */
export function potOf(store: Store): { readonly ball: string; readonly pocket: PocketName } | null {
  const { lock } = store.session;
  if (lock?.solved) return { ball: lock.ball, pocket: lock.pocket };
  const { ball: struck } = store.document.shot.strike;
  const [ball, pocket] =
    store.ghost.trace?.outcome.pocketed.find(([id]) => id !== struck) ?? ([] as const);
  return ball === undefined || pocket === undefined ? null : { ball, pocket };
}

/** The aimed shot as a play of the game; null if it needs a call and nothing can be called. */
function playOf(store: Store, { engine }: Pick<Context, "engine">): Play | null {
  const request = standing(store, engine)?.frame.state.request;
  const { strike, balls, struck } = store.shot;
  if (request?.kind !== "shot" || !strike || struck === null) return null;
  const call = presentCall(store, engine) ?? undefined;
  if (!call && !request.calls.includes("nothing")) return null;
  const [x, y] = balls[struck]!.position;
  return {
    strike,
    ...(request.in_hand !== null && { cue_ball: [x, y] as const }),
    ...(call && { call }),
  };
}
