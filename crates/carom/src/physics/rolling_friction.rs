//! Rolling resistance: one coefficient, or one for each band of speeds.
//!
//! The measured deceleration of a rolling ball grows with its speed. With a coefficient that is
//! constant in each of a few bands of speed every path stays quadratic in time, so contacts are
//! found by the same closed forms. At the end of a band one path ends and the next begins.
//! [`RollingLaw`](super::RollingLaw) computes bands from a measured law.

use alloc::format;

use crate::error::{Error, ErrorKind};

/// The largest number of speed bands. Purpose: the physics has a fixed size and needs no memory of
/// its own. 13 bands follow the measured law of heated cloth up to 3 m/s within 0.2 % of the roll
/// or 10 mm (validation/three_cushion_tracks); more would enlarge every copy of the physics.
pub const MAX_ROLLING_BANDS: usize = 16;

/// A speed that is larger than the end of a band by at most this fraction of it belongs to the
/// band below. A ball at the end of a band has the band's speed up to rounding, about 1e-16 of it.
/// Much smaller, and the ball could begin the same band again; larger, and a ball could have the
/// wrong coefficient for a time that matters.
const END_ROUNDING: f64 = 1e-12;

/// A coefficient of rolling resistance and the speeds at which it holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingBand {
    /// The largest speed of the band, m/s; infinite for the last band.
    pub up_to: f64,
    /// The coefficient μ_r in this band.
    pub friction: f64,
}

/// Coefficient of rolling resistance μ_r as a function of the ball's speed, constant in bands. A
/// rolling ball is decelerated by μ_r g (Leckie & Greenspan 2006, eq. 4, has one constant).
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct RollingFriction {
    /// The speed above which each band begins, m/s; 0 for the first, infinite for unused ones.
    above: [f64; MAX_ROLLING_BANDS],
    /// μ_r in each band; 0 in unused ones.
    friction: [f64; MAX_ROLLING_BANDS],
}

impl RollingFriction {
    /// A coefficient that does not depend on speed.
    pub const fn constant(mu: f64) -> Self {
        let mut above = [f64::INFINITY; MAX_ROLLING_BANDS];
        let mut friction = [0.0; MAX_ROLLING_BANDS];
        above[0] = 0.0;
        friction[0] = mu;
        Self { above, friction }
    }

    /// From the bands of a preset, which are not checked: as those of [`Self::from_bands`].
    pub(super) fn of_bands(bands: &[RollingBand]) -> Self {
        // The coefficient 0 shows an error: a test requires that every preset has a larger one.
        Self::from_bands(bands).unwrap_or(Self::constant(0.0))
    }

    /// From bands in ascending order of speed. The last one has no upper end.
    ///
    /// # Errors
    /// [`Error::Input`] with the place in the list: there is no band, or more than
    /// [`MAX_ROLLING_BANDS`]; the ends do not increase; the last band has an end; or a number is
    /// negative or not finite.
    pub fn from_bands(bands: &[RollingBand]) -> Result<Self, Error> {
        if bands.is_empty() || bands.len() > MAX_ROLLING_BANDS {
            return Err(ErrorKind::WrongCount.at(
                "",
                format!("found a list of {} bands", bands.len()),
                format!("write 1 to {MAX_ROLLING_BANDS} bands, or a number"),
            ));
        }
        let mut result = Self::constant(0.0);
        let mut below = 0.0;
        for (i, band) in bands.iter().enumerate() {
            let is_last = i + 1 == bands.len();
            check(i, band, below, is_last)?;
            result.above[i] = below;
            result.friction[i] = band.friction;
            below = band.up_to;
        }
        Ok(result)
    }

    /// The bands in ascending order of speed.
    pub fn bands(&self) -> impl Iterator<Item = RollingBand> + '_ {
        let end = |i: usize| self.above.get(i + 1).copied().unwrap_or(f64::INFINITY);
        let used = self.above.iter().take_while(|above| above.is_finite()).count();
        (0..used).map(move |i| RollingBand { up_to: end(i), friction: self.friction[i] })
    }

    /// The coefficient, if it is the same at every speed.
    pub fn as_constant(&self) -> Option<f64> {
        (self.above[1] == f64::INFINITY).then_some(self.friction[0])
    }

    /// μ_r of a ball that rolls at `speed` (m/s).
    pub fn at(&self, speed: f64) -> f64 {
        self.band(speed).0
    }

    /// μ_r of a ball that rolls at `speed` (m/s), and the speed at which its band ends as the ball
    /// slows down, m/s: 0 in the lowest band.
    #[inline(always)]
    pub(crate) fn band(&self, speed: f64) -> (f64, f64) {
        if speed <= self.above[1] { (self.friction[0], 0.0) } else { self.upper_band(speed) }
    }

    // Not inlined: a ball on a cloth with one coefficient never needs it.
    #[inline(never)]
    fn upper_band(&self, speed: f64) -> (f64, f64) {
        let mut i = 0;
        while i + 1 < MAX_ROLLING_BANDS && self.is_above(speed, i + 1) {
            i += 1;
        }
        (self.friction[i], self.above[i])
    }

    /// Whether `speed` is above the lower end of band `i`.
    #[inline(always)]
    fn is_above(&self, speed: f64, i: usize) -> bool {
        speed > self.above[i] * (1.0 + END_ROUNDING)
    }
}

/// Refuses band number `i`, which begins above the speed `below` (m/s).
fn check(i: usize, band: &RollingBand, below: f64, is_last: bool) -> Result<(), Error> {
    let RollingBand { up_to, friction } = *band;
    let refuse = |key: &str, what: alloc::string::String, remedy: &str| {
        Err(ErrorKind::OutOfRange.at(format!("[{i}].{key}"), what, remedy))
    };
    if !(friction >= 0.0 && friction.is_finite()) {
        return refuse("friction", format!("{friction:?} is no coefficient"), "write a number ≥ 0");
    }
    if is_last {
        if up_to == f64::INFINITY {
            return Ok(());
        }
        let what = format!("the last band ends at {up_to:?} m/s");
        return refuse("up_to", what, "leave it out: the last band holds for all faster balls");
    }
    if !up_to.is_finite() {
        let what = format!("band {i} has no end, and a band follows");
        return refuse("up_to", what, "give the largest speed of the band, m/s");
    }
    if up_to <= below {
        let what = format!("{up_to:?} m/s is not above the end of the band before, {below:?} m/s");
        return refuse("up_to", what, "sort the bands by speed, each end larger than the last");
    }
    Ok(())
}
