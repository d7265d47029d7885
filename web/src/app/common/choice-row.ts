/** A row of buttons of which one is chosen, for the keyboard and for screen readers. */

export interface Choice<Name> {
  readonly name: Name;
  readonly button: HTMLButtonElement;
}

const STEPS: Readonly<Record<string, number>> = {
  ArrowLeft: -1,
  ArrowUp: -1,
  ArrowRight: 1,
  ArrowDown: 1,
};

/**
 * Puts the buttons into `root`, whose role is radiogroup.
 *
 * @param choose Called when a button is pressed, and when an arrow key moves to it.
 * @returns A function that shows which one is chosen.
 */
export function mountChoice<Name extends string>(
  root: HTMLElement,
  choices: readonly Choice<Name>[],
  choose: (name: Name) => void,
): (chosen: Name) => void {
  for (const { name, button } of choices) {
    button.setAttribute("role", "radio");
    button.addEventListener("click", () => {
      choose(name);
    });
    root.append(button);
  }
  root.addEventListener("keydown", (event) => {
    const step = STEPS[event.key];
    if (step === undefined) return;
    const at = choices.findIndex(({ button }) => button === event.target);
    const next = choices[(at + step + choices.length) % choices.length]!;
    choose(next.name);
    next.button.focus();
    event.preventDefault();
  });
  return (chosen) => {
    for (const { name, button } of choices) {
      button.setAttribute("aria-checked", String(name === chosen));
      button.tabIndex = name === chosen ? 0 : -1;
    }
  };
}
