/** Plays the aimed shot, and continues from where its balls stop. */

import type { Trace } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { ballName } from "../common/words.ts";
import type { Store } from "../document/store.ts";
import { automatic, changed } from "../document/strike-angles.ts";
import { playShot } from "../game/play.ts";
import { replay } from "../replay/control.ts";
import { sentence, t } from "../words/translate.ts";

/** Plays the aimed shot: in a game as a move, on a free table as a replay of the ghost. */
export function shoot(store: Store, context: Context): void {
  if (store.session.mode === "replay") return;
  if (store.document.game) {
    // With reduced motion the bar shows the next request at once; "Watch again" replays the shot.
    playShot(store, context, (trace) => {
      if (!context.reducedMotion()) replay(store, trace);
    });
    return;
  }
  const { trace, error } = store.ghost;
  if (!trace) {
    store.refuse(t("error.unplayable", { why: error ?? "" }));
    return;
  }
  const still = context.reducedMotion();
  store.settle();
  replay(store, trace, still ? trace.duration : 0, !still);
}

/** Makes the end of the replayed shot the new layout. */
export function takeItFromHere(store: Store, context: Context): void {
  const { trace } = store.session;
  if (!trace || store.document.game) return;
  const left = trace.shot.balls.filter((_, index) => !gone(trace, index));
  const cue = store.document.shot.strike.ball;
  const struck = left.some(({ id }) => id === cue) ? cue : left[0]?.id;
  if (struck === undefined) {
    store.refuse(t("aim.no-ball-left"));
    return;
  }
  const { shot } = store.document;
  const entries = new Map(shot.balls.map((ball) => [ball.id, ball]));
  const balls = left.map(({ id }) => {
    const { mass, radius } = entries.get(id) ?? {};
    const [x, y] = endOf(trace, id);
    return { id, position: [x, y] as const, ...(mass && { mass }), ...(radius && { radius }) };
  });
  store.setSession({ lock: null });
  // The next shot starts at the centre and at the automatic elevation: both rarely carry over.
  const strike = automatic(changed(shot.strike, { ball: struck, side: 0, height: 0 }));
  const taken = store.apply({ shot: { ...shot, balls, strike } }, t("change.take"));
  if (taken && struck !== cue) {
    const names = { ball: ballName(cue), struck: ballName(struck) };
    context.announce(sentence(t("aim.other-struck", names)));
  }
}

function endOf(trace: Trace, id: string): readonly [number, number] {
  const index = trace.shot.balls.findIndex((ball) => ball.id === id);
  const states = trace.statesAt(trace.duration);
  const stride = states.length / trace.shot.balls.length;
  return [states[index * stride]!, states[index * stride + 1]!];
}

function gone(trace: Trace, index: number): boolean {
  const { id } = trace.shot.balls[index]!;
  const { pocketed, off_table } = trace.outcome;
  return pocketed.some(([ball]) => ball === id) || off_table.includes(id);
}
