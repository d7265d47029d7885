/** Below the table during a game: the score, whose turn it is, the last ruling, and choices. */

import "./game.css";
import type { Engine, FrameState, GameFacts, Seat } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { focusWhileScrolling, h, setText } from "../common/dom.ts";
import { gameName } from "../common/preset-names.ts";
import { leave } from "../replay/replay-control.ts";
import type { State, Store } from "../document/store.ts";
import type { Game, Setup } from "../document/stored-game.ts";
import { presentCall } from "./calling.ts";
import { mountMachine } from "./machine/thinking-sign.ts";
import { mountClock } from "./match/shot-clock.ts";
import { framesWon, raceWinner } from "./match/race.ts";
import { mountTray } from "./match/pocketed-tray.ts";
import { choose, startNext } from "./game-actions.ts";
import { progressOf } from "./game-progress.ts";
import { replayedMove } from "./review/reviewed-shots.ts";
import { mountStep } from "./review/review-step.ts";
import { isPerson, standing } from "./awaited-turn.ts";
import { closeStudy } from "./variations.ts";
import {
  choiceInWords,
  isForOne,
  headline,
  other,
  refereeText,
  requestInWords,
  rulingInWords,
} from "./game-words.ts";
import { capital, sentence, t } from "../words/translate.ts";

/** Time (ms) between the end of a replayed shot and the next request. */
const REST = 700;

export function mountBar(root: HTMLElement, store: Store, context: Context): void {
  const bar = new GameBar(root, store, context);
  store.subscribe((now, before) => {
    bar.follow(now, before);
    if (now.session !== before.session) bar.followReplay(now, before);
  });
  bar.show();
}

class GameBar {
  readonly #root: HTMLElement;
  readonly #store: Store;
  readonly #context: Context;
  readonly #score = h("p", { class: "score" });
  readonly #title = h("strong");
  readonly #asked = h("span");
  readonly #ruling = h("p", { class: "ruling" });
  readonly #said = h(
    "div",
    { role: "status", "aria-live": "polite" },
    this.#ruling,
    h("p", { class: "asked" }, this.#title, " ", this.#asked),
  );
  readonly #answers = h("div", { class: "row answers", hidden: true });
  #resting: ReturnType<typeof setTimeout> | undefined;

  constructor(root: HTMLElement, store: Store, context: Context) {
    this.#root = root;
    this.#store = store;
    this.#context = context;
    const machine = h("div", { class: "row machine" });
    const step = h("div", { class: "row step" });
    const study = h("div", { class: "row study", hidden: true });
    const clock = h("div", { class: "shot-clock" });
    root.append(this.#score, this.#said, this.#answers, step, machine, study, clock);
    mountStudy(study, store, context);
    focusWhileScrolling(root, this.#score, this.#said, this.#answers);
    mountStep(step, store, context);
    mountClock(clock, store, context);
    mountTray(document.getElementById("stage")!, store, context);
    mountMachine(machine, store, context);
  }

  show(): void {
    const { game, study } = this.#store.document;
    const { engine } = this.#context;
    this.#root.hidden = game === null && !study;
    this.#score.hidden = this.#said.hidden = game === null;
    if (game === null) this.#answers.hidden = true;
    const progress = standing(this.#store, engine);
    if (!game || !progress) return;
    const watching = this.#store.session.mode === "replay";
    // The bar must not reveal the outcome while the shot is replayed.
    const shown = watching ? replayedMove(this.#store, engine) : null;
    const state = shown === null ? progress.frame.state : progress.steps[shown]!.before;
    showScore(this.#score, engine, game, state);
    const last = watching ? undefined : progress.steps.at(-1);
    this.#showRequest(game, state, last ? rulingInWords(last, game.setup.names) : "");
    this.#ruling.dataset.foul = String(last?.ruling.legal === false);
    this.#showAnswers(watching ? null : state, game);
  }

  /** @param ruling The last ruling; empty while a shot is replayed. */
  #showRequest({ setup, here }: Game, state: FrameState, ruling: string): void {
    const { request } = state;
    const isQuiet = this.#store.session.mode === "replay" || request.kind === "over";
    const isKnown = request.kind === "choice" && ruling.includes(refereeText(request.why));
    setText(this.#ruling, ruling);
    setText(this.#title, isQuiet ? "" : sentence(headline(request, setup.names, here)));
    const call = () => presentCall(this.#store, this.#context.engine);
    setText(this.#asked, isQuiet || isKnown ? "" : requestInWords(state, call()));
  }

  #showAnswers(state: FrameState | null, game: Game): void {
    const row = this.#answers;
    const buttons = state ? this.#buttons(state, game) : [];
    const texts = (all: Iterable<Element>) => [...all].map((button) => button.textContent).join();
    if (texts(row.children) === texts(buttons)) return;
    // The pressed button disappears; its focus moves to the table, where the game continues.
    if (row.contains(document.activeElement)) document.getElementById("table")?.focus();
    row.replaceChildren(...buttons);
    row.hidden = buttons.length === 0;
  }

  #buttons({ request }: FrameState, { setup }: Game): HTMLElement[] {
    if (request.kind === "choice" && isPerson(this.#store, request.player)) {
      const opponent = setup.names[other(request.player)];
      return request.choices.map((choice) => {
        const label = capital(choiceInWords(choice, opponent));
        return answer(label, () => choose(this.#store, this.#context, choice));
      });
    }
    if (request.kind !== "over") return [];
    const { race } = setup;
    const { winner } = request;
    const isEnd = race && raceWinner(race, winner) !== null;
    const label = !race ? t("table.another") : t(isEnd ? "race.another" : "race.next");
    return [answer(label, () => startNext(this.#store, this.#context, winner))];
  }

  follow({ session, document: now }: State, before: State): void {
    const isOther =
      session.mode !== before.session.mode ||
      session.replay.trace !== before.session.replay.trace ||
      now.game !== before.document.game ||
      now.study !== before.document.study;
    if (isOther) this.show();
    // The call follows the aim.
    else if (
      now.game &&
      (now.shot !== before.document.shot || session.orientation !== before.session.orientation)
    ) {
      this.#context.loop.input(this.#root, () => this.show());
    }
  }

  /** Leaves the replay of the last shot some time after its end. */
  followReplay({ session, document: now }: State, before: State): void {
    clearTimeout(this.#resting);
    const { trace, playing, time } = session.replay;
    const ended = trace && before.session.replay.playing && !playing && time >= trace.duration;
    // After an older shot the replay stays, for a step to another one.
    const isLast = trace === standing(this.#store, this.#context.engine)?.trace;
    if (now.game && ended && isLast) this.#resting = setTimeout(() => leave(this.#store), REST);
  }
}

/** While a shot of a game is analysed: which one it is, and the way back. */
function mountStudy(root: HTMLElement, store: Store, { engine }: Context): void {
  const text = h("span");
  const back = answer(t("study.close"), () => closeStudy(store, engine));
  back.id = "close-study";
  root.append(text, back);
  const show = (): void => {
    const { study } = store.document;
    root.hidden = !study;
    const step = study && progressOf(engine, study.game).steps[study.move];
    if (!study || !step) return;
    const name = study.game.setup.names[step.player];
    setText(text, t("study.of", { number: study.move + 1, name }));
  };
  store.subscribe((now, before) => {
    if (now.document.study !== before.document.study) show();
  });
  show();
}

function answer(text: string, onclick: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "button primary", onclick }, text);
}

function showScore(root: HTMLElement, engine: Engine, { setup }: Game, state: FrameState): void {
  const { request } = state;
  const active = request.kind === "over" ? request.winner : request.player;
  const side = (player: 0 | 1) =>
    h(
      "span",
      { class: "side", "data-active": String(active === player) },
      h("span", { class: "name" }, setup.names[player]),
      ...extras(state, player),
    );
  const order = setup.race?.turned ? ([1, 0] as const) : ([0, 1] as const);
  const text = pointsText(setup, state, engine.gameFacts[state.game], order);
  // A dash would read as a score: "Player 1 – Machine 2".
  const points =
    text === ""
      ? h("span", { class: "hint versus" }, t("table.versus"))
      : h("span", { class: "points" }, text);
  const [first, second] = [side(order[0]), side(order[1])];
  const players = isForOne(engine, state.game) ? [side(0), points] : [first, points, second];
  const { race } = setup;
  const about = race
    ? t("race.to", { game: gameName(state.game), count: race.to })
    : gameName(state.game);
  root.replaceChildren(...players, h("span", { class: "hint push" }, about));
}

/** Frames of a race, points of a frame, or both; empty for a single frame without points. */
function pointsText(
  { race }: Setup,
  { scores, request }: FrameState,
  facts: GameFacts | undefined,
  [first, second]: readonly [Seat, Seat],
): string {
  const points = `${scores[first]} : ${scores[second]}`;
  if (facts?.players === 1) return `${scores[0]}`;
  const hasPoints = facts?.scoring !== "last-ball";
  if (!race) return hasPoints ? points : "";
  const won = framesWon(race, request.kind === "over" ? request.winner : null);
  const frames = `${won[first]} : ${won[second]}`;
  return hasPoints ? `${frames} (${points})` : frames;
}

/** A player's group, innings and fouls. */
function extras({ state, fouls_in_a_row: fouls }: FrameState, player: 0 | 1): HTMLElement[] {
  const said: string[] = [];
  const group = state.groups?.[player];
  if (group) said.push(t(`table.${group}`));
  const innings = state.innings?.[player];
  if (innings !== undefined) said.push(t("table.innings", { count: innings }));
  if (fouls[player] > 1) said.push(t("table.fouls", { count: fouls[player] }));
  return said.map((text) => h("span", { class: "hint" }, text));
}
