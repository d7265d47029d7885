//! The settings of the searching player.

use carom::Error;

use crate::breaks::BreakShot;

/// How the searching player searches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearchSettings {
    /// Share of a round's simulations that search for candidates; the rest races them. 0 to 0.9.
    pub exploring: f64,
    /// Number of candidates that enter the first race.
    pub racing: usize,
    /// Number of safeties among them.
    pub safeties: usize,
    /// Simulations of the first round. Each further round has twice as many.
    pub first_round: u64,
    /// Number of finalists whose replies are searched; 0 for none.
    pub finalists: usize,
    /// Successors of a finalist that are searched.
    pub representatives: usize,
    /// Simulations for each of them.
    pub per_reply: u64,
    /// Whether finalists are moved uphill by the weights of their samples.
    pub shift: bool,
    /// Number of plays whose chances are stated, from samples that took no part in the choice. At
    /// least 1.
    pub stated: usize,
    /// A frame is conceded if the expected chance of winning is below this. Only in snooker, where
    /// points behind cannot always be made up.
    pub concede_below: f64,
    /// The opening shot of every rack; `None` if it is searched.
    pub break_shot: Option<BreakShot>,
}

impl Default for SearchSettings {
    fn default() -> Self {
        Self {
            exploring: 0.45,
            racing: 48,
            safeties: 12,
            first_round: 1500,
            finalists: 6,
            representatives: 8,
            per_reply: 160,
            shift: true,
            stated: 1,
            concede_below: 0.001,
            break_shot: None,
        }
    }
}

/// Share of the simulations that states the chances of a play, and the largest share for all plays.
const FRESH: f64 = 0.06;
const FRESH_IN_ALL: f64 = 0.25;
/// Fewest and most samples of such a statement: with 4000 the standard error of a chance is at most
/// 0.8 points.
const FRESH_SAMPLES: [u64; 2] = [8, 4000];

impl SearchSettings {
    /// Number of fresh samples of a stated play, of `simulations` in all.
    pub(crate) fn fresh(&self, simulations: u64) -> u64 {
        let share = FRESH.min(FRESH_IN_ALL / self.stated as f64);
        ((share * simulations as f64) as u64).clamp(FRESH_SAMPLES[0], FRESH_SAMPLES[1])
    }

    /// Rejects settings out of range.
    ///
    /// # Errors
    /// [`Error::Input`] for a share outside 0 to 0.9, for a race without candidates, and as
    /// [`BreakShot::check`].
    pub fn check(&self) -> Result<(), Error> {
        if !(0.0..=0.9).contains(&self.exploring) {
            let what = format!("{:?} is not a share", self.exploring);
            return Err(Error::input("settings.exploring", what, "write a number from 0 to 0.9"));
        }
        for (key, value) in [
            ("racing", self.racing as u64),
            ("stated", self.stated as u64),
            ("first_round", self.first_round),
            ("representatives", self.representatives as u64),
            ("per_reply", self.per_reply),
        ] {
            if value == 0 {
                let place = format!("settings.{key}");
                return Err(Error::input(place, "0 is out of range", "write at least 1"));
            }
        }
        self.break_shot
            .map_or(Ok(()), |shot| shot.check())
            .map_err(|error| error.inside("settings.break_shot"))
    }
}
