// What a link carries: the document, the view, and the instant of a replay.

import type { Noise, ShotFile } from "../../engine/types.ts";
import { FIRST_VIEW, type View } from "../document.ts";
import type { Game } from "../game/game.ts";
import type { State } from "../store.ts";
import { fromFragment, isLink, LinkError, toFragment } from "./link.ts";

/** The state of a page as it can be handed on. The shot is as yet unchecked: the engine does that. */
export interface Shared {
  readonly shot: ShotFile;
  readonly noise: Noise | null;
  readonly seed: number;
  /** Its moves are as yet unchecked as well. */
  readonly game: Game | null;
  readonly view: View;
  /** Time of the replay (s); null while aiming. */
  readonly time: number | null;
}

/** What may stand in a view; the first is what a link leaves out. */
const CHOICES: { readonly [K in keyof View]: readonly View[K][] } = {
  theme: ["auto", "light", "dark"],
  camera: ["top", "orbit", "cue"],
  units: ["m/s", "km/h", "mph"],
};

const SIGMAS: readonly (keyof Noise)[] = ["speed", "azimuth", "elevation", "side", "height"];

/**
 * The link's fragment, with its `#`.
 *
 * @param shot The shot as the engine has it: the document's may differ from it by a rounding.
 */
export function stateToFragment(shot: ShotFile, { document, view, session }: State): string {
  const keys = Object.keys(CHOICES) as (keyof View)[];
  const changed = keys.filter((key) => view[key] !== FIRST_VIEW[key]);
  return toFragment({
    shot,
    ...(document.noise && { noise: document.noise }),
    ...(document.seed !== 0 && { seed: document.seed }),
    ...(document.game && { game: document.game }),
    ...(changed.length > 0 && { view: Object.fromEntries(changed.map((key) => [key, view[key]])) }),
    ...(session.mode === "replay" && { time: session.time }),
  });
}

/**
 * What a fragment carries; null if it is no link.
 *
 * @throws {LinkError} It is damaged, or of another version.
 */
export function stateFromFragment(fragment: string): Shared | null {
  if (!isLink(fragment)) return null;
  const data = fromFragment(fragment);
  if (!isRecord(data) || !isRecord(data.shot)) throw new LinkError("This link carries no shot.");
  const { seed = 0, time = null } = data;
  return {
    shot: data.shot as unknown as ShotFile,
    noise: noiseOf(data.noise),
    seed: typeof seed === "number" && Number.isSafeInteger(seed) && seed >= 0 ? seed : 0,
    game: gameOf(data.game),
    view: viewOf(data.view),
    time: typeof time === "number" && time >= 0 ? time : null,
  };
}

function noiseOf(data: unknown): Noise | null {
  if (!isRecord(data)) return null;
  const entries = SIGMAS.map((key) => {
    const sigma = data[key];
    if (typeof sigma !== "number" || !(sigma >= 0)) {
      throw new LinkError(`The noise in this link has no sensible "${key}".`);
    }
    return [key, sigma] as const;
  });
  return Object.fromEntries(entries) as unknown as Noise;
}

/** A game in the shape that the page writes; whether its moves are allowed, the referee says. */
function gameOf(data: unknown): Game | null {
  if (data === undefined || data === null) return null;
  const isPair = (value: unknown, type: (one: unknown) => boolean) =>
    Array.isArray(value) && value.length === 2 && value.every(type);
  const isText = (value: unknown) => typeof value === "string";
  if (isRecord(data) && isRecord(data.setup) && Array.isArray(data.moves)) {
    const { rules, options, from, names, skills } = data.setup;
    const isSound =
      isText(rules) &&
      isRecord(options) &&
      (from === null || isRecord(from)) &&
      isPair(names, isText) &&
      isPair(skills, (skill) => skill === null || isText(skill)) &&
      (data.call === null || isRecord(data.call)) &&
      data.moves.every(isMove);
    if (isSound) return data as unknown as Game;
  }
  throw new LinkError("The game in this link is not one that this page can read.");
}

function isMove(move: unknown): boolean {
  if (!isRecord(move)) return false;
  return (
    typeof move.choice === "string" ||
    move.concede === true ||
    (isRecord(move.play) && isRecord(move.play.strike))
  );
}

/** Choices that this page does not know are its own first ones: a view is no reason to refuse. */
function viewOf(data: unknown): View {
  if (!isRecord(data)) return FIRST_VIEW;
  const known = Object.entries(CHOICES).filter(([key, choices]) =>
    (choices as readonly unknown[]).includes(data[key]),
  );
  return { ...FIRST_VIEW, ...Object.fromEntries(known.map(([key]) => [key, data[key]])) };
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
