//! Relative motion of two bodies, and the squared gap between them.

/// Relative motion: separation d + v t + h t², h being half the relative acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<const N: usize> {
    /// Separation of the centres at t = 0, m.
    pub d: [f64; N],
    /// Relative velocity at t = 0, m/s.
    pub v: [f64; N],
    /// Half the relative acceleration, m/s².
    pub h: [f64; N],
}

impl<const N: usize> Motion<N> {
    /// Separation of the centres at time `t` (s), m.
    #[inline(always)]
    pub fn at(&self, t: f64) -> [f64; N] {
        core::array::from_fn(|i| self.d[i] + t * (self.v[i] + t * self.h[i]))
    }

    /// Relative velocity at time `t` (s), m/s.
    #[inline(always)]
    pub fn velocity_at(&self, t: f64) -> [f64; N] {
        core::array::from_fn(|i| self.v[i] + 2.0 * (t * self.h[i]))
    }
}

/// Inner product.
#[inline(always)]
pub(crate) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let mut sum = a[0] * b[0];
    for i in 1..N {
        sum += a[i] * b[i];
    }
    sum
}

/// |a × b|², in any number of dimensions. The products of the first two axes with the third are
/// summed first, so that a motion turned by 90° about the third has the same bits.
#[inline(always)]
pub(crate) fn cross_squared<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let mut sum = 0.0;
    for j in (1..N).rev() {
        for i in 0..j {
            let cross = a[i] * b[j] - a[j] * b[i];
            sum += cross * cross;
        }
    }
    sum
}

/// The squared gap f(t) = |x(t)|² − D² of a motion x, and half its derivative.
///
/// Both are computed from the positions and not from the expanded coefficients of the quartic. Near
/// a contact |x| ≈ D, so f has the rounding error of a position. The expanded form has one larger
/// by the ratio of |x(0)|² to D², a factor of about a thousand on a table.
#[derive(Clone, Copy)]
pub(crate) struct Gap<'a, const N: usize> {
    pub(crate) motion: &'a Motion<N>,
    pub(crate) distance_squared: f64,
}

/// A point of the gap function.
#[derive(Clone, Copy)]
pub(crate) struct Sample {
    /// Time, s.
    pub(crate) t: f64,
    /// f(t), m².
    pub(crate) f: f64,
    /// f′(t)/2, m²/s.
    pub(crate) g: f64,
}

impl<'a, const N: usize> Gap<'a, N> {
    #[inline(always)]
    pub(crate) fn new(motion: &'a Motion<N>, distance: f64) -> Self {
        Gap { motion, distance_squared: distance * distance }
    }

    #[inline(always)]
    pub(crate) fn sample(&self, t: f64) -> Sample {
        let x = self.motion.at(t);
        let velocity = self.motion.velocity_at(t);
        Sample { t, f: dot(&x, &x) - self.distance_squared, g: dot(&x, &velocity) }
    }

    /// The sample at t, and the two parts of f″(t)/2: |ẋ|² and 2 x·h.
    #[inline(always)]
    pub(crate) fn sample_with_curvature(&self, t: f64) -> (Sample, f64, f64) {
        let x = self.motion.at(t);
        let velocity = self.motion.velocity_at(t);
        let f = dot(&x, &x) - self.distance_squared;
        let sample = Sample { t, f, g: dot(&x, &velocity) };
        (sample, dot(&velocity, &velocity), 2.0 * dot(&x, &self.motion.h))
    }
}
