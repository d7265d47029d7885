/** The marks of a photo as buttons, for the keyboard and for screen readers. The pointer passes through. */

import type { Point } from "../../engine/index.ts";
import { ballText, fill, TEXTS } from "../texts.ts";
import type { Session } from "../photo-session.ts";
import { element } from "./element.ts";
import type { Stage } from "./photo-stage.ts";

/** A landmark by its index, or a ball by its id. */
export type Mark = { readonly landmark: number } | { readonly ball: string };

/** Steps of the arrow keys, pixels of the photo: alone, and with Shift. */
const STEP = 1;
const LONG_STEP = 10;

/** The step (pixels of the photo) of an arrow key; null for other keys. */
export function arrow(event: KeyboardEvent): Point | null {
  const step = event.shiftKey ? LONG_STEP : STEP;
  const steps: Readonly<Record<string, Point>> = {
    ArrowLeft: [-step, 0],
    ArrowRight: [step, 0],
    ArrowUp: [0, -step],
    ArrowDown: [0, step],
  };
  return steps[event.key] ?? null;
}

export interface HandleActions {
  nudge(mark: Mark, step: Point): void;
  remove(mark: Mark): void;
  confirm(mark: Mark): void;
  select(mark: Mark): void;
  blur(): void;
}

export class Handles {
  readonly root: HTMLElement;
  readonly #actions: HandleActions;
  readonly #buttons = new Map<string, HTMLButtonElement>();

  constructor(actions: HandleActions) {
    this.#actions = actions;
    this.root = element("div", { class: "photo-handles" });
  }

  /** Updates the buttons; those that stay keep the focus. */
  show(stage: Stage, { draft }: Session): void {
    const wanted = new Map<string, { mark: Mark; pixel: Point; label: string }>();
    draft.landmarks.forEach((pixel, landmark) => {
      const label = fill(TEXTS.landmark, { number: landmark + 1 });
      wanted.set(`landmark ${landmark}`, { mark: { landmark }, pixel, label });
    });
    for (const { id, pixel, suggested } of draft.balls) {
      const label = fill(suggested ? TEXTS.suggestedHandle : TEXTS.handle, { ball: ballText(id) });
      wanted.set(`ball ${id}`, { mark: { ball: id }, pixel, label });
    }
    for (const [key, made] of this.#buttons) {
      if (wanted.has(key)) continue;
      made.remove();
      this.#buttons.delete(key);
    }
    for (const [key, { mark, pixel, label }] of wanted) {
      const made = this.#buttons.get(key) ?? this.#create(key, mark, label);
      made.setAttribute("aria-label", label);
      const [x, y] = stage.place(pixel);
      made.style.transform = `translate(${x}px, ${y}px)`;
    }
  }

  #create(key: string, mark: Mark, label: string): HTMLButtonElement {
    const made = element("button", { type: "button", class: "photo-handle", "aria-label": label });
    made.addEventListener("focus", () => this.#actions.select(mark));
    made.addEventListener("blur", () => this.#actions.blur());
    made.addEventListener("keydown", (event) => {
      const step = arrow(event);
      if (step) this.#actions.nudge(mark, step);
      else if (event.key === "Enter") this.#actions.confirm(mark);
      else if (event.key === "Delete" || event.key === "Backspace") this.#actions.remove(mark);
      else return;
      event.preventDefault();
    });
    this.#buttons.set(key, made);
    this.root.append(made);
    return made;
  }
}
