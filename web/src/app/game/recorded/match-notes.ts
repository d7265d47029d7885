/** In the Game tab: what the record of a match has beside the game. */

import type { Engine, Strike } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { button, h, setText, svg } from "../../common/dom.ts";
import { round, speedIn, type SpeedUnit } from "../../common/units.ts";
import type { Game } from "../../document/stored-game.ts";
import type { Store } from "../../document/store.ts";
import { refereeText } from "../game-words.ts";
import { percent } from "../machine/machine-explanation.ts";
import { replayedMove, replayMove } from "../review/reviewed-shots.ts";
import { chanceSteps, EDGE, HEIGHT, type StepLine, stepLines, WIDTH } from "./chance-steps.ts";
import { noteAt, strikesAt } from "./intended-shots.ts";
import { hasMatch, showFrames } from "./match-list.ts";
import { decimal, sentence, t } from "../../words/translate.ts";

/** Mounts the section; it is hidden in games that are not frames of a match. */
export function mountNotes(root: HTMLElement, store: Store, context: Context): void {
  const text = h("p", { class: "hint" });
  const curve = h("div", { class: "chances" });
  const shot = h("div", {});
  const frames = button(t("recorded.frames"), () => showFrames(store, context));
  root.append(text, curve, shot, h("div", { class: "row" }, frames));
  const show = (): void => {
    const { game } = store.document;
    root.hidden = !game?.notes;
    if (!game?.notes) return;
    const { frame, end } = game.notes;
    const number = { number: frame + 1 };
    const why = end ? sentence(refereeText(end.why)) : t("recorded.no-end");
    setText(text, `${t("recorded.of-match", number)} ${why}`);
    frames.hidden = !hasMatch(store);
    const index = store.session.mode === "replay" ? replayedMove(store, context.engine) : null;
    curve.replaceChildren(...curveOf(game, index, store, context));
    const { units } = store.view;
    const strikes = index === null ? null : strikesTable(context.engine, game, index, units);
    shot.replaceChildren(...(strikes ? [strikes] : []));
  };
  store.subscribe((now, before) => {
    const isSame =
      now.document.game === before.document.game &&
      now.session.replay.trace === before.session.replay.trace &&
      now.session.mode === before.session.mode &&
      now.view.units === before.view.units;
    if (!isSame) show();
  });
  show();
}

/** The curve of the chances, and its legend. @param at The move that is replayed. */
function curveOf(game: Game, at: number | null, store: Store, context: Context): Node[] {
  const lines = stepLines(chanceSteps(game.notes!));
  if (lines.length === 0) return [];
  const name = game.setup.names[0];
  const isSplit = lines.some(({ by }) => by === "luck");
  const last = lines.at(-1)!;
  const said = t("recorded.curve", { name, from: percent(lines[0]!.from), to: percent(last.to) });
  return [
    h("p", { class: "hint" }, t(isSplit ? "recorded.split" : "recorded.expected", { name })),
    svg(
      "svg",
      { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": said },
      ...[HEIGHT - EDGE, HEIGHT / 2, EDGE].map((y) =>
        svg("line", { class: "axis", x1: EDGE, y1: y, x2: WIDTH - EDGE, y2: y }),
      ),
      ...lines.map((line) => stepOf(line, at, store, context)),
    ),
  ];
}

function stepOf(line: StepLine, at: number | null, store: Store, context: Context): SVGElement {
  const { index, by, x1, y1, x2, y2 } = line;
  const kind = index === at ? `${by} here` : by;
  const replay = (): void => replayMove(store, context.engine, index, context.reducedMotion());
  return svg(
    "g",
    { class: kind, onclick: replay },
    svg("title", {}, stepText(line)),
    svg("rect", { x: x1, y: 0, width: x2 - x1, height: HEIGHT }),
    svg("line", { x1, y1, x2, y2 }),
  );
}

function stepText({ index, by, from, to }: StepLine): string {
  const what = { number: index + 1, change: signed(to - from), chance: percent(to) };
  return t(`recorded.step-${by}`, what);
}

/** A change of a chance with its sign, in percent. */
function signed(change: number): string {
  return `${change < 0 ? "−" : "+"}${percent(Math.abs(change))}`;
}

/** The intention beside the execution of a move; null if it has only one strike. */
function strikesTable(engine: Engine, game: Game, index: number, unit: SpeedUnit): Node | null {
  const strikes = strikesAt(game, index);
  if (!strikes) return null;
  const heads = [
    unit,
    t("recorded.azimuth"),
    t("recorded.elevation"),
    t("recorded.side"),
    t("recorded.height"),
  ];
  const columns = heads.map((head) => h("th", { scope: "col" }, head));
  const row = (key: "intended" | "executed") =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, t(`recorded.${key}`)),
      ...numbersOf(strikes[key], engine.tip, unit).map((number) => h("td", {}, number)),
    );
  return h(
    "table",
    { class: "strikes" },
    h("thead", {}, h("tr", {}, h("td", {}), ...columns)),
    h("tbody", {}, row("intended"), row("executed")),
  );
}

/** Speed, azimuth, elevation, side and height as they are shown. */
function numbersOf(strike: Strike, tip: number, unit: SpeedUnit): string[] {
  const degrees = (angle: number) => (angle * 180) / Math.PI;
  return [
    speedIn(unit, strike.speed),
    degrees(strike.azimuth),
    degrees(strike.elevation),
    strike.side / tip,
    strike.height / tip,
  ].map((value) => decimal(round(value, 2), 2));
}

/** The chances of a move and the refused answers before it, as a line of the record; false without any. */
export function chancesAt(game: Game, index: number): HTMLElement | false {
  const note = noteAt(game, index);
  const said: string[] = [];
  if (note?.chance !== undefined) said.push(t("recorded.chance", { chance: percent(note.chance) }));
  if (note?.luck) {
    const [before, expected, after] = note.luck;
    const luck = { decision: signed(expected - before), luck: signed(after - expected) };
    said.push(t("recorded.luck", luck));
  }
  const refused = refusedBefore(game, index);
  if (refused > 0) said.push(t("recorded.refused", { count: refused }));
  return said.length > 0 && h("span", { class: "hint" }, said.join(" "));
}

/** How many answers were refused before the move was accepted. */
function refusedBefore(game: Game, index: number): number {
  const moves = game.notes?.moves ?? [];
  const at = moves.findIndex((note) => note.index === index);
  let count = 0;
  for (let k = at - 1; k >= 0 && moves[k]!.refused !== undefined; k--) count += 1;
  return count;
}
