/**
 * The sounds of impacts, synthesised: a short burst of noise through resonances that decay. Their
 * frequencies were chosen by ear after the impacts' durations: two balls touch for 0.25 ms (Alciatore,
 * TP B.29), so their click reaches some kilohertz; a cushion gives way for some milliseconds and is dull.
 */

import type { Impact, ImpactKind } from "./impacts.ts";

/** A resonance. */
interface Tone {
  /** Hz. */
  readonly frequency: number;
  /** Time in which it falls to a thousandth, s. */
  readonly decay: number;
  /** Share of the loudness. */
  readonly gain: number;
}

interface Voice {
  readonly tones: readonly Tone[];
  /** Upper limit of the noise (Hz), its decay (s) and its share of the loudness. */
  readonly noise: Tone;
  /** Change of velocity (m/s) that is heard at full loudness. */
  readonly loudest: number;
}

const VOICES: Readonly<Record<ImpactKind, Voice>> = {
  tip: {
    tones: [{ frequency: 950, decay: 0.04, gain: 0.6 }],
    noise: { frequency: 2500, decay: 0.02, gain: 0.4 },
    loudest: 9,
  },
  ball: {
    tones: [
      { frequency: 3100, decay: 0.035, gain: 0.5 },
      { frequency: 5400, decay: 0.02, gain: 0.3 },
    ],
    noise: { frequency: 8000, decay: 0.008, gain: 0.3 },
    loudest: 6,
  },
  rail: {
    tones: [{ frequency: 140, decay: 0.12, gain: 0.7 }],
    noise: { frequency: 600, decay: 0.05, gain: 0.4 },
    loudest: 7,
  },
  slate: {
    tones: [{ frequency: 420, decay: 0.06, gain: 0.6 }],
    noise: { frequency: 1500, decay: 0.02, gain: 0.4 },
    loudest: 5,
  },
  pocket: {
    tones: [{ frequency: 95, decay: 0.25, gain: 0.7 }],
    noise: { frequency: 900, decay: 0.18, gain: 0.5 },
    loudest: 6,
  },
};

/** The loudness of an impact, 0 to 1: loudness is heard as about the 0.6th power of the intensity. */
export function loudness({ kind, strength }: Impact): number {
  return Math.min(1, strength / VOICES[kind].loudest) ** 1.2;
}

/** Loudness below which an impact is not played. */
const INAUDIBLE = 0.003;

/** Duration of the noise that all voices share, s. */
const NOISE = 0.5;

const noises = new WeakMap<BaseAudioContext, AudioBuffer>();

/** White noise, always the same. */
function noiseOf(context: BaseAudioContext): AudioBuffer {
  const kept = noises.get(context);
  if (kept) return kept;
  const buffer = context.createBuffer(1, Math.ceil(NOISE * context.sampleRate), context.sampleRate);
  const samples = buffer.getChannelData(0);
  // A linear congruential generator (Park & Miller 1988), so that every film sounds the same.
  let state = 1;
  for (let k = 0; k < samples.length; k += 1) {
    state = (state * 48271) % 2147483647;
    samples[k] = (2 * state) / 2147483647 - 1;
  }
  noises.set(context, buffer);
  return buffer;
}

/**
 * Plays an impact.
 *
 * @param when Time of the context, s.
 * @returns A function that silences it; null if it is too quiet to be heard.
 */
export function sound(
  context: BaseAudioContext,
  target: AudioNode,
  impact: Impact,
  when: number,
): (() => void) | null {
  const level = loudness(impact);
  if (level < INAUDIBLE) return null;
  const { tones, noise } = VOICES[impact.kind];
  const out = new StereoPannerNode(context, { pan: 0.6 * impact.pan });
  out.connect(target);
  const sources: AudioScheduledSourceNode[] = [];
  const add = (source: AudioScheduledSourceNode, last: AudioNode, { decay, gain }: Tone) => {
    const envelope = new GainNode(context, { gain: 0 });
    envelope.gain.setValueAtTime(level * gain, when);
    envelope.gain.exponentialRampToValueAtTime(level * gain * 1e-3, when + decay);
    last.connect(envelope).connect(out);
    source.start(when);
    source.stop(when + decay);
    sources.push(source);
  };
  for (const tone of tones) {
    const source = new OscillatorNode(context, { frequency: tone.frequency });
    add(source, source, tone);
  }
  const source = new AudioBufferSourceNode(context, { buffer: noiseOf(context) });
  const filter = new BiquadFilterNode(context, { type: "lowpass", frequency: noise.frequency });
  source.connect(filter);
  add(source, filter, noise);
  return () => {
    for (const each of sources) each.stop();
    out.disconnect();
  };
}
