/** Undo and redo without limit over immutable states. Knows nothing of what the states are. */

interface Entry<T> {
  readonly state: T;
  /** What led to this state, for "Undo …". Empty for the first. */
  readonly label: string;
  /** Changes of one gesture carry one group and are one entry; null once the gesture is over. */
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

  /** What undo would take back, null if there is nothing. */
  get undoLabel(): string | null {
    return this.#past.length > 0 ? this.#present.label : null;
  }

  /** What redo would do again, null if there is nothing. */
  get redoLabel(): string | null {
    return this.#future.at(-1)?.label ?? null;
  }

  /** Makes `state` the present. Within one group only the last state is kept. */
  push(state: T, label: string, group: string | null = null): void {
    if (group === null || group !== this.#present.group) this.#past.push(this.#present);
    this.#present = { state, label, group };
    this.#future = [];
  }

  /** Ends the gesture: the next push is an entry of its own whatever its group. */
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
