//! The strikes that a player, or a robot, can reach.

use core::f64::consts::{FRAC_PI_2, TAU};

use carom::resolve::cue_ball::Strike;
use carom::shot::CuePose;
use carom::{Error, ErrorKind, Shot};

/// Limits of the strikes that a search may return; none by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reach {
    /// The first and the last azimuth, rad, counter-clockwise: from 350° to 10° is a range of 20°. A range
    /// of a turn or more has all azimuths.
    pub azimuth: Option<[f64; 2]>,
    /// Least and greatest elevation, rad. A strike that would be lower is raised to the least.
    pub elevation: Option<[f64; 2]>,
    /// Two opposite corners of the rectangle in which the end of the butt must be, m, in the file's
    /// frame ([`CuePose::butt`]).
    pub butt: Option<[[f64; 2]; 2]>,
}

impl Reach {
    /// Rejects limits that no strike meets.
    ///
    /// # Errors
    /// [`Error::Input`] for numbers that are not finite or out of range, and for elevations in the wrong
    /// order.
    pub fn check(&self) -> Result<(), Error> {
        let refuse = |place: &str, what: String, remedy: &str| {
            Err(ErrorKind::OutOfRange.at(place, what, remedy))
        };
        if let Some([first, last]) = self.azimuth
            && !(first.is_finite() && last.is_finite())
        {
            let what = format!("{first:?} to {last:?} rad is not a range of azimuths");
            return refuse("azimuth", what, "give two finite numbers, the first and the last");
        }
        if let Some([least, most]) = self.elevation
            && !(0.0 <= least && least <= most && most < FRAC_PI_2)
        {
            let what = format!("{least:?} to {most:?} rad is not a range of elevations");
            return refuse("elevation", what, "give 0 <= least <= most, less than a right angle");
        }
        if let Some(corners) = self.butt
            && !corners.as_flattened().iter().all(|x| x.is_finite())
        {
            let what = format!("{corners:?} are not two corners");
            return refuse("butt", what, "give ((x, y), (x, y)) in m");
        }
        Ok(())
    }

    /// The azimuth at a `share` of the range.
    pub(crate) fn azimuth_at(&self, share: f64) -> f64 {
        match self.azimuth {
            Some([first, last]) => (first + turn(first, last) * share).rem_euclid(TAU),
            None => TAU * share,
        }
    }

    /// `strike`, raised to the least elevation.
    pub(crate) fn raised(&self, strike: Strike) -> Strike {
        let least = self.elevation.map_or(0.0, |[least, _]| least);
        Strike { elevation: strike.elevation.max(least), ..strike }
    }

    /// Whether a player can play `strike` on the struck ball of `shot`.
    pub(crate) fn allows(&self, strike: &Strike, shot: &Shot) -> bool {
        let in_azimuth = self.azimuth.is_none_or(|[first, last]| {
            (strike.azimuth - first).rem_euclid(TAU) <= turn(first, last)
        });
        let in_elevation =
            self.elevation.is_none_or(|[least, most]| (least..=most).contains(&strike.elevation));
        in_azimuth && in_elevation && self.butt.is_none_or(|corners| is_in(corners, strike, shot))
    }
}

/// The angle from `first` counter-clockwise to `last`, rad, in [0, 2π].
fn turn(first: f64, last: f64) -> f64 {
    if (last - first).abs() >= TAU { TAU } else { (last - first).rem_euclid(TAU) }
}

fn is_in([a, b]: [[f64; 2]; 2], strike: &Strike, shot: &Shot) -> bool {
    let Some((ball, _)) = shot.strike() else { return true };
    let butt = CuePose::new(strike, (&shot.balls()[ball]).into()).butt();
    let between = |x: f64, a: f64, b: f64| (a.min(b)..=a.max(b)).contains(&x);
    between(butt.x, a[0], b[0]) && between(butt.y, a[1], b[1])
}
