/** What the variants say: how likely each ball drops. */

import { h, setText, uniqueId } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { ballName, sentence } from "../common/words.ts";
import type { Progress } from "./client.ts";
import { type Chance, chanceInWords } from "./statistics.ts";
import type { Tally } from "./tally.ts";

/** How long (ms) a result stands before it is told: while one drags, nothing is. */
const TELL_AFTER = 1000;

export function mountResult(
  root: HTMLElement,
): (progress: Progress | string | null, store: Store) => void {
  const heading = h("h2", { id: uniqueId("chances") }, "Chance to drop");
  const body = h("tbody");
  const table = h(
    "table",
    { class: "chances", "aria-labelledby": heading.id },
    h(
      "thead",
      { class: "unseen" },
      h("tr", {}, h("th", { scope: "col" }, "Ball"), h("th", { scope: "col" }, "Chance to drop")),
    ),
    body,
  );
  const notes = h("p", { class: "notes" });
  const bar = h("progress", { max: 1, "aria-label": "Variants simulated" });
  const count = h("p", { class: "hint", id: "variants" });
  const aloud = h("p", { class: "unseen", role: "status", "aria-live": "polite" });
  root.append(heading, table, notes, bar, count, aloud);
  let telling: ReturnType<typeof setTimeout> | undefined;

  return (progress, store) => {
    clearTimeout(telling);
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
    if (done) telling = setTimeout(() => setText(aloud, told(rows)), TELL_AFTER);
  };
}

interface Row {
  readonly name: string;
  readonly chance: Chance;
}

/** The struck ball first (a scratch is what one wants to know), then the likeliest. */
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
      `${tally.failed} of ${tally.count} could not be played and count as nothing dropped: ` +
        (tally.reason ?? ""),
    );
  }
  return notes;
}

/** In a sentence: the likeliest balls. */
function told(rows: readonly Row[]): string {
  const likely = rows.filter(({ chance }) => chance.hits > 0).slice(0, 3);
  if (likely.length === 0) return "No ball drops in any variant.";
  return `Chance to drop: ${likely.map(({ name, chance }) => `${name} ${chanceInWords(chance)}`).join(", ")}.`;
}
