/** Reads shot files and traces, and gives a shot without a strike one to aim with. */

import { CaromError, type BallEntry, type Engine, type Noise } from "../../engine/index.ts";
import type { ShotFile, StrikeEntry, Trace } from "../../engine/index.ts";
import { detailedText, PageError } from "../common/refusals.ts";
import type { AimedShot, Document } from "./document.ts";
import { type Filmed, splitFilm } from "./filmed.ts";
import { t } from "../words/translate.ts";

/** The strike of a shot whose file has none: a soft shot along the table. */
const DEFAULT_STRIKE: Omit<StrikeEntry, "ball"> = { speed: 2, azimuth_deg: 90 };

/** The shot with a strike; a file without one gets a strike on its cue ball, or else its first ball. */
export function aimed(file: ShotFile): AimedShot {
  if (file.strike) return { ...file, strike: file.strike };
  const cue = file.balls.find((ball) => ball.id === "cue") ?? file.balls[0];
  return { ...file, strike: { ball: cue?.id ?? "", ...DEFAULT_STRIKE } };
}

/** A document about a shot file, outside a game. */
export function documentOf(file: ShotFile, noise: Noise | null = null, seed = 0): Document {
  return { shot: aimed(file), noise, seed, game: null };
}

/** What a file contains. */
export interface FileContents {
  readonly shot: AimedShot;
  /** The trace that is replayed first; null: the page opens for aiming. */
  readonly trace: Trace | null;
  /** What a camera saw of the shot. */
  readonly filmed: Filmed | undefined;
}

/**
 * Reads a shot file or a trace.
 *
 * @throws CaromError if the engine refuses it, SyntaxError if it is not JSON.
 */
export function readFile(engine: Engine, json: string): FileContents {
  const format = formatOf(json);
  if (format === "carom-trace/1") {
    const trace = engine.trace(json);
    return { trace, ...contents(startOf(trace.shot.file)) };
  }
  const shot = engine.shot(json);
  const file = shot.source;
  const moving = file.balls.some((ball) => ball.velocity ?? ball.angular_velocity);
  if (!moving || file.strike) return { trace: null, ...contents(aimed(file)) };
  // A cue cannot strike balls that already move: show the replay, and aim where the balls started.
  return { trace: shot.simulate(), ...contents(startOf(file)) };
}

function contents(file: AimedShot): Pick<FileContents, "shot" | "filmed"> {
  const { shot, filmed } = splitFilm(file);
  return { shot, filmed };
}

/**
 * The format that a file names; undefined if it names none.
 *
 * @throws PageError for another format or no object, SyntaxError if it is not JSON.
 */
function formatOf(json: string): string | undefined {
  const file = JSON.parse(json) as { readonly format?: unknown } | null;
  const isObject = typeof file === "object" && file !== null && !Array.isArray(file);
  if (!isObject) throw new PageError(t("error.not-json"), "");
  const { format } = file;
  if (format === undefined || format === "carom-shot/1" || format === "carom-trace/1")
    return format;
  const isOurs = typeof format === "string" && /^carom-(shot|trace|frame)\//.test(format);
  throw new PageError(t(isOurs ? "error.other-version" : "error.not-json"), "format");
}

/** Why a file with this text cannot be opened, as a sentence. */
export function cannotOpen(error: unknown, text: string): string {
  const why =
    error instanceof SyntaxError ? t("error.not-json") : detailedText(error, ballsIn(text));
  return t("error.file", { why });
}

/** The balls in a text that may be a shot or a trace; none if it is neither. */
function ballsIn(text: string): readonly { readonly id?: unknown }[] {
  try {
    const file = JSON.parse(text) as { readonly shot?: unknown; readonly balls?: unknown } | null;
    const { balls } = (file?.shot ?? file) as { readonly balls?: unknown };
    return ballsOf(balls);
  } catch {
    return [];
  }
}

/** Entries of balls that the engine has not checked. */
export function ballsOf(balls: unknown): readonly { readonly id?: unknown }[] {
  if (!Array.isArray(balls)) return [];
  return balls.map((ball: unknown) => (typeof ball === "object" && ball !== null ? ball : {}));
}

/** The balls of a file at their first positions, at rest. */
function startOf(file: ShotFile): AimedShot {
  const balls = file.balls.map((ball) => {
    const still: { -readonly [K in keyof BallEntry]: BallEntry[K] } = { ...ball };
    delete still.velocity;
    delete still.angular_velocity;
    delete still.rolling;
    return file.strike ? ball : still;
  });
  return aimed({ ...file, balls });
}

/** Whether the engine accepts a shot file. */
export function accepts(engine: Engine, file: ShotFile): boolean {
  try {
    engine.shot(file).free();
    return true;
  } catch (error) {
    if (error instanceof CaromError) return false;
    throw error;
  }
}
