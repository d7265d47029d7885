//! Errors that are spread evenly, by which candidates are compared.
//!
//! The mean value of a play is an integral over five normal deviates. The first points of a sequence with
//! low discrepancy come nearer to it than as many random ones (Niederreiter, *Random number generation and
//! quasi-Monte Carlo methods*, 1992). The sequence is Sobol's (1967). A random shift of the digits for every
//! seed leaves each point with the distribution of [`carom::Noise::draw`].

use carom::math::{log, sqrt};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// Binary digits of a point, and so of the number of points.
const DIGITS: usize = 40;
/// The primitive polynomials (degree, and inner coefficients as binary digits) and the first direction numbers
/// of all dimensions but the first: the first rows of Joe & Kuo (2008), `new-joe-kuo-6`.
const POLYNOMIALS: [(usize, u64, [u64; 3]); 4] =
    [(1, 0, [1, 0, 0]), (2, 1, [1, 3, 0]), (3, 1, [1, 3, 1]), (3, 2, [1, 1, 1])];
/// The direction numbers of the five dimensions.
const DIRECTIONS: [[u64; DIGITS]; 5] = directions();
/// Which dimension belongs to the speed, the azimuth, the elevation, the side and the height. The first are
/// the most even, and the azimuth decides most shots.
const DIMENSIONS: [usize; 5] = [1, 0, 4, 2, 3];
/// Separates these random numbers from others of the same seed.
const STREAM: u128 = 0x6576_656e;

/// The errors of one seed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EvenErrors {
    shifts: [u64; 5],
}

impl EvenErrors {
    pub(crate) fn new(seed: u64) -> Self {
        let mut random = Pcg64::new(u128::from(seed), STREAM);
        Self { shifts: core::array::from_fn(|_| random.next_u64() >> (64 - DIGITS)) }
    }

    /// The deviates of number `index`, below 2⁴⁰, for [`carom::Noise::apply`].
    pub(crate) fn deviates(&self, index: u64) -> [f64; 5] {
        DIMENSIONS.map(|dimension| {
            let used = DIRECTIONS[dimension].iter().enumerate();
            let point = used
                .filter(|(digit, _)| index >> digit & 1 == 1)
                .fold(self.shifts[dimension], |point, (_, direction)| point ^ direction);
            // The middle of the interval that the digits leave is never 0 or 1.
            normal_quantile((point as f64 + 0.5) / (1_u64 << DIGITS) as f64)
        })
    }
}

/// Direction numbers by the recurrence of Bratley & Fox (1988), as whole numbers of [`DIGITS`] digits.
const fn directions() -> [[u64; DIGITS]; 5] {
    let mut all = [[0; DIGITS]; 5];
    let mut k = 0;
    while k < DIGITS {
        all[0][k] = 1 << (DIGITS - 1 - k);
        k += 1;
    }
    let mut dimension = 1;
    while dimension < 5 {
        let (degree, inner, first) = POLYNOMIALS[dimension - 1];
        let mut k = 0;
        while k < DIGITS {
            all[dimension][k] = if k < degree {
                first[k] << (DIGITS - 1 - k)
            } else {
                let mut number =
                    all[dimension][k - degree] ^ (all[dimension][k - degree] >> degree);
                let mut j = 1;
                while j < degree {
                    if inner >> (degree - 1 - j) & 1 == 1 {
                        number ^= all[dimension][k - j];
                    }
                    j += 1;
                }
                number
            };
            k += 1;
        }
        dimension += 1;
    }
    all
}

/// The value below which a normal deviate lies with probability `share`, in (0, 1); its error is
/// below 1e-15 of it (Wichura 1988, algorithm AS 241, PPND16).
fn normal_quantile(share: f64) -> f64 {
    const MIDDLE: [[f64; 8]; 2] = [
        [
            3.387_132_872_796_366_6,
            133.141_667_891_784_38,
            1_971.590_950_306_551_3,
            13_731.693_765_509_46,
            45_921.953_931_549_87,
            67_265.770_927_008_7,
            33_430.575_583_588_13,
            2_509.080_928_730_122_7,
        ],
        [
            1.0,
            42.313_330_701_600_91,
            687.187_007_492_057_9,
            5_394.196_021_424_751,
            21_213.794_301_586_597,
            39_307.895_800_092_71,
            28_729.085_735_721_943,
            5_226.495_278_852_854,
        ],
    ];
    const TAIL: [[f64; 8]; 2] = [
        [
            1.423_437_110_749_683_5,
            4.630_337_846_156_546,
            5.769_497_221_460_691,
            3.647_848_324_763_204_5,
            1.270_458_252_452_368_4,
            0.241_780_725_177_450_6,
            0.022_723_844_989_269_184,
            7.745_450_142_783_414e-4,
        ],
        [
            1.0,
            2.053_191_626_637_759,
            1.676_384_830_183_803_8,
            0.689_767_334_985_1,
            0.148_103_976_427_480_08,
            0.015_198_666_563_616_457,
            5.475_938_084_995_345e-4,
            1.050_750_071_644_416_9e-9,
        ],
    ];
    const FAR: [[f64; 8]; 2] = [
        [
            6.657_904_643_501_103,
            5.463_784_911_164_114,
            1.784_826_539_917_291_3,
            0.296_560_571_828_504_87,
            0.026_532_189_526_576_124,
            0.001_242_660_947_388_078_4,
            2.711_555_568_743_487_6e-5,
            2.010_334_399_292_288_1e-7,
        ],
        [
            1.0,
            0.599_832_206_555_887_9,
            0.136_929_880_922_735_8,
            0.014_875_361_290_850_615,
            7.868_691_311_456_133e-4,
            1.846_318_317_510_054_8e-5,
            1.421_511_758_316_446e-7,
            2.044_263_103_389_939_8e-15,
        ],
    ];
    let polynomial = |factors: &[f64; 8], x: f64| factors.iter().rev().fold(0.0, |y, f| y * x + f);
    let ratio =
        |[above, below]: &[[f64; 8]; 2], x: f64| polynomial(above, x) / polynomial(below, x);
    let middle = share - 0.5;
    if middle.abs() <= 0.425 {
        return middle * ratio(&MIDDLE, 0.180_625 - middle * middle);
    }
    let out = sqrt(-log(share.min(1.0 - share)));
    let deviate = if out <= 5.0 { ratio(&TAIL, out - 1.6) } else { ratio(&FAR, out - 5.0) };
    if middle < 0.0 { -deviate } else { deviate }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::SQRT_2;

    use super::{EvenErrors, normal_quantile};

    #[test]
    fn the_quantile_is_the_inverse_of_the_normal_distribution() {
        let below = |x: f64| 0.5 * libm::erfc(-x / SQRT_2);
        for share in [1e-12, 1e-9, 1e-4, 0.01, 0.074, 0.076, 0.3, 0.5, 0.8, 0.93, 0.99, 0.999_99] {
            let found = below(normal_quantile(share));
            assert!((found - share).abs() < 1e-14 * share.max(0.01), "{share}: {found}");
        }
        assert!(normal_quantile(0.25) + normal_quantile(0.75) < 1e-15);
    }

    #[test]
    fn a_few_even_errors_have_the_moments_of_normal_deviates() {
        for seed in 0..20 {
            let errors = EvenErrors::new(seed);
            for k in 0..5 {
                let all: Vec<f64> = (0..256).map(|index| errors.deviates(index)[k]).collect();
                let mean = all.iter().sum::<f64>() / 256.0;
                let square = all.iter().map(|x| x * x).sum::<f64>() / 256.0;
                // Random deviates have standard errors of 0.06 and 0.09.
                assert!(mean.abs() < 0.02, "seed {seed}, {k}: {mean}");
                assert!((square - 1.0).abs() < 0.03, "seed {seed}, {k}: {square}");
            }
        }
    }

    #[test]
    fn every_interval_of_a_sixteenth_has_one_of_sixteen_points() {
        let mut shares = [[false; 16]; 5];
        for index in 32..48 {
            for (k, deviate) in EvenErrors::new(7).deviates(index).into_iter().enumerate() {
                let share = 0.5 * libm::erfc(-deviate / SQRT_2);
                shares[k][(16.0 * share) as usize] = true;
            }
        }
        assert_eq!(shares, [[true; 16]; 5]);
    }

    #[test]
    fn the_even_errors_of_two_parameters_are_independent() {
        let errors = EvenErrors::new(3);
        for (i, j) in (0..5).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let product = |index| errors.deviates(index)[i] * errors.deviates(index)[j];
            let covariance = (0..1024).map(product).sum::<f64>() / 1024.0;
            assert!(covariance.abs() < 0.01, "{i} and {j}: {covariance}");
        }
    }
}
