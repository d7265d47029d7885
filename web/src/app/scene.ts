/** Updates the viewer from the state. No other module changes what the viewer shows, except films. */

import { STRIDE, type Engine, type Strike, type Trace } from "../engine/index.ts";
import type { CuePose, Mark, Viewer } from "../viewer/index.ts";
import type { Context } from "./common/context.ts";
import type { AimedShot } from "./document/document.ts";
import { areasOf } from "./game/areas.ts";
import type { Game } from "./document/game.ts";
import { canAim, standing } from "./game/play.ts";
import type { State, Store } from "./document/store.ts";

/** Greatest distance (m) of a drawn path from the exact one: below a pixel at usual zooms. */
const PATH_TOLERANCE = 0.0005;

/** Distance of the cue from the ball (m), and its increase per m/s, which shows the speed. */
const PULL = 0.03;
const PULL_PER_SPEED = 0.03;
/** Greatest distance (m), so that the cue stays in the picture. */
const LONGEST_PULL = 0.35;

export interface SceneStats {
  /** Time of the last update of the scene, without drawing, ms. */
  sceneMs: number;
}

export class Scene {
  readonly stats: SceneStats = { sceneMs: 0 };
  readonly #store: Store;
  readonly #viewer: Viewer;
  readonly #engine: Engine;
  #shown: State | null = null;
  /** The game whose areas are shown. */
  #game: Game | null = null;
  /** Name of the pocket that is lit. */
  #lit: string | null = null;
  #paths: Trace | null = null;
  #style: "ghost" | "trace" = "ghost";
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
    const replayed = now.session.mode === "replay" ? now.session.trace : null;
    const shot = replayed?.shot ?? this.#store.shot;
    this.#viewer.setTable(shot.geometry, shot.balls);
    if (replayed) this.#replay(replayed, now.session.time);
    else this.#aim(now);
    const selected = shot.balls.findIndex(({ id }) => id === now.session.selected);
    this.#viewer.select(selected < 0 ? null : selected);
    this.stats.sceneMs = performance.now() - start;
  }

  #replay(trace: Trace, time: number): void {
    this.#setBalls(trace.statesAt(time, this.#buffer(trace.shot.balls.length)));
    this.#setPaths(trace, "trace");
    this.#viewer.setTime(time);
    this.#viewer.setCue(null);
    this.#viewer.setMarks([]);
    this.#showAreas(null);
    this.#light(null);
  }

  #aim({ document, session }: State): void {
    const { shot } = this.#store;
    const aims = canAim(this.#store, this.#engine);
    const trace = aims ? this.#store.ghost.trace : null;
    const states = this.#buffer(shot.balls.length);
    shot.balls.forEach((ball, index) => {
      states.fill(0, index * STRIDE, (index + 1) * STRIDE);
      states.set(ball.position, index * STRIDE);
      states[index * STRIDE + 12] = 1;
    });
    const refused = refusedBall(session.refusal?.attempt ?? null, document.shot);
    if (refused) states.set(refused.position, refused.index * STRIDE);
    this.#setBalls(states);
    this.#viewer.setTime(null);
    this.#setPaths(trace, "ghost");
    this.#viewer.setCue(aims && shot.struck !== null ? pose(shot.strike!, shot.struck) : null);
    this.#viewer.setMarks([
      ...(trace ? marks(trace) : []),
      ...(refused
        ? [{ position: place(states, refused.index), kind: "refused", ball: refused.index }]
        : []),
    ]);
    this.#showAreas(document.game);
    this.#light(aims ? (session.lock?.pocket ?? null) : null);
  }

  /** Lights a pocket up. */
  #light(pocket: string | null): void {
    if (pocket === this.#lit) return;
    this.#lit = pocket;
    this.#viewer.light(pocket === null ? null : { pocket });
  }

  /** Marks the areas of a game on the cloth; null removes them. */
  #showAreas(game: Game | null): void {
    if (game === this.#game) return;
    this.#game = game;
    const progress = standing(this.#store, this.#engine);
    const { geometry, balls } = this.#store.shot;
    const areas = game && progress ? areasOf(game, progress, geometry, balls[0]?.radius ?? 0) : [];
    this.#viewer.setAreas(areas);
  }

  #buffer(balls: number): Float64Array {
    if (this.#states.length !== balls * STRIDE) this.#states = new Float64Array(balls * STRIDE);
    return this.#states;
  }

  #setBalls(states: Float64Array): void {
    this.#viewer.setBalls(states);
  }

  #setPaths(trace: Trace | null, style: "ghost" | "trace"): void {
    // Ghost and replay show the same trace in different styles.
    if (trace === this.#paths && style === this.#style) return;
    this.#paths = trace;
    this.#style = style;
    const paths = (trace?.shot.balls ?? []).flatMap((_, ball) => {
      const points = trace!.polyline(ball, PATH_TOLERANCE);
      return moves(points) ? [{ ball, points, style }] : [];
    });
    this.#viewer.setPaths(paths);
  }
}

/** Whether a path has any length. */
function moves(points: Float64Array): boolean {
  for (let k = 4; k < points.length; k += 4) {
    if (points[k] !== points[0] || points[k + 1] !== points[1]) return true;
  }
  return false;
}

function pose({ speed, ...strike }: Strike, ball: number): CuePose {
  return { ball, ...strike, pull: Math.min(PULL + PULL_PER_SPEED * speed, LONGEST_PULL) };
}

/** Ghost balls: the struck ball at its first contact with another ball, and where it stops. */
function marks(trace: Trace): Mark[] {
  const { struck, balls } = trace.shot;
  const id = struck === null ? null : balls[struck]!.id;
  if (struck === null || id === null) return [];
  const found: Mark[] = [];
  const contact = trace.events.find(
    // A strike moves the balls that touch the cue ball at once.
    ({ type, balls }) =>
      (type === "ball-collision" || type === "cue-strike") &&
      balls.length > 1 &&
      balls.includes(id),
  );
  if (contact) {
    const { position } = contact.before[contact.balls.indexOf(id)]!;
    found.push({ position, kind: "ghost-ball", ball: struck });
  }
  const { pocketed, off_table } = trace.outcome;
  if (!off_table.includes(id) && !pocketed.some(([ball]) => ball === id)) {
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
  attempt: AimedShot | null,
  shot: AimedShot,
): { index: number; position: readonly number[] } | null {
  if (attempt?.balls.length !== shot.balls.length) return null;
  const index = attempt.balls.findIndex((ball, k) => ball.position !== shot.balls[k]!.position);
  return index < 0 ? null : { index, position: attempt.balls[index]!.position };
}
