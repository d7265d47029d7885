/** `Player` over the WebAssembly module. */

import { json, known, numbers, text, whole } from "./arguments.ts";
import type { TableOptions } from "./drawn-tables.ts";
import { refuse } from "./error.ts";
import { Handle, checked } from "./handle.ts";
import { noiseJson, noiseOf } from "./noise.ts";
import * as wasm from "./pkg/carom_wasm.js";
import type {
  Analysis,
  Decision,
  ExplainOptions,
  Perception,
  Player,
  PlayerOptions,
  Progress,
  Thought,
} from "./player.ts";
import type { Frame } from "./rules.ts";
import { type Counting, checkTable, MOST_RANKED, rankedOnTables } from "./ranked-plays.ts";
import type { Noise } from "./types.ts";

/** Simulated shots of a decision if no budget is given, as in Python. */
const USUAL_SIMULATIONS = 20_000;
/** The samples of this number of simulated shots take about a gigabyte; WebAssembly has four. */
const MOST_SIMULATIONS = 1e7;
const MOST_ROUNDS = 2 ** 32 - 1;
const USUAL_PLAYS = 5;
/** More than a search has candidates. */
const MOST_PLAYS = 1000;

const OPTIONS = {
  name: true,
  noise: true,
  opponentNoise: true,
  perception: true,
  simulations: true,
  rounds: true,
  time: true,
  seed: true,
} as const;
const TABLES = { posterior: true, draws: true } as const;
const EXPLAIN = { ...TABLES, count: true } as const;

/** The objects of frames and shots in WebAssembly's memory. */
type Objects = Pick<Counting, "frame" | "shot">;

export class WasmPlayer implements Player {
  readonly name: string;
  readonly noise: Noise;
  readonly #player: Handle<wasm.Player>;
  readonly #thinking: Handle<wasm.Thinking>;
  readonly #objects: Objects;
  readonly #perception: Perception | undefined;
  readonly #seed: number;

  constructor(options: PlayerOptions, objects: Objects) {
    const { name = "carom" } = known("options", options, OPTIONS);
    const player = checked(() => new wasm.Player(text("name", name)));
    this.name = player.name();
    this.#player = new Handle("player", player);
    const usual = player.noise() ?? wasm.olympiad(1);
    this.noise = options.noise ?? noiseOf(usual);
    this.#thinking = new Handle("player", thinkingOf(options, usual, player.simulations()));
    this.#objects = objects;
    this.#perception = options.perception;
    this.#seed = options.seed ?? 0;
  }

  choose(frame: Frame, options: TableOptions = {}): Decision {
    return finished(this.beginChoice(frame, options));
  }

  explain(frame: Frame, options: ExplainOptions = {}): Analysis {
    return finished(this.beginAnalysis(frame, options));
  }

  beginChoice(frame: Frame, options: TableOptions = {}): Thought<Decision> {
    const given = known("options", options, TABLES);
    if (given.posterior !== undefined && frame.state.request.kind === "shot") {
      // Without a play the search answers alone.
      return new MappedThought(this.beginAnalysis(frame, { ...given, count: 1 }), (found) =>
        found.plays.length > 0 ? decisionOf(found) : this.choose(frame),
      );
    }
    return new WasmThought(this.#begin(frame), (thought, interrupted) => {
      type Written = Pick<Decision, "play" | "choice" | "win_chance" | "simulations" | "rounds">;
      const decision = JSON.parse(thought.intoDecision()) as Written;
      const concession = decision.play === null && decision.choice === null;
      return { ...decision, concession, interrupted };
    });
  }

  beginAnalysis(frame: Frame, options: ExplainOptions = {}): Thought<Analysis> {
    const { count = USUAL_PLAYS, ...tables } = known("options", options, EXPLAIN);
    if (count === 0) refuse("out-of-range", "count", "0 plays are nothing", "ask for at least 1");
    const plays = Number(whole("count", count, MOST_PLAYS));
    const read = (thought: wasm.Thought, interrupted: boolean): Analysis => ({
      ...(JSON.parse(thought.intoAnalysis()) as Omit<Analysis, "interrupted">),
      interrupted,
    });
    if (tables.posterior === undefined) return new WasmThought(this.#begin(frame, plays), read);
    checkTable(this.#objects.frame(frame), tables);
    // The frame may be played on before the search has ended.
    const position = frame.copy();
    const counting: Counting = {
      ...this.#objects,
      tables,
      noise: this.noise,
      perception: this.#perception,
      seed: this.#seed,
    };
    const thought = this.#begin(position, Math.max(plays, MOST_RANKED));
    return new WasmThought(
      thought,
      (ended, interrupted) => rankedOnTables(read(ended, interrupted), position, counting, plays),
      () => position.free(),
    );
  }

  #begin(frame: Frame, plays?: number): wasm.Thought {
    const [player, thinking] = [this.#player.object, this.#thinking.object];
    const position = this.#objects.frame(frame);
    return checked(() => player.begin(position, thinking, plays));
  }

  free(): void {
    this.#player.free();
    this.#thinking.free();
  }
}

/**
 * The options for the engine.
 * @param usual The errors of the player's level, or the Olympiad's.
 * @param named The simulated shots of the player's name.
 */
function thinkingOf(
  options: PlayerOptions,
  usual: string,
  named: number | undefined,
): wasm.Thinking {
  const { noise, opponentNoise, perception, simulations, rounds, time, seed = 0 } = options;
  if (simulations !== undefined && options.name?.includes(":")) {
    refuse(
      "duplicate",
      "simulations",
      `the name "${options.name}" has a number of them too`,
      "write only one",
    );
  }
  const isLimited = time !== undefined || rounds !== undefined;
  const most = simulations ?? named ?? (isLimited ? MOST_SIMULATIONS : USUAL_SIMULATIONS);
  const own = noise === undefined ? usual : noiseJson(noise);
  return checked(
    () =>
      new wasm.Thinking(
        own,
        opponentNoise === undefined ? own : noiseJson(opponentNoise, "opponentNoise"),
        perception === undefined ? undefined : json(perception, "perception"),
        whole("seed", seed),
        atLeastOne("simulations", most, MOST_SIMULATIONS),
        rounds === undefined ? undefined : Number(atLeastOne("rounds", rounds, MOST_ROUNDS)),
        time === undefined ? undefined : seconds(time),
      ),
  );
}

function atLeastOne(place: string, value: number, most: number): bigint {
  if (value !== 0) return whole(place, value, most);
  return refuse(
    "out-of-range",
    place,
    "0 is out of range",
    `write a whole number from 1 to ${most}`,
  );
}

function seconds(time: number): number {
  const [value] = numbers("", { time }, ["time"]);
  if (value! > 0 && value! < Infinity) return value!;
  return refuse(
    "out-of-range",
    "time",
    `${value} is out of range`,
    "write a number of seconds above 0",
  );
}

function finished<T>(thought: Thought<T>): T {
  try {
    while (thought.playRound());
    return thought.end();
  } finally {
    thought.free();
  }
}

class WasmThought<T> implements Thought<T> {
  readonly #handle: Handle<wasm.Thought>;
  readonly #end: (thought: wasm.Thought, interrupted: boolean) => T;
  readonly #freed: () => void;

  /** @param freed Frees what the end needs besides the thought. */
  constructor(
    thought: wasm.Thought,
    end: (thought: wasm.Thought, interrupted: boolean) => T,
    freed: () => void = () => undefined,
  ) {
    this.#handle = new Handle("thought", thought);
    this.#end = end;
    this.#freed = freed;
  }

  playRound(): boolean {
    return checked(() => this.#handle.object.playRound());
  }

  get progress(): Progress {
    return JSON.parse(this.#handle.object.progress()) as Progress;
  }

  end(interrupted = false): T {
    const thought = this.#handle.take();
    try {
      return checked(() => this.#end(thought, interrupted));
    } finally {
      this.#freed();
    }
  }

  free(): void {
    this.#handle.free();
    this.#freed();
  }
}

/** A thought whose result becomes another value. */
class MappedThought<S, T> implements Thought<T> {
  readonly #thought: Thought<S>;
  readonly #map: (result: S) => T;

  constructor(thought: Thought<S>, map: (result: S) => T) {
    this.#thought = thought;
    this.#map = map;
  }

  playRound(): boolean {
    return this.#thought.playRound();
  }

  get progress(): Progress {
    return this.#thought.progress;
  }

  end(interrupted = false): T {
    return this.#map(this.#thought.end(interrupted));
  }

  free(): void {
    this.#thought.free();
  }
}

/** The best play of an analysis as a decision. */
function decisionOf({ plays, simulations, rounds, interrupted }: Analysis): Decision {
  const [best] = plays;
  return {
    play: best?.play ?? null,
    choice: null,
    win_chance: best?.win_chance ?? null,
    simulations,
    rounds,
    concession: best === undefined,
    interrupted,
  };
}
