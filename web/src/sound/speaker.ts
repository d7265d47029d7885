/** Plays the impacts of running replays. */

import type { Trace } from "../engine/index.ts";
import { type Impact, impactsOf } from "./impacts.ts";
import { type Moment, Schedule } from "./schedule.ts";
import { sound } from "./voices.ts";

/** Loudness of all sounds together, so that a break does not clip. */
const MASTER = 0.5;

/** How long a phone vibrates when the tip meets the ball, ms. */
const BUZZ = 12;

export class Speaker {
  #context: AudioContext | null = null;
  #output: AudioNode | null = null;
  #trace: Trace | null = null;
  #schedule: Schedule | null = null;
  readonly #playing = new Set<() => void>();

  /**
   * Readies the audio. Browsers allow it only within a gesture of the user, such as the click that
   * shoots.
   */
  wake(): void {
    if (typeof AudioContext === "undefined" || !isActivated()) return;
    if (!this.#context) {
      this.#context = new AudioContext();
      const limiter = new DynamicsCompressorNode(this.#context, { threshold: -12, ratio: 8 });
      const gain = new GainNode(this.#context, { gain: MASTER });
      gain.connect(limiter).connect(this.#context.destination);
      this.#output = gain;
    }
    // A refusal leaves the replay silent.
    this.#context.resume().catch(() => undefined);
  }

  /** Call once per picture of a running replay. */
  follow(trace: Trace, moment: Moment): void {
    if (trace !== this.#trace || !this.#schedule?.follows(moment.time)) {
      this.silence();
      this.#trace = trace;
      this.#schedule = new Schedule(impactsOf(trace), moment.time);
    }
    for (const { impact, delay } of this.#schedule.due(moment)) this.#sound(impact, delay);
  }

  #sound(impact: Impact, delay: number): void {
    if (impact.kind === "tip" && "vibrate" in navigator && isActivated()) navigator.vibrate(BUZZ);
    const [context, output] = [this.#context, this.#output];
    if (context?.state !== "running" || !output) return;
    const stop = sound(context, output, impact, context.currentTime + delay);
    if (!stop) return;
    this.#playing.add(stop);
    setTimeout(() => this.#playing.delete(stop), 1000 * (delay + 0.5));
  }

  /** Silences what sounds or is about to: the replay was paused, moved or left. */
  silence(): void {
    for (const stop of this.#playing) stop();
    this.#playing.clear();
    this.#schedule = null;
    this.#trace = null;
  }
}

/**
 * Whether the user has touched or clicked the page. Before, browsers refuse sound and vibration, and report
 * each attempt: an embedded trace plays by itself.
 */
function isActivated(): boolean {
  // Firefox has it since version 120.
  return !("userActivation" in navigator) || navigator.userActivation.hasBeenActive;
}
