/** Pseudorandom numbers that are the same in every run. */

export interface Random {
  /** Uniform in [low, high). */
  uniform(low: number, high: number): number;
  /** Gaussian with mean 0 and this standard deviation. */
  gaussian(deviation: number): number;
  /** One of the values. */
  choice<T>(values: readonly T[]): T;
}

/** A Lehmer generator (multiplier 48271, modulus 2³¹ − 1). */
export function generator(seed: number): Random {
  const modulus = 2147483647;
  let state = (48271 * (seed + 1)) % modulus;
  // Neighbouring seeds have similar first numbers.
  for (let k = 0; k < 8; k += 1) state = (48271 * state) % modulus;
  const next = () => {
    state = (48271 * state) % modulus;
    return (state - 1) / (modulus - 1);
  };
  return {
    uniform: (low, high) => low + (high - low) * next(),
    gaussian: (deviation) =>
      deviation * Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next()),
    choice: (values) => values[Math.floor(next() * values.length)]!,
  };
}
