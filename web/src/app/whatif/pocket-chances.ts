/** The chance of each ball to be pocketed, from the variants. */

import { h, setText, uniqueId } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { refusalText } from "../common/refusals.ts";
import { playedName } from "../common/shot-words.ts";
import type { VariantsProgress } from "./variants-client.ts";
import { type Chance, chanceInWords } from "./chance-statistics.ts";
import type { Tally } from "./variant-tally.ts";
import { decimal, paragraph, sentence, t } from "../words/translate.ts";

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

interface Row {
  readonly name: string;
  readonly chance: Chance;
}

/** The struck ball first, for its scratch; then the other balls by chance. */
function rowsOf(tally: Tally, store: Store): Row[] {
  const { balls, struck } = store.shot;
  const rows = balls.map(({ id }, index) => ({
    name: index === struck ? t("chance.scratch", { ball: playedName(id) }) : playedName(id),
    chance: tally.pocketed(index),
    first: index === struck,
  }));
  return rows.sort((a, b) => Number(b.first) - Number(a.first) || b.chance.value - a.chance.value);
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
  const notes = shot.balls.flatMap(({ id }, index) => {
    const off = tally.off(index);
    return off.hits > 0
      ? [sentence(t("chance.off", { ball: playedName(id), chance: chanceInWords(off) }))]
      : [];
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
