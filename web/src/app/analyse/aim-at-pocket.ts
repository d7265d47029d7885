/** Aiming by ball and pocket: lines are searched in a worker, and the aim turns when one is found. */

import { CaromError, type Engine, type PocketName } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { errorText } from "../common/refusals.ts";
import { playedName, pocketName } from "../common/shot-words.ts";
import type { FoundPot, PotQuestion, Store } from "../document/store.ts";
import { isObjectBall } from "../pot/aim-with-snap.ts";
import { Desk } from "./desk/desk-client.ts";
import DeskWorker from "./desk/desk-worker.ts?worker&inline";
import { t } from "../words/translate.ts";

const desks = new WeakMap<Engine, Desk>();

function deskOf(engine: Engine): Desk {
  let desk = desks.get(engine);
  if (!desk) desks.set(engine, (desk = new Desk(() => new DeskWorker(), engine)));
  return desk;
}

/** Searches in a worker, or at once where the browser starts none. */
function solve(
  engine: Engine,
  question: PotQuestion,
  answer: (found: FoundPot | null) => void,
): void {
  deskOf(engine).ask(
    { kind: "pot", ...question },
    {
      part: ({ found }) => answer(found),
      refused: () => answer(searched(engine, question)),
    },
  );
}

function searched(engine: Engine, { shot: file, ball, pockets }: PotQuestion): FoundPot | null {
  const shot = engine.shot(file);
  try {
    for (const pocket of pockets) {
      const aim = shot.potAim(ball, pocket);
      if (aim) return { pocket, aim };
    }
    return null;
  } finally {
    shot.free();
  }
}

/** Lets the worker search the lines of pots. */
export function mountPots(store: Store, { engine }: Context): void {
  store.solvePotsWith((question, answer) => solve(engine, question, answer));
}

/** Aims a ball at the first of some pockets that a line reaches; `done` gets it, null if there is none. */
function aim(
  store: Store,
  engine: Engine,
  ball: string,
  pockets: readonly PocketName[],
  done: (pocket: PocketName | null) => void,
): void {
  const asked = store.document;
  solve(engine, { shot: store.shot.json(), ball, pockets }, (found) => {
    // The user may have gone on meanwhile.
    if (store.document !== asked || store.session.mode !== "aim") return;
    if (!found) {
      done(null);
      return;
    }
    const names = { ball: playedName(ball), pocket: pocketName(found.pocket) };
    try {
      if (store.takeAim(ball, found.pocket, found.aim, t("change.aim-pot", names))) {
        done(found.pocket);
      }
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      store.refuse(errorText(error));
    }
  });
}

/** Aims `ball` at `pocket`, or says that no line was found; `done` learns which. */
export function aimAtPocket(
  store: Store,
  { engine, announce }: Pick<Context, "engine" | "announce">,
  ball: string,
  pocket: PocketName,
  done: (isFound: boolean) => void,
): void {
  aim(store, engine, ball, [pocket], (found) => {
    if (found === null) {
      announce(t("pot.no-line", { ball: playedName(ball), pocket: pocketName(pocket) }));
    }
    done(found !== null);
  });
}

/** Aims the selected ball at the next pocket, in the order of the table, that a line reaches. */
export function aimAtNextPocket(store: Store, context: Context, step: 1 | -1): void {
  const { selected, lock } = store.session;
  const pockets = store.shot.geometry.pockets.map(({ name }) => name);
  if (pockets.length === 0) {
    store.refuse(t("pot.no-pockets"));
    return;
  }
  if (!isObjectBall(store, selected)) {
    store.refuse(t("pot.no-ball"));
    return;
  }
  const at = lock?.ball === selected ? pockets.indexOf(lock.pocket) : -1;
  const from = at < 0 && step < 0 ? 0 : at;
  const count = pockets.length;
  const order = pockets.map((_, k) => pockets[(from + step * (k + 1) + count * (k + 1)) % count]!);
  aim(store, context.engine, selected, order, (found) => {
    if (found === null) context.announce(t("pot.no-line-at-all", { ball: playedName(selected) }));
  });
}
