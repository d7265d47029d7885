//! Rolling resistance in bands of speed, read from the physics independently of the engine.

use carom::physics::Cloth;

/// Rounding of a speed at the end of a band, as a fraction of it. A ball at the end of a band
/// begins the band below.
const END_ROUNDING: f64 = 1e-11;

/// The coefficient of rolling resistance at `speed`, m/s, and the lower end of its band, m/s.
pub(crate) fn band(cloth: &Cloth, speed: f64) -> (f64, f64) {
    let mut low = 0.0;
    for band in cloth.rolling_friction.bands() {
        if speed <= band.up_to * (1.0 + END_ROUNDING) {
            return (band.friction, low);
        }
        low = band.up_to;
    }
    unreachable!("the last band has no upper end")
}

/// Whether a band ends at `speed`, m/s.
pub(crate) fn is_end(cloth: &Cloth, speed: f64) -> bool {
    let at = |end: f64| (speed - end).abs() <= END_ROUNDING * end;
    cloth.rolling_friction.bands().any(|band| band.up_to.is_finite() && at(band.up_to))
}
