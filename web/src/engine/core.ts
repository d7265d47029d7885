/**
 * The engine without the WebAssembly that `index.ts` carries: for a worker, which is sent
 * `Engine.module`, and for whoever serves the `.wasm` file himself.
 */
import { CaromError } from "./error.js";
import * as wasm from "./pkg/carom_wasm.js";
import {
  type BallInfo,
  type Batch,
  type BreakOptions,
  type Choice,
  type Engine,
  type Frame,
  type FrameOptions,
  type FrameState,
  type FrameTerms,
  type Geometry,
  type Noise,
  type NoisyBatch,
  type Outcome,
  type Play,
  type Ruling,
  type Shot,
  type ShotFile,
  type Strike,
  STRIDE,
  type Trace,
  type TraceFile,
} from "./types.js";

export * from "./error.js";
export * from "./types.js";

const USUAL_TERMS: Required<FrameTerms> = { target: 40, miss: true, patience: 100 };

let loaded: Promise<Engine> | undefined;

/**
 * The engine, ready to use. There is one in a thread: every call gives the same, whatever its source.
 * @throws WebAssembly.CompileError if the source is no WebAssembly.
 */
export function load(source: BufferSource | WebAssembly.Module): Promise<Engine> {
  loaded ??= start(source).catch((error: unknown) => {
    loaded = undefined;
    throw error;
  });
  return loaded;
}

async function start(source: BufferSource | WebAssembly.Module): Promise<Engine> {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  await wasm.default({ module_or_path: module });
  return new WasmEngine(module);
}

/** What `call` gives; what the engine refuses, as a `CaromError`. */
function checked<T>(call: () => T): T {
  try {
    return call();
  } catch (error) {
    if (error instanceof Error && ("place" in error || "shot" in error)) {
      const { place, shot } = error as { place?: string; shot?: string };
      throw new CaromError(error.message, place, shot);
    }
    throw error;
  }
}

/** A number that the engine counts with. */
/** JSON of a file that is text or a value; undefined has none, and becomes null, which the engine refuses. */
function asText(file: unknown): string {
  return typeof file === "string" ? file : JSON.stringify(file === undefined ? null : file);
}

function whole(name: string, value: number): bigint {
  if (Number.isSafeInteger(value) && value >= 0) return BigInt(value);
  throw new CaromError(
    `${name}: ${value} is out of range; write a whole number from 0 to ${Number.MAX_SAFE_INTEGER}`,
    name,
  );
}

class WasmEngine implements Engine {
  readonly version = wasm.version();
  readonly games: readonly string[] = wasm.games();
  readonly ruleSets: readonly string[] = wasm.ruleSets();
  readonly module: WebAssembly.Module;
  #tables: readonly Geometry[] | undefined;
  #physics: Engine["physics"] | undefined;
  #noises: Engine["noisePresets"] | undefined;

  constructor(module: WebAssembly.Module) {
    this.module = module;
  }

  get tables() {
    return (this.#tables ??= JSON.parse(wasm.tables()) as Geometry[]);
  }

  get physics() {
    return (this.#physics ??= JSON.parse(wasm.physics()) as Engine["physics"]);
  }

  shot(file: string | ShotFile): Shot {
    return new WasmShot(checked(() => wasm.Shot.fromJson(asText(file))));
  }

  trace(file: string | TraceFile): Trace {
    return new WasmTrace(checked(() => wasm.Trace.fromJson(asText(file))));
  }

  breakShot(game: string, options: BreakOptions = {}): Shot {
    const { table, speed, seed = 0, gap } = options;
    return new WasmShot(
      checked(() => wasm.breakShot(game, table, speed, whole("seed", seed), gap)),
    );
  }

  simulate(shots: readonly Shot[]): Batch {
    const list = new wasm.Shots();
    try {
      for (const shot of shots) list.push(handleOf(shot));
      return toBatch(list.simulate());
    } finally {
      list.free();
    }
  }

  olympiad(multiplier = 1): Noise {
    return named(wasm.olympiad(multiplier));
  }

  get noisePresets() {
    return (this.#noises ??= Object.fromEntries(
      (JSON.parse(wasm.noisePresets()) as [string, number[]][]).map(([name, sigmas]) => [
        name,
        named(sigmas),
      ]),
    ));
  }

  usualTable(game: string): string {
    return checked(() => wasm.usualTable(game));
  }

  frame(game: string, options: FrameOptions = {}): Frame {
    const { table, physics, seed = 0 } = options;
    const { target, miss, patience } = { ...USUAL_TERMS, ...options };
    const json = (value: unknown) => (value === undefined ? undefined : JSON.stringify(value));
    const start = whole("seed", seed);
    return new WasmFrame(
      checked(
        () => new wasm.Frame(game, json(table), json(physics), start, target, miss, patience),
      ),
    );
  }

  frameOf(game: string, shot: Shot, terms: FrameTerms = {}): Frame {
    const { target, miss, patience } = { ...USUAL_TERMS, ...terms };
    const handle = handleOf(shot);
    return new WasmFrame(checked(() => wasm.Frame.ofShot(game, handle, target, miss, patience)));
  }

  schema(kind: "shot" | "trace"): object {
    return JSON.parse(kind === "shot" ? wasm.shotSchema() : wasm.traceSchema()) as object;
  }
}

/** A strike, or the σ of one, from the engine's five numbers. */
function named(numbers: ArrayLike<number>): Strike {
  return {
    speed: numbers[0]!,
    azimuth: numbers[1]!,
    elevation: numbers[2]!,
    side: numbers[3]!,
    height: numbers[4]!,
  };
}

function handleOf(shot: Shot): wasm.Shot {
  if (shot instanceof WasmShot) return shot.handle;
  throw new TypeError("a shot of this engine is wanted: make it with Engine.shot");
}

class WasmShot implements Shot {
  readonly handle: wasm.Shot;
  #file: ShotFile | undefined;
  #geometry: Geometry | undefined;
  #balls: readonly BallInfo[] | undefined;

  constructor(handle: wasm.Shot) {
    this.handle = handle;
  }

  get file() {
    return (this.#file ??= JSON.parse(this.json()) as ShotFile);
  }

  json(): string {
    return this.handle.toJson();
  }

  get geometry() {
    return (this.#geometry ??= JSON.parse(this.handle.geometry()) as Geometry);
  }

  get balls() {
    return (this.#balls ??= this.#readBalls());
  }

  #readBalls(): BallInfo[] {
    const numbers = this.handle.balls();
    return this.handle.ids().map((id, i) => {
      const [radius, mass, x, y, z] = numbers.subarray(5 * i, 5 * i + 5);
      return { id, radius: radius!, mass: mass!, position: [x!, y!, z!] };
    });
  }

  get struck() {
    return this.handle.struck() ?? null;
  }

  get strike(): Strike | null {
    const numbers = this.handle.strike();
    if (numbers === undefined) return null;
    return named(numbers);
  }

  get miscueLimit() {
    return this.handle.miscueLimit();
  }

  withStrike({ speed, azimuth, elevation, side, height }: Strike): Shot {
    return new WasmShot(
      checked(() => this.handle.withStrike(speed, azimuth, elevation, side, height)),
    );
  }

  simulate(): Trace {
    return new WasmTrace(checked(() => this.handle.simulate()));
  }

  vary(noise: Noise, seed: number, first: number, count: number): NoisyBatch {
    const { speed, azimuth, elevation, side, height } = noise;
    const sigmas = Float64Array.of(speed, azimuth, elevation, side, height);
    const start = whole("first", first);
    const rows = Number(whole("count", count));
    const batch = checked(() => this.handle.vary(sigmas, whole("seed", seed), start, rows));
    const strikes = batch.strikes();
    return { ...toBatch(batch), strikes };
  }

  free() {
    this.handle.free();
  }
}

/** Copies a batch's arrays out, and frees it. */
function toBatch(batch: wasm.Batch): Batch {
  const texts = batch.errors();
  const errors = new Map<number, string>();
  batch.failed().forEach((shot, k) => errors.set(shot, texts[k]!));
  const result = {
    shots: batch.shots(),
    balls: batch.balls(),
    finalPosition: batch.finalPosition(),
    pocket: batch.pocket(),
    events: batch.events(),
    errors,
  };
  batch.free();
  return result;
}

class WasmTrace implements Trace {
  readonly #handle: wasm.Trace;
  readonly duration: number;
  #shot: Shot | undefined;
  #hash: string | undefined;
  #events: Trace["events"] | undefined;
  #outcome: Outcome | undefined;

  constructor(handle: wasm.Trace) {
    this.#handle = handle;
    this.duration = handle.duration();
  }

  get hash() {
    return (this.#hash ??= this.#handle.hash());
  }

  get shot() {
    return (this.#shot ??= new WasmShot(this.#handle.shot()));
  }

  json(): string {
    return this.#handle.toJson();
  }

  get events() {
    return (this.#events ??= (JSON.parse(this.json()) as TraceFile).events);
  }

  get outcome() {
    return (this.#outcome ??= JSON.parse(this.#handle.outcome()) as Outcome);
  }

  statesAt(time: number, out?: Float64Array): Float64Array {
    const length = STRIDE * this.shot.balls.length;
    if (out !== undefined && out.length !== length) {
      throw new RangeError(`out has ${out.length} numbers; it needs ${length}`);
    }
    const states = out ?? new Float64Array(length);
    checked(() => this.#handle.statesAt(time, states));
    return states;
  }

  polyline(ball: number, tolerance: number): Float64Array {
    const balls = this.shot.balls.length;
    if (!Number.isInteger(ball) || ball < 0 || ball >= balls) {
      const given = JSON.stringify(ball);
      throw new RangeError(`there is no ball ${given}; write an index from 0 to ${balls - 1}`);
    }
    if (!(tolerance > 0)) {
      throw new RangeError(`the tolerance ${tolerance} m is out of range; write one above 0`);
    }
    return this.#handle.polyline(ball, tolerance);
  }

  free() {
    this.#handle.free();
  }
}

class WasmFrame implements Frame {
  readonly #handle: wasm.Frame;
  #state: FrameState | undefined;

  constructor(handle: wasm.Frame) {
    this.#handle = handle;
  }

  get state() {
    return (this.#state ??= JSON.parse(this.#handle.toJson()) as FrameState);
  }

  get handBounds() {
    const box = this.#handle.handBounds();
    if (box === undefined) return null;
    const [left, bottom, right, top] = box;
    return [[left!, bottom!] as const, [right!, top!] as const] as const;
  }

  shot(play: Play): Shot {
    return withArguments(play, (given) => new WasmShot(checked(() => this.#handle.shot(given))));
  }

  play(play: Play) {
    const played = withArguments(play, (given) => checked(() => this.#handle.play(given)));
    this.#state = undefined;
    const ruling = JSON.parse(played.ruling()) as Ruling;
    return { ruling, trace: new WasmTrace(played.intoTrace()) };
  }

  choose(choice: Choice): Ruling {
    const ruling = checked(() => this.#handle.choose(choice));
    this.#state = undefined;
    return JSON.parse(ruling) as Ruling;
  }

  concede(): Ruling {
    const ruling = checked(() => this.#handle.concede());
    this.#state = undefined;
    return JSON.parse(ruling) as Ruling;
  }

  copy(): Frame {
    return new WasmFrame(this.#handle.copy());
  }

  free() {
    this.#handle.free();
  }
}

function withArguments<T>(
  { strike, cue_ball, call }: Play,
  use: (given: wasm.PlayArguments) => T,
): T {
  const { speed, azimuth, elevation, side, height } = strike;
  const numbers = Float64Array.of(speed, azimuth, elevation, side, height);
  const place = cue_ball && Float64Array.from(cue_ball);
  const { kind = "nothing", ball, into } = call ?? {};
  const given = new wasm.PlayArguments(numbers, place, kind, ball, into);
  try {
    return use(given);
  } finally {
    given.free();
  }
}
