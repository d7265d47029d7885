/** A scene of a shot: table, balls, cue, paths, and what the app wants pointed out. */

import { Color, PCFShadowMap, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { Balls } from "./balls";
import type { Box } from "./camera/pose";
import { Rig } from "./camera/rig";
import { room } from "./environment";
import { Areas } from "./overlay/areas";
import { Cue } from "./overlay/cue";
import { Fan } from "./overlay/fan";
import { Lines } from "./overlay/lines";
import { Marks } from "./overlay/marks";
import { Lighting, SLANT } from "./lighting";
import { Governor, isSoftware, type Level, LEVELS, LOW, STILL } from "./quality";
import { Table } from "./table";
import { reach } from "./table/outline";
import { palette } from "./theme";
import {
  type Area,
  type BallInfo,
  type BallPath,
  type CameraMode,
  type CuePose,
  type Geometry,
  type Mark,
  type Pick,
  type Point,
  type Quality,
  STRIDE,
  type Theme,
} from "./types";

/** Radius around a ball in which it can be picked, pixels: a finger is not a pointer. */
const REACH = { touch: 24, mouse: 8 };
/** Time without a change after which the picture that stands is drawn at full quality, ms. */
const CALM = 400;
/** Space around the balls on endless cloth, and the least that is shown of it, m. */
const ENDLESS_MARGIN = 0.35;
const ENDLESS_LEAST = 1.8;

export interface ViewerOptions {
  theme: Theme;
  /** Never a real shadow map if false; default true. */
  shadows?: boolean;
  /** Cameras jump instead of flying. */
  reducedMotion?: boolean;
  /** Called when {@link Viewer.needsFrame} becomes true, also by the hand or the window's size. */
  onChange?: () => void;
}

/**
 * Draws a table on a canvas. It has no loop of its own: call {@link Viewer.render} from yours while
 * {@link Viewer.needsFrame} is true.
 */
export class Viewer {
  readonly #canvas: HTMLCanvasElement;
  readonly #renderer: WebGLRenderer;
  readonly #software: boolean;
  readonly #shadowsAllowed: boolean;
  readonly #scene = new Scene();
  readonly #lighting = new Lighting();
  readonly #room = room();
  readonly #table = new Table();
  readonly #balls = new Balls(this.#room, SLANT);
  readonly #rig: Rig;
  readonly #ghosts = new Lines({ width: 1.8, opacity: 0.62, dash: [0.022, 0.014] });
  readonly #traces = new Lines({ width: 2.4, opacity: 0.92 });
  readonly #aim = new Lines({ width: 1.1, opacity: 0.3 });
  readonly #fan = new Fan();
  readonly #cue = new Cue();
  readonly #areas = new Areas();
  readonly #marks = new Marks();
  readonly #watcher: ResizeObserver;
  #governor: Governor;
  #quality: Quality = "auto";
  #geometry: Geometry | null = null;
  #infos: readonly BallInfo[] = [];
  #pose: CuePose | null = null;
  #selected: number | null = null;
  readonly #onChange: () => void;
  #dirty = true;
  #renderMs = 0;
  /** When the browser's first frame after the last picture began, ms; and the request to be told. */
  #nextFrame = NaN;
  #request = 0;
  /** Whether the next picture is a still, whether the last one was, and what waits to ask for one. */
  #calm = false;
  #sharp = false;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /**
   * @param canvas - Sized by the page's style; the viewer follows.
   * @throws Error if the browser gives no WebGL 2.
   */
  constructor(canvas: HTMLCanvasElement, options: ViewerOptions) {
    this.#canvas = canvas;
    this.#onChange = options.onChange ?? (() => undefined);
    this.#software = isSoftware();
    // Smoothing is for the life of a context; software renders it too slowly.
    this.#renderer = new WebGLRenderer({ canvas, antialias: !this.#software });
    this.#renderer.shadowMap.type = PCFShadowMap;
    this.#shadowsAllowed = options.shadows ?? true;
    this.#rig = new Rig(canvas, options.reducedMotion ?? false, () => this.#touch());
    this.#governor = new Governor(this.#software ? LOW : 0);
    this.#scene.add(
      this.#lighting.group,
      this.#table.group,
      this.#areas.group,
      this.#fan.group,
      this.#balls.group,
      this.#ghosts.object,
      this.#traces.object,
      this.#aim.object,
      this.#cue.mesh,
      this.#marks.group,
    );
    this.setTheme(options.theme);
    this.#applyLevel();
    this.#watcher = new ResizeObserver(() => this.resize());
    this.#watcher.observe(canvas);
    canvas.addEventListener("webglcontextrestored", this.#restored);
    this.resize();
  }

  /** Whether a call of {@link render} would draw something new. */
  get needsFrame(): boolean {
    return this.#dirty || this.#rig.flying;
  }

  /** `top`, `orbit` (turned by drag, wheel and pinch) or `cue` (behind the ball that is aimed at). */
  get camera(): CameraMode {
    return this.#rig.mode;
  }

  /** Goes to a view; in a flight of two thirds of a second, or at once. */
  setCamera(mode: CameraMode, instant = false): void {
    this.#rig.setMode(mode, instant, performance.now());
    this.#touch();
  }

  /** Back to the standard view of the present camera. */
  resetView(): void {
    if (this.#geometry) this.#rig.setBox(this.#box(this.#geometry));
    this.#rig.reset(performance.now());
    this.#touch();
  }

  /**
   * Whether dragging turns the orbit camera. Set it to false while a drag moves a ball or the cue: in a
   * `pointerdown` listener of the capture phase, so that it comes before the camera's own.
   */
  get controls(): boolean {
    return this.#rig.enabled;
  }

  set controls(enabled: boolean) {
    this.#rig.enabled = enabled;
  }

  /** `auto` follows the time that frames take; `low` has no shadow map, `high` all there is. */
  get quality(): Quality {
    return this.#quality;
  }

  set quality(quality: Quality) {
    this.#quality = quality;
    this.#governor = new Governor(this.#software ? LOW : 0);
    this.#applyLevel();
    this.#touch();
  }

  /**
   * `frameMs`: median time between frames in the last continuous motion, ms (0: none yet). `renderMs`:
   * the JavaScript time of the last frame. `level`: index of the present quality, 0 the best.
   */
  get stats(): { frameMs: number; renderMs: number; level: number } {
    return { frameMs: this.#governor.frameMs, renderMs: this.#renderMs, level: this.#level };
  }

  setTheme(theme: Theme): void {
    const colors = palette(theme);
    this.#scene.background = new Color(colors.background);
    this.#lighting.setPalette(colors);
    this.#table.setPalette(colors);
    this.#touch();
  }

  /** Table and balls at rest; cheap for a geometry that is the same object or says the same. */
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
      this.#balls.setViewer(this.#rig.side);
    }
    this.#follow();
  }

  /** Moves all balls to the states that `Trace.statesAt` gives. */
  setBalls(states: Float64Array): void {
    if (states.length < STRIDE * this.#balls.count) {
      throw new Error(
        `${states.length} numbers for ${this.#balls.count} balls; give ${STRIDE} for each of setTable's balls.`,
      );
    }
    this.#balls.setStates(states);
    this.#follow();
  }

  /** Draws these paths instead of the ones before, each in its ball's colour. */
  setPaths(paths: readonly BallPath[]): void {
    this.#ghosts.clear();
    this.#traces.clear();
    for (const { ball, points, style } of paths) {
      const lines = style === "ghost" ? this.#ghosts : this.#traces;
      lines.add(points, 4, this.#balls.looks[ball]?.path ?? "#ffffff");
    }
    this.#ghosts.commit();
    this.#traces.commit();
    this.#touch();
  }

  /**
   * Where a ball ends in many variants, as a heat map, and a choice of its ways.
   *
   * @param points - x, y (m) per variant; NaN where it ends off the cloth. Null clears.
   * @param paths - x, y, z (m) per point of each way.
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
    this.#touch();
  }

  /** Lays the cue on its ball and draws its line; null takes both away. */
  setCue(cue: CuePose | null): void {
    this.#pose = cue;
    this.#placeCue();
    this.#touch();
  }

  setAreas(areas: readonly Area[]): void {
    this.#areas.set(areas);
    this.#touch();
  }

  setMarks(marks: readonly Mark[]): void {
    this.#marks.set(marks, this.#balls);
    this.#touch();
  }

  select(ball: number | null): void {
    this.#selected = ball;
    this.#marks.select(ball, this.#balls);
    this.#touch();
  }

  /**
   * What lies under a point of the page.
   *
   * @param pointer - `PointerEvent.pointerType`: balls are easier to hit by touch.
   */
  pick(clientX: number, clientY: number, pointer = "mouse"): Pick {
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

  /**
   * Where a place of the table is on the page, px; null behind the camera.
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
   * Draws; call it from a loop of animation frames while {@link needsFrame}. Where motion is drawn at
   * less than full quality, a still follows when nothing has changed for a while.
   */
  render(): void {
    const start = performance.now();
    // Before the cameras move: what they change needs another frame.
    this.#dirty = false;
    const still = this.#calm;
    this.#calm = false;
    this.#govern(still);
    this.#draw();
    this.#renderMs = performance.now() - start;
    this.#awaitCalm(still);
  }

  /** The picture as PNG, with all shadows and `scale` (2) pixels per pixel of the page. */
  async capture(scale = 2): Promise<Blob> {
    this.#apply({ ...STILL, pixelRatio: scale }, scale);
    this.#draw();
    // Asked for in the same task: a canvas is cleared after it was shown.
    const encoded = new Promise<Blob | null>((resolve) =>
      this.#canvas.toBlob(resolve, "image/png"),
    );
    this.#applyLevel();
    this.render();
    const blob = await encoded;
    if (!blob) {
      throw new Error("The browser could not encode the picture; take it with a smaller scale.");
    }
    return blob;
  }

  /** Follows the canvas's size; called by itself when that changes. */
  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#canvas;
    if (width === 0 || height === 0) return;
    this.#renderer.setSize(width, height, false);
    this.#rig.setAspect(width / height);
    this.#balls.setViewer(this.#rig.side);
    this.#touch();
  }

  /** Gives everything back; the viewer cannot be used afterwards. */
  dispose(): void {
    this.#watcher.disconnect();
    this.#canvas.removeEventListener("webglcontextrestored", this.#restored);
    cancelAnimationFrame(this.#request);
    clearTimeout(this.#timer);
    for (const part of [
      this.#rig,
      this.#table,
      this.#balls,
      this.#ghosts,
      this.#traces,
      this.#aim,
      this.#areas,
      this.#fan,
      this.#cue,
      this.#marks,
      this.#room,
      this.#lighting,
    ]) {
      part.dispose();
    }
    this.#renderer.dispose();
  }

  readonly #restored = (): void => this.#touch();

  #touch(): void {
    this.#dirty = true;
    this.#onChange();
  }

  /** What depends on where the balls are. */
  #follow(): void {
    this.#placeCue();
    this.#marks.select(this.#selected, this.#balls);
    this.#touch();
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

  #draw(): void {
    this.#rig.update(performance.now());
    this.#renderer.render(this.#scene, this.#rig.camera);
  }

  /** Judges the time between two frames, if this is the browser's next one after the last picture. */
  #govern(still: boolean): void {
    const frame = Number(document.timeline.currentTime);
    const changed = this.#governor.frame(frame, frame === this.#nextFrame && !still);
    if (still) this.#apply(STILL, this.#stillRatio);
    else if (this.#sharp || (changed && this.#quality === "auto")) this.#applyLevel();
    this.#sharp = still;
    this.#nextFrame = NaN;
    cancelAnimationFrame(this.#request);
    // The frame after a still is late for the still's sake.
    if (!still) this.#request = requestAnimationFrame((time) => (this.#nextFrame = time));
  }

  /** Once nothing has changed for a while, the picture that stands is drawn at full quality. */
  #awaitCalm(still: boolean): void {
    clearTimeout(this.#timer);
    if (still || this.#quality !== "auto" || this.#level === 0) return;
    this.#timer = setTimeout(() => {
      if (this.#dirty) return;
      this.#calm = true;
      this.#touch();
    }, CALM);
  }

  /** Pixels per pixel of the page in stills: without smoothing, twice as many are the smoothing. */
  get #stillRatio(): number {
    return this.#software ? STILL.pixelRatio : devicePixelRatio;
  }

  #applyLevel(): void {
    this.#apply(LEVELS[this.#level]!, devicePixelRatio);
  }

  /** Index of the quality that is shown. */
  get #level(): number {
    return { auto: this.#governor.level, low: LOW, high: 0 }[this.#quality];
  }

  #apply(level: Level, screen: number): void {
    const shadows = level.shadows && this.#shadowsAllowed;
    const ratio = Math.min(level.pixelRatio, screen);
    if (this.#renderer.getPixelRatio() !== ratio) this.#renderer.setPixelRatio(ratio);
    this.#renderer.shadowMap.enabled = shadows;
    this.#lighting.shadows = shadows;
    this.#balls.setShadows(shadows);
    this.#balls.setDetail(level.detail);
  }

  /** What the cameras show: the table with its rails, or the balls on endless cloth. */
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
      const missing = Math.max(ENDLESS_MARGIN, (ENDLESS_LEAST - (high - low)) / 2);
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
