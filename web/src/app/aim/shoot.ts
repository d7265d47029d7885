/** Plays the aimed shot, and continues from where its balls stop. */

import { CaromError, type Noise, type Shot, type Trace } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { errorText } from "../common/refusals.ts";
import { ballName } from "../common/shot-words.ts";
import type { Document } from "../document/document.ts";
import { withMarks } from "../document/marks.ts";
import type { Store } from "../document/store.ts";
import { automatic, changed } from "../document/strike-angles.ts";
import { playShot } from "../game/game-actions.ts";
import { ballsAfter, treeEngine } from "../document/balls-after.ts";
import { MOST_NODES, NO_TREE, withShot } from "../document/shot-tree.ts";
import { replay } from "../replay/replay-control.ts";
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
  const { attempt } = store.session;
  let played = trace;
  try {
    if (attempt?.errors) played = withErrors(store.shot, attempt.errors, attempt.seed);
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    store.refuse(t("error.unplayable", { why: errorText(error, store.shot.balls) }));
    return;
  }
  const still = context.reducedMotion();
  store.settle();
  if (store.session.activity === "analyse" && !attempt) keep(store, context);
  replay(store, played, still ? played.duration : 0, !still);
}

/** The shot as a player with these errors plays it. */
function withErrors(shot: Shot, errors: Noise, seed: number): Trace {
  return shot.variant(errors, 0, { seed }).simulate();
}

/** Adds the aimed shot to the tree of the analysis. */
function keep(store: Store, { engine }: Context): void {
  const { shot, tree = NO_TREE } = store.document;
  const next = withShot(tree, shot, treeEngine(engine).endOf);
  if (next.nodes.length > MOST_NODES) store.refuse(t("tree.too-many", { most: MOST_NODES }));
  else if (next.at !== tree.at && store.apply({ tree: next }, t("change.node"))) {
    kept.set(store, store.document);
  }
}

/** Documents whose last change added the shot to the tree: going on from its end is the same step. */
const kept = new WeakMap<Store, Document>();

/** Makes the end of the replayed shot the new layout. */
export function takeItFromHere(store: Store, context: Context): void {
  const { trace } = store.session.replay;
  if (!trace || store.document.game) return;
  const { shot } = store.document;
  const balls = ballsAfter(trace, shot);
  const cue = shot.strike.ball;
  const struck = balls.some(({ id }) => id === cue) ? cue : balls[0]?.id;
  if (struck === undefined) {
    store.refuse(t("aim.no-ball-left"));
    return;
  }
  store.setSession({ lock: null });
  // The next shot starts at the centre and at the automatic elevation: both rarely carry over.
  const strike = automatic(changed(shot.strike, { ball: struck, side: 0, height: 0 }));
  // What is drawn belongs to the position before.
  const change = { shot: withMarks({ ...shot, balls, strike }, []) };
  // One undo takes back one shot.
  const taken =
    kept.get(store) === store.document
      ? store.amend(change)
      : store.apply(change, t("change.take"));
  if (taken && struck !== cue) {
    const names = { ball: ballName(cue), struck: ballName(struck) };
    context.announce(sentence(t("aim.other-struck", names)));
  }
}
