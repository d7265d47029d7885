//! Restitution at low speed.
//!
//! Cloth friction can push a ball with constant acceleration into another one or into a rail.
//! With a constant coefficient of restitution e < 1 it then bounces infinitely often in finite
//! time (Zeno), and the shot never ends. Real collisions also become elastic as they become
//! gentle: below the yield speed of the material nothing is lost but a little sound. So the
//! coefficient rises to 1 at low speed; no energy is ever added, and the bounces stop shrinking.

/// Approach speed up to which an impact is perfectly elastic, m/s: one millimetre per second, a
/// ball that takes a minute to cross its own diameter. A larger value changes how clusters of
/// balls come to rest; a much smaller one lets bounces shrink until they drown in rounding.
pub const ELASTIC: f64 = 1e-3;

/// Approach speed from which a law's own restitution holds, m/s.
pub const FULL: f64 = 2.0 * ELASTIC;

/// Coefficient of restitution for an impact at `approach_speed` (m/s, ≥ 0): `e` from
/// [`FULL`] up, exactly 1 at or below [`ELASTIC`], linear (so continuous) between.
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
    fn restitution_is_constant_above_twice_the_quiet_speed() {
        assert_eq!(effective(0.93, FULL), 0.93);
        assert_eq!(effective(0.93, 5.0), 0.93);
    }

    #[test]
    fn restitution_is_one_at_and_below_the_quiet_speed() {
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
