/** What the engine refuses, in one sentence: the place, what is wrong there, what would be right. */
export class CaromError extends Error {
  override readonly name = "CaromError";
  /** Path in the input, such as `balls[3].position`; empty if there is none. */
  readonly place: string;
  /** The shot file, JSON, where a simulation reached its cap of events. */
  readonly shot: string | undefined;

  constructor(message: string, place = "", shot?: string) {
    super(message);
    this.place = place;
    this.shot = shot;
  }
}
