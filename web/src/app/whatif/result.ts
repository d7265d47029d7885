/** The chance of each ball to be pocketed, from the variants. */

import { h, setText, uniqueId } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { ballName, sentence } from "../common/words.ts";
import type { VariantsProgress } from "./client.ts";
import { type Chance, chanceInWords } from "./statistics.ts";
import type { Tally } from "./tally.ts";

/** Time (ms) without a change after which the result is read to screen readers. */
const REST = 1000;

export function mountResult(
  root: HTMLElement,
): (progress: VariantsProgress | string | null, store: Store) => void {
  const heading = h("h2", { id: uniqueId("chances") }, "Chance to be pocketed");
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
        h("th", { scope: "col" }, "Ball"),
        h("th", { scope: "col" }, "Chance to be pocketed"),
      ),
    ),
    body,
  );
  const notes = h("p", { class: "notes" });
  const bar = h("progress", { max: 1, "aria-label": "Variants simulated" });
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
    setText(notes, notesOf(tally, store).join(" "));
    bar.value = tally.count / tally.total;
    bar.hidden = done;
    setText(count, done ? `${tally.count} variants in ${elapsed.toFixed(0)} ms` : "Simulating …");
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
    name: index === struck ? `${ballName(id)} (scratch)` : ballName(id),
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
      ? [sentence(`${ballName(id)} leaves the table: ${chanceInWords(off)}`)]
      : [];
  });
  if (tally.failed > 0) {
    notes.push(
      `${tally.failed} of ${tally.count} variants could not be played and count as nothing pocketed: ` +
        (tally.reason ?? ""),
    );
  }
  return notes;
}

/** The most likely balls in a sentence. */
function inSentence(rows: readonly Row[]): string {
  const likely = rows.filter(({ chance }) => chance.hits > 0).slice(0, 3);
  if (likely.length === 0) return "No ball is pocketed in any variant.";
  return `Chance to be pocketed: ${likely.map(({ name, chance }) => `${name} ${chanceInWords(chance)}`).join(", ")}.`;
}
