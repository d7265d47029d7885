/** What kind of error it is. The names stay from version to version; docs/errors.md explains each. */
export const ERROR_KINDS = [
  "syntax",
  "format",
  "missing",
  "unknown-key",
  "wrong-type",
  "unknown-name",
  "unknown-ball",
  "out-of-range",
  "wrong-count",
  "duplicate",
  "conflict",
  "mismatch",
  "changed",
  "wrong-table",
  "unsupported",
  "wrong-state",
  "busy",
  "stopped",
  "system",
  "ball-count",
  "duplicate-id",
  "overlap",
  "in-cushion",
  "over-pocket",
  "outside-table",
  "in-slate",
  "wrong-radius",
  "no-room",
  "moving",
  "not-on-cloth",
  "no-strike",
  "misses-ball",
  "miscue",
  "unreachable",
  "cue-obstructed",
  "too-many-events",
  "endless-motion",
  "no-play",
  "frame-over",
  "not-a-move",
  "not-a-choice",
  "no-call",
  "no-nomination",
  "not-called",
  "called-ball-down",
  "no-safety",
  "no-push-out",
  "wrong-nomination",
  "not-in-hand",
  "no-place",
  "outside-region",
  "touches-ball",
] as const;

export type ErrorKind = (typeof ERROR_KINDS)[number];

/** The parts of an error, as plain values. */
export interface Refusal {
  /** Place, fault and remedy in a sentence. */
  readonly message: string;
  /** `"other"` for an error whose message is all that it has. */
  readonly kind: ErrorKind | "other";
  /** Path in the input, such as `balls[3].position`; empty if the fault has no place in the input. */
  readonly place: string;
  /** What is wrong. */
  readonly fault: string;
  /** What to do about it; empty if `fault` says so already. */
  readonly remedy: string;
  /** The values of which `fault` speaks, such as the id of a ball. */
  readonly details: Readonly<Record<string, string | number>>;
  /** The shot file, JSON, if a simulation reached its cap of events; see `Engine.traceToCap`. */
  readonly shot: string | undefined;
}

/** A refusal of the engine. The message names the place, the fault and the remedy. */
export class CaromError extends Error implements Refusal {
  override readonly name = "CaromError";
  readonly kind: Refusal["kind"];
  readonly place: string;
  readonly fault: string;
  readonly remedy: string;
  readonly details: Refusal["details"];
  readonly shot: string | undefined;

  /** The message is made of the other parts if it is left out. */
  constructor(refusal: Pick<Refusal, "kind" | "fault"> & Partial<Refusal>) {
    const { kind, place = "", fault, remedy = "", details = {}, shot } = refusal;
    const where = place === "" ? "" : `${place}: `;
    const what = remedy === "" ? fault : `${fault}; ${remedy}`;
    super(refusal.message ?? where + what);
    this.kind = kind;
    this.place = place;
    this.fault = fault;
    this.remedy = remedy;
    this.details = details;
    this.shot = shot;
  }
}

/** The parts of an error. An error itself loses them on its way between threads. */
export function refusalOf(given: Refusal | Error): Refusal {
  const error = "kind" in given ? given : new CaromError({ kind: "other", fault: String(given) });
  const { message, kind, place, fault, remedy, details, shot } = error;
  return { message, kind, place, fault, remedy, details, shot };
}

/** The same error at another place, with another remedy if one is given. */
export function moved(error: Refusal, place: string, remedy = error.remedy): CaromError {
  const { kind, fault, details, shot } = error;
  return new CaromError({ kind, place, fault, remedy, details, shot });
}

/** @throws CaromError always. */
export function refuse(kind: ErrorKind, place: string, fault: string, remedy: string): never {
  throw new CaromError({ kind, place, fault, remedy });
}
