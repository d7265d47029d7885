//! A puzzle that is not solved yet.

use carom::Shot;
use carom::resolve::cue_ball::Strike;

use crate::goal::DrillGoal;

/// A puzzle without its solution.
pub(super) struct Task {
    pub(super) shot: Shot,
    pub(super) goal: DrillGoal,
    pub(super) search: Search,
}

/// Where its solutions are sought.
pub(super) enum Search {
    /// Pots of a ball into these pockets. `is_about_cue_ball`: the pot alone is too little.
    Pot { ball: usize, pockets: Vec<usize>, tips: Vec<Tip>, is_about_cue_ball: bool },
    /// Aims at these balls, from edge to edge.
    Aims { balls: Vec<usize>, tips: Vec<Tip>, aims: u32 },
    /// All directions.
    Around { tips: Vec<Tip>, directions: u32 },
}

/// A strike without its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tip {
    pub(super) speed: f64,
    pub(super) side: f64,
    pub(super) height: f64,
}

impl Tip {
    /// Every combination of speeds, sides and heights.
    pub(super) fn grid(speeds: &[f64], sides: &[f64], heights: &[f64]) -> Vec<Self> {
        let mut tips = Vec::new();
        for &speed in speeds {
            for &height in heights {
                tips.extend(sides.iter().map(|&side| Self { speed, side, height }));
            }
        }
        tips
    }

    /// The strike in a direction, rad, at its default elevation.
    pub(super) fn towards(self, shot: &Shot, azimuth: f64) -> Strike {
        let Self { speed, side, height } = self;
        shot.at_own_elevation(&Strike { speed, azimuth, elevation: 0.0, side, height })
    }
}
