/** Requests and rulings of the referee as sentences. */

import type {
  Call,
  CaromCount,
  Choice,
  Engine,
  FrameState,
  Seat,
  Request,
  Ruling,
} from "../../engine/index.ts";
import { playedName, playedNames, pocketName } from "../common/shot-words.ts";
import type { Pair } from "../document/stored-game.ts";
import type { PlayedMove } from "./game-progress.ts";
import { keyOf, list, paragraph, type PlainKey, sentence, t } from "../words/translate.ts";

/** Up to this many balls are listed by name. */
const LISTED = 3;

const GROUPS = ["solids", "stripes"] as const;

export function other(player: Seat): Seat {
  return player === 0 ? 1 : 0;
}

/** Whether the game has one player only. */
export function isForOne({ gameFacts }: Pick<Engine, "gameFacts">, rules: string): boolean {
  return gameFacts[rules]?.players === 1;
}

/** Whose turn it is, or who won. @param here The player at this page, if the other one is a friend. */
export function headline(request: Request, names: Pair<string>, here?: Seat): string {
  if (request.kind !== "over" && request.player === here) {
    return t("friend.yours", { name: names[here] });
  }
  switch (request.kind) {
    case "shot":
      return t("turn.shoots", { name: names[request.player] });
    case "choice":
      return t("turn.decides", { name: names[request.player] });
    case "over":
      return request.winner === null
        ? t("turn.drawn")
        : t("turn.wins", { name: names[request.winner] });
  }
}

/** A request as sentences, with the present call. */
export function requestInWords(frame: FrameState, call: Call | null = null): string {
  const { request, state, balls } = frame;
  if (request.kind !== "shot") return sentence(refereeText(request.why));
  const { in_hand, calls } = request;
  const said = [onInWords(request.on, state, Object.keys(balls))];
  if (in_hand) said.push(t(`request.${in_hand}`));
  const kind = call?.kind === "on" ? "nominated" : "called";
  if (call) said.push(t(`request.${kind}`, { call: callInWords(call) }));
  else if (calls.includes("on")) said.push(t("request.nominate"));
  else if (!calls.includes("nothing")) said.push(t("request.call"));
  if (!call && calls.includes("push-out")) said.push(t("request.push-out"));
  return paragraph(said.filter(Boolean).map(sentence));
}

/** A text of the engine's referee in the present language. */
export function refereeText(english: string): string {
  const key = keyOf(english, "referee.");
  return key ? t(key as Extract<PlainKey, `referee.${string}`>) : english;
}

/** Which balls are on; empty if any ball may be hit first. */
export function onInWords(
  on: readonly string[],
  state: FrameState["state"],
  lying: readonly string[],
): string {
  if (state.innings) return "";
  if (state.free_ball) return t("request.free-ball");
  if (state.on === "red") return t("request.red");
  if (state.on === "color" && on.length > 1) return t("request.colour");
  const group = GROUPS.find((name) =>
    on.every((ball) => (name === "solids") === Number(ball) < 8 && ball !== "8"),
  );
  if (state.groups?.some(Boolean) && group && on.length > 0) return t(`request.${group}`);
  if (state.groups && on.length !== 1) return lying.includes("8") ? t("request.open") : "";
  if (on.length === 0 || on.length > LISTED) return "";
  return t("request.on", { balls: list(playedNames(on), "disjunction") });
}

/** The ruling on a move. */
export function rulingInWords(step: PlayedMove, names: Pair<string>): string {
  const { ruling, after } = step;
  const said = [moveInWords(step, names), ...points(ruling, names)];
  const { spotted } = ruling;
  if (spotted.length > 0) {
    const key = spotted.length > 1 ? "ruling.many-spotted" : "ruling.one-spotted";
    said.push(t(key, { balls: listed(spotted) }));
  }
  if (ruling.racked) said.push(t("ruling.racked"));
  if (after.request.kind === "over") {
    const winner = headline(after.request, names);
    said.push(t("ruling.over", { winner, why: refereeText(after.request.why) }));
  }
  return paragraph(said.map(sentence));
}

/** Whether a ruling tells more than that the shot was legal, so that a player wants to read it. */
export function isNotable({ move, ruling, after }: PlayedMove): boolean {
  if (!("play" in move) || !ruling.legal || after.request.kind !== "shot") return true;
  const called = move.play.call?.kind;
  const isDeclared = called === "safety" || called === "push-out";
  return isDeclared || ruling.spotted.length > 0 || ruling.racked;
}

function moveInWords({ move, player, ruling, potted }: PlayedMove, names: Pair<string>): string {
  const name = names[player];
  if ("concede" in move) return t("ruling.concedes", { name });
  if ("choice" in move) {
    return t("ruling.choice", { name, choice: choiceInWords(move.choice, names[other(player)]) });
  }
  if (!ruling.legal) {
    return t("ruling.foul", { name, fouls: ruling.fouls.map(foulInWords).join(t("ruling.gap")) });
  }
  if (ruling.carom) return caromInWords(ruling.carom, name);
  const kind = move.play.call?.kind;
  const said =
    potted.length === 0 ? t("ruling.nothing") : t("ruling.pocketed", { balls: listed(potted) });
  const called = kind === "safety" || kind === "push-out" ? kind : "legal";
  return t(`ruling.${called}`, { name, potted: said });
}

/** What the referee counted in a legal shot of a game without pockets. */
function caromInWords({ balls, cushions: count, needed, stayed }: CaromCount, name: string) {
  if (balls === 0) return t("ruling.carom.no-ball", { name });
  if (stayed) return t("ruling.carom.stayed", { name });
  const said = balls === 1 ? "one-ball" : count < needed ? "short" : "both";
  if (said === "short") return t("ruling.carom.short", { name, count });
  // Where no cushion is needed and none was touched, their number is not worth a word.
  return needed === 0 && count === 0
    ? t(`ruling.carom.${said}`, { name })
    : t(`ruling.carom.${said}-cushions`, { name, count });
}

function foulInWords({ what, rule }: Ruling["fouls"][number]): string {
  const foul = refereeText(what);
  return rule ? t("ruling.foul-rule", { foul, rule }) : foul;
}

/** The balls by name, or their number if they are many. */
function listed(balls: readonly string[]): string {
  const count = balls.length;
  return count > LISTED ? t("ruling.balls", { count }) : list(playedNames(balls));
}

function points({ points: scored }: Ruling, names: Pair<string>): string[] {
  return scored.flatMap((points, player) => {
    const said = { name: names[player as Seat], count: Math.abs(points) };
    return points === 0 ? [] : [t(points > 0 ? "ruling.scores" : "ruling.loses", said)];
  });
}

/** A choice as the text of its button. */
export function choiceInWords(choice: Choice, opponent: string): string {
  switch (choice) {
    case "pass-back":
    case "rebreak-by-other":
    case "replace":
      return t(`choice.${choice}`, { opponent });
    default:
      return t(`choice.${choice}`);
  }
}

/** A call, which may be incomplete, as text; empty for null. */
export function callInWords(call: Call | null): string {
  switch (call?.kind) {
    case undefined:
      return "";
    case "safety":
      return t("call.a-safety");
    case "push-out":
      return t("call.a-push-out");
    case "on":
      return playedName(call.ball!);
    case "pocket":
      return t("call.ball-and-pocket", {
        ball: call.ball === undefined ? t("call.no-ball") : playedName(call.ball),
        pocket:
          call.into === undefined
            ? t("call.no-pocket")
            : t("pocket.named", { pocket: pocketName(call.into) }),
      });
  }
}
