/** The tab of the best shots: five lines of the player that searches, and why one is better than another. */

import "./analyse-panel.css";
import type { Recommendation } from "../../engine/index.ts";
import ThinkerWorker from "../../engine/thinker-worker.ts?worker&inline";
import type { Context } from "../common/context.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import { gameName, levelName } from "../common/preset-names.ts";
import { changeUnpressed } from "../common/press.ts";
import type { State, Store } from "../document/store.ts";
import { ellipseOf, leavePicture } from "./leave-picture.ts";
import { type Found, Lines } from "./line-search.ts";
import { mountNext } from "./look-ahead.ts";
import { isForOne } from "../game/game-words.ts";
import { Desk } from "./desk/desk-client.ts";
import DeskWorker from "./desk/desk-worker.ts?worker&inline";
import { aimLine, readShot, shotOf } from "./play-line.ts";
import { type Position, positionOf } from "./analysed-position.ts";
import { hidePreview, showShot } from "./result-preview.ts";
import { mountStop } from "./stop-handle.ts";
import { leaveText, lineText, percent, strikeText, whatText, whyText } from "./analyse-words.ts";
import { decimal, t } from "../words/translate.ts";

/** Time (ms) without a change of the position after which it is searched: a drag moves a ball every frame. */
const REST = 60;

/** Variants of a counted pot. */
const POTS = 600;

/** Colour of the area in which the cue ball stops. */
const STOP = "#8fe3ff";

export function mountLines(root: HTMLElement, store: Store, context: Context): void {
  const { engine } = context;
  const list = h("ol", { class: "lines", "aria-label": t("lines.title") });
  const status = h("p", {
    class: "hint",
    role: "status",
    "aria-live": "polite",
    id: "lines-status",
  });
  const rules = h("select", { id: uniqueId("rules") });
  const rulesRow = labelled(t("lines.game"), rules);
  const level = h(
    "select",
    { id: uniqueId("level") },
    ...Object.keys(engine.noisePresets).map((name) =>
      h("option", { value: name }, levelName(name)),
    ),
  );
  const levelRow = labelled(t("lines.level"), level);
  const own = h("p", { class: "hint" }, t("lines.own-errors"));
  root.append(
    rulesRow,
    levelRow,
    own,
    h("h2", {}, t("lines.title")),
    list,
    status,
    h("p", { class: "hint" }, t("lines.hint")),
  );
  const stop = h("section", { "aria-label": t("stop.title") });
  root.append(stop);
  mountStop(stop, store, context);
  const next = h("section", { "aria-label": t("next.title") });
  root.append(next);
  mountNext(next, store, context);
  rules.addEventListener("change", () => store.setPart("analysis", { rules: rules.value }));
  level.addEventListener("change", () => store.setPart("analysis", { level: level.value }));

  const desk = new Desk(() => new DeskWorker(), engine);
  /** Chances of pots, by their plays. */
  const potChances = new WeakMap<Recommendation["play"], number>();
  let lines: Lines | null = null;
  let found: Found | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;

  /** Whether the tab is in view and there is a position to look at. */
  const isWanted = () => !root.hidden && store.session.mode === "aim";

  /** Waits until the position rests, and then searches it. */
  function follow(): void {
    clearTimeout(timer);
    lines?.stop();
    if (!isWanted()) return;
    list.dataset.stale = "true";
    timer = setTimeout(ask, REST);
  }

  function ask(): void {
    const position = positionOf(store, engine);
    showSettings(position);
    if (!position) {
      found = null;
      changeUnpressed(list, () => list.replaceChildren());
      setText(status, t(store.document.game ? "lines.no-shot" : "lines.no-game"));
    } else if (found?.done && found.position.key === position.key) {
      show(found);
    } else {
      setText(status, t("lines.searching"));
      lines ??= new Lines(() => new ThinkerWorker(), engine, { found: show, refused });
      lines.ask(position);
    }
  }

  function refused(message: string): void {
    setText(status, message);
  }

  function show(result: Found): void {
    found = result;
    // While shots are found, the list changes under a pointer that presses one of them.
    changeUnpressed(list, () => showFound(result));
    countPots(result);
  }

  function showFound({ plays, done, elapsed }: Found): void {
    const focused = [...list.querySelectorAll(".line")].indexOf(document.activeElement!);
    hidePreview(store);
    list.replaceChildren(...plays.map((line, index) => lineItem(line, index, plays)));
    delete list.dataset.stale;
    list.dataset.done = String(done);
    list.dataset.elapsed = String(Math.round(elapsed));
    list.querySelectorAll<HTMLElement>(".line")[focused]?.focus();
    const samples = plays[0]?.samples ?? 0;
    setText(
      status,
      plays.length === 0
        ? t("lines.none")
        : done
          ? t("lines.done", { samples, seconds: decimal(elapsed / 1000, 1) })
          : t("lines.searching"),
    );
  }

  function lineItem(
    line: Recommendation,
    index: number,
    all: readonly Recommendation[],
  ): HTMLElement {
    const { play, kept, foul, win_chance: win } = line;
    const { geometry, balls } = store.shot;
    const cue = store.document.shot.strike.ball;
    // A single player keeps the turn with every shot, makes no foul and wins nothing: there the pot counts.
    const alone = isForOne(engine, rules.value);
    const facts = alone
      ? h("span", { class: "facts" }, potFact(line))
      : h(
          "span",
          { class: "facts" },
          fact(
            t(line.ball === null ? "lines.kept" : "lines.pot-chance"),
            percent(kept.probability),
          ),
          fact(t("lines.foul"), percent(foul.probability)),
          fact(t("lines.win"), percent(win)),
        );
    const button = h(
      "button",
      {
        type: "button",
        class: "line",
        onclick: () => {
          hidePreview(store);
          if (aimLine(store, line)) context.announce(t("lines.aimed", { line: lineText(line) }));
        },
        onpointerenter: () => preview(line),
        onpointerleave: () => hidePreview(store),
        onfocus: () => preview(line),
        onblur: () => hidePreview(store),
      },
      h(
        "span",
        { class: "said" },
        h("strong", {}, whatText(line)),
        h("span", { class: "hint" }, strikeText(play.strike)),
        facts,
        h("span", { class: "unseen" }, leaveText(line)),
      ),
      leavePicture(geometry, balls, cue, line, isLying()),
    );
    return h("li", {}, button, ...(all.length > 1 ? why(line, index, all) : []));
  }

  /** The chance of a line's pot, counted; empty until it is known, and for a line without a pot. */
  function potFact(line: Recommendation): HTMLElement | false {
    if (line.ball === null || line.pocket === null) return false;
    const chance = potChances.get(line.play);
    return fact(t("lines.pot-chance"), chance === undefined ? "…" : percent(chance));
  }

  /** Counts the pots of the lines, one after the other. */
  function countPots({ plays, position, done }: Found): void {
    if (!done || !isForOne(engine, position.rules)) return;
    const line = plays.find(({ ball, play }) => ball !== null && !potChances.has(play));
    if (line?.ball == null || line.pocket === null) return;
    const { ball, pocket, play } = line;
    desk.ask(
      {
        kind: "chance",
        noise: position.noise,
        count: POTS,
        of: { shot: JSON.stringify(shotOf(store.document.shot, play)), ball, pocket },
      },
      {
        part: ({ met, count }) => count === POTS && potChances.set(play, met / count),
        done: () => {
          if (found?.plays === plays) show(found);
        },
      },
    );
  }

  /** Whether the table lies on the screen, as in a wide window. */
  function isLying(): boolean {
    const { size } = store.shot.geometry;
    const [from, to] = [
      context.viewer.project(0, 0, 0),
      context.viewer.project(0, size?.[1] ?? 1, 0),
    ];
    return from !== null && to !== null && Math.abs(to[0] - from[0]) > Math.abs(to[1] - from[1]);
  }

  function preview(line: Recommendation): void {
    if (!isWanted() || list.dataset.stale) return;
    const shot = readShot(engine, store.document.shot, line.play);
    const outline = ellipseOf(line);
    if (shot) showShot(store, shot, outline ? [{ outline, color: STOP }] : []);
  }

  function showSettings(position: Position | null): void {
    const inGame = store.document.game !== null;
    const { noise } = store.document;
    own.hidden = noise === null;
    levelRow.hidden = noise !== null;
    rulesRow.hidden = inGame;
    level.value = store.session.analysis.level;
    const games = position?.games ?? [];
    if (rules.dataset.games !== games.join()) {
      rules.dataset.games = games.join();
      rules.replaceChildren(...games.map((name) => h("option", { value: name }, rulesName(name))));
    }
    rules.disabled = games.length === 0;
    rules.value = position?.rules ?? "";
  }

  store.subscribe((now, before) => {
    if (matters(now, before)) follow();
    else if (found && now.session.turn !== before.session.turn) show(found);
  });
  new MutationObserver(follow).observe(root, { attributeFilter: ["hidden"] });
  follow();
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

/** The button that compares a line with the best one, or the best one with the second. */
function why(
  line: Recommendation,
  index: number,
  all: readonly Recommendation[],
): readonly HTMLElement[] {
  const other = index === 0 ? 1 : 0;
  const text = h("p", { class: "why", id: uniqueId("why"), hidden: true });
  const button = h(
    "button",
    {
      type: "button",
      class: "button plain ask",
      "aria-expanded": "false",
      "aria-controls": text.id,
      "aria-label": t("why.ask", { a: Math.min(index, other) + 1, b: Math.max(index, other) + 1 }),
      onclick: () => {
        text.hidden = !text.hidden;
        button.setAttribute("aria-expanded", String(!text.hidden));
        const [first, second] = index === 0 ? [line, all[1]!] : [all[0]!, line];
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

function labelled(text: string, select: HTMLSelectElement): HTMLElement {
  return h("div", { class: "labelled" }, h("label", { for: select.id }, text), select);
}
