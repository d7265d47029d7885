//! Restitution at low speed.

/// Approach speed from which a law's own restitution holds, m/s: 2 mm/s.
pub const FULL: f64 = 2e-3;

/// Approach speed up to which an impact is lossless, m/s: 1 mm/s. Bounces of a ball that the
/// cloth pushes against something then keep their size instead of shrinking for ever.
pub const ELASTIC: f64 = 1e-3;

/// The restitution that acts at `approach` (m/s): `e` from [`FULL`] up, exactly 1 down from
/// [`ELASTIC`], linear between.
#[inline]
pub fn effective(e: f64, approach: f64) -> f64 {
    if approach >= FULL {
        e
    } else if approach <= ELASTIC {
        1.0
    } else {
        e + (1.0 - e) * ((FULL - approach) / (FULL - ELASTIC))
    }
}
