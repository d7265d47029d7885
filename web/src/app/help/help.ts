/** The help: what one can do, and every key. */

import licenses from "../../../../LICENSE-THIRD-PARTY?raw";
import { h } from "../common/dom.ts";
import { KEYS } from "../input/keys.ts";

const WAYS: readonly (readonly [string, string])[] = [
  ["Aim", "Drag on the cloth to turn the cue around its ball, or tap the cloth to aim there."],
  ["Strike", "Click the ball’s face for the tip; speed, elevation and direction have fields."],
  [
    "Look ahead",
    "While you aim, the whole shot is simulated and drawn; what happens is said below.",
  ],
  ["Shoot", "Plays it. “Take it from here” goes on with the balls where they end."],
  [
    "Move balls",
    "Drag them. Where a ball cannot lie it turns red, the reason is said, and it goes back.",
  ],
  [
    "Play a game",
    "Under Game two people play a frame with a referee. Tap a ball and a pocket to call them; undo takes shots back.",
  ],
  [
    "Everything else",
    "Racks, tables and balls are under Layout; models and coefficients under Physics.",
  ],
];

/** @returns Opens the help. */
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
      ...WAYS.flatMap(([term, text]) => [h("dt", {}, term), h("dd", {}, text)]),
    ),
    h("h2", {}, "Keys"),
    h("p", { class: "hint" }, "Arrow keys, Enter and Space act while the table has the focus."),
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
    // Not by the attribute `autofocus`, which browsers refuse in a frame of another origin.
    title.focus();
  };
}
