/** Objects and errors of the WebAssembly module. */

import { CaromError, refusalOf } from "./error.ts";

/** Calls the engine and turns its refusal into a `CaromError`. */
export function checked<T>(call: () => T): T {
  try {
    return call();
  } catch (error) {
    if (error instanceof Error && "kind" in error) {
      throw new CaromError(refusalOf(error));
    }
    throw error;
  }
}

/**
 * A value for an own property of objects in WebAssembly's memory. `structuredClone` and `postMessage` cannot
 * copy a symbol, and their error has its text; without it they would make an empty object, silently.
 */
export function uncloneable(what: string, remedy: string): symbol {
  return Symbol(`${what} of the engine, which cannot be cloned: ${remedy}`);
}

/** An object in WebAssembly's memory, until it is freed. */
export class Handle<T extends { free(): void }> {
  readonly #kind: string;
  #object: T | null;

  /** @param kind What the object is, for the message after it was freed. */
  constructor(kind: string, object: T) {
    this.#kind = kind;
    this.#object = object;
  }

  /** @throws TypeError if the object was freed. */
  get object(): T {
    if (this.#object) return this.#object;
    throw new TypeError(
      `this ${this.#kind} was freed; call free() after its last use, or make a new ${this.#kind}`,
    );
  }

  /** The object, which its last call consumes. @throws TypeError if it was freed. */
  take(): T {
    const { object } = this;
    this.#object = null;
    return object;
  }

  free(): void {
    this.#object?.free();
    this.#object = null;
  }
}
