/** Updates the viewer from the state. No other module changes what the viewer shows, except films. */

import type { Call, Engine, FilmedBall, Strike, Trace } from "../engine/index.ts";
import { STRIDE } from "../engine/types.ts";
import type { Area, BallPath, CuePose, Density, Mark, Viewer } from "../viewer/index.ts";
import { VERTEX } from "../viewer/viewer-types.ts";
import { stopHandle } from "./analyse/stop-handle.ts";
import type { Context } from "./common/context.ts";
import type { AimedShot, Attempt, Session } from "./document/document.ts";
import { areasOf } from "./game/game-areas.ts";
import { awaitedMark } from "./draw/draw-keys.ts";
import { filmOf } from "./document/filmed.ts";
import type { Game, Guide } from "./document/stored-game.ts";
import { shownGuide } from "./document/guide-extent.ts";
import { shortPaths } from "./game/guide/short-paths.ts";
import { shownContact } from "./game/guide/shown-contact.ts";
import { intendedTrace } from "./game/recorded/intended-shots.ts";
import { presentCall } from "./game/calling.ts";
import { canAim, standing } from "./game/awaited-turn.ts";
import { contactLinesOf, lineFrom } from "./pot/contact-lines.ts";
import { strokePull } from "./replay/replay-clock.ts";
import { filmedMarks, filmedPaths } from "./replay/filmed-paths.ts";
import { timedPaths } from "./replay/trail-paths.ts";
import type { State, Store } from "./document/store.ts";

/** Greatest distance (m) of a drawn path from the exact one: below a pixel at usual zooms. */
const PATH_TOLERANCE = 0.0005;

/** Distance of the cue from the ball (m), and its increase per m/s, which shows the speed. */
const PULL = 0.03;
const PULL_PER_SPEED = 0.03;
/** Greatest distance (m), so that the cue stays in the picture. */
const LONGEST_PULL = 0.35;

const NO_AREAS: readonly Area[] = [];
const NO_FILM: readonly FilmedBall[] = [];

/** What has areas on the cloth: an attempt or else a game, a line of the analysis, and the stop. */
interface Marked {
  readonly attempt?: Attempt | null;
  readonly game?: Game | null;
  readonly others?: readonly Area[];
  readonly stop?: Area | null;
}

/** What is drawn beside the paths of a trace. */
interface Beside {
  /** Whether the lines of the first contact are drawn. */
  readonly withLines?: boolean;
  readonly film?: readonly FilmedBall[];
  /** The shot before the errors of its player, which is shown as an aimed one is. */
  readonly intended?: Trace | null;
}

export interface SceneStats {
  /** Time of the last update of the scene, without drawing, ms. */
  sceneMs: number;
  /** Number of balls whose paths are shown. */
  paths: number;
}

export class Scene {
  readonly stats: SceneStats = { sceneMs: 0, paths: 0 };
  readonly #store: Store;
  readonly #viewer: Viewer;
  readonly #engine: Engine;
  #shown: State | null = null;
  /** What the marked areas of the cloth come from. */
  #marked: readonly unknown[] = [];
  /** What the drawn marks come from. */
  #drawn: readonly unknown[] = [undefined, null, undefined, undefined, undefined];
  #zone: Density | null = null;
  /** What is lit, as text. */
  #lit = "";
  #paths: Trace | null = null;
  /** What is shown of the present paths. */
  #extent: Guide | "trace" = "full";
  #hasContactLines = false;
  #intended: Trace | null = null;
  #film: readonly FilmedBall[] = NO_FILM;
  #states = new Float64Array(0);

  constructor(store: Store, context: Pick<Context, "viewer" | "loop" | "engine">) {
    this.#store = store;
    this.#viewer = context.viewer;
    this.#engine = context.engine;
    store.subscribe(() => {
      context.loop.invalidate();
    });
  }

  /** Updates the scene. Called once before every picture. */
  update(): void {
    const now = this.#store.state;
    const before = this.#shown;
    if (now === before) return;
    const start = performance.now();
    this.#shown = now;
    if (now.view.camera !== before?.view.camera) {
      this.#viewer.setCamera(now.view.camera, before === null);
    }
    const replayed = now.session.mode === "replay" ? now.session.replay.trace : null;
    const shot = (replayed ?? now.session.analysis.preview?.trace)?.shot ?? this.#store.shot;
    this.#viewer.setTable(shot.geometry, shot.balls);
    if (replayed) this.#replay(replayed, now.session);
    else this.#aim(now);
    const zone = replayed ? null : now.session.analysis.zone;
    if (zone !== this.#zone) {
      this.#zone = zone;
      this.#viewer.setZone(zone);
    }
    this.#showDrawing(now);
    const selected = shot.balls.findIndex(({ id }) => id === now.session.selected);
    this.#viewer.select(selected < 0 ? null : selected);
    this.stats.sceneMs = performance.now() - start;
  }

  #replay(trace: Trace, { replay: { time, stroke } }: Session): void {
    this.#setBalls(trace.statesAt(time, this.#buffer(trace.shot.balls.length)));
    const film = this.#filmOfShot();
    this.#setPaths(trace, "trace", { film, intended: intendedTrace(this.#store, this.#engine) });
    this.#viewer.setTime(time);
    this.#viewer.setCue(stroke > 0 ? stroking(trace, stroke) : null);
    this.#viewer.setMarks(filmedMarks(film, trace.shot.balls, time));
    this.#showAreas({ attempt: this.#store.session.attempt });
    this.#light(null);
  }

  #aim({ document, session }: State): void {
    const { preview } = session.analysis;
    const shot = preview?.trace?.shot ?? this.#store.shot;
    const aims = canAim(this.#store, this.#engine);
    const guide = shownGuide({ document, session });
    const ghost = preview?.trace ?? this.#store.ghost.trace;
    // A plan takes the place of the aimed shot.
    const isPlan = preview?.marks !== undefined;
    const trace = aims && guide !== "none" && !isPlan ? ghost : null;
    const states = this.#buffer(shot.balls.length);
    shot.balls.forEach((ball, index) => {
      states.fill(0, index * STRIDE, (index + 1) * STRIDE);
      states.set(ball.position, index * STRIDE);
      states[index * STRIDE + 12] = 1;
    });
    const refused = refusedBall(session.refusal?.shot ?? null, document.shot);
    if (refused) states.set(refused.position, refused.index * STRIDE);
    this.#setBalls(states);
    this.#viewer.setTime(null);
    this.#setPaths(trace, guide, {
      withLines: session.overlays.contact && guide === "full",
      film: preview ? NO_FILM : this.#filmOfShot(),
    });
    const hasCue = aims && !isPlan && shot.struck !== null;
    this.#viewer.setCue(hasCue ? pose(shot.strike!, shot.struck) : null);
    this.#viewer.setMarks([
      ...(trace ? marks(trace, guide) : []),
      ...(refused
        ? [{ position: place(states, refused.index), kind: "refused", ball: refused.index }]
        : []),
    ]);
    const stop = preview ? null : stopHandle(this.#store);
    this.#showAreas({
      attempt: session.attempt,
      game: document.game,
      others: preview?.areas ?? NO_AREAS,
      stop,
    });
    const falls = guide === "full" ? (trace?.outcome.pocketed[0]?.[1] ?? null) : null;
    const aimed = session.lock?.pocket ?? falls;
    const asked = session.attempt?.pocket ?? null;
    this.#light(aims && !isPlan ? (aimed ?? asked) : null, aimed === null && asked !== null);
  }

  /** Lights a pocket up. A light that pulses asks for something. */
  #light(pocket: string | null, pulses = false): void {
    const lit = pocket === null ? "" : `${pocket} ${pulses}`;
    if (lit === this.#lit) return;
    this.#lit = lit;
    this.#viewer.light(pocket === null ? null : { pocket, pulses });
  }

  /** Marks areas of the cloth. */
  #showAreas({ attempt = null, game = null, others = NO_AREAS, stop = null }: Marked): void {
    const call = game && presentCall(this.#store, this.#engine);
    const sources = [attempt, game, JSON.stringify(call), others, stop];
    if (sources.every((source, k) => source === this.#marked[k])) return;
    this.#marked = sources;
    this.#viewer.setAreas([
      ...(attempt?.areas ?? this.#gameAreas(game, call)),
      ...others,
      ...(stop ? [stop] : []),
    ]);
  }

  #gameAreas(game: Game | null, call: Call | null): Area[] {
    const progress = standing(this.#store, this.#engine);
    const { geometry, balls } = this.#store.shot;
    return game && progress ? areasOf(call, progress, geometry, balls[0]?.radius ?? 0) : [];
  }

  /** Shows what is drawn, and while the keyboard draws its place. */
  #showDrawing({ document, session }: State): void {
    const { marks } = document.shot;
    const awaited = awaitedMark(this.#store);
    const cursor = session.drawing?.cursor ?? null;
    const plan = session.mode === "aim" ? session.analysis.preview?.marks : undefined;
    const sources = [marks, cursor, session.drawing?.start, session.drawing?.tool, plan];
    if (sources.every((source, k) => source === this.#drawn[k])) return;
    this.#drawn = sources;
    const all = [...(marks ?? []), ...(plan ?? []), ...(awaited ? [awaited] : [])];
    this.#viewer.setDrawing(all, cursor);
  }

  #buffer(balls: number): Float64Array {
    if (this.#states.length !== balls * STRIDE) this.#states = new Float64Array(balls * STRIDE);
    return this.#states;
  }

  #setBalls(states: Float64Array): void {
    this.#viewer.setBalls(states);
  }

  /** The film of the present shot. */
  #filmOfShot(): readonly FilmedBall[] {
    const film = filmOf(this.#store.document);
    return film.length > 0 ? film : NO_FILM;
  }

  #setPaths(trace: Trace | null, extent: Guide | "trace", beside: Beside): void {
    const { withLines = false, film = NO_FILM, intended = null } = beside;
    // Ghost and replay show the same trace in different styles.
    const isSame = trace === this.#paths && intended === this.#intended && film === this.#film;
    if (isSame && extent === this.#extent && withLines === this.#hasContactLines) return;
    this.#intended = intended;
    this.#film = film;
    this.#paths = trace;
    this.#extent = extent;
    this.#hasContactLines = withLines;
    const paths =
      trace === null
        ? []
        : extent === "short"
          ? shortPaths(trace, PATH_TOLERANCE)
          : wholePaths(trace, extent);
    if (intended) paths.push(...aimedPaths(intended));
    const long = paths.filter(({ points }) => moves(points));
    this.stats.paths = long.length;
    this.#viewer.setPaths([
      ...long,
      ...filmedPaths(film, (trace?.shot ?? this.#store.shot).balls),
      ...(withLines && trace ? contactLines(trace) : []),
    ]);
  }
}

/** The tangent line and the natural angle, in the colour of the cue ball. */
function contactLines(trace: Trace): BallPath[] {
  const { struck, balls, geometry } = trace.shot;
  const lines = contactLinesOf(trace);
  if (!lines || struck === null) return [];
  return [lines.tangent, lines.natural].map((direction) => ({
    ball: struck,
    points: lineFrom(lines.from, direction, geometry.size, balls[struck]!.radius),
    style: "contact-line",
  }));
}

/** The paths of an intended shot that its player aimed: of the struck ball and of the first that it hits. */
function aimedPaths(trace: Trace): BallPath[] {
  const { struck, balls } = trace.shot;
  const first = balls.findIndex(({ id }) => id === trace.outcome.first_contact);
  return wholePaths(trace, "full").filter(({ ball }) => ball === struck || ball === first);
}

function wholePaths(trace: Trace, extent: Guide | "trace"): BallPath[] {
  if (extent === "trace") {
    const paths = timedPaths(trace, PATH_TOLERANCE);
    return paths.map((points, ball) => ({ ball, points, style: "trace" }));
  }
  return trace.shot.balls.map((_, ball) => ({
    ball,
    points: trace.polyline(ball, PATH_TOLERANCE),
    style: "ghost",
  }));
}

/** Whether a path has any length. */
function moves(points: Float64Array): boolean {
  for (let k = VERTEX; k < points.length; k += VERTEX) {
    if (points[k] !== points[0] || points[k + 1] !== points[1]) return true;
  }
  return false;
}

function pose({ speed, ...strike }: Strike, ball: number): CuePose {
  return { ball, ...strike, pull: Math.min(PULL + PULL_PER_SPEED * speed, LONGEST_PULL) };
}

/** The cue during its stroke, `left` seconds before the strike. */
function stroking({ shot }: Trace, left: number): CuePose | null {
  if (!shot.strike || shot.struck === null) return null;
  const start = pose(shot.strike, shot.struck);
  return { ...start, pull: strokePull(left, start.pull) };
}

/**
 * Ghost balls: the struck ball at its first contact with another ball, and where it stops. The short guide
 * has the first one only, and only on the aim line.
 */
function marks(trace: Trace, guide: Guide): Mark[] {
  const { struck, balls } = trace.shot;
  const id = struck === null ? null : balls[struck]!.id;
  if (struck === null || id === null) return [];
  const found: Mark[] = [];
  const contact = shownContact(trace, guide);
  if (contact) found.push({ position: contact.ghost, kind: "ghost-ball", ball: struck });
  const { pocketed, off_table } = trace.outcome;
  if (guide === "full" && !off_table.includes(id) && !pocketed.some(([ball]) => ball === id)) {
    const end = trace.statesAt(trace.duration);
    found.push({ position: place(end, struck), kind: "ghost-ball", ball: struck });
  }
  return found;
}

function place(states: Float64Array, ball: number): [number, number, number] {
  const at = ball * STRIDE;
  return [states[at]!, states[at + 1]!, states[at + 2]!];
}

/** The ball whose new position was refused, if there is one. */
function refusedBall(
  refused: AimedShot | null,
  shot: AimedShot,
): { index: number; position: readonly number[] } | null {
  if (refused?.balls.length !== shot.balls.length) return null;
  const index = refused.balls.findIndex((ball, k) => ball.position !== shot.balls[k]!.position);
  return index < 0 ? null : { index, position: refused.balls[index]!.position };
}
