/** The scene of a shot: table, balls, cue, paths and marks. */

import { Raycaster, Scene, Vector2, Vector3 } from "three";
import { STRIDE } from "../engine/types.ts";
import { Balls } from "./balls/drawn-balls.ts";
import type { Box } from "./camera/pose.ts";
import { Rig } from "./camera/rig.ts";
import { Areas } from "./overlay/marked-areas.ts";
import { Cue } from "./overlay/cue.ts";
import { Highlight } from "./overlay/highlight.ts";
import type { Density } from "./overlay/density.ts";
import { Fan } from "./overlay/fan.ts";
import { Lines } from "./overlay/pixel-lines.ts";
import { DrawnMarks } from "./overlay/drawn-marks.ts";
import { Marks } from "./overlay/ring-marks.ts";
import { Paths } from "./overlay/ball-paths.ts";
import { pocketAt, railAt } from "./pointing.ts";
import { Lighting } from "./lighting.ts";
import { Governor, isSoftware, type Level, LEVELS, LOW, STILL } from "./quality.ts";
import { type Loupe, loupePlace, Stage, ZOOM } from "./render/stage.ts";
import { Table } from "./table/drawn-table.ts";
import { reach } from "./table/table-outline.ts";
import { clothColor, palette } from "./theme-colors.ts";
import {
  type Area,
  type BallInfo,
  type BallPath,
  type CameraMode,
  type CuePose,
  type DrawnMark,
  type Geometry,
  type HitResult,
  type Lit,
  type Mark,
  type PickResult,
  type Point,
  type Quality,
  type Theme,
} from "./viewer-types.ts";

/** Radius around a ball in which it can be picked, pixels; larger for fingers. */
const REACH = { touch: 24, mouse: 8 };
/** Time without a change after which a still is drawn at full quality, ms. */
const STILL_DELAY = 400;
/** Margin around the balls on unbounded cloth, and the least extent that is shown, m. */
const UNBOUNDED_MARGIN = 0.35;
const UNBOUNDED_LEAST = 1.8;

/** A point of the page, CSS pixels. */
interface Spot {
  readonly x: number;
  readonly y: number;
}

export interface ViewerOptions {
  theme: Theme;
  /** Whether shadow maps are allowed. Default true. */
  shadows?: boolean;
  /** Whether cameras jump instead of flying. */
  reducedMotion?: boolean;
  /** Called when {@link Viewer.needsPicture} becomes true, also after gestures and resizing. */
  onChange?: () => void;
}

/**
 * Draws a table on a canvas. It has no loop of its own: call {@link Viewer.render} from yours while
 * {@link Viewer.needsPicture} is true.
 */
export class Viewer {
  readonly #canvas: HTMLCanvasElement;
  readonly #stage: Stage;
  readonly #shadowsAllowed: boolean;
  readonly #scene = new Scene();
  readonly #lighting = new Lighting();
  readonly #table = new Table();
  readonly #balls = new Balls();
  readonly #rig: Rig;
  readonly #paths = new Paths();
  readonly #highlight = new Highlight();
  /** Dashes without gaps: the paths of the first picture have the same shader. */
  readonly #aim = new Lines({ width: 1.1, opacity: 0.3, dash: [1, 0] });
  readonly #fan = new Fan();
  readonly #zone = new Fan();
  readonly #cue = new Cue();
  readonly #areas = new Areas();
  readonly #marks = new Marks();
  readonly #drawn = new DrawnMarks();
  readonly #watcher: ResizeObserver;
  #governor: Governor;
  #quality: Quality = "auto";
  #geometry: Geometry | null = null;
  #infos: readonly BallInfo[] = [];
  #pose: CuePose | null = null;
  #selected: number | null = null;
  #lit: Lit | null = null;
  #loupe: Loupe | null = null;
  readonly #reducedMotion: boolean;
  readonly #onChange: () => void;
  #dirty = true;
  #renderMs = 0;
  /** Number of pictures so far. */
  #pictures = 0;
  /** Start of the browser's first frame after the last picture, ms, and the request that records it. */
  #nextPicture = NaN;
  #request = 0;
  /** Whether the next picture is a still, whether the last one was, and the timer that requests one. */
  #stillDue = false;
  #wasStill = false;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #stillRequest = 0;

  /**
   * @param canvas - Its size is set by the page's style.
   * @throws Error if the browser does not support WebGL 2.
   */
  constructor(canvas: HTMLCanvasElement, options: ViewerOptions) {
    this.#canvas = canvas;
    this.#reducedMotion = options.reducedMotion ?? false;
    this.#onChange = options.onChange ?? (() => undefined);
    this.#stage = new Stage(canvas, this.#scene, isSoftware());
    this.#stage.smooths = false;
    this.#shadowsAllowed = options.shadows ?? true;
    this.#rig = new Rig(canvas, this.#reducedMotion, () => this.#invalidate());
    this.#governor = this.#newGovernor();
    this.#scene.add(
      this.#lighting.group,
      this.#table.group,
      this.#areas.group,
      this.#fan.group,
      this.#zone.group,
      this.#balls.group,
      this.#paths.group,
      this.#highlight.group,
      this.#aim.object,
      this.#cue.mesh,
      this.#marks.group,
      this.#drawn.group,
    );
    this.setTheme(options.theme);
    this.#applyLevel();
    this.#watcher = new ResizeObserver(() => this.resize());
    this.#watcher.observe(canvas);
    canvas.addEventListener("webglcontextrestored", this.#restored);
    this.resize();
  }

  /** Whether a call of {@link render} would draw something new. */
  get needsPicture(): boolean {
    return this.#dirty || this.#rig.flying || this.#pulses;
  }

  /** Whether the camera moves from one view to another. */
  get flying(): boolean {
    return this.#rig.flying;
  }

  /** `top`, `orbit` (turned by drag, wheel and pinch) or `cue` (behind the cue). */
  get camera(): CameraMode {
    return this.#rig.mode;
  }

  /** Changes the camera, in a flight of two thirds of a second or at once. */
  setCamera(mode: CameraMode, instant = false): void {
    this.#rig.setMode(mode, instant, performance.now());
    this.#invalidate();
  }

  /** Returns to the standard view of the present camera. */
  resetView(): void {
    if (this.#geometry) this.#rig.setBox(this.#box(this.#geometry));
    this.#rig.reset(performance.now());
    this.#invalidate();
  }

  /**
   * Whether dragging turns the orbit camera. Set it to false for a drag that moves a ball or the cue, in a
   * `pointerdown` listener of the capture phase, which runs before the camera's own listener.
   */
  get controls(): boolean {
    return this.#rig.enabled;
  }

  set controls(enabled: boolean) {
    this.#rig.enabled = enabled;
  }

  /** `auto` adapts to the frame times; `low` has no shadow map, `high` is the best level. */
  get quality(): Quality {
    return this.#quality;
  }

  set quality(quality: Quality) {
    this.#quality = quality;
    this.#stage.smooths = true;
    this.#governor = this.#newGovernor();
    this.#applyLevel();
    this.#invalidate();
  }

  /**
   * `pictureMs`: median time between frames in the last continuous motion, ms (0: none yet). `renderMs`:
   * the JavaScript time of the last frame. `level`: index of the present quality, 0 the best.
   */
  get stats(): { pictureMs: number; renderMs: number; level: number } {
    return { pictureMs: this.#governor.pictureMs, renderMs: this.#renderMs, level: this.#level };
  }

  setTheme(theme: Theme): void {
    const colors = palette(theme);
    this.#stage.background = colors.background;
    this.#lighting.setPalette(colors);
    this.#balls.setLight(this.#lighting.light);
    this.#table.setPalette(colors);
    this.#invalidate();
  }

  /** Sets the table and the balls at rest; fast if the geometry is equal to the present one. */
  setTable(geometry: Geometry, balls: readonly BallInfo[]): void {
    const same = this.#geometry !== null && sameTable(this.#geometry, geometry);
    this.#infos = balls;
    this.#balls.setBalls(balls, geometry);
    this.#geometry = geometry;
    if (!same) {
      const box = this.#box(geometry);
      this.#table.setGeometry(geometry, middle(box));
      this.#lighting.fit(box);
      this.#rig.setBox(box);
      this.#stage.invalidate();
    }
    this.#ballsMoved();
  }

  /** Moves all balls to states of `Trace.statesAt`. */
  setBalls(states: Float64Array): void {
    if (states.length < STRIDE * this.#balls.count) {
      throw new Error(
        `${states.length} numbers for ${this.#balls.count} balls; give ${STRIDE} for each of setTable's balls.`,
      );
    }
    this.#balls.setStates(states);
    this.#ballsMoved();
  }

  /** Replaces the drawn paths; each has its ball's colour. */
  setPaths(paths: readonly BallPath[]): void {
    this.#paths.set(paths, this.#balls, this.#cloth);
    this.#invalidate();
  }

  /**
   * Sets the time of a replay, s. Played paths are then trails of the last second, until all balls rest.
   * Null, and reduced motion, show whole paths.
   */
  setTime(time: number | null): void {
    this.#paths.setTime(this.#reducedMotion ? null : time, this.#balls, this.#cloth);
    this.#invalidate();
  }

  /** Lights a pocket, a rail or a ball softly; null puts the light out. */
  light(lit: Lit | null): void {
    this.#lit = lit;
    if (this.#geometry) this.#highlight.set(lit, this.#geometry, this.#balls);
    this.#invalidate();
  }

  /**
   * Magnifies the surroundings of a point of the page in a disc; null removes the disc.
   *
   * @param disc - Where the disc is, and its magnification; left out: beside the point, as for a finger.
   */
  loupe(point: Spot | null, disc?: { readonly at: Spot; readonly zoom: number }): void {
    const area = this.#canvas.getBoundingClientRect();
    const inside = ({ x, y }: Spot): Point => [x - area.left, y - area.top];
    if (!point) this.#loupe = null;
    else {
      const from = inside(point);
      const at = disc ? inside(disc.at) : loupePlace(from, [area.width, area.height]);
      this.#loupe = { from, at, zoom: disc?.zoom ?? ZOOM };
    }
    this.#invalidate();
  }

  /**
   * Shows the final positions of a ball in many variants as a heat map, with some of its paths.
   *
   * @param points - x, y (m) per variant; NaN if the ball ends off the cloth. Null clears.
   * @param paths - x, y, z (m) per point of each path.
   */
  setFan(points: Float64Array | null, paths: readonly Float32Array[] = []): void {
    if (points && this.#geometry) {
      const { min, max } = this.#box(this.#geometry);
      const size = this.#geometry.size;
      const origin: Point = size ? [0, 0] : [min[0], min[1]];
      this.#fan.set(points, paths, origin, size ?? [max[0] - min[0], max[1] - min[1]]);
    } else {
      this.#fan.clear();
    }
    this.#invalidate();
  }

  /** Shows a density over the playing area, such as chances by place; null removes it. */
  setZone(density: Density | null): void {
    const size = this.#geometry?.size;
    if (density && size) this.#zone.setHeat(density, [0, 0], size);
    else this.#zone.clear();
    this.#invalidate();
  }

  /** Places the cue at its ball and draws the line of aim; null removes both. */
  setCue(cue: CuePose | null): void {
    this.#pose = cue;
    this.#placeCue();
    this.#invalidate();
  }

  setAreas(areas: readonly Area[]): void {
    this.#areas.set(areas);
    this.#invalidate();
  }

  setMarks(marks: readonly Mark[]): void {
    this.#marks.set(marks, this.#balls);
    this.#invalidate();
  }

  /**
   * Shows what the user has drawn.
   *
   * @param cursor - The place of the keyboard while it draws, m; null: none.
   */
  setDrawing(marks: readonly DrawnMark[], cursor: Point | null): void {
    this.#drawn.set(marks, cursor);
    this.#invalidate();
  }

  select(ball: number | null): void {
    this.#selected = ball;
    this.#marks.select(ball, this.#balls);
    this.#invalidate();
  }

  /**
   * The ball and the place under a point of the page.
   *
   * @param pointer - `PointerEvent.pointerType`: a touch picks balls in a larger radius.
   */
  pick(clientX: number, clientY: number, pointer = "mouse"): PickResult {
    const area = this.#canvas.getBoundingClientRect();
    const x = (2 * (clientX - area.left)) / area.width - 1;
    const y = 1 - (2 * (clientY - area.top)) / area.height;
    const camera = this.#rig.camera;
    const reach = pointer === "mouse" ? REACH.mouse : REACH.touch;
    const ball = this.#balls.at(camera, x, y, reach, [area.width, area.height]);
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2(x, y), camera);
    const { origin, direction } = caster.ray;
    const height = this.#infos.at(ball ?? 0)?.radius ?? 0;
    const along = (height - origin.z) / direction.z;
    const hit = along > 0 && Number.isFinite(along);
    return {
      ball,
      point: hit ? [origin.x + along * direction.x, origin.y + along * direction.y] : null,
    };
  }

  /** The ball, the pocket or the rail under a point of the page; `pointer` as in {@link Viewer.pick}. */
  hit(clientX: number, clientY: number, pointer = "mouse"): HitResult {
    const picked = this.pick(clientX, clientY, pointer);
    const geometry = this.#geometry;
    if (!geometry || picked.ball !== null) return { ...picked, pocket: null, rail: null };
    const pocket = pocketAt([clientX, clientY], geometry, (x, y, z) => this.project(x, y, z));
    const rail = pocket === null && picked.point ? railAt(picked.point, geometry) : null;
    return { ...picked, pocket, rail };
  }

  /**
   * Position of a place of the table on the page, px; null if it is behind the camera.
   */
  project(x: number, y: number, z: number): [clientX: number, clientY: number] | null {
    const place = new Vector3(x, y, z).project(this.#rig.camera);
    if (place.z > 1) return null;
    const area = this.#canvas.getBoundingClientRect();
    return [
      area.left + ((place.x + 1) / 2) * area.width,
      area.top + ((1 - place.y) / 2) * area.height,
    ];
  }

  /**
   * A step on the cloth as it is seen: to the right and down, relative to the width of the canvas. Null if
   * an end is behind the camera. Unlike {@link Viewer.project} it does not ask the browser for the layout.
   */
  seen([x, y]: Point, [toX, toY]: Point): [right: number, down: number] | null {
    const { camera } = this.#rig;
    const from = new Vector3(x, y, 0).project(camera);
    const to = new Vector3(toX, toY, 0).project(camera);
    if (from.z > 1 || to.z > 1) return null;
    return [(to.x - from.x) / 2, (from.y - to.y) / 2 / camera.aspect];
  }

  /**
   * Draws a picture. Call it once per animation frame while {@link needsPicture}. If moving pictures are
   * below full quality, a still at full quality follows when nothing changes for a while.
   */
  render(): void {
    const start = performance.now();
    // Cleared before the cameras move, because their changes need another frame.
    this.#dirty = false;
    this.#pictures += 1;
    const still = this.#stillDue;
    this.#stillDue = false;
    this.#govern(still);
    this.#draw(still || this.#level < LOW);
    this.#renderMs = performance.now() - start;
    this.#awaitStill(still);
  }

  /** Starts to compile the shaders of the first pictures, in slices. They compile in parallel until then. */
  compile(): Generator<undefined, void, undefined> {
    const parts = [this.#balls.group, this.#cue.mesh, this.#paths.group, this.#aim.object];
    const objects = [this.#table.samples(), ...parts, this.#marks.group];
    return this.#stage.compile(objects, this.#rig.camera);
  }

  /** Resolves when the last picture is drawn: {@link render} only orders it. */
  finished(): Promise<void> {
    return this.#stage.finished();
  }

  /** The picture as PNG, with shadows and `scale` pixels per CSS pixel. */
  async capture(scale = 2): Promise<Blob> {
    this.#apply({ ...STILL, pixelRatio: scale }, scale);
    this.#draw(true);
    // In the same task, because the browser clears the canvas after displaying it.
    const encoded = new Promise<Blob | null>((resolve) =>
      this.#canvas.toBlob(resolve, "image/png"),
    );
    this.#applyLevel();
    this.render();
    const blob = await encoded;
    if (!blob) {
      throw new Error("The browser could not encode the picture: use a smaller scale.");
    }
    return blob;
  }

  /** Adapts to the size of the canvas; the viewer calls it when the size changes. */
  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#canvas;
    if (width === 0 || height === 0) return;
    this.#stage.resize(width, height);
    this.#rig.setAspect(width / height);
    this.#invalidate();
  }

  /** Frees all resources; the viewer is unusable afterwards. */
  dispose(): void {
    this.#watcher.disconnect();
    this.#canvas.removeEventListener("webglcontextrestored", this.#restored);
    cancelAnimationFrame(this.#request);
    cancelAnimationFrame(this.#stillRequest);
    clearTimeout(this.#timer);
    for (const part of [
      this.#rig,
      this.#table,
      this.#balls,
      this.#paths,
      this.#highlight,
      this.#aim,
      this.#areas,
      this.#fan,
      this.#zone,
      this.#cue,
      this.#marks,
      this.#drawn,
      this.#lighting,
      this.#stage,
    ]) {
      part.dispose();
    }
  }

  readonly #restored = (): void => {
    this.#stage.invalidate();
    this.#invalidate();
  };

  /** Whether a light pulses. */
  get #pulses(): boolean {
    return this.#highlight.lit && this.#lit?.pulses === true && !this.#reducedMotion;
  }

  /** Colour of the cloth, into which trails fade. */
  get #cloth(): string {
    return clothColor(this.#geometry?.physics);
  }

  #invalidate(): void {
    this.#dirty = true;
    this.#onChange();
  }

  /** Updates what depends on the positions of the balls. */
  #ballsMoved(): void {
    this.#placeCue();
    this.#marks.select(this.#selected, this.#balls);
    if (this.#lit?.ball !== undefined) this.light(this.#lit);
    this.#invalidate();
  }

  #placeCue(): void {
    const cue = this.#pose;
    if (!cue || !this.#geometry || cue.ball >= this.#balls.count) {
      this.#cue.hide();
      this.#aim.clear().commit();
      return;
    }
    const center = this.#balls.center(cue.ball);
    this.#cue.place(cue, center, this.#balls.info(cue.ball).radius, this.#geometry);
    const far = reach(center, cue.azimuth, this.#geometry.size);
    const [dx, dy] = [Math.cos(cue.azimuth), Math.sin(cue.azimuth)];
    const { x, y, z } = center;
    this.#aim
      .clear()
      .add([x, y, z, x + far * dx, y + far * dy, z], 3, "#ffffff")
      .commit();
    this.#rig.setAim(center, cue);
  }

  /** @param fine - Whether software rendering smooths edges. */
  #draw(fine: boolean): void {
    this.#rig.update(performance.now());
    const { camera, side, above } = this.#rig;
    this.#balls.setViewer(side, above);
    this.#balls.pixels = (this.#stage.height * camera.projectionMatrix.elements[5]) / 2;
    this.#highlight.pulse(this.#pulses ? performance.now() / 1000 : null);
    this.#stage.draw(camera, fine, this.#loupe);
  }

  /**
   * Sets the quality of this picture. The time since the last picture counts only if that was drawn in
   * the browser's previous frame.
   */
  #govern(still: boolean): void {
    const now = Number(document.timeline.currentTime);
    const changed = this.#governor.pictureAt(now, now === this.#nextPicture && !still);
    if (still) this.#apply(STILL, devicePixelRatio);
    else if (this.#wasStill || (changed && this.#quality === "auto")) this.#applyLevel();
    this.#wasStill = still;
    this.#nextPicture = NaN;
    cancelAnimationFrame(this.#request);
    // A still takes longer, so the frame after it is not measured.
    if (!still) this.#request = requestAnimationFrame((time) => (this.#nextPicture = time));
  }

  /** Requests a still when nothing has changed for a while. */
  #awaitStill(still: boolean): void {
    clearTimeout(this.#timer);
    cancelAnimationFrame(this.#stillRequest);
    if (still || this.#quality !== "auto" || this.#level === 0) return;
    this.#timer = setTimeout(() => {
      // On a slow machine the next picture of a motion may be due by now: it goes first, and cancels this.
      this.#stillRequest = requestAnimationFrame(() => {
        if (!this.#dirty) void this.#smooth();
      });
    }, STILL_DELAY);
  }

  /** The first rest smooths the table, the next one everything. A change stops it. */
  async #smooth(): Promise<void> {
    const all = this.#stage.smooths;
    const pictures = this.#pictures;
    // Another number of pixels empties the canvas, so that it is drawn at once.
    if (!all || Math.min(STILL.pixelRatio, devicePixelRatio) === this.#stage.pixelRatio) {
      if (all) this.#apply(STILL, devicePixelRatio);
      this.#stage.prepare(this.#rig.camera, all);
      if (all) this.#applyLevel();
      await this.#stage.finished();
      if (this.#dirty || this.#pictures !== pictures) return;
    }
    if (all) this.#stillDue = true;
    else this.#stage.showSmooth();
    this.#invalidate();
  }

  #applyLevel(): void {
    this.#apply(LEVELS[this.#level]!, devicePixelRatio);
  }

  /** Software rendering keeps the table's picture, which takes a low level. */
  #newGovernor(): Governor {
    return this.#stage.software ? new Governor(LOW, LOW) : new Governor(0);
  }

  /** Index of the present level. */
  get #level(): number {
    return { auto: this.#governor.level, low: LOW, high: 0 }[this.#quality];
  }

  #apply(level: Level, screen: number): void {
    const shadows = level.shadows && this.#shadowsAllowed;
    this.#stage.setPixelRatio(Math.min(level.pixelRatio, screen));
    this.#stage.shadows = shadows;
    this.#lighting.shadows = shadows;
    this.#balls.setShadows(shadows);
  }

  /** The box that the cameras show: the table with its rails, or the balls on unbounded cloth. */
  #box(geometry: Geometry): Box {
    if (geometry.size) {
      const [width, length] = geometry.size;
      const rail = geometry.rail_width ?? 0;
      return {
        min: [-rail, -rail, 0],
        max: [width + rail, length + rail, geometry.cushion_height],
      };
    }
    const range = (axis: 0 | 1): [number, number] => {
      const places = this.#infos.length > 0 ? this.#infos.map((ball) => ball.position[axis]) : [0];
      const [low, high] = [Math.min(...places), Math.max(...places)];
      const missing = Math.max(UNBOUNDED_MARGIN, (UNBOUNDED_LEAST - (high - low)) / 2);
      return [low - missing, high + missing];
    };
    const [[left, right], [bottom, top]] = [range(0), range(1)];
    return { min: [left, bottom, 0], max: [right, top, 0.03] };
  }
}

function middle({ min, max }: Box): Point {
  return [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
}

function sameTable(a: Geometry, b: Geometry): boolean {
  return a === b || JSON.stringify(a) === JSON.stringify(b);
}
