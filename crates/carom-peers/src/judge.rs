//! Decides whether the answer of a finder is right, without solving the quartic.
//!
//! The gap can close only where it falls, so a missed contact shows at the stationary points of f =
//! |d + vt + ht²|² − D². These are roots of a cubic, which bisection brackets reliably. An error δ
//! of such a time changes the gap by δ² only. The gap is computed in 106 bits, accurate to about
//! 1e-30 m on a table.
//!
//! An error of two roundings in d has no physical meaning, so a fault is measured as a **depth**:
//! the overlap of the bodies in a missed contact, or the distance from touching or approaching in a
//! false one. On a path longer than any table the rounding of positions, and so the tolerance,
//! grows in proportion.

use std::ops::RangeInclusive;

use carom_roots::Motion;

use crate::double_double::DoubleDouble;
use crate::families::{Case, LARGEST_TABLE};

/// The judgement of an answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// No contact was missed, and none is false: the depth is zero or below the tolerance.
    Right {
        /// ||x| − D| at the returned time, or 0 for "no contact", m; divided by the same factor as the
        /// tolerance on a path longer than any table.
        gap: f64,
    },
    /// The bodies approach and overlap by `depth` (m) before the answer: a missed contact.
    Missed {
        /// Overlap, m.
        depth: f64,
    },
    /// At the answer the bodies are `clearance` (m) away from a contact: a false contact.
    FalseContact {
        /// Distance to the nearest position that would be a contact, m.
        clearance: f64,
    },
    /// A time before 0, after the horizon, or not a number.
    OutOfRange,
}

/// Limit of bisections: from the widest bracket to neighbouring doubles, with a margin.
const MAX_HALVINGS: usize = 160;

/// Judges `answer`. Faults smaller than `tolerance` (m, on a table) count as right.
pub fn judge<const N: usize>(case: &Case<N>, answer: Option<f64>, tolerance: f64) -> Verdict {
    ExactMotion::new(case, tolerance).judge(answer)
}

/// A path and its obstacle in high precision.
pub(crate) trait Truth {
    /// The interval of time in which a contact counts, s.
    fn window(&self) -> RangeInclusive<f64>;

    /// Depth below which a fault does not count, m on a table.
    fn tolerance(&self) -> f64;

    /// Length of the path up to `t` in units of the largest table, at least 1.
    fn extent(&self, t: f64) -> f64;

    /// Distance from touching at `t`, m, negative in an overlap.
    fn gap(&self, t: f64) -> f64;

    /// A number with the sign of the gap's rate of change at `t`.
    fn rate(&self, t: f64) -> f64;

    /// All times in the window, and possibly others, at which the gap may have an extremum,
    /// ascending.
    fn stationary_times(&self) -> Vec<f64>;

    fn tolerance_at(&self, t: f64) -> f64 {
        self.tolerance() * self.extent(t)
    }

    fn judge(&self, answer: Option<f64>) -> Verdict {
        let window = self.window();
        if answer.is_some_and(|t| !window.contains(&t)) {
            return Verdict::OutOfRange;
        }
        let stationary = self.stationary_times();
        let end = answer.unwrap_or(*window.end());
        if let Some(depth) = self.overlap_fallen_into(&stationary, end) {
            return Verdict::Missed { depth };
        }
        let Some(t) = answer else { return Verdict::Right { gap: 0.0 } };
        let gap = self.gap(t);
        let clearance = gap.max(self.lift_to_approach(&stationary, t));
        if clearance > self.tolerance_at(t) {
            return Verdict::FalseContact { clearance };
        }
        Verdict::Right { gap: gap.abs() / self.extent(t) }
    }

    /// The first overlap beyond the tolerance that the bodies reach while the gap falls, up to
    /// `end`.
    fn overlap_fallen_into(&self, stationary: &[f64], end: f64) -> Option<f64> {
        let from = *self.window().start();
        let mut times = vec![from];
        times.extend(stationary.iter().copied().filter(|&t| from < t && t < end));
        // After the last stationary point the gap only rises.
        if end.is_finite() {
            times.push(end);
        }
        times.windows(2).find_map(|span| {
            let depth = self.gap(span[0]).min(0.0) - self.gap(span[1]);
            (depth > self.tolerance_at(span[1])).then_some(depth)
        })
    }

    /// Change of the gap between `t` and the stationary point with the nearest gap; 0 if the bodies
    /// approach at `t`.
    fn lift_to_approach(&self, stationary: &[f64], t: f64) -> f64 {
        if self.rate(t) <= 0.0 {
            return 0.0;
        }
        let here = self.gap(t);
        stationary.iter().map(|&s| (self.gap(s) - here).abs()).fold(f64::INFINITY, f64::min)
    }
}

fn dot<const N: usize>(a: [DoubleDouble; N], b: [DoubleDouble; N]) -> DoubleDouble {
    let mut sum = a[0] * b[0];
    for i in 1..N {
        sum = sum + a[i] * b[i];
    }
    sum
}

/// The motion in 106 bits.
struct ExactMotion<const N: usize> {
    case: Case<N>,
    tolerance: f64,
    d: [DoubleDouble; N],
    v: [DoubleDouble; N],
    h: [DoubleDouble; N],
    /// f′/2 = g₀ + g₁t + g₂t² + g₃t³.
    g: [DoubleDouble; 4],
}

impl<const N: usize> ExactMotion<N> {
    fn new(case: &Case<N>, tolerance: f64) -> Self {
        let Motion { d, v, h } = case.motion;
        let [d, v, h] = [d, v, h].map(|w| w.map(DoubleDouble::from));
        let times = |n: f64, x: DoubleDouble| DoubleDouble::from(n) * x;
        let g = [
            dot(d, v),
            dot(v, v) + times(2.0, dot(d, h)),
            times(3.0, dot(v, h)),
            times(2.0, dot(h, h)),
        ];
        ExactMotion { case: *case, tolerance, d, v, h, g }
    }

    fn rate_root(&self, mut low: f64, mut high: f64) -> Option<f64> {
        let rising = self.rate(high) > 0.0;
        if rising == (self.rate(low) > 0.0) {
            return None;
        }
        for _ in 0..MAX_HALVINGS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if (self.rate(middle) > 0.0) == rising { high = middle } else { low = middle }
        }
        Some(high)
    }
}

impl<const N: usize> Truth for ExactMotion<N> {
    fn window(&self) -> RangeInclusive<f64> {
        0.0..=self.case.horizon
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }

    fn extent(&self, t: f64) -> f64 {
        let size = |w: [f64; N]| w.iter().map(|x| x * x).sum::<f64>().sqrt();
        let Motion { d, v, h } = self.case.motion;
        let extent = size(d) + t * (size(v) + t * size(h));
        self.case.metre.max(extent / LARGEST_TABLE)
    }

    /// |x(t)| − D, m.
    fn gap(&self, t: f64) -> f64 {
        let time = DoubleDouble::from(t);
        let x: [DoubleDouble; N] =
            std::array::from_fn(|i| self.d[i] + time * (self.v[i] + time * self.h[i]));
        let distance = DoubleDouble::from(self.case.distance);
        let squared = dot(x, x);
        let sum = squared.value().sqrt() + self.case.distance;
        (squared - distance * distance).value() / sum
    }

    /// f′/2 at t.
    fn rate(&self, t: f64) -> f64 {
        let time = DoubleDouble::from(t);
        (self.g[0] + time * (self.g[1] + time * (self.g[2] + time * self.g[3]))).value()
    }

    /// All real t with f′ = 0, ascending.
    fn stationary_times(&self) -> Vec<f64> {
        let [g0, g1, g2, g3] = self.g.map(DoubleDouble::value);
        if g3 == 0.0 {
            return if g1 == 0.0 { vec![] } else { vec![-g0 / g1] };
        }
        // Fujiwara's bound on the magnitude of every root.
        let bound = 2.0 * (g2 / g3).abs().max((g1 / g3).abs().sqrt()).max((g0 / g3).abs().cbrt());
        let mut ends = vec![-bound];
        let discriminant = g2 * g2 - 3.0 * g1 * g3;
        if discriminant > 0.0 {
            let q = -(g2 + discriminant.sqrt().copysign(g2));
            let (s, t) = (q / (3.0 * g3), g1 / q);
            ends.extend([s.min(t), s.max(t)]);
        }
        ends.push(bound);
        ends.windows(2).filter_map(|span| self.rate_root(span[0], span[1])).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Verdict, judge};
    use crate::families::Case;
    use carom_roots::Motion;

    const DEPTH: f64 = 1e-15;

    fn verdict(motion: &Motion<2>, answer: Option<f64>) -> Verdict {
        let case = Case { motion: *motion, distance: 1.0, horizon: 10.0, metre: 1.0 };
        judge(&case, answer, DEPTH)
    }

    #[test]
    fn only_the_time_of_a_head_on_contact_is_right() {
        let motion = Motion { d: [3.0, 0.0], v: [-2.0, 0.0], h: [0.0, 0.0] };
        assert_eq!(verdict(&motion, Some(1.0)), Verdict::Right { gap: 0.0 });
        assert_eq!(verdict(&motion, None), Verdict::Missed { depth: 1.0 });
        assert_eq!(verdict(&motion, Some(1.5)), Verdict::Missed { depth: 1.0 });
        assert_eq!(verdict(&motion, Some(0.5)), Verdict::FalseContact { clearance: 1.0 });
        assert_eq!(verdict(&motion, Some(-1.0)), Verdict::OutOfRange);
        assert_eq!(verdict(&motion, Some(f64::NAN)), Verdict::OutOfRange);
    }

    #[test]
    fn bodies_that_touch_and_separate_have_no_contact() {
        let motion = Motion { d: [1.0, 0.0], v: [2.0, 1.0], h: [0.0, 0.0] };
        assert_eq!(verdict(&motion, None), Verdict::Right { gap: 0.0 });
        assert!(matches!(verdict(&motion, Some(0.0)), Verdict::FalseContact { .. }));
    }

    #[test]
    fn bodies_that_separate_and_return_have_a_contact() {
        let motion = Motion { d: [1.0, 0.0], v: [2.0, 0.0], h: [-1.0, 0.0] };
        assert_eq!(verdict(&motion, Some(2.0)), Verdict::Right { gap: 0.0 });
        assert!(matches!(verdict(&motion, None), Verdict::Missed { .. }));
    }
}
