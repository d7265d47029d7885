/** In the Game tab: what a machine meant with its last shot, and what it expected. */

import { CaromError, type Recommendation } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { h, setText } from "../../common/dom.ts";
import { playedName, pocketName } from "../../common/shot-words.ts";
import { estimatedPercent } from "../../common/units.ts";
import type { Game } from "../../document/stored-game.ts";
import type { Store } from "../../document/store.ts";
import { standing } from "../awaited-turn.ts";
import { lastByMachine, type Reason, reasonOf } from "./reason.ts";
import { thinkerOf } from "./machine-thinker.ts";
import { levelToMove } from "./machine-turns.ts";
import { decimal, paragraph, sentence, t } from "../../words/translate.ts";

/** Mounts the section; it is hidden until a machine has played. */
export function mountExplanation(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const title = h("h2");
  const text = h("p", { class: "reason", role: "status", "aria-live": "polite" });
  root.append(title, text);
  /** The moves of the game whose last shot is explained. */
  let shown: Game["moves"] | null = null;
  /** What is said of it, with pockets as the picture shows them. */
  let words = (): string => "";

  async function explain(game: Game, index: number): Promise<void> {
    words = () => t("reason.asking");
    setText(text, words());
    const progress = standing(store, engine)!;
    try {
      const reason = await reasonOf(engine, game, progress, index, await thinkerOf(engine));
      if (shown !== game.moves) return;
      words = () => reasonInWords(reason);
      setText(text, words());
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      if (shown !== game.moves) return;
      words = () => t("reason.none");
      setText(text, words());
    }
  }

  const show = (): void => {
    const { game } = store.document;
    const progress = standing(store, engine);
    const index = game && progress && lastByMachine(game, progress);
    root.hidden = index === null;
    if (!game || !progress || index === null) {
      shown = null;
      return;
    }
    // The machine's next decision goes first.
    if (store.session.mode === "replay" || levelToMove(store, engine) !== null) return;
    if (shown === game.moves) return;
    shown = game.moves;
    const name = game.setup.names[progress.steps[index]!.player];
    setText(title, t("reason.title", { name }));
    void explain(game, index);
  };
  store.subscribe((now, before) => {
    if (now.document.game !== before.document.game || now.session.mode !== before.session.mode) {
      show();
    } else if (now.session.orientation !== before.session.orientation) setText(text, words());
  });
  show();
}

/** A reason in sentences. */
export function reasonInWords(reason: Reason | null): string {
  if (!reason) return t("reason.none");
  const { meant, instead, expected } = reason;
  const other = instead && {
    play: playInWords(instead),
    win: estimated(instead.win_chance),
  };
  // A weaker machine does not find the best play: the other one may be better than its own.
  const isBetter = meant !== null && instead !== null && instead.win_chance > meant.win_chance;
  const said = meant
    ? [
        ...chancesInWords(meant),
        other ? t(isBetter ? "reason.prefers" : "reason.instead", other) : "",
      ]
    : [
        t("reason.none"),
        expected === null ? "" : t("reason.win", { win: estimated(expected) }),
        other ? t("reason.prefers", other) : "",
      ];
  return paragraph(said.filter(Boolean).map(sentence));
}

function chancesInWords(meant: Recommendation): string[] {
  const { win_if_kept: kept, win_if_missed: missed } = meant;
  const chances = [
    t("reason.meant", { play: playInWords(meant) }),
    t("reason.chances", {
      kept: estimated(meant.kept.probability),
      foul: estimated(meant.foul.probability),
    }),
    t("reason.win", { win: estimated(meant.win_chance) }),
  ];
  // After a safety the other player shoots: both cases would repeat what is said.
  if (Math.round(100 * meant.kept.probability) === 0) return chances;
  return [
    ...chances,
    kept === null ? "" : t("reason.if-kept", { win: estimated(kept) }),
    missed === null ? "" : t("reason.if-missed", { win: estimated(missed) }),
  ];
}

/** What a play is meant to do, within a sentence. */
export function playInWords({ kind, ball, pocket, legs }: Recommendation): string {
  const first = legs[1]?.[0];
  if (ball !== null && pocket !== null) {
    const names = { ball: playedName(ball), pocket: pocketName(pocket) };
    switch (kind) {
      case "bank":
      case "kick":
      case "combination":
        return t(`reason.${kind}`, names);
      default:
        return t("reason.pot", names);
    }
  }
  if (kind === "break" || kind === "push-out") return t(`reason.${kind}`);
  const hit = kind === "carom" ? "carom" : "safety";
  return first === undefined
    ? t(`reason.${hit}`)
    : t(`reason.${hit}-off`, { ball: playedName(first) });
}

/** A probability in percent, as text. */
export function percent(probability: number): string {
  return decimal(100 * probability, 0);
}

/** The same for what a machine expected, which no simulation makes certain. */
function estimated(probability: number): string {
  return decimal(estimatedPercent(probability));
}
