//! Restitution at low speed.
//!
//! Friction of the cloth can push a ball with constant acceleration against another ball or a rail.
//! With a constant coefficient of restitution e < 1 the ball then bounces infinitely often in
//! finite time (Zeno's paradox), and the shot never ends. Real collisions become elastic as they
//! become gentle: below the yield speed of the material only a little energy is lost, as sound. So
//! the coefficient rises to 1 at low speed. No energy is added, and the bounces stop shrinking.

/// Approach speed up to which an impact is perfectly elastic, m/s: one millimetre per second; a
/// ball this slow takes a minute to cross its own diameter. Larger, and clusters of balls come to
/// rest differently; much smaller, and bounces shrink until they are smaller than rounding errors.
pub const ELASTIC: f64 = 1e-3;

/// Approach speed from which a law's own restitution applies, m/s.
pub const FULL: f64 = 2.0 * ELASTIC;

/// Coefficient of restitution of an impact at `approach_speed` (m/s, ≥ 0): `e` from [`FULL`] on,
/// exactly 1 up to [`ELASTIC`], linear between the two, so it is continuous.
#[inline]
pub fn effective(e: f64, approach_speed: f64) -> f64 {
    if approach_speed >= FULL {
        e
    } else if approach_speed <= ELASTIC {
        1.0
    } else {
        1.0 - (1.0 - e) * (approach_speed / ELASTIC - 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::{ELASTIC, FULL, effective};

    #[test]
    fn restitution_is_the_laws_own_from_twice_the_elastic_speed_on() {
        assert_eq!(effective(0.93, FULL), 0.93);
        assert_eq!(effective(0.93, 5.0), 0.93);
    }

    #[test]
    fn restitution_is_one_up_to_the_elastic_speed() {
        for speed in [0.0, 1e-12, 0.5 * ELASTIC, ELASTIC] {
            assert_eq!(effective(0.0, speed), 1.0);
        }
    }

    #[test]
    fn restitution_is_continuous_and_falls_with_speed_between() {
        let mut last = 1.0;
        for step in 0..=1000 {
            let e = effective(0.6, ELASTIC * (1.0 + f64::from(step) / 1000.0));
            assert!(e <= last && last - e < 1e-3, "{last} then {e}");
            last = e;
        }
        assert!((last - 0.6).abs() < 1e-15);
    }
}
