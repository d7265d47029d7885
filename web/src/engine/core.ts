/**
 * The engine without embedded WebAssembly: for a worker, which receives `Engine.module` from its page,
 * and for sites that serve the `.wasm` file themselves.
 */
import { bits, boolean, json, known, named, numbers, text, whole } from "./arguments.ts";
import type { CaromRoute, DiamondReading } from "./carom-route.ts";
import type {
  DrillFile,
  Goal,
  GoalArea,
  GoalCondition,
  ListedPuzzle,
  Puzzle,
  ShotVerdict,
} from "./drill-goals.ts";
import type { BreakOptions, Engine, RollingBand, RollingOptions } from "./engine.ts";
import { evaluate, type EvaluateOptions, type Evaluation } from "./evaluation.ts";
import { CaromError, type Refusal, refusalOf, refuse } from "./error.ts";
import { FRAME_FORMAT, replay } from "./frame-record.ts";
import { Handle, checked, uncloneable } from "./handle.ts";
import { noiseJson, noiseOf } from "./noise.ts";
import * as wasm from "./pkg/carom_wasm.js";
import type { Player, PlayerOptions } from "./player.ts";
import type { StudyFile, TaskVerdict } from "./study.ts";
import type { MatchFrame, MatchGame, MatchHeader, MatchRecord } from "./match.ts";
import type {
  Choice,
  Frame,
  FrameMove,
  FrameOptions,
  FrameRecord,
  FrameState,
  FrameOfTerms,
  FrameTerms,
  GameFacts,
  PlannedPlay,
  Play,
  PlayErrors,
  Ruling,
  Successors,
} from "./rules.ts";
import { readStrike } from "./strike.ts";
import {
  type BallInfo,
  type Batch,
  type CoefficientKey,
  type Geometry,
  type LeaveAim,
  type LeaveOptions,
  type Noise,
  type NoisyBatch,
  type Outcome,
  type Point,
  type PotAim,
  type Shot,
  type ShotFile,
  type Strike,
  type StrikeInput,
  STRIDE,
  type Trace,
  type TraceEnd,
  type TraceFile,
  type VaryOptions,
} from "./types.ts";
import { warnOnce } from "./warn.ts";
import { WasmPlayer } from "./wasm-player.ts";

export * from "./carom-route.ts";
export type * from "./drill-goals.ts";
export * from "./engine.ts";
export * from "./error.ts";
export type * from "./drawn-tables.ts";
export type * from "./evaluation.ts";
export * from "./match.ts";
export * from "./player.ts";
export * from "./rules.ts";
export * from "./types.ts";

/** Default options of `rollingBands`, those of Python's `rolling_bands`. */
const ROLLING = { fastest: 3, share: 0.005, least: 0.005, gravity: 9.80665 } as const;

/** Largest values of the 32-bit integers that the engine takes for `points` and `patience`. */
const LARGEST_POINTS = 2 ** 31 - 1;
const LARGEST_PATIENCE = 2 ** 32 - 1;

/**
 * Memory (bytes) that one batch may take: 1 GiB. WebAssembly has 4 GiB at most, and a failed
 * allocation there stops the engine for good.
 */
const BATCH_MEMORY = 2 ** 30;
/** Bytes of a batch per row, and per row and ball. */
const ROW_BYTES = 44;
const BALL_BYTES = 25;

/** Memory of as many successors: about half of `BATCH_MEMORY`. */
const MOST_SUCCESSORS = 2 ** 24;

/** Variants of `evaluate`, as in Python. */
const USUAL_VARIANTS = 10_000;

/** Variants that rank the strikes of `leaveAim`: more take longer than a user waits. */
const MOST_VARIANTS = 100_000;

// The keys of options and plays; the types make each list complete.
const VARIANTS = { seed: true, first: true } as const;
const LEAVE = { noise: true, variants: true, speed: true, offset: true } as const;
const BREAK = { table: true, preset: true, speed: true, seed: true, gap: true } as const;
const TERMS = { points: true, miss: true, patience: true, target: true } as const;
const PLAY_ERRORS = { noise: true, seed: true } as const;
const PLAY = { strike: true, cue_ball: true, call: true, cling: true } as const;
const CALL = { kind: true, ball: true, into: true } as const;

let loaded: Promise<Engine> | undefined;

/**
 * Loads the engine. A thread has one engine: later calls return the same one, whatever their source.
 * @throws WebAssembly.CompileError if the source is not WebAssembly.
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

class WasmEngine implements Engine {
  readonly version = wasm.version();
  readonly tip = wasm.tip();
  readonly gameFacts = factsByName(wasm.gameFacts());
  readonly defaultTerms = JSON.parse(wasm.defaultOptions()) as Engine["defaultTerms"];
  readonly games: readonly string[] = Object.keys(this.gameFacts);
  readonly ruleSets: readonly string[] = this.games;
  readonly players: readonly string[] = wasm.players();
  readonly module: WebAssembly.Module;
  #tables: readonly Geometry[] | undefined;
  #physics: Engine["physics"] | undefined;
  #puzzles: readonly ListedPuzzle[] | undefined;
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
    return new WasmShot(checked(() => wasm.Shot.fromJson(json(file))));
  }

  traceToCap(error: CaromError): Trace {
    if (error.shot === undefined) {
      refuse(
        "wrong-state",
        "error",
        "it is not one of a shot at its cap of events",
        "simulate the shot",
      );
    }
    const shot = checked(() => wasm.Shot.fromJson(error.shot!));
    try {
      return new WasmTrace(checked(() => shot.simulateToCap()));
    } finally {
      shot.free();
    }
  }

  trace(file: string | TraceFile): Trace {
    return new WasmTrace(checked(() => wasm.Trace.fromJson(json(file))));
  }

  breakShot(game: string, options: BreakOptions = {}): Shot {
    const { table, preset, seed = 0 } = known("options", options, BREAK);
    if (table !== undefined) text("table", table);
    if (preset !== undefined) text("preset", preset);
    const [speed, gap] = (["speed", "gap"] as const).map((key) =>
      options[key] === undefined ? undefined : numbers("", options, [key])[0],
    );
    return new WasmShot(
      checked(() =>
        wasm.breakShot(text("game", game), table, speed, whole("seed", seed), gap, preset),
      ),
    );
  }

  get puzzles() {
    return (this.#puzzles ??= JSON.parse(wasm.puzzles()) as ListedPuzzle[]);
  }

  puzzle(id: string): Puzzle {
    return JSON.parse(checked(() => wasm.puzzle(text("id", id)))) as Puzzle;
  }

  drill(file: string | DrillFile): DrillFile {
    return JSON.parse(checked(() => wasm.readDrill(json(file)))) as DrillFile;
  }

  areaDistance(area: GoalArea, table: string, [x, y]: Point): number {
    return checked(() => wasm.areaDistance(json(area), text("table", table), x, y));
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
    const [factor] = numbers("", { multiplier }, ["multiplier"]);
    return noiseOf(checked(() => wasm.olympiad(factor!)));
  }

  get noisePresets() {
    return (this.#noises ??= Object.fromEntries(
      JSON.parse(wasm.noisePresets()) as [string, Noise][],
    ));
  }

  checkNoise(noise: Noise): void {
    checked(() => wasm.checkNoise(noiseJson(noise)));
  }

  currentPresetName(name: string): string {
    return wasm.currentPresetName(name) ?? name;
  }

  withDatedNames<T extends Pick<ShotFile, "table" | "physics">>(file: T): T {
    return checked(() => JSON.parse(wasm.withDatedNames(JSON.stringify(file))) as T);
  }

  rollingBands(
    a: number,
    b: number,
    options: RollingOptions = {},
  ): number | readonly RollingBand[] {
    const law = numbers("", { a, b }, ["a", "b"]);
    const given = known("options", options, ROLLING);
    const tolerance = numbers("", { ...ROLLING, ...given }, Object.keys(ROLLING));
    const [fastest, share, least, gravity] = tolerance;
    return checked(
      () =>
        JSON.parse(wasm.rollingBands(law[0]!, law[1]!, fastest!, share!, least!, gravity!)) as
          number | RollingBand[],
    );
  }

  usualTable(game: string): string {
    return checked(() => wasm.usualTable(text("game", game)));
  }

  frame(game: string, options: FrameOptions = {}): Frame {
    const { seed = 0 } = known("options", options, {
      ...TERMS,
      table: true,
      physics: true,
      seed: true,
    });
    const terms = termsOf(options, this.defaultTerms);
    const optional = (value: unknown) => (value === undefined ? undefined : JSON.stringify(value));
    const [table, physics] = [optional(options.table), optional(options.physics)];
    const { points, miss, patience } = terms;
    const start = typeof seed === "string" ? bits("seed", seed) : whole("seed", seed);
    const frame = checked(
      () => new wasm.Frame(text("game", game), table, physics, start, points, miss, patience),
    );
    return new WasmFrame(frame, () => {
      const setup = wasm.Frame.recordedSetup(game, table, physics);
      return { game, ...(JSON.parse(setup) as Pick<ShotFile, "table">), seed, ...terms };
    });
  }

  frameOf(game: string, shot: Shot, terms: FrameOfTerms = {}): Frame {
    const { player } = known("options", terms, { ...TERMS, player: true });
    const shooter = player === undefined ? undefined : Number(whole("player", player, 1));
    const written = termsOf(terms, this.defaultTerms);
    const { points, miss, patience } = written;
    const handle = handleOf(shot);
    const frame = checked(() =>
      wasm.Frame.ofShot(text("game", game), handle, points, miss, patience, shooter),
    );
    const file = handle.toJson(true, true);
    const isSecond = frame.player() === 1;
    return new WasmFrame(frame, () => ({
      game,
      shot: JSON.parse(file) as ShotFile,
      ...written,
      ...(isSecond && { player: 1 }),
    }));
  }

  checkRecord(record: FrameRecord): void {
    checked(() => wasm.checkRecord(json(record)));
  }

  replay(record: FrameRecord): Frame {
    return replay(this, record);
  }

  matchRecord(record: string): MatchRecord {
    return new WasmMatchRecord(checked(() => new wasm.MatchRecord(text("record", record))));
  }

  study(json: string): StudyFile {
    checked(() => wasm.checkStudy(text("json", json)));
    return JSON.parse(json) as StudyFile;
  }

  judge(trace: Trace, goal: readonly GoalCondition[]): TaskVerdict {
    if (trace instanceof WasmTrace) return trace.judge(goal);
    throw new TypeError("this is not a trace of this engine; make it with Shot.simulate");
  }

  player(options: PlayerOptions = {}): Player {
    return new WasmPlayer(options, { frame: frameHandleOf, shot: handleOf });
  }

  evaluate(
    shot: Shot,
    noise: Noise,
    n = USUAL_VARIANTS,
    options: EvaluateOptions = {},
  ): Evaluation {
    return evaluate(handleOf(shot), frameHandleOf, noise, n, options);
  }

  schema(kind: string): object {
    const schemas: Readonly<Record<string, () => string>> = {
      shot: wasm.shotSchema,
      trace: wasm.traceSchema,
      study: wasm.studySchema,
    };
    const schema = Object.hasOwn(schemas, kind) ? schemas[kind] : undefined;
    if (schema) return JSON.parse(schema()) as object;
    refuse(
      "unknown-name",
      "kind",
      `there is no schema "${kind}"`,
      'write "shot", "trace" or "study"',
    );
  }
}

function factsByName(json: string): Engine["gameFacts"] {
  const facts = JSON.parse(json) as readonly GameFacts[];
  return Object.fromEntries(facts.map((game) => [game.name, game]));
}

function termsOf(given: FrameTerms, usual: Engine["defaultTerms"]): Engine["defaultTerms"] {
  // eslint-disable-next-line @typescript-eslint/no-deprecated -- the old spelling still works
  const { target: old } = given;
  if (old !== undefined) warnOnce("FrameTerms.target is called FrameTerms.points now");
  const { points, miss, patience } = {
    ...usual,
    ...(old !== undefined && { points: old }),
    ...given,
  };
  return {
    points: Number(whole("options.points", points, LARGEST_POINTS)),
    miss: boolean("options.miss", miss),
    patience: Number(whole("options.patience", patience, LARGEST_PATIENCE)),
  };
}

/** A strike from the engine's five numbers. */
function strikeOf(values: ArrayLike<number>): Strike {
  return {
    speed: values[0]!,
    azimuth: values[1]!,
    elevation: values[2]!,
    side: values[3]!,
    height: values[4]!,
  };
}

function handleOf(shot: Shot): wasm.Shot {
  if (shot instanceof WasmShot) return shot.handle.object;
  throw new TypeError("this is not a shot of this engine; make it with Engine.shot");
}

function frameHandleOf(frame: Frame): wasm.Frame {
  if (frame instanceof WasmFrame) return frame.handle.object;
  throw new TypeError("this is not a frame of this engine; make it with Engine.frame");
}

const SHOT = uncloneable("a shot", "send shot.file, and read it with engine.shot");
const TRACE = uncloneable("a trace", "send trace.json(), and read it with engine.trace");
const MATCH = uncloneable(
  "a record of a match",
  "send its text, and read it with engine.matchRecord",
);
const FRAME = uncloneable("a frame", "send frame.record, and restore it with engine.replay");

class WasmMatchRecord implements MatchRecord {
  readonly kind = MATCH;
  readonly #handle: Handle<wasm.MatchRecord>;
  readonly header: MatchHeader;
  readonly isFinished: boolean;
  readonly frames: readonly MatchFrame[];

  constructor(record: wasm.MatchRecord) {
    this.#handle = new Handle("record", record);
    this.header = JSON.parse(record.header()) as MatchHeader;
    this.isFinished = record.isFinished();
    this.frames = JSON.parse(record.frames()) as MatchFrame[];
  }

  game(frame: number): MatchGame {
    const number = whole("frame", frame);
    return JSON.parse(checked(() => this.#handle.object.game(number))) as MatchGame;
  }

  free() {
    this.#handle.free();
  }
}

class WasmShot implements Shot {
  readonly kind = SHOT;
  readonly handle: Handle<wasm.Shot>;
  #file: ShotFile | undefined;
  #geometry: Geometry | undefined;
  #physics: Shot["physics"] | undefined;
  #balls: readonly BallInfo[] | undefined;

  constructor(shot: wasm.Shot) {
    this.handle = new Handle("shot", shot);
  }

  get file() {
    return (this.#file ??= JSON.parse(this.json()) as ShotFile);
  }

  json(): string {
    return this.handle.object.toJson(true, false);
  }

  get source() {
    if (!this.hasDefaultElevation) return this.file;
    return JSON.parse(this.handle.object.toJson(false, false)) as ShotFile;
  }

  get hasDefaultElevation() {
    return this.handle.object.hasDefaultElevation();
  }

  get geometry() {
    return (this.#geometry ??= JSON.parse(this.handle.object.geometry()) as Geometry);
  }

  get physics() {
    return (this.#physics ??= JSON.parse(this.handle.object.physics()) as Shot["physics"]);
  }

  get balls() {
    return (this.#balls ??= this.#readBalls());
  }

  #readBalls(): BallInfo[] {
    const values = this.handle.object.balls();
    return this.handle.object.ids().map((id, i) => {
      const [radius, mass, x, y, z] = values.subarray(5 * i, 5 * i + 5);
      return { id, radius: radius!, mass: mass!, position: [x!, y!, z!] };
    });
  }

  get struck() {
    return this.handle.object.struck() ?? null;
  }

  get strike(): Strike | null {
    const values = this.handle.object.strike();
    return values === undefined ? null : strikeOf(values);
  }

  get miscueLimit() {
    return this.handle.object.miscueLimit();
  }

  coefficientAt(key: CoefficientKey, at: number): number {
    const [value] = numbers("", { at }, ["at"]);
    return checked(() => this.handle.object.coefficientAt(text("key", key), value!));
  }

  judge(goal: Goal, left: readonly string[] = []): ShotVerdict {
    const verdict = checked(() => this.handle.object.judge(json(goal), [...left]));
    return JSON.parse(verdict) as ShotVerdict;
  }

  withStrike(strike: StrikeInput): Shot {
    const { numbers: values } = readStrike(strike);
    return new WasmShot(checked(() => this.handle.object.withStrike(...values)));
  }

  get until() {
    return this.handle.object.until() ?? null;
  }

  withUntil(until: number | null): Shot {
    const time = until === null ? undefined : numbers("", { until }, ["until"])[0];
    return new WasmShot(checked(() => this.handle.object.withUntil(time)));
  }

  #indices(ball: string, pocket: string): readonly [number, number] {
    const balls = this.balls.map(({ id }) => id);
    const pockets = this.geometry.pockets.map(({ name }) => name);
    return [named("ball", ball, balls), named("pocket", pocket, pockets)];
  }

  potAim(ball: string, pocket: string, options: { readonly near?: boolean } = {}): PotAim | null {
    const { near = false } = known("options", options, { near: true });
    const indices = this.#indices(ball, pocket);
    const aim = checked(() => this.handle.object.potAim(...indices, boolean("near", near)));
    if (!aim) return null;
    const found = {
      strike: strikeOf(aim.strike()),
      margin: aim.margin(),
      kind: aim.kind(),
      route: aim.route(),
      losesCueBall: aim.losesCueBall(),
    };
    aim.free();
    return found;
  }

  leaveAim(
    ball: string,
    pocket: string,
    place: Point,
    options: LeaveOptions = {},
  ): LeaveAim | null {
    const given = known("options", options, LEAVE);
    const { noise, variants = 100, speed = [0.5, 7], offset = 0.45 } = given;
    const indices = this.#indices(ball, pocket);
    const at = Float64Array.from(numbers("place", place, ["0", "1"]));
    const range = Float64Array.from([
      ...numbers("speed", speed, ["0", "1"]),
      ...numbers("", { offset }, ["offset"]),
    ]);
    const errors = noise === undefined ? wasm.olympiad(1) : noiseJson(noise);
    const count = Number(whole("variants", variants, MOST_VARIANTS));
    const aim = checked(() => this.handle.object.leaveAim(...indices, at, range, errors, count));
    if (!aim) return null;
    const [x, y] = aim.end();
    const found = {
      strike: strikeOf(aim.strike()),
      end: [x!, y!] as const,
      distance: aim.distance(),
      isReached: aim.isReached(),
      chance: aim.chance(),
    };
    aim.free();
    return found;
  }

  simulate(): Trace {
    return new WasmTrace(checked(() => this.handle.object.simulate()));
  }

  vary(noise: Noise, n: number, options: VaryOptions | number = {}, count?: number): NoisyBatch {
    if (typeof options === "number") {
      warnOnce(
        "Shot.vary(noise, seed, first, count) is spelled Shot.vary(noise, n, { seed, first }) now",
      );
      return this.vary(noise, count!, { seed: n, first: options });
    }
    const { seed = 0, first = 0 } = known("options", options, VARIANTS);
    const most = Math.floor(BATCH_MEMORY / (ROW_BYTES + BALL_BYTES * this.balls.length));
    const rows = Number(whole("n", n, most, "ask for more in parts, with `first`"));
    const errors = noiseJson(noise);
    const [start, from] = [whole("seed", seed), whole("first", first)];
    const batch = checked(() => this.handle.object.vary(errors, rows, start, from));
    const strikes = batch.strikes();
    return Object.assign(toBatch(batch), { strikes });
  }

  variant(noise: Noise, index = 0, options: { readonly seed?: number } = {}): Shot {
    const { seed = 0 } = known("options", options, { seed: true });
    const errors = noiseJson(noise);
    const [start, number] = [whole("seed", seed), whole("index", index)];
    return new WasmShot(checked(() => this.handle.object.variant(errors, start, number)));
  }

  free() {
    this.handle.free();
  }
}

/** Copies a batch's arrays out of WebAssembly's memory, and frees it. */
function toBatch(batch: wasm.Batch): Batch {
  const failed = batch.failed();
  const refusals = new Map<number, Refusal>();
  batch.errors().forEach((error, k) => refusals.set(failed[k]!, refusalOf(error as Refusal)));
  const errors = new Map([...refusals].map(([shot, { message }]) => [shot, message]));
  const result = {
    shots: batch.shots(),
    balls: batch.balls(),
    final_position: batch.finalPosition(),
    pocket: batch.pocket(),
    events: batch.events(),
    errors,
    refusals,
  };
  batch.free();
  // The old spelling: not enumerable, so that it is neither copied nor printed.
  Object.defineProperty(result, "finalPosition", {
    get: () => {
      warnOnce("Batch.finalPosition is called Batch.final_position now");
      return result.final_position;
    },
  });
  return result;
}

class WasmTrace implements Trace {
  readonly kind = TRACE;
  readonly #handle: Handle<wasm.Trace>;
  readonly duration: number;
  readonly end: TraceEnd;
  #shot: Shot | undefined;
  #hash: string | undefined;
  #events: Trace["events"] | undefined;
  #outcome: Outcome | undefined;

  constructor(trace: wasm.Trace) {
    this.#handle = new Handle("trace", trace);
    this.duration = trace.duration();
    this.end = trace.end() as TraceEnd;
  }

  get hash() {
    return (this.#hash ??= this.#handle.object.hash());
  }

  get shot() {
    return (this.#shot ??= new WasmShot(this.#handle.object.shot()));
  }

  json(): string {
    return this.#handle.object.toJson();
  }

  get events() {
    return (this.#events ??= (JSON.parse(this.json()) as TraceFile).events);
  }

  get outcome() {
    return (this.#outcome ??= JSON.parse(this.#handle.object.outcome()) as Outcome);
  }

  judge(goal: readonly GoalCondition[]): TaskVerdict {
    return JSON.parse(checked(() => this.#handle.object.judge(json(goal)))) as TaskVerdict;
  }

  statesAt(time: number, out?: Float64Array): Float64Array {
    const trace = this.#handle.object;
    const length = STRIDE * this.shot.balls.length;
    if (out !== undefined && !(out instanceof Float64Array && out.length === length)) {
      const given = (out as ArrayLike<number> | null)?.length ?? "no";
      throw new RangeError(`out has ${given} numbers; it needs ${length}, in a Float64Array`);
    }
    const states = out ?? new Float64Array(length);
    const [at] = numbers("", { time }, ["time"]);
    checked(() => {
      trace.statesAt(at!, states);
    });
    return states;
  }

  polyline(ball: number, tolerance: number): Float64Array {
    const trace = this.#handle.object;
    const balls = this.shot.balls.length;
    if (!Number.isInteger(ball) || ball < 0 || ball >= balls) {
      const given = JSON.stringify(ball);
      throw new RangeError(`there is no ball ${given}; write an index from 0 to ${balls - 1}`);
    }
    if (!(tolerance > 0)) {
      throw new RangeError(`the tolerance ${tolerance} m is out of range; write one above 0`);
    }
    return trace.polyline(ball, tolerance);
  }

  countedTouches(): readonly (readonly [event: number, ball: string | null])[] {
    return JSON.parse(this.#handle.object.countedTouches()) as [number, string | null][];
  }

  diamondReading(ball: number, event?: number): DiamondReading | null {
    const found = this.#handle.object.diamondReading(ball, event);
    return found === undefined ? null : (JSON.parse(found) as DiamondReading);
  }

  caromRoute(): CaromRoute | null {
    const found = this.#handle.object.caromRoute();
    return found === undefined ? null : (JSON.parse(found) as CaromRoute);
  }

  free() {
    this.#handle.free();
  }
}

class WasmFrame implements Frame {
  readonly kind = FRAME;
  readonly handle: Handle<wasm.Frame>;
  readonly #setup: () => FrameRecord["setup"];
  readonly #moves: FrameMove[];
  #state: FrameState | undefined;

  constructor(frame: wasm.Frame, setup: () => FrameRecord["setup"], moves: FrameMove[] = []) {
    this.handle = new Handle("frame", frame);
    this.#setup = setup;
    this.#moves = moves;
  }

  get record(): FrameRecord {
    const [setup, moves] = [this.#setup(), this.#moves];
    return structuredClone({ format: FRAME_FORMAT, engine: wasm.version(), setup, moves });
  }

  get hash() {
    return this.handle.object.hash();
  }

  get state() {
    return (this.#state ??= JSON.parse(this.handle.object.toJson()) as FrameState);
  }

  get handBounds() {
    const box = this.handle.object.handBounds();
    if (box === undefined) return null;
    const [left, bottom, right, top] = box;
    return [[left!, bottom!] as const, [right!, top!] as const] as const;
  }

  describe() {
    return this.handle.object.describe();
  }

  answerSchema() {
    return JSON.parse(this.handle.object.answerSchema()) as Readonly<Record<string, unknown>>;
  }

  shot(play: Play): Shot {
    const frame = this.handle.object;
    return withPlay(play, (given) => new WasmShot(checked(() => frame.shot(given))));
  }

  play(play: Play, errors: PlayErrors = {}) {
    const frame = this.handle.object;
    known("errors", errors, PLAY_ERRORS);
    const noise = errors.noise && noiseJson(errors.noise);
    const given = errors.seed ?? 0;
    const seeds = (typeof given === "number" ? [given] : given).map((seed) => whole("seed", seed));
    const result = withPlay(play, (given) =>
      checked(() =>
        noise ? frame.playNoisy(given, noise, BigUint64Array.from(seeds)) : frame.play(given),
      ),
    );
    this.#state = undefined;
    this.#moves.push({ play: playedOf(play, result) });
    const ruling = JSON.parse(result.ruling()) as Ruling;
    return { ruling, trace: new WasmTrace(result.intoTrace()) };
  }

  choose(choice: Choice): Ruling {
    const ruling = checked(() => this.handle.object.choose(text("choice", choice)));
    this.#state = undefined;
    this.#moves.push({ choice });
    return JSON.parse(ruling) as Ruling;
  }

  concede(): Ruling {
    const ruling = checked(() => this.handle.object.concede());
    this.#state = undefined;
    this.#moves.push({ concede: true });
    return JSON.parse(ruling) as Ruling;
  }

  successors(play: Play, noise: Noise, n: number, options: VaryOptions = {}): Successors {
    const frame = this.handle.object;
    const errors = noiseJson(noise);
    const { seed = 0, first = 0 } = known("options", options, VARIANTS);
    const rows = Number(whole("n", n, MOST_SUCCESSORS, "ask for more in parts, with `first`"));
    const [start, from] = [whole("seed", seed), whole("first", first)];
    const found = withPlay(play, (given) =>
      checked(() => frame.successors(given, errors, rows, start, from)),
    );
    try {
      const [player, winner] = [found.player(), found.winner()];
      return { player, winner, legal: found.legal(), cue_ball: found.cueBall() };
    } finally {
      found.free();
    }
  }

  copy(): Frame {
    return new WasmFrame(this.handle.object.copy(), this.#setup, [...this.#moves]);
  }

  free() {
    this.handle.free();
  }
}

/** A play as it was played, for a record: with all numbers of the strike, and policies that are not the usual ones. */
function playedOf({ strike: given, cue_ball, call }: Play, result: wasm.PlayResult): PlannedPlay {
  const { obstruction = "report", miscue = "refuse" } = given;
  const cling = result.cling();
  return {
    strike: {
      ...strikeOf(result.strike()),
      ...(obstruction !== "report" && { obstruction }),
      ...(miscue !== "refuse" && { miscue }),
    },
    ...(cue_ball && { cue_ball: [cue_ball[0], cue_ball[1]] }),
    ...(call && { call: { ...call } }),
    ...(cling !== undefined && { cling: JSON.parse(cling) as NonNullable<ShotFile["cling"]> }),
  };
}

/** Converts a play for the engine, and frees the converted play afterwards. */
function withPlay<T>(play: Play, use: (given: wasm.PlayArguments) => T): T {
  const { strike, cue_ball, call, cling } = known("play", play, PLAY);
  const { obstruction, miscue, ...read } = readStrike(strike);
  const place = cue_ball === undefined ? undefined : numbers("cue_ball", cue_ball, ["0", "1"]);
  const { kind = "nothing", ball, into } = call === undefined ? {} : known("call", call, CALL);
  text("call.kind", kind);
  if (ball !== undefined) text("call.ball", ball);
  if (into !== undefined) text("call.into", into);
  const given = new wasm.PlayArguments(...read.numbers);
  try {
    checked(() => {
      if (place !== undefined) given.setCueBall(place[0]!, place[1]!);
      given.setCall(kind, ball, into);
      given.setPolicy(obstruction, miscue);
      if (cling !== undefined) given.setCling(json(cling));
    });
    return use(given);
  } finally {
    given.free();
  }
}
