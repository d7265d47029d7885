/** Requests and rulings of the referee as sentences. */

import type {
  Call,
  Choice,
  FrameState,
  Seat,
  Region,
  Request,
  Ruling,
} from "../../engine/index.ts";
import { ballName, placeName, sentence } from "../common/words.ts";
import type { Pair } from "../document/game.ts";
import type { PlayedMove } from "./progress.ts";

const REGIONS: Readonly<Record<Region, string>> = {
  anywhere: "anywhere on the table",
  "behind-head-string": "behind the head string",
  "the-d": "in the D",
};

/** Up to this many balls are listed by name. */
const LISTED = 3;

const GROUPS = { solids: "solids (1 to 7)", stripes: "stripes (9 to 15)" } as const;

export function other(player: Seat): Seat {
  return player === 0 ? 1 : 0;
}

/** "eight-ball" as a heading. */
export function gameName(rules: string): string {
  const words = rules.replace("straight-pool", "straight pool");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** Whether the game has one player only. */
export function isForOne(rules: string): boolean {
  return rules === "practice";
}

/** Whose turn it is, or who won. */
export function headline(request: Request, names: Pair<string>): string {
  switch (request.kind) {
    case "shot":
      return `${names[request.player]} to shoot`;
    case "choice":
      return `${names[request.player]} decides`;
    case "over":
      return request.winner === null ? "Nobody wins" : `${names[request.winner]} wins`;
  }
}

/** A request as sentences, with the present call. */
export function requestInWords(frame: FrameState, call: Call | null = null): string {
  const { request, state, balls, game } = frame;
  if (request.kind !== "shot") return sentence(request.why);
  const { in_hand, calls } = request;
  const said = [onInWords(request.on, state, Object.keys(balls), game)];
  if (in_hand) said.push(`the cue ball is in hand, ${REGIONS[in_hand]}`);
  if (call) said.push(`${call.kind === "on" ? "nominated" : "called"}: ${callInWords(call)}`);
  else if (calls.includes("on")) said.push("nominate the ball on");
  else if (!calls.includes("nothing")) said.push("call a ball and its pocket, or a safety");
  if (!call && calls.includes("push-out")) said.push("a push-out is allowed");
  return said.filter(Boolean).map(sentence).join(" ");
}

/** Which balls are on; empty if any ball may be hit first. */
function onInWords(
  on: readonly string[],
  state: FrameState["state"],
  lying: readonly string[],
  game: string,
): string {
  if (game === "three-cushion") return "";
  if (state.free_ball) return "there is a free ball";
  if (state.on === "red") return "a red is on";
  if (state.on === "color" && on.length > 1) return "a colour is on";
  const group = (Object.keys(GROUPS) as (keyof typeof GROUPS)[]).find((name) =>
    on.every((ball) => (name === "solids") === Number(ball) < 8 && ball !== "8"),
  );
  if (state.groups?.some(Boolean) && group && on.length > 0) return `${GROUPS[group]} are on`;
  if (state.groups && on.length !== 1) return lying.includes("8") ? "the table is open" : "";
  if (on.length === 0 || on.length > LISTED) return "";
  const names = on.map(ballName).join(" or ");
  return `${names} is on`;
}

/** The ruling on a move. */
export function rulingInWords(step: PlayedMove, names: Pair<string>): string {
  const { move, player, ruling, after } = step;
  const name = names[player];
  const said: string[] = [];
  if ("concede" in move) said.push(`${name} concedes`);
  else if ("choice" in move)
    said.push(`${name}: ${choiceInWords(move.choice, names[other(player)])}`);
  else if (ruling.legal) said.push(`${name}: ${legalInWords(step.potted, move.play.call)}`);
  else said.push(`Foul by ${name}: ${ruling.fouls.map(foulInWords).join("; ")}`);
  said.push(...points(ruling, names));
  const { spotted } = ruling;
  if (spotted.length > 0)
    said.push(`${listed(spotted)} ${spotted.length > 1 ? "are" : "is"} spotted`);
  if (ruling.racked) said.push("the balls are racked again");
  if (after.request.kind === "over") {
    said.push(`${headline(after.request, names)}: ${after.request.why}`);
  }
  return said.map(sentence).join(" ");
}

function foulInWords({ what, rule }: Ruling["fouls"][number]): string {
  return rule ? `${what} (${rule})` : what;
}

function legalInWords(potted: readonly string[], call: Call | undefined): string {
  const kind = call?.kind === "safety" || call?.kind === "push-out" ? `, a ${call.kind}` : "";
  const pocketed = potted.length === 0 ? "nothing pocketed" : `${listed(potted)} pocketed`;
  return `a legal shot${kind}, ${pocketed}`;
}

/** The balls by name, or their number if they are many. */
function listed(balls: readonly string[]): string {
  return balls.length > LISTED ? `${balls.length} balls` : balls.map(ballName).join(" and ");
}

function points({ points: scored }: Ruling, names: Pair<string>): string[] {
  return scored.flatMap((count, player) =>
    count === 0
      ? []
      : [
          `${names[player as Seat]} ${count > 0 ? "scores" : "loses"} ${Math.abs(count)} ` +
            (Math.abs(count) === 1 ? "point" : "points"),
        ],
  );
}

/** A choice as the text of its button. */
export function choiceInWords(choice: Choice, opponent: string): string {
  const words: Readonly<Record<Choice, string>> = {
    "play-on": "play the balls as they lie",
    "play-from-hand": "play with the cue ball in hand",
    "pass-back": `let ${opponent} shoot`,
    rebreak: "rack again and break",
    "rebreak-by-other": `rack again, ${opponent} breaks`,
    "spot-eight": "spot the eight and shoot",
    replace: `put the balls back, ${opponent} shoots again`,
    "spot-frozen": "spot the touching balls and shoot",
    "spot-nearest": "spot the nearest ball and shoot from behind the head string",
  };
  return words[choice];
}

/** A call, which may be incomplete, as text; empty for null. */
export function callInWords(call: Call | null): string {
  switch (call?.kind) {
    case undefined:
      return "";
    case "safety":
      return "a safety";
    case "push-out":
      return "a push-out";
    case "on":
      return ballName(call.ball!);
    case "pocket": {
      const ball = call.ball === undefined ? "no ball yet" : ballName(call.ball);
      const pocket = call.into === undefined ? "no pocket yet" : `${placeName(call.into)} pocket`;
      return `${ball}, ${pocket}`;
    }
  }
}
