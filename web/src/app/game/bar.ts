/** Below the table during a game: the score, whose turn it is, the last ruling, and choices. */

import "./game.css";
import type { FrameState } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { h, setText } from "../common/dom.ts";
import { gameName } from "../common/presets.ts";
import { leave } from "../replay/control.ts";
import type { Store } from "../document/store.ts";
import type { Game } from "../document/game.ts";
import { choose, standing, startGame } from "./play.ts";
import {
  choiceInWords,
  isForOne,
  headline,
  other,
  refereeText,
  requestInWords,
  rulingInWords,
} from "./words.ts";
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
  root.append(score, said, answers);

  function show(): void {
    const { game } = store.document;
    root.hidden = game === null;
    const progress = standing(store, engine);
    if (!game || !progress) return;
    const watching = store.session.mode === "replay";
    const last = progress.steps.at(-1);
    // The bar must not reveal the outcome while the shot is replayed.
    const state = watching && last && "play" in last.move ? last.before : progress.frame.state;
    const { names } = game.setup;
    showScore(score, game, state);
    const rulingText = watching || !last ? "" : rulingInWords(last, names);
    const { request } = state;
    const over = request.kind === "over";
    const known = request.kind === "choice" && rulingText.includes(refereeText(request.why));
    setText(ruling, rulingText);
    ruling.dataset.foul = String(!watching && last?.ruling.legal === false);
    setText(title, watching || over ? "" : sentence(headline(request, names)));
    setText(asked, watching || over || known ? "" : requestInWords(state, game.call));
    showAnswers(answers, watching ? null : state, game);
  }

  function showAnswers(row: HTMLElement, state: FrameState | null, game: Game): void {
    const request = state?.request;
    const buttons: HTMLElement[] = [];
    if (request?.kind === "choice") {
      const opponent = game.setup.names[other(request.player)];
      for (const choice of request.choices) {
        const label = capital(choiceInWords(choice, opponent));
        buttons.push(answer(label, () => choose(store, context, choice)));
      }
    } else if (request?.kind === "over") {
      const seed = (game.setup.options.seed ?? 0) + 1;
      const setup = { ...game.setup, from: null, options: { ...game.setup.options, seed } };
      buttons.push(answer(t("table.another"), () => startGame(store, context, setup)));
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
    if (document.game !== before.document.game || session.mode !== before.session.mode) show();
    if (session === before.session) return;
    clearTimeout(resting);
    const { trace, playing, time } = session;
    const ended = trace && before.session.playing && !playing && time >= trace.duration;
    if (document.game && ended) resting = setTimeout(() => leave(store), REST);
  });
  show();
}

function answer(text: string, onclick: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "button primary", onclick }, text);
}

function showScore(root: HTMLElement, { setup }: Game, state: FrameState): void {
  const { request, scores } = state;
  const active = request.kind === "over" ? request.winner : request.player;
  const side = (player: 0 | 1) =>
    h(
      "span",
      { class: "side", "data-active": String(active === player) },
      h("span", { class: "name" }, setup.names[player]),
      ...extras(state, player),
    );
  const points = WITH_POINTS.has(state.game)
    ? h("span", { class: "points" }, isForOne(state.game) ? `${scores[0]}` : scores.join(" : "))
    : h("span", { class: "points" }, "–");
  const players = isForOne(state.game) ? [side(0), points] : [side(0), points, side(1)];
  root.replaceChildren(...players, h("span", { class: "hint push" }, gameName(state.game)));
}

/** Games that count points. */
const WITH_POINTS = new Set(["straight-pool", "snooker", "three-cushion", "practice"]);

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
