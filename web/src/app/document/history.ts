/** Unlimited undo and redo over immutable states of any type. */

interface Entry<T> {
  readonly state: T;
  /** Name of the change that led to this state, for "Undo: …"; empty for the first state. */
  readonly label: string;
  /** Changes with the same group are one entry; null once the gesture is over. */
  readonly group: string | null;
}

/** A state with the name of the change that led to it. */
export interface Step<T> {
  readonly state: T;
  readonly label: string;
}

/** A whole history as plain values: the states in the order of time, and the index of the present one. */
export interface Steps<T> {
  readonly steps: readonly Step<T>[];
  readonly at: number;
}

export class History<T> {
  #past: Entry<T>[] = [];
  #present: Entry<T>;
  #future: Entry<T>[] = [];

  constructor(state: T) {
    this.#present = { state, label: "", group: null };
  }

  /** The history of some steps. */
  static of<T>({ steps, at }: Steps<T>): History<T> {
    const entries = steps.map(({ state, label }) => ({ state, label, group: null }));
    const history = new History(entries[at]!.state);
    history.#past = entries.slice(0, at);
    history.#present = entries[at]!;
    history.#future = entries.slice(at + 1).reverse();
    return history;
  }

  get steps(): Steps<T> {
    const all = [...this.#past, this.#present, ...[...this.#future].reverse()];
    return { steps: all.map(({ state, label }) => ({ state, label })), at: this.#past.length };
  }

  /**
   * Adds what was done before the first state.
   *
   * @param label Name of the change that led to the first state.
   * @param future What undo had taken back; it is dropped if something has changed since.
   */
  precede(past: readonly Step<T>[], label: string, future: readonly Step<T>[]): void {
    const entry = ({ state, label: name }: Step<T>) => ({ state, label: name, group: null });
    const isFirst = this.#past.length === 0;
    const first = isFirst ? this.#present : this.#past[0]!;
    const named = { ...first, label };
    if (isFirst) this.#present = named;
    else this.#past[0] = named;
    this.#past = [...past.map(entry), ...this.#past];
    if (isFirst && this.#future.length === 0) this.#future = [...future].reverse().map(entry);
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
