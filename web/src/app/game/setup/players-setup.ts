/** The players in the set-up: their names, and whether a person or a machine plays. */

import type { Engine, Seat } from "../../../engine/index.ts";
import type { Context } from "../../common/context.ts";
import { h, uniqueId } from "../../common/dom.ts";
import { levelName } from "../../common/preset-names.ts";
import { LONGEST_NAME, type Pair, type Setup } from "../../document/stored-game.ts";
import { LEVELS, machineName } from "../machine/machine-levels.ts";
import { isForOne } from "../game-words.ts";
import { t } from "../../words/translate.ts";
import { label, labelled, select } from "./setup-controls.ts";

/** The players as the form has them. */
export interface Players {
  readonly setup: Pick<Setup, "names" | "skills" | "machines">;
  /** The player at this page, if the other one is a friend. */
  readonly here: Seat | undefined;
}

/** Value of the list entry for a friend at another page. */
const FRIEND = "friend";

/** The second player at first: the level of a club player. */
const USUAL_OPPONENT: (typeof LEVELS)[number] = "level-3";

interface Row {
  readonly name: HTMLInputElement;
  readonly by: HTMLSelectElement;
  readonly errors: HTMLSelectElement;
}

/** @returns Reads the players, and shows those of a game. */
export function mountPlayers(
  root: HTMLElement,
  { engine }: Context,
): { readonly read: () => Players; readonly show: (rules: string) => void } {
  const rows = [rowOf(engine, 0), rowOf(engine, 1)] as const;
  const names = rows.map(({ name, by }, player) =>
    h(
      "div",
      { class: "seat" },
      labelled(t("setup.player", { number: player + 1 }), name),
      labelled(t("setup.played-by"), by),
    ),
  );
  const errors = rows.map(({ errors }, player) => {
    const text = t("setup.errors-of", { player: t("setup.player", { number: player + 1 }) });
    return h("div", { class: "labelled" }, label(errors, text), errors);
  });
  const details = h(
    "details",
    {},
    h("summary", {}, t("setup.persons")),
    ...errors,
    h("p", { class: "hint" }, t("setup.errors-hint")),
  );
  root.append(h("h2", {}, t("setup.players")), ...names, details);

  let rules = "";
  const show = (): void => {
    const present = rows.map((_, player) => player === 0 || !isForOne(engine, rules));
    names.forEach((row, player) => (row.hidden = !present[player]));
    errors.forEach((row, player) => (row.hidden = !present[player] || isMachine(rows[player]!)));
    details.hidden = errors.every((row) => row.hidden);
  };
  rows.forEach(({ name, by }, player) => {
    let usual = name.value;
    by.addEventListener("change", () => {
      const next = usualName(player, by.value);
      if (name.value === usual) name.value = next;
      usual = next;
      // A friend plays against the person at this page.
      const opponent = rows[1 - player]!.by;
      if (by.value === FRIEND && opponent.value !== "") setTo(opponent, "");
      else if (isMachine(rows[player]!) && opponent.value === FRIEND) setTo(opponent, "");
      show();
    });
  });
  // Somebody alone wants an opponent.
  setTo(rows[1].by, USUAL_OPPONENT);
  return {
    show: (shown) => {
      rules = shown;
      show();
    },
    read: () => playersOf(rows, isForOne(engine, rules)),
  };
}

function rowOf(engine: Engine, player: Seat): Row {
  const by = select([
    ["", t("setup.person")],
    [FRIEND, t("setup.friend")],
    ...LEVELS.map((level): [string, string] => [level, machineName(level)]),
  ]);
  const levels = Object.keys(engine.noisePresets);
  const errors = select([
    ["", t("setup.no-errors")],
    ...levels.map((level): [string, string] => [level, levelName(level)]),
  ]);
  return { name: nameField(player), by, errors };
}

/** @param isAlone Whether the game is for one player. */
function playersOf(rows: readonly [Row, Row], isAlone: boolean): Players {
  const pair = <T>(read: (row: Row, player: number) => T): Pair<T> => [
    read(rows[0], 0),
    read(rows[1], 1),
  ];
  const machines = pair((row) => (isMachine(row) ? row.by.value : null));
  const friend = rows.findIndex(({ by }) => by.value === FRIEND);
  return {
    setup: {
      names: pair(({ name, by }, player) => name.value.trim() || usualName(player, by.value)),
      skills: pair((row) => (isMachine(row) ? null : row.errors.value || null)),
      ...(machines.some(Boolean) && { machines }),
    },
    here: friend < 0 || isAlone ? undefined : friend === 0 ? 1 : 0,
  };
}

function isMachine({ by }: Row): boolean {
  return by.value !== "" && by.value !== FRIEND;
}

/** Chooses an entry as if the user did. */
function setTo(list: HTMLSelectElement, value: string): void {
  list.value = value;
  list.dispatchEvent(new Event("change"));
}

function usualName(player: number, level: string): string {
  if (level === "" || level === FRIEND) return t("setup.player", { number: player + 1 });
  return t("machine.name", { level: level.replace(/^\D+/, "") });
}

function nameField(player: number): HTMLInputElement {
  return h("input", {
    type: "text",
    id: uniqueId("name"),
    value: usualName(player, ""),
    maxlength: LONGEST_NAME,
    autocomplete: "off",
  });
}
