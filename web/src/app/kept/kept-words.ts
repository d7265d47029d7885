/** The sentences about works and games that the page keeps. */

import type { Engine } from "../../engine/index.ts";
import { gameName } from "../common/preset-names.ts";
import type { Game } from "../document/stored-game.ts";
import { framesWon } from "../game/match/race.ts";
import { isForOne, other } from "../game/game-words.ts";
import { drillOf } from "../train/drills/index.ts";
import { drillName } from "../train/train-words.ts";
import { t } from "../words/translate.ts";
import type { FinishedGame } from "./finished-game.ts";
import type { Work } from "./kept-work.ts";

export function workText(engine: Engine, { steps: { steps, at }, practice }: Work): string {
  const { shot, game, study } = steps[at]!.state;
  if (practice) {
    const { running } = practice.kept;
    if (running.puzzle) return t("puzzle.title");
    const attempts = drillOf(running.drill)?.attempts ?? running.points.length;
    return t("kept.drill", {
      name: running.own?.name ?? drillName({ id: running.drill }),
      done: running.points.length,
      attempts,
    });
  }
  if (study) return t("kept.study", { number: study.move + 1, game: gameText(engine, study.game) });
  if (game) return gameText(engine, game);
  return t("kept.analysis", { balls: t("kept.balls", { count: shot.balls.length }) });
}

/** A game that goes on: its name, its players and how far it is. */
function gameText(engine: Engine, { setup, moves }: Game): string {
  const [first, second] = setup.names;
  const players = isForOne(engine, setup.rules) ? first : t("kept.against", { first, second });
  const count = moves.filter((move) => "play" in move).length;
  return t("kept.game", {
    game: gameName(setup.rules),
    players,
    shots: t("kept.shots", { count }),
  });
}

/** A game that has ended: who played, and the result. */
export function resultText(
  engine: Engine,
  { game: { setup }, winner, scores }: FinishedGame,
): string {
  const { rules, names, race } = setup;
  const game = gameName(rules);
  if (isForOne(engine, rules)) return t("kept.alone", { game, name: names[0], points: scores[0] });
  const hasPoints = engine.gameFacts[rules]?.scoring !== "last-ball";
  const shown = race ? framesWon(race, winner) : hasPoints ? scores : null;
  if (shown) {
    const [a, b] = race?.turned ? ([1, 0] as const) : ([0, 1] as const);
    return t("kept.result", { game, first: names[a], a: shown[a], b: shown[b], second: names[b] });
  }
  if (winner === null) return t("kept.drawn", { game, first: names[0], second: names[1] });
  return t("kept.won", { game, winner: names[winner], loser: names[other(winner)] });
}
