/** Below the table during a game: the score, whose turn it is, the last ruling, and choices. */

import "./game.css";
import type { Engine, FrameState, GameFacts, Seat } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { focusWhileScrolling, h, setText } from "../common/dom.ts";
import { gameName } from "../common/preset-names.ts";
import { leave } from "../replay/replay-control.ts";
import type { Store } from "../document/store.ts";
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
  const { engine } = context;
  const score = h("p", { class: "score" });
  const title = h("strong");
  const asked = h("span");
  const ruling = h("p", { class: "ruling" });
  const said = h("div", { role: "status", "aria-live": "polite" }, ruling);
  said.append(h("p", { class: "asked" }, title, " ", asked));
  const answers = h("div", { class: "row answers", hidden: true });
  const machine = h("div", { class: "row machine" });
  const step = h("div", { class: "row step" });
  const study = h("div", { class: "row study", hidden: true });
  root.append(score, said, answers, step, machine, study);
  mountStudy(study, store, context);
  focusWhileScrolling(root, score, said, answers);
  mountStep(step, store, context);
  const clock = h("div", { class: "shot-clock" });
  root.append(clock);
  mountClock(clock, store, context);
  mountTray(document.getElementById("stage")!, store, context);
  mountMachine(machine, store, context);

  function show(): void {
    const { game } = store.document;
    root.hidden = game === null && !store.document.study;
    score.hidden = said.hidden = game === null;
    if (game === null) answers.hidden = true;
    const progress = standing(store, engine);
    if (!game || !progress) return;
    const watching = store.session.mode === "replay";
    const last = progress.steps.at(-1);
    // The bar must not reveal the outcome while the shot is replayed.
    const shown = watching ? replayedMove(store, engine) : null;
    const state = shown === null ? progress.frame.state : progress.steps[shown]!.before;
    const { names } = game.setup;
    showScore(score, engine, game, state);
    const rulingText = watching || !last ? "" : rulingInWords(last, names);
    const { request } = state;
    const over = request.kind === "over";
    const known = request.kind === "choice" && rulingText.includes(refereeText(request.why));
    setText(ruling, rulingText);
    ruling.dataset.foul = String(!watching && last?.ruling.legal === false);
    setText(title, watching || over ? "" : sentence(headline(request, names, game.here)));
    setText(
      asked,
      watching || over || known ? "" : requestInWords(state, presentCall(store, engine)),
    );
    showAnswers(answers, watching ? null : state, game);
  }

  function showAnswers(row: HTMLElement, state: FrameState | null, game: Game): void {
    const request = state?.request;
    const buttons: HTMLElement[] = [];
    if (request?.kind === "choice" && isPerson(store, request.player)) {
      const opponent = game.setup.names[other(request.player)];
      for (const choice of request.choices) {
        const label = capital(choiceInWords(choice, opponent));
        buttons.push(answer(label, () => choose(store, context, choice)));
      }
    } else if (request?.kind === "over") {
      const { race } = game.setup;
      const { winner } = request;
      const isEnd = race && raceWinner(race, winner) !== null;
      const label = !race ? t("table.another") : t(isEnd ? "race.another" : "race.next");
      buttons.push(answer(label, () => startNext(store, context, winner)));
    }
    const texts = (all: Iterable<Element>) => [...all].map((button) => button.textContent).join();
    if (texts(row.children) === texts(buttons)) return;
    // The pressed button disappears; its focus moves to the table, where the game continues.
    if (row.contains(document.activeElement)) document.getElementById("table")?.focus();
    row.replaceChildren(...buttons);
    row.hidden = buttons.length === 0;
  }

  let resting: ReturnType<typeof setTimeout> | undefined;
  store.subscribe((now, before) => {
    const { session, document } = now;
    const isOther =
      session.mode !== before.session.mode || session.replay.trace !== before.session.replay.trace;
    const isOtherGame =
      document.game !== before.document.game || document.study !== before.document.study;
    if (isOtherGame || isOther) show();
    // The call follows the aim.
    else if (
      document.game &&
      (document.shot !== before.document.shot || session.orientation !== before.session.orientation)
    ) {
      context.loop.input(root, show);
    }
    if (session === before.session) return;
    clearTimeout(resting);
    const { trace, playing, time } = session.replay;
    const ended = trace && before.session.replay.playing && !playing && time >= trace.duration;
    // After an older shot the replay stays, for a step to another one.
    const isLast = trace === standing(store, engine)?.trace;
    if (document.game && ended && isLast) resting = setTimeout(() => leave(store), REST);
  });
  show();
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
      ? h("span", { class: "hint" }, t("table.versus"))
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
