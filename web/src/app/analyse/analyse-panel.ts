/** The tab of the best shots: five recommendations of the player that searches, and why one is better than another. */

import "./analyse-panel.css";
import type { Recommendation } from "../../engine/index.ts";
import ThinkerWorker from "../../engine/thinker-worker.ts?worker&inline";
import type { Context } from "../common/context.ts";
import { h, labelled, setText, uniqueId } from "../common/dom.ts";
import { gameName, levelName } from "../common/preset-names.ts";
import { changeUnpressed } from "../common/press.ts";
import type { State, Store } from "../document/store.ts";
import { ellipseOf, leavePicture } from "./leave-picture.ts";
import { type Found, RecommendationSearch } from "./recommendation-search.ts";
import { mountNext } from "./look-ahead.ts";
import { isForOne } from "../game/game-words.ts";
import { Desk } from "./desk/desk-client.ts";
import DeskWorker from "./desk/desk-worker.ts?worker&inline";
import { aimRecommendation, readShot, shotOf } from "./aim-recommendation.ts";
import { type Position, positionOf } from "./analysed-position.ts";
import { hidePreview, resultButton, showShot } from "./result-preview.ts";
import { mountStop } from "./stop-handle.ts";
import {
  leaveText,
  recommendationText,
  percent,
  strikeText,
  whatText,
  whyText,
} from "./analyse-words.ts";
import { routeText } from "../pot/carom-words.ts";
import { readingInWords } from "../pot/diamond-words.ts";
import { decimal, t } from "../words/translate.ts";

/** Time (ms) without a change of the position after which it is searched: a drag moves a ball every frame. */
const REST = 60;

/** Variants of a counted pot. */
const POTS = 600;

/** Colour of the area in which the cue ball stops. */
const STOP = "#8fe3ff";

export function mountLines(root: HTMLElement, store: Store, context: Context): void {
  const panel = new LinesPanel(root, store, context);
  const stop = h("section", { "aria-label": t("stop.title") });
  const next = h("section", { "aria-label": t("next.title") });
  root.append(stop, next);
  mountStop(stop, store, context);
  mountNext(next, root, store, context);
  store.subscribe((now, before) => {
    if (matters(now, before)) panel.follow();
    else if (now.session.orientation !== before.session.orientation) panel.showAgain();
  });
  const follow = () => panel.follow();
  new MutationObserver(follow).observe(root, { attributeFilter: ["hidden"] });
  follow();
}

/** The list of recommendations, and the settings of their search. */
class LinesPanel {
  readonly #root: HTMLElement;
  readonly #store: Store;
  readonly #context: Context;
  readonly #list = h("ol", { class: "lines", "aria-label": t("lines.title") });
  readonly #status = h("p", {
    class: "hint",
    role: "status",
    "aria-live": "polite",
    id: "lines-status",
  });
  readonly #rules = h("select", { id: uniqueId("rules") });
  readonly #rulesRow = labelled(t("lines.game"), this.#rules);
  readonly #level = h("select", { id: uniqueId("level") });
  readonly #levelRow = labelled(t("lines.level"), this.#level);
  readonly #own = h("p", { class: "hint" }, t("lines.own-errors"));
  readonly #desk: Desk;
  /** Chances of pots, by their plays. */
  readonly #potChances = new WeakMap<Recommendation["play"], number>();
  /** Starts workers, so it is made for the first question. */
  #search: RecommendationSearch | null = null;
  #found: Found | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(root: HTMLElement, store: Store, context: Context) {
    const { engine } = context;
    this.#root = root;
    this.#store = store;
    this.#context = context;
    this.#desk = new Desk(() => new DeskWorker(), engine);
    this.#level.append(
      ...Object.keys(engine.noisePresets).map((name) =>
        h("option", { value: name }, levelName(name)),
      ),
    );
    this.#rules.addEventListener("change", () =>
      store.setPart("analysis", { rules: this.#rules.value }),
    );
    this.#level.addEventListener("change", () =>
      store.setPart("analysis", { level: this.#level.value }),
    );
    root.append(
      this.#rulesRow,
      this.#levelRow,
      this.#own,
      h("h2", {}, t("lines.title")),
      this.#list,
      this.#status,
      h("p", { class: "hint" }, t("lines.hint")),
    );
  }

  /** Whether the tab is in view and there is a position to look at. */
  get #isWanted(): boolean {
    return !this.#root.hidden && this.#store.session.mode === "aim";
  }

  /** Waits until the position rests, and then searches it. */
  follow(): void {
    clearTimeout(this.#timer);
    this.#search?.stop();
    if (!this.#isWanted) return;
    this.#list.dataset.stale = "true";
    this.#timer = setTimeout(() => this.#ask(), REST);
  }

  #ask(): void {
    const position = positionOf(this.#store, this.#context.engine);
    this.#showSettings(position);
    if (!position) {
      this.#found = null;
      changeUnpressed(this.#list, () => this.#list.replaceChildren());
      setText(this.#status, t(this.#store.document.game ? "lines.no-shot" : "lines.no-game"));
    } else if (this.#found?.done && this.#found.position.key === position.key) {
      this.#show(this.#found);
    } else {
      setText(this.#status, t("lines.searching"));
      this.#search ??= new RecommendationSearch(() => new ThinkerWorker(), this.#context.engine, {
        found: (result) => this.#show(result),
        refused: (message) => setText(this.#status, message),
      });
      this.#search.ask(position);
    }
  }

  #show(result: Found): void {
    this.#found = result;
    // While shots are found, the list changes under a pointer that presses one of them.
    changeUnpressed(this.#list, () => this.#showFound(result));
    this.#countPots(result);
  }

  #showFound({ plays, done, elapsed }: Found): void {
    const focused = [...this.#list.querySelectorAll(".line")].indexOf(document.activeElement!);
    hidePreview(this.#store);
    this.#list.replaceChildren(
      ...plays.map((recommendation, index) => this.#item(recommendation, index, plays)),
    );
    delete this.#list.dataset.stale;
    this.#list.dataset.done = String(done);
    this.#list.dataset.elapsed = String(Math.round(elapsed));
    this.#list.querySelectorAll<HTMLElement>(".line")[focused]?.focus();
    const samples = plays[0]?.samples ?? 0;
    setText(
      this.#status,
      plays.length === 0
        ? t("lines.none")
        : done
          ? t("lines.done", { samples, seconds: decimal(elapsed / 1000, 1) })
          : t("lines.searching"),
    );
  }

  #item(
    recommendation: Recommendation,
    index: number,
    all: readonly Recommendation[],
  ): HTMLElement {
    const { play, kept, foul, route, win_chance: win } = recommendation;
    const { geometry, balls } = this.#store.shot;
    const cue = this.#store.document.shot.strike.ball;
    // A single player keeps the turn with every shot, makes no foul and wins nothing: there the pot counts.
    const alone = isForOne(this.#context.engine, this.#rules.value);
    const facts = alone
      ? h("span", { class: "facts" }, this.#potFact(recommendation))
      : h(
          "span",
          { class: "facts" },
          fact(
            t(recommendation.ball === null ? "lines.kept" : "lines.pot-chance"),
            percent(kept.probability),
          ),
          fact(t("lines.foul"), percent(foul.probability)),
          fact(t("lines.win"), percent(win)),
        );
    const button = resultButton(
      this.#store,
      {
        take: () => {
          if (aimRecommendation(this.#store, recommendation))
            this.#context.announce(t("lines.aimed", { line: recommendationText(recommendation) }));
        },
        show: () => this.#preview(recommendation),
      },
      h(
        "span",
        { class: "said" },
        h("strong", {}, whatText(recommendation)),
        route && h("span", { class: "route" }, routeText(route)),
        h("span", { class: "hint" }, strikeText(play.strike)),
        route?.system && h("span", { class: "hint" }, readingInWords(route.system)),
        facts,
        h("span", { class: "unseen" }, leaveText(recommendation)),
      ),
      leavePicture(geometry, balls, cue, recommendation, this.#isLying()),
    );
    return h("li", {}, button, ...(all.length > 1 ? why(recommendation, index, all) : []));
  }

  /** The counted chance of the pot; empty until it is known, and where no ball is to fall. */
  #potFact(recommendation: Recommendation): HTMLElement | false {
    if (recommendation.ball === null || recommendation.pocket === null) return false;
    const chance = this.#potChances.get(recommendation.play);
    return fact(t("lines.pot-chance"), chance === undefined ? "…" : percent(chance));
  }

  /** Counts the pots of the recommendations, one after the other. */
  #countPots({ plays, position, done }: Found): void {
    if (!done || !isForOne(this.#context.engine, position.rules)) return;
    const recommendation = plays.find(
      ({ ball, play }) => ball !== null && !this.#potChances.has(play),
    );
    if (recommendation?.ball == null || recommendation.pocket === null) return;
    const { ball, pocket, play } = recommendation;
    this.#desk.ask(
      {
        kind: "chance",
        noise: position.noise,
        count: POTS,
        of: { shot: JSON.stringify(shotOf(this.#store.document.shot, play)), ball, pocket },
      },
      {
        part: ({ met, count }) => count === POTS && this.#potChances.set(play, met / count),
        done: () => {
          if (this.#found?.plays === plays) this.#show(this.#found);
        },
      },
    );
  }

  /** Whether the table lies on the screen, as in a wide window. */
  #isLying(): boolean {
    const { size } = this.#store.shot.geometry;
    const [from, to] = [
      this.#context.viewer.project(0, 0, 0),
      this.#context.viewer.project(0, size?.[1] ?? 1, 0),
    ];
    return from !== null && to !== null && Math.abs(to[0] - from[0]) > Math.abs(to[1] - from[1]);
  }

  #preview(recommendation: Recommendation): void {
    if (!this.#isWanted || this.#list.dataset.stale) return;
    const shot = readShot(this.#context.engine, this.#store.document.shot, recommendation.play);
    const outline = ellipseOf(recommendation);
    if (shot) showShot(this.#store, shot, outline ? [{ outline, color: STOP }] : []);
  }

  #showSettings(position: Position | null): void {
    const inGame = this.#store.document.game !== null;
    const { noise } = this.#store.document;
    this.#own.hidden = noise === null;
    this.#levelRow.hidden = noise !== null;
    this.#rulesRow.hidden = inGame;
    this.#level.value = this.#store.session.analysis.level;
    const games = position?.games ?? [];
    if (this.#rules.dataset.games !== games.join()) {
      this.#rules.dataset.games = games.join();
      this.#rules.replaceChildren(
        ...games.map((name) => h("option", { value: name }, rulesName(name))),
      );
    }
    this.#rules.disabled = games.length === 0;
    this.#rules.value = position?.rules ?? "";
  }

  /** Shows what was found as the picture now names it. */
  showAgain(): void {
    if (this.#found) this.#show(this.#found);
  }
}

/** Whether the position, or what is asked about it, may have changed. */
function matters(
  { document: now, session }: State,
  { document: before, session: earlier }: State,
): boolean {
  return (
    now.shot.balls !== before.shot.balls ||
    now.shot.table !== before.shot.table ||
    now.shot.physics !== before.shot.physics ||
    now.shot.strike.ball !== before.shot.strike.ball ||
    now.noise !== before.noise ||
    now.game?.moves !== before.game?.moves ||
    session.mode !== earlier.mode ||
    session.analysis.level !== earlier.analysis.level ||
    session.analysis.rules !== earlier.analysis.rules
  );
}

/** The button that compares a recommendation with the best one, or the best one with the second. */
function why(
  recommendation: Recommendation,
  index: number,
  all: readonly Recommendation[],
): readonly HTMLElement[] {
  const text = h("p", { class: "why", id: uniqueId("why"), hidden: true });
  const button = h(
    "button",
    {
      type: "button",
      class: "button plain ask",
      "aria-expanded": "false",
      "aria-controls": text.id,
      "aria-label": index === 0 ? t("why.best") : t("why.ask", { a: 1, b: index + 1 }),
      onclick: () => {
        text.hidden = !text.hidden;
        button.setAttribute("aria-expanded", String(!text.hidden));
        const [first, second] = index === 0 ? [recommendation, all[1]!] : [all[0]!, recommendation];
        setText(text, text.hidden ? "" : whyText(first, second, [1, index === 0 ? 2 : index + 1]));
      },
    },
    t("why.why"),
  );
  return [button, text];
}

function fact(name: string, value: string): HTMLElement {
  return h("span", {}, `${name} `, h("b", {}, value));
}

function rulesName(name: string): string {
  return name === "straight-pool" ? t("lines.any-ball") : gameName(name);
}
