/** Unlimited undo and redo over immutable states of any type. */

interface Entry<T> {
  readonly state: T;
  /** Name of the change that led to this state, for "Undo: …"; empty for the first state. */
  readonly label: string;
  /** Changes with the same group are one entry; null once the gesture is over. */
  readonly group: string | null;
}

export class History<T> {
  #past: Entry<T>[] = [];
  #present: Entry<T>;
  #future: Entry<T>[] = [];

  constructor(state: T) {
    this.#present = { state, label: "", group: null };
  }

  get present(): T {
    return this.#present.state;
  }

  /** Name of the change that undo would take back; null if there is none. */
  get undoLabel(): string | null {
    return this.#past.length > 0 ? this.#present.label : null;
  }

  /** Name of the change that redo would repeat; null if there is none. */
  get redoLabel(): string | null {
    return this.#future.at(-1)?.label ?? null;
  }

  /** Adds a state. It replaces the present one if both have the same group. */
  push(state: T, label: string, group: string | null = null): void {
    if (group === null || group !== this.#present.group) this.#past.push(this.#present);
    this.#present = { state, label, group };
    this.#future = [];
  }

  /** Replaces the present state; undo then takes back both changes. */
  amend(state: T): void {
    this.#present = { ...this.#present, state };
    this.#future = [];
  }

  /** Ends the gesture: the next state becomes an entry of its own, whatever its group. */
  settle(): void {
    this.#present = { ...this.#present, group: null };
  }

  undo(): boolean {
    const before = this.#past.pop();
    if (!before) return false;
    this.#future.push(this.#present);
    this.#present = { ...before, group: null };
    return true;
  }

  redo(): boolean {
    const next = this.#future.pop();
    if (!next) return false;
    this.#past.push(this.#present);
    this.#present = { ...next, group: null };
    return true;
  }
}
