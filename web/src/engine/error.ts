/** A refusal of the engine. The message names the place, the fault and the remedy. */
export class CaromError extends Error {
  override readonly name = "CaromError";
  /** Path in the input, such as `balls[3].position`; empty if the fault has no place in the input. */
  readonly place: string;
  /** The shot file, JSON, if a simulation reached its cap of events; see `Engine.traceToCap`. */
  readonly shot: string | undefined;

  constructor(message: string, place = "", shot?: string) {
    super(message);
    this.place = place;
    this.shot = shot;
  }
}
