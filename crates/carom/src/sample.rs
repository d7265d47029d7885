//! Sampling the parameters of shots: sequences of points in the unit cube, and quantiles of
//! distributions.
//!
//! A point depends only on the seed, its index and the number of its coordinates. So point 17 is
//! the same alone or among thousands, in any order, for any number of threads, on every platform.

use chacha20::rand_core::Rng;

use crate::math::{exp, log, pow, sqrt};
use crate::noise::random;

/// Part of the generator's key that separates these random numbers from others of the same seed.
const POINT: &[u8; 24] = b"carom: sampled parameter";
/// The same for the shift of an even sequence.
const SHIFT: &[u8; 24] = b"carom: shift of sequence";

/// A sequence of points in the unit cube.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sequence {
    /// Independent of each other, uniform: ChaCha8 (Bernstein 2008).
    Random,
    /// Low discrepancy: the additive recurrence R of Roberts (2018), after Kronecker, with steps
    /// φ⁻¹, φ⁻², … where φ is the root of x^(d+1) = x + 1. A random shift (Cranley & Patterson
    /// 1976) makes each point by itself uniform. Any run of consecutive points is as even as any
    /// other.
    Even,
}

impl Sequence {
    /// Puts point `index` of this seed into `point`; every coordinate is in (0, 1).
    pub fn point(self, seed: u64, index: u64, point: &mut [f64]) {
        match self {
            Self::Random => {
                let mut random = random(POINT, seed, index);
                point.fill_with(|| unit(random.next_u64()));
            }
            Self::Even => {
                let mut shift = random(SHIFT, seed, 0);
                let phi = root(point.len());
                let mut step = 1.0;
                for x in point {
                    step /= phi;
                    *x = unit(shift.next_u64().wrapping_add(index.wrapping_mul(in_turns(step))));
                }
            }
        }
    }
}

/// The middle of one of 2⁵² cells of (0, 1): never 0 or 1, whose normal quantiles are infinite.
fn unit(word: u64) -> f64 {
    const CELL: f64 = 1.0 / (1_u64 << 52) as f64;
    ((word >> 12) as f64 + 0.5) * CELL
}

/// A number in (0, 1) in units of 2⁻⁶⁴; odd, so that its multiples visit every such number.
fn in_turns(x: f64) -> u64 {
    const WHOLE: f64 = 18_446_744_073_709_551_616.0;
    (x * WHOLE) as u64 | 1
}

/// The root φ > 1 of x^(d+1) = x + 1.
fn root(dimensions: usize) -> f64 {
    let mut phi = 2.0;
    // A fixed-point iteration: every step at least halves the error.
    for _ in 0..64 {
        phi = pow(1.0 + phi, 1.0 / (dimensions as f64 + 1.0));
    }
    phi
}

/// The distribution of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Uniform between the two numbers.
    Uniform(f64, f64),
    /// The logarithm is uniform between those of the two numbers, both positive.
    LogUniform(f64, f64),
    /// Gaussian: mean and standard deviation.
    Normal(f64, f64),
}

impl Distribution {
    /// The quantile of `u` in (0, 1): the value that a drawn one does not exceed with probability
    /// `u`.
    pub fn quantile(self, u: f64) -> f64 {
        match self {
            Self::Uniform(a, b) => a + (b - a) * u,
            Self::LogUniform(a, b) => exp(log(a) + (log(b) - log(a)) * u),
            Self::Normal(mean, sigma) => mean + sigma * normal_quantile(u),
        }
    }
}

/// The standard normal distribution's quantile of p in (0, 1), to about 1 part in 10¹⁶: Wichura
/// (1988), *The percentage points of the normal distribution*, algorithm AS 241, PPND16, with its
/// names. NaN for p outside (0, 1).
pub fn normal_quantile(p: f64) -> f64 {
    /// Half the width of the central interval, and its square.
    const SPLIT1: f64 = 0.425;
    const CONST1: f64 = 0.180_625;
    /// Where the two formulas for the tails meet, and the centre of the nearer one.
    const SPLIT2: f64 = 5.0;
    const CONST2: f64 = 1.6;
    let q = p - 0.5;
    if q.abs() <= SPLIT1 {
        let r = CONST1 - q * q;
        return q * ratio(r, &A, &B);
    }
    let r = sqrt(-log(if q < 0.0 { p } else { 1.0 - p }));
    let tail = if r <= SPLIT2 { ratio(r - CONST2, &C, &D) } else { ratio(r - SPLIT2, &E, &F) };
    if q < 0.0 { -tail } else { tail }
}

/// The quotient of two polynomials, coefficients from the constant upwards.
fn ratio(r: f64, over: &[f64; 8], under: &[f64; 8]) -> f64 {
    let value = |polynomial: &[f64; 8]| polynomial.iter().rev().fold(0.0, |sum, c| sum * r + c);
    value(over) / value(under)
}

const A: [f64; 8] = [
    3.387_132_872_796_366_5,
    1.331_416_678_917_843_8e2,
    1.971_590_950_306_551_3e3,
    1.373_169_376_550_946e4,
    4.592_195_393_154_987e4,
    6.726_577_092_700_87e4,
    3.343_057_558_358_813e4,
    2.509_080_928_730_122_7e3,
];
const B: [f64; 8] = [
    1.0,
    4.231_333_070_160_091e1,
    6.871_870_074_920_579e2,
    5.394_196_021_424_751e3,
    2.121_379_430_158_659_7e4,
    3.930_789_580_009_271e4,
    2.872_908_573_572_194_3e4,
    5.226_495_278_852_854e3,
];
const C: [f64; 8] = [
    1.423_437_110_749_683_5,
    4.630_337_846_156_546,
    5.769_497_221_460_691,
    3.647_848_324_763_204_5,
    1.270_458_252_452_368_4,
    2.417_807_251_774_506e-1,
    2.272_384_498_926_918_4e-2,
    7.745_450_142_783_414e-4,
];
const D: [f64; 8] = [
    1.0,
    2.053_191_626_637_759,
    1.676_384_830_183_803_8,
    6.897_673_349_851e-1,
    1.481_039_764_274_800_8e-1,
    1.519_866_656_361_645_7e-2,
    5.475_938_084_995_345e-4,
    1.050_750_071_644_416_9e-9,
];
const E: [f64; 8] = [
    6.657_904_643_501_103,
    5.463_784_911_164_114,
    1.784_826_539_917_291_3,
    2.965_605_718_285_048_7e-1,
    2.653_218_952_657_612_4e-2,
    1.242_660_947_388_078_4e-3,
    2.711_555_568_743_487_6e-5,
    2.010_334_399_292_288_1e-7,
];
const F: [f64; 8] = [
    1.0,
    5.998_322_065_558_88e-1,
    1.369_298_809_227_358e-1,
    1.487_536_129_085_061_5e-2,
    7.868_691_311_456_133e-4,
    1.846_318_317_510_054_8e-5,
    1.421_511_758_316_446e-7,
    2.044_263_103_389_939_8e-15,
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Round-off of a quantile, relative to 1 or to itself.
    const ROUNDING: f64 = 4e-16;

    #[test]
    fn wichuras_own_test_values_come_out() {
        // AS 241, section "Test results".
        for (p, z) in [
            (0.25, -0.674_489_750_196_081_7),
            (0.001, -3.090_232_306_167_813_5),
            (1e-20, -9.262_340_089_798_408),
        ] {
            let found = normal_quantile(p);
            assert!((found - z).abs() <= ROUNDING * z.abs().max(1.0), "{p}: {found} is not {z}");
        }
        assert_eq!(normal_quantile(0.5), 0.0);
    }

    #[test]
    fn quantiles_are_symmetric_about_one_half() {
        for p in [0.4, 0.07, 0.01, 1e-6] {
            let sum = normal_quantile(p) + normal_quantile(1.0 - p);
            // 1 − p has lost digits of p.
            assert!(sum.abs() < 1e-9, "{p}: {sum}");
        }
    }

    #[test]
    fn a_point_is_a_function_of_its_seed_and_index_alone() {
        for sequence in [Sequence::Random, Sequence::Even] {
            let point = |seed, index| {
                let mut p = [0.0; 3];
                sequence.point(seed, index, &mut p);
                p
            };
            assert_eq!(point(1, 1000), point(1, 1000));
            assert_ne!(point(1, 1000), point(1, 1001));
            assert_ne!(point(1, 1000), point(2, 1000));
            assert!((0..1000).flat_map(|i| point(9, i)).all(|x| x > 0.0 && x < 1.0));
        }
    }

    #[test]
    fn even_points_leave_no_cell_of_the_square_empty_where_random_ones_do() {
        const CELLS: usize = 16;
        let empty = |sequence: Sequence, first: u64| {
            let mut hit = [false; CELLS * CELLS];
            for index in 0..3 * hit.len() as u64 {
                let mut p = [0.0; 2];
                sequence.point(5, first + index, &mut p);
                let [i, j] = p.map(|x| (x * CELLS as f64) as usize);
                hit[i * CELLS + j] = true;
            }
            hit.iter().filter(|hit| !**hit).count()
        };
        for first in [0, 1_000_000_007, u64::MAX / 3] {
            assert_eq!(empty(Sequence::Even, first), 0);
            assert!(empty(Sequence::Random, first) > 0);
        }
    }
}
