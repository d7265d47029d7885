/** The chance of each ball to be pocketed, from the variants. */

import type { Shot } from "../../engine/index.ts";
import { arc } from "../common/arc.ts";
import { h, setText, uniqueId } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { refusalText } from "../common/refusals.ts";
import { distinctNames } from "../common/shot-words.ts";
import type { VariantsProgress } from "./variants-client.ts";
import { type Chance, chanceInWords } from "./chance-statistics.ts";
import type { Tally } from "./variant-tally.ts";
import { decimal, paragraph, sentence, t } from "../words/translate.ts";

/** The ring around the ball of a row: its radius, ball radii, and its colour. */
const RING = 2;
const RING_COLOR = "#ffffff";

/** Time (ms) without a change after which the result is read to screen readers. */
const REST = 1000;

export function mountResult(
  root: HTMLElement,
): (progress: VariantsProgress | string | null, store: Store) => void {
  const heading = h("h2", { id: uniqueId("chances") }, t("chance.heading"));
  const body = h("tbody");
  const table = h(
    "table",
    { class: "chances", "aria-labelledby": heading.id },
    h(
      "thead",
      { class: "unseen" },
      h(
        "tr",
        {},
        h("th", { scope: "col" }, t("chance.ball")),
        h("th", { scope: "col" }, t("chance.heading")),
      ),
    ),
    body,
  );
  const notes = h("p", { class: "notes" });
  const bar = h("progress", { max: 1, "aria-label": t("chance.simulated") });
  const count = h("p", { class: "hint", id: "variants" });
  const spoken = h("p", { class: "unseen", role: "status", "aria-live": "polite" });
  root.append(heading, table, notes, bar, count, spoken);
  let resting: ReturnType<typeof setTimeout> | undefined;
  let shown: { readonly store: Store; readonly rows: readonly Row[] } | null = null;
  // The rows are replaced while variants are simulated: the table itself listens.
  body.addEventListener("pointerover", ({ target }) => {
    const row = (target as Element).closest("tr");
    const ball = shown?.rows[row ? row.sectionRowIndex : -1]?.ball;
    if (shown && ball !== undefined) ringBall(shown.store, ball);
  });
  body.addEventListener("pointerleave", () => {
    shown?.store.setPart("analysis", { preview: null });
  });

  return (progress, store) => {
    clearTimeout(resting);
    table.hidden = bar.hidden = typeof progress === "string";
    if (typeof progress === "string" || !progress) {
      setText(notes, progress ?? "");
      setText(count, "");
      return;
    }
    const { tally, done, elapsed } = progress;
    const rows = rowsOf(tally, store);
    body.replaceChildren(...rows.map(rowElement));
    shown = { store, rows };
    setText(notes, paragraph(notesOf(tally, store)));
    bar.value = tally.count / tally.total;
    bar.hidden = done;
    const milliseconds = decimal(elapsed, 0);
    const counted = { count: tally.count, milliseconds };
    setText(count, done ? t("chance.count", counted) : t("chance.simulating"));
    count.dataset.done = String(done);
    if (done) resting = setTimeout(() => setText(spoken, inSentence(rows)), REST);
  };
}

/** Shows on the table which ball a row is about. */
function ringBall(store: Store, index: number): void {
  const ball = store.shot.balls[index];
  if (!ball) return;
  const [x, y] = ball.position;
  const area = { outline: arc([x, y], RING * ball.radius), color: RING_COLOR };
  store.setPart("analysis", { preview: { trace: null, areas: [area] } });
}

interface Row {
  readonly ball: number;
  readonly name: string;
  readonly chance: Chance;
}

/** The struck ball first, for its scratch; then the other balls by chance. */
function rowsOf(tally: Tally, store: Store): Row[] {
  const { struck } = store.shot;
  const rows = namesOf(store.shot).map((name, index) => ({
    ball: index,
    name: index === struck ? t("chance.scratch", { ball: name }) : name,
    chance: tally.pocketed(index),
    first: index === struck,
  }));
  return rows.sort((a, b) => Number(b.first) - Number(a.first) || b.chance.value - a.chance.value);
}

function namesOf({ balls, struck }: Shot): string[] {
  const ids = balls.map(({ id }) => id);
  return distinctNames(ids, struck === null ? null : ids[struck]!);
}

function rowElement({ name, chance }: Row): HTMLTableRowElement {
  const bar = h("div", { class: "bar" });
  bar.style.setProperty("--share", String(chance.value));
  return h(
    "tr",
    {},
    h("th", { scope: "row" }, name),
    h("td", {}, bar, h("span", {}, chanceInWords(chance))),
  );
}

function notesOf(tally: Tally, { shot }: Store): string[] {
  const notes = namesOf(shot).flatMap((ball, index) => {
    const off = tally.off(index);
    return off.hits > 0 ? [sentence(t("chance.off", { ball, chance: chanceInWords(off) }))] : [];
  });
  if (tally.reason) {
    notes.push(
      t("chance.failed", {
        failed: tally.failed,
        count: tally.count,
        why: refusalText(tally.reason),
      }),
    );
  }
  return notes;
}

/** The most likely balls in a sentence. */
function inSentence(rows: readonly Row[]): string {
  const likely = rows.filter(({ chance }) => chance.hits > 0).slice(0, 3);
  if (likely.length === 0) return t("chance.none");
  const balls = likely.map(({ name, chance }) =>
    t("chance.of-ball", { ball: name, chance: chanceInWords(chance) }),
  );
  return t("chance.likely", { balls: balls.join(", ") });
}
