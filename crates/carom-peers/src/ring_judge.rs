//! Decides whether the answer for a round edge is right, without solving for the contact.
//!
//! As in [`crate::judge`], a missed contact shows at the stationary points of the squared gap F =
//! |x|² + a² − R² − 2aρ. There x·ẋ = aρ′, so that (x·ẋ)²ρ² − a²(xẋ + yẏ)² = 0: a polynomial of
//! degree ten, which also vanishes where the path crosses the axis. Its roots are isolated by the
//! sign variations of its Bernstein coefficients (Descartes' rule: none means no root) in 106 bits.
//! Its other roots do no harm: the gap is monotone between any two neighbouring roots.

use std::ops::RangeInclusive;

use carom_roots::Motion;

use crate::double_double::DoubleDouble;
use crate::families::LARGEST_TABLE;
use crate::judge::{Truth, Verdict};
use crate::ring_families::RingCase;

/// Judges `answer`. Faults smaller than `tolerance` (m, on a table) count as right.
pub fn judge_ring(case: &RingCase, answer: Option<f64>, tolerance: f64) -> Verdict {
    ExactRingPath::new(case, tolerance).judge(answer)
}

/// The path in 106 bits.
struct ExactRingPath {
    case: RingCase,
    tolerance: f64,
    d: [DoubleDouble; 3],
    v: [DoubleDouble; 3],
    h: [DoubleDouble; 3],
}

/// Coefficients of a polynomial, constant first.
type Polynomial = Vec<DoubleDouble>;

fn product(a: &[DoubleDouble], b: &[DoubleDouble]) -> Polynomial {
    let mut c = vec![DoubleDouble::from(0.0); a.len() + b.len() - 1];
    for (i, &x) in a.iter().enumerate() {
        for (j, &y) in b.iter().enumerate() {
            c[i + j] = c[i + j] + x * y;
        }
    }
    c
}

fn sum(a: &[DoubleDouble], b: &[DoubleDouble]) -> Polynomial {
    let zero = DoubleDouble::from(0.0);
    let at = |p: &[DoubleDouble], i: usize| p.get(i).copied().unwrap_or(zero);
    (0..a.len().max(b.len())).map(|i| at(a, i) + at(b, i)).collect()
}

/// Number of halvings: a stationary point is known to 2⁻⁵⁶ of the window. Since an error δ of its
/// time changes the gap by δ² only, this is more than enough.
const HALVINGS: u32 = 56;

impl ExactRingPath {
    fn new(case: &RingCase, tolerance: f64) -> Self {
        let [d, v, h] =
            [case.motion.d, case.motion.v, case.motion.h].map(|w| w.map(DoubleDouble::from));
        ExactRingPath { case: *case, tolerance, d, v, h }
    }

    fn at(&self, t: f64) -> [DoubleDouble; 3] {
        let t = DoubleDouble::from(t);
        [0, 1, 2].map(|i| self.d[i] + t * (self.v[i] + t * self.h[i]))
    }

    fn velocity_at(&self, t: f64) -> [DoubleDouble; 3] {
        let twice = DoubleDouble::from(2.0 * t);
        [0, 1, 2].map(|i| self.v[i] + twice * self.h[i])
    }

    /// The polynomial of degree ten, and its factor at the axis xẋ + yẏ, on the window scaled to
    /// [0, 1].
    fn stationary_polynomials(&self) -> [Polynomial; 2] {
        let RingCase { from, horizon, ring, .. } = self.case;
        let span = DoubleDouble::from(horizon) - DoubleDouble::from(from);
        let (start, velocity) = (self.at(from), self.velocity_at(from));
        let x: [Polynomial; 3] =
            [0, 1, 2].map(|i| vec![start[i], span * velocity[i], span * (span * self.h[i])]);
        let two = DoubleDouble::from(2.0);
        let rate = |p: &Polynomial| vec![p[1], two * p[2]];
        let [a, b, c] = [0, 1, 2].map(|i| product(&x[i], &rate(&x[i])));
        let level = sum(&a, &b);
        let whole = sum(&level, &c);
        let radius_squared = sum(&product(&x[0], &x[0]), &product(&x[1], &x[1]));
        let ring = DoubleDouble::from(ring);
        let minus = vec![-(ring * ring)];
        let whole = sum(
            &product(&product(&whole, &whole), &radius_squared),
            &product(&minus, &product(&level, &level)),
        );
        [whole, level]
    }
}

impl Truth for ExactRingPath {
    fn window(&self) -> RangeInclusive<f64> {
        self.case.from..=self.case.horizon
    }

    fn tolerance(&self) -> f64 {
        self.tolerance
    }

    fn extent(&self, t: f64) -> f64 {
        let size = |w: [f64; 3]| w.iter().map(|x| x * x).sum::<f64>().sqrt();
        let Motion { d, v, h } = self.case.motion;
        let extent = size(d) + t * (size(v) + t * size(h));
        (extent / LARGEST_TABLE).max(1.0)
    }

    /// √((ρ − a)² + z²) − R, m.
    fn gap(&self, t: f64) -> f64 {
        let [x, y, z] = self.at(t);
        let out = (x * x + y * y).sqrt() - DoubleDouble::from(self.case.ring);
        let squared = out * out + z * z;
        let distance = DoubleDouble::from(self.case.distance);
        let sum = squared.value().sqrt() + self.case.distance;
        (squared - distance * distance).value() / sum
    }

    /// The sign of the gap's rate: that of x·ẋ ρ − a(xẋ + yẏ), in m³/s.
    fn rate(&self, t: f64) -> f64 {
        let (x, w) = (self.at(t), self.velocity_at(t));
        let level = x[0] * w[0] + x[1] * w[1];
        let radius = (x[0] * x[0] + x[1] * x[1]).sqrt();
        ((level + x[2] * w[2]) * radius - DoubleDouble::from(self.case.ring) * level).value()
    }

    /// All times in the window at which the gap may have an extremum, ascending.
    fn stationary_times(&self) -> Vec<f64> {
        let RingCase { from, horizon, .. } = self.case;
        let mut times = Vec::new();
        // On a path through the axis the first polynomial has a double root, which rounding may
        // hide; the second has a single root there.
        for polynomial in self.stationary_polynomials() {
            isolate(&bernstein(&polynomial), 0.0, 1.0, HALVINGS, &mut times);
        }
        times.sort_by(f64::total_cmp);
        times.into_iter().map(|u| from + u * (horizon - from)).collect()
    }
}

/// The Bernstein coefficients on [0, 1]: bᵢ = Σⱼ C(i, j)/C(n, j) cⱼ.
fn bernstein(polynomial: &[DoubleDouble]) -> Polynomial {
    let n = polynomial.len() - 1;
    // Differences, from the last: cⱼ/C(n, j) are the forward differences at 0.
    let mut difference: Polynomial = polynomial
        .iter()
        .enumerate()
        .map(|(j, &c)| c * DoubleDouble::ratio(1.0, binomial(n, j)))
        .collect();
    let mut coefficients = Vec::with_capacity(n + 1);
    for _ in 0..=n {
        coefficients.push(difference[0]);
        for j in 0..n {
            difference[j] = difference[j] + difference[j + 1];
        }
    }
    coefficients
}

fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |c, i| c * (n - i) as f64 / (i + 1) as f64)
}

/// Adds to `roots` one point of each part of [low, high] that may contain a root.
fn isolate(b: &[DoubleDouble], low: f64, high: f64, halvings: u32, roots: &mut Vec<f64>) {
    let mut signs = b.iter().map(|b| b.value()).filter(|&b| b != 0.0);
    let Some(first) = signs.next() else { return };
    if b.iter().all(|b| b.value() * first > 0.0) {
        return;
    }
    if halvings == 0 {
        roots.push(0.5 * (low + high));
        return;
    }
    let half = DoubleDouble::from(0.5);
    let n = b.len();
    let mut points = b.to_vec();
    let mut left = Vec::with_capacity(n);
    let mut right = vec![points[0]; n];
    for level in 0..n {
        left.push(points[0]);
        right[n - 1 - level] = points[n - 1 - level];
        for i in 0..n - 1 - level {
            points[i] = half * (points[i] + points[i + 1]);
        }
    }
    let middle = 0.5 * (low + high);
    isolate(&left, low, middle, halvings - 1, roots);
    isolate(&right, middle, high, halvings - 1, roots);
}

#[cfg(test)]
mod tests {
    use super::judge_ring;
    use crate::judge::Verdict;
    use crate::ring_families::RingCase;
    use carom_roots::Motion;

    const DEPTH: f64 = 1e-15;

    fn verdict(d: [f64; 3], v: [f64; 3], answer: Option<f64>) -> Verdict {
        let motion = Motion { d, v, h: [0.0; 3] };
        let case = RingCase { motion, ring: 2.0, distance: 0.5, from: 0.0, horizon: 10.0 };
        judge_ring(&case, answer, DEPTH)
    }

    #[test]
    fn only_the_time_of_a_contact_from_outside_is_right() {
        let (d, v) = ([4.5, 0.0, 0.0], [-1.0, 0.0, 0.0]);
        assert_eq!(verdict(d, v, Some(2.0)), Verdict::Right { gap: 0.0 });
        assert_eq!(verdict(d, v, None), Verdict::Missed { depth: 0.5 });
        assert_eq!(verdict(d, v, Some(5.5)), Verdict::Missed { depth: 0.5 });
        assert_eq!(verdict(d, v, Some(1.0)), Verdict::FalseContact { clearance: 1.0 });
        assert_eq!(verdict(d, v, Some(-1.0)), Verdict::OutOfRange);
    }

    #[test]
    fn only_the_time_of_a_contact_across_the_axis_is_right() {
        let (d, v) = ([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
        assert_eq!(verdict(d, v, Some(2.5)), Verdict::Right { gap: 0.0 });
        assert_eq!(verdict(d, v, Some(0.5)), Verdict::FalseContact { clearance: 1.0 });
        let Verdict::Missed { depth } = verdict(d, v, None) else { panic!("a missed contact") };
        assert!((depth - 0.5).abs() <= DEPTH, "{depth}");
    }

    #[test]
    fn bodies_that_touch_and_separate_have_no_contact() {
        let (d, v) = ([2.5, 0.0, 0.0], [1.0, 0.0, 0.0]);
        assert_eq!(verdict(d, v, None), Verdict::Right { gap: 0.0 });
        let (d, v) = ([2.4, 0.0, 0.0], [1.0, 0.0, 0.0]);
        assert!(matches!(verdict(d, v, Some(0.0)), Verdict::FalseContact { .. }));
    }
}
