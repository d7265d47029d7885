/** The shot clock: the time of a person for a shot, one extension in a frame, and what is played at its end. */

import { CaromError, type Play, type Seat } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { h, setText } from "../../common/dom.ts";
import type { Game } from "../../document/stored-game.ts";
import type { Store } from "../../document/store.ts";
import { playMove } from "../game-actions.ts";
import { type Progress, someCall } from "../game-progress.ts";
import { askedShot, standing } from "../awaited-turn.ts";
import { t } from "../../words/translate.ts";

/** Time (ms) between two looks at the clock. */
const TICK = 200;

/** Remaining time (s) from which the clock is marked. */
const SOON = 10;

/** Cue speed (m/s) and directions of the shot that is played when the time is up. */
const SOFTEST = 0.02;
const DIRECTIONS = 72;

export function mountClock(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const time = h("span", { class: "clock", role: "timer" });
  const more = h("button", { type: "button", class: "button plain" });
  root.append(time, more);
  more.addEventListener("click", () => {
    const asked = askedShot(store, engine);
    const { game } = store.document;
    const seconds = game?.setup.clock;
    if (!asked || !game || seconds === undefined || hasExtended(game, asked.player)) return;
    const extended = [0, 1].map((k) => k === asked.player || hasExtended(game, k === 0 ? 0 : 1));
    end += 1000 * seconds;
    const next: Game = { ...game, extended: [extended[0]!, extended[1]!] };
    store.apply({ game: next }, t("change.extension"));
  });

  /** The moves of the game whose shot is timed, and when its time is up. */
  let timed: Game["moves"] | null = null;
  let end = 0;
  let ticking: ReturnType<typeof setInterval> | undefined;

  function look(): void {
    const { game } = store.document;
    const asked = store.session.mode === "aim" ? askedShot(store, engine) : null;
    const seconds = game?.setup.clock;
    root.hidden = !game || !asked || seconds === undefined;
    if (!game || !asked || seconds === undefined) {
      clearInterval(ticking);
      ticking = undefined;
      if (!game || standing(store, engine)?.frame.state.request.kind !== "shot") timed = null;
      return;
    }
    if (timed !== game.moves) {
      timed = game.moves;
      end = performance.now() + 1000 * seconds;
    }
    ticking ??= setInterval(look, TICK);
    const left = Math.max(0, Math.ceil((end - performance.now()) / 1000));
    setText(time, t("clock.left", { seconds: left }));
    time.dataset.soon = String(left <= SOON);
    more.hidden = hasExtended(game, asked.player);
    setText(more, t("clock.extend", { seconds }));
    if (left === 0) timeIsUp(game, asked.player);
  }

  function timeIsUp(game: Game, player: Seat): void {
    timed = null;
    const progress = standing(store, engine)!;
    const [x, y] = store.shot.balls[store.shot.struck!]!.position;
    const play = foulWithout(progress, [x, y]);
    if (play) playMove(store, context, play);
    context.announce(t("clock.up", { name: game.setup.names[player] }));
  }

  store.subscribe((now, before) => {
    if (now.document.game !== before.document.game || now.session.mode !== before.session.mode) {
      look();
    }
  });
  look();
}

function hasExtended({ extended }: Game, player: Seat): boolean {
  return extended?.[player] ?? false;
}

/**
 * The softest shot that hits no ball: a foul in pool and snooker, and the end of the inning in
 * three-cushion. Null if every direction hits a ball.
 */
export function foulWithout({ frame }: Progress, place: readonly [number, number]): Play | null {
  const { request } = frame.state;
  if (request.kind !== "shot") return null;
  const call = someCall(request);
  for (let k = 0; k < DIRECTIONS; k += 1) {
    const azimuth = (2 * Math.PI * k) / DIRECTIONS;
    const play: Play = {
      strike: { speed: SOFTEST, azimuth, side: 0, height: 0 },
      ...(request.in_hand !== null && { cue_ball: place }),
      ...(call && { call }),
    };
    const tried = frame.copy();
    try {
      const { trace } = tried.play(play);
      const { first_contact: first } = trace.outcome;
      trace.free();
      const { request: next } = tried.state;
      // In three-cushion a miss ends the inning without a foul.
      const isLost = next.kind === "over" || next.player !== request.player;
      if (isLost && first === null) return play;
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
    } finally {
      tried.free();
    }
  }
  return null;
}
