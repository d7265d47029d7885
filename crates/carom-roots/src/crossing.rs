//! The first downward crossing of zero by a quadratic function of time.

use crate::root::sqrt;

/// First t in [0, `horizon`] with f(t) = c₀ + c₁t + c₂t² ≤ 0 and f′(t) < 0, or `None`.
///
/// f is called the gap. If it is at or below zero at the start and closing, the result is 0.
/// Otherwise the result is the time at which the gap closes next, or the turning point if the gap
/// is not positive there. A gap that only grazes zero has no crossing. `horizon` may be infinite.
///
/// Units are arbitrary: one unit of length for f and one unit of time for t.
#[inline]
pub fn first_crossing(c0: f64, c1: f64, c2: f64, horizon: f64) -> Option<f64> {
    let closing = c1 < 0.0 || (c1 == 0.0 && c2 < 0.0);
    let t = if c0 <= 0.0 {
        if closing {
            0.0
        } else if c2 < 0.0 {
            last_descent(c0, c1, c2)
        } else {
            return None;
        }
    } else if c1 < 0.0 {
        let discriminant = c1 * c1 - 4.0 * (c0 * c2);
        // Zero is a graze: the gap reaches zero with zero rate and opens again.
        if c2 > 0.0 && discriminant <= 0.0 {
            return None;
        }
        // This form of the smaller root adds two positive numbers and does not divide by c₂.
        2.0 * c0 / (sqrt(discriminant) - c1)
    } else if c2 < 0.0 {
        last_descent(c0, c1, c2)
    } else {
        return None;
    };
    (t <= horizon && t < f64::INFINITY).then_some(t)
}

/// The crossing of a gap that opens first (c₁ ≥ 0) and closes later (c₂ < 0): the larger root, or
/// the turning point if the gap never becomes positive.
#[inline]
fn last_descent(c0: f64, c1: f64, c2: f64) -> f64 {
    let discriminant = c1 * c1 - 4.0 * (c0 * c2);
    (c1 + sqrt(discriminant.max(0.0))) / (-2.0 * c2)
}

#[cfg(test)]
mod tests {
    use super::first_crossing;

    const NEVER: f64 = f64::INFINITY;

    #[test]
    fn a_gap_that_closes_uniformly_crosses_when_it_is_closed() {
        assert_eq!(first_crossing(2.0, -4.0, 0.0, NEVER), Some(0.5));
        assert_eq!(first_crossing(2.0, -4.0, 0.0, 0.5), Some(0.5));
        assert_eq!(first_crossing(2.0, -4.0, 0.0, 0.49), None);
    }

    #[test]
    fn the_first_of_two_roots_is_the_descent() {
        // (t − 1)(t − 3)
        assert_eq!(first_crossing(3.0, -4.0, 1.0, NEVER), Some(1.0));
        // −(t + 1)(t − 3): opens, then closes
        assert_eq!(first_crossing(3.0, 2.0, -1.0, NEVER), Some(3.0));
    }

    #[test]
    fn a_graze_and_a_miss_are_no_crossing() {
        assert_eq!(first_crossing(1.0, -2.0, 1.0, NEVER), None);
        assert_eq!(first_crossing(1.1, -2.0, 1.0, NEVER), None);
        assert_eq!(first_crossing(1.0, 0.0, 0.0, NEVER), None);
        assert_eq!(first_crossing(1.0, 2.0, 0.0, NEVER), None);
    }

    #[test]
    fn a_touching_start_crosses_at_once_only_if_closing() {
        assert_eq!(first_crossing(0.0, -1.0, 5.0, NEVER), Some(0.0));
        assert_eq!(first_crossing(-1e-17, -1.0, 0.0, NEVER), Some(0.0));
        assert_eq!(first_crossing(0.0, 0.0, -1.0, NEVER), Some(0.0));
        assert_eq!(first_crossing(0.0, 0.0, 1.0, NEVER), None);
        assert_eq!(first_crossing(0.0, 0.0, 0.0, NEVER), None);
        assert_eq!(first_crossing(0.0, 1.0, 0.0, NEVER), None);
    }

    #[test]
    fn a_touching_start_that_opens_crosses_on_the_return() {
        assert_eq!(first_crossing(0.0, 2.0, -1.0, NEVER), Some(2.0));
        // never positive: −1 + t − t²/2 has its maximum, −1/2, at t = 1
        assert_eq!(first_crossing(-1.0, 1.0, -0.5, NEVER), Some(1.0));
        assert_eq!(first_crossing(-1.0, 1.0, -0.5, 0.9), None);
    }

    #[test]
    fn a_tiny_leading_coefficient_costs_no_accuracy() {
        let t = first_crossing(1.0, -1.0, 1e-300, NEVER).unwrap();
        assert_eq!(t, 1.0);
        let t = first_crossing(1.0, -1.0, -1e-18, NEVER).unwrap();
        assert_eq!(t, 1.0);
    }

    #[test]
    fn a_crossing_later_than_any_number_is_none() {
        assert_eq!(first_crossing(1e300, -1e-300, 0.0, NEVER), None);
        assert_eq!(first_crossing(1.0, -1.0, 0.0, -1.0), None);
        assert_eq!(first_crossing(1.0, f64::NAN, 0.0, 1.0), None);
    }
}
