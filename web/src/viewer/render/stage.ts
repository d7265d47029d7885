/**
 * Draws the scene at a level of quality. With software rendering the table is drawn once while the camera
 * rests. Then a picture restores it only in the tiles that the moving parts cover or have left, and draws
 * these parts on top.
 */

import {
  type Camera,
  LinearFilter,
  Matrix4,
  type Object3D,
  PCFShadowMap,
  type PerspectiveCamera,
  type Scene,
  Vector2,
  WebGLRenderer,
} from "three";
import { Extent } from "./extent.ts";
import { Kept } from "./kept-picture.ts";
import { DEPTH, MOVING, STILL } from "./layers.ts";
import { Copier, Picture } from "./picture.ts";
import { Tiles } from "./tiles.ts";

/** Usual magnification and diameter (CSS pixels) of the loupe, and its border as a share of the radius. */
export const ZOOM = 2.5;
export const LOUPE = 132;
const BORDER = 0.035;
/** Time (ms) between two looks whether a picture is drawn. */
const POLL = 8;

/** The circle of a loupe, CSS pixels from the upper left corner of the canvas. */
export interface Loupe {
  /** Centre of the part that is magnified. */
  readonly from: readonly [x: number, y: number];
  /** Centre of the circle. */
  readonly at: readonly [x: number, y: number];
  readonly zoom: number;
}

/**
 * Where the loupe for a finger is: above it, or beside it at the upper edge; inside the canvas.
 *
 * @param size - Width and height of the canvas, CSS pixels.
 */
export function loupePlace(
  [x, y]: readonly [number, number],
  [width, height]: readonly [number, number],
): [x: number, y: number] {
  const radius = LOUPE / 2;
  const away = 1.35 * LOUPE;
  const inside = (at: number, end: number): number => Math.max(radius, Math.min(end - radius, at));
  if (y - away >= radius) return [inside(x, width), inside(y - away, height)];
  // Beside the finger, on the side with more room.
  return [inside(x + (x < width / 2 ? away : -away), width), inside(y, height)];
}

/**
 * A context for pictures without transparency, which the browser puts on the page faster; three.js would
 * ask for transparency. Antialiasing is fixed for the life of a context, and too slow for software
 * rendering, with which the canvas keeps what a picture does not change.
 *
 * @throws Error if the browser does not support WebGL 2.
 */
function opaque(canvas: HTMLCanvasElement, software: boolean): WebGL2RenderingContext {
  const options = { alpha: false, antialias: !software, preserveDrawingBuffer: software };
  const context = canvas.getContext("webgl2", { ...options, depth: true, stencil: false });
  if (!context) throw new Error("The browser has no WebGL 2: update it, or allow it 3D graphics.");
  return context;
}

export class Stage {
  readonly software: boolean;
  readonly renderer: WebGLRenderer;
  readonly #scene: Scene;
  readonly #copier = new Copier();
  /** The table without moving parts, and the tiles of the screen that show something else. */
  readonly #table = new Kept();
  readonly #tiles = new Tiles();
  readonly #extent = new Extent(this.#tiles);
  /** A whole picture with smooth edges, and the loupe's. */
  readonly #smooth = new Picture(true);
  readonly #loupe = new Picture(true, LinearFilter);
  /** The camera of this picture and of the last one, and whether `#table` shows what it sees. */
  readonly #view = new Matrix4();
  #last: Matrix4 | null = null;
  #fresh = false;
  #smooths = true;
  /** Whether `#smooth` has the next picture already. */
  #isFine = false;
  readonly #size = new Vector2();

  constructor(canvas: HTMLCanvasElement, scene: Scene, software: boolean) {
    this.software = software;
    this.#scene = scene;
    this.renderer = new WebGLRenderer({ canvas, context: opaque(canvas, software) });
    // The check waits for every shader; the browser reports an invalid one anyway.
    this.renderer.debug.checkShaderErrors = false;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.autoClear = false;
  }

  /** Call it when the table, the light or the background has changed. */
  invalidate(): void {
    this.#fresh = false;
  }

  /**
   * Whether the kept table has smooth edges. The first picture comes sooner without them: a software renderer
   * compiles shaders of their own for them.
   */
  get smooths(): boolean {
    return this.#smooths || !this.software;
  }

  set smooths(smooths: boolean) {
    if (smooths !== this.#smooths) this.#fresh = false;
    this.#smooths = smooths;
  }

  /**
   * Draws what the next picture with smooth edges needs, ahead of it and beside the screen; what it shows stays
   * as it is until then. Wait for {@link finished} before that picture.
   *
   * @param fine - Whether the edges of everything are smoothed, or the table's.
   */
  prepare(camera: Camera, fine: boolean): void {
    if (!this.software) return;
    if (fine) {
      this.#into(this.#smooth, () => this.#whole(camera));
      this.#isFine = true;
    } else if (this.#fresh) {
      this.#layer(STILL, this.#table.smooth, camera);
    }
  }

  /** Shows the table's smooth edges, which {@link prepare} has drawn. */
  showSmooth(): void {
    this.#smooths = true;
    this.#tiles.markAll();
  }

  set shadows(drawn: boolean) {
    this.renderer.shadowMap.enabled = drawn;
  }

  set background(color: string) {
    this.renderer.setClearColor(color);
    this.#fresh = false;
  }

  get pixelRatio(): number {
    return this.renderer.getPixelRatio();
  }

  setPixelRatio(ratio: number): void {
    if (this.renderer.getPixelRatio() === ratio) return;
    this.renderer.setPixelRatio(ratio);
    this.#fresh = false;
  }

  resize(width: number, height: number): void {
    const { x, y } = this.renderer.getSize(this.#size);
    // Another size empties the canvas, and the table is drawn again.
    if (x === width && y === height) return;
    this.renderer.setSize(width, height, false);
    this.#fresh = false;
  }

  /** Height of the canvas, device pixels. */
  get height(): number {
    return this.renderer.getDrawingBufferSize(this.#size).y;
  }

  /**
   * Starts to compile the shaders of these objects and their children, also if they are hidden. Yields after
   * each object.
   */
  *compile(objects: readonly Object3D[], camera: Camera): Generator<undefined, void, undefined> {
    for (const object of objects) {
      this.renderer.compile(object, camera, this.#scene);
      yield;
    }
    if (this.software) this.#table.compile(this.renderer);
  }

  /**
   * Resolves when everything so far is drawn. Without this the browser waits for it on the main thread, with
   * software rendering for half a second at the first picture, which compiles the shaders.
   */
  async finished(): Promise<void> {
    const context = this.renderer.getContext() as WebGL2RenderingContext;
    const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    context.flush();
    const isDone = () =>
      context.isContextLost() ||
      context.getSyncParameter(fence, context.SYNC_STATUS) === context.SIGNALED;
    while (!isDone()) await new Promise((resolve) => setTimeout(resolve, POLL));
    context.deleteSync(fence);
  }

  /**
   * Draws a picture.
   *
   * @param fine - Whether software rendering smooths the edges of everything.
   */
  draw(camera: PerspectiveCamera, fine: boolean, loupe: Loupe | null): void {
    const { renderer } = this;
    renderer.setRenderTarget(null);
    if (!this.software) this.#whole(camera);
    else if (fine) this.#finely(camera);
    else this.#quickly(camera);
    this.#isFine = false;
    if (loupe) this.#magnify(camera, loupe);
  }

  dispose(): void {
    this.#copier.dispose();
    for (const picture of [this.#table, this.#smooth, this.#loupe]) picture.dispose();
    this.renderer.dispose();
  }

  #whole(camera: Camera): void {
    camera.layers.set(STILL);
    camera.layers.enable(MOVING);
    this.renderer.clear();
    this.renderer.render(this.#scene, camera);
  }

  #finely(camera: Camera): void {
    if (!this.#isFine) this.#into(this.#smooth, () => this.#whole(camera));
    this.#copier.copy(this.renderer, this.#smooth);
    this.#tiles.markAll();
  }

  #quickly(camera: Camera): void {
    this.#view.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const moves = this.#last !== null && !this.#view.equals(this.#last);
    this.#last = (this.#last ?? new Matrix4()).copy(this.#view);
    // While the camera moves, the table's picture could be used only once.
    if (moves) {
      this.#fresh = false;
      this.#whole(camera);
      return;
    }
    const { x: width, y: height } = this.renderer.getDrawingBufferSize(this.#size);
    this.#tiles.resize(width, height);
    if (!this.#fresh) this.#keepTable(camera);
    camera.layers.set(MOVING);
    this.#extent.mark(this.#scene, camera, [width, height]);
    this.#table.restore(this.renderer, this.#tiles, this.#tiles.take(), this.#smooths);
    this.renderer.render(this.#scene, camera);
  }

  #keepTable(camera: Camera): void {
    const { depths, smooth } = this.#table;
    const parts: readonly [number, Picture][] = this.#smooths
      ? [
          [STILL, smooth],
          [DEPTH, depths],
        ]
      : [[STILL, depths]];
    for (const [layer, picture] of parts) this.#layer(layer, picture, camera);
    this.#tiles.markAll();
    this.#fresh = true;
  }

  #layer(layer: number, picture: Picture, camera: Camera): void {
    camera.layers.set(layer);
    this.#into(picture, () => {
      this.renderer.clear();
      this.renderer.render(this.#scene, camera);
    });
  }

  #into(picture: Picture, draw: () => void): void {
    this.renderer.getDrawingBufferSize(this.#size);
    if (picture.width !== this.#size.x || picture.height !== this.#size.y)
      picture.setSize(this.#size.x, this.#size.y);
    this.renderer.setRenderTarget(picture);
    draw();
    this.renderer.setRenderTarget(null);
  }

  #magnify(camera: PerspectiveCamera, { from, at, zoom }: Loupe): void {
    const { renderer } = this;
    const { x: width, y: height } = renderer.getSize(this.#size);
    const side = Math.round(LOUPE * renderer.getPixelRatio());
    if (this.#loupe.width !== side) this.#loupe.setSize(side, side);
    const seen = LOUPE / zoom;
    camera.setViewOffset(width, height, from[0] - seen / 2, from[1] - seen / 2, seen, seen);
    renderer.setRenderTarget(this.#loupe);
    this.#whole(camera);
    renderer.setRenderTarget(null);
    camera.clearViewOffset();
    renderer.setViewport(at[0] - LOUPE / 2, height - at[1] - LOUPE / 2, LOUPE, LOUPE);
    this.#copier.disc(renderer, this.#loupe, BORDER);
    renderer.setViewport(0, 0, width, height);
    this.#markDisc(at, height);
  }
  /** Marks the disc of the loupe around `at` (CSS pixels), which the next picture removes. */
  #markDisc([x, y]: Loupe["at"], height: number): void {
    const ratio = this.renderer.getPixelRatio();
    const [left, bottom] = [x - LOUPE / 2, height - y - LOUPE / 2].map((at) => at * ratio) as [
      number,
      number,
    ];
    this.#tiles.mark(left, bottom, left + LOUPE * ratio, bottom + LOUPE * ratio);
  }
}
