/** The help dialog: what the page can do, and all keys. */

import licenses from "../../../../LICENSE-THIRD-PARTY?raw";
import { h } from "../common/dom.ts";
import { KEYS } from "../input/keys.ts";

const TOPICS: readonly (readonly [string, string])[] = [
  [
    "Pot",
    "Tap a ball, then a pocket. The aim stays solved while you change speed, spin and elevation.",
  ],
  [
    "Aim",
    "Drag on the cloth to turn the cue; it clicks into pots. Or tap the cloth to aim at that point.",
  ],
  [
    "Strike",
    "Click the ball under Aim to place the tip: English, follow or draw. Set speed, elevation and direction beside it.",
  ],
  [
    "Look ahead",
    "While you aim, the page simulates the whole shot, draws the paths of the balls, and describes the outcome below the table.",
  ],
  ["Shoot", "Plays the shot. “Take it from here” continues from where the balls stop."],
  [
    "Move balls",
    "Drag a ball to move it. At a place that is not allowed it turns red, the page gives the reason, and the ball goes back.",
  ],
  [
    "Play a game",
    "Under Game two players play a frame with a referee. Tap a ball and a pocket to call them. Undo also takes back shots.",
  ],
  [
    "Everything else",
    "Layout has racks, tables and balls; Physics has the models and their coefficients.",
  ],
];

/** @returns A function that opens the help. */
export function mountHelp(dialog: HTMLDialogElement, showSteps: () => void): () => void {
  const close = () => {
    dialog.close();
  };
  const title = h("h2", { id: "help-title", tabindex: -1 }, "How to use this table");
  dialog.append(
    title,
    h(
      "dl",
      { class: "ways" },
      ...TOPICS.flatMap(([term, text]) => [h("dt", {}, term), h("dd", {}, text)]),
    ),
    h("h2", {}, "Keys"),
    h("p", { class: "hint" }, "Arrow keys, Enter and Space work while the table has the focus."),
    h(
      "dl",
      { class: "keys" },
      ...KEYS.flatMap(({ shown, help }) => [
        h("dt", {}, ...shown.map((key) => h("kbd", {}, key))),
        h("dd", {}, help),
      ]),
    ),
    h(
      "details",
      { class: "licenses" },
      h("summary", {}, "Software inside this page, and its licenses"),
      h("pre", { tabindex: 0, "aria-label": "Licenses" }, licenses),
    ),
    h(
      "div",
      { class: "row end" },
      h(
        "button",
        {
          type: "button",
          class: "button",
          onclick: () => {
            close();
            showSteps();
          },
        },
        "Show the first steps",
      ),
      h("button", { type: "button", class: "button primary", onclick: close }, "Close"),
    ),
  );
  return () => {
    dialog.showModal();
    // Browsers ignore the attribute `autofocus` in a frame of another origin.
    title.focus();
  };
}
