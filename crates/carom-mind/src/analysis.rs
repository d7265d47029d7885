//! The report of a search: the best plays with their chances, and what they leave.
//!
//! All chances are counted with errors that took no part in the choice.

use carom::Error;
use carom::table::PocketName;
use carom_plan::{CaromRoute, Chance, Moments};
use carom_rules::{BallIndex, Play};

use crate::player::{Budget, Situation, Spent};
use crate::search::{Candidate, Found, PlayKind, PlayedLeg, PlayedVariant, ShotSearch};
use crate::searcher::Searcher;

/// One of the plays that a search recommends, with its chances.
#[derive(Clone, Debug, PartialEq)]
pub struct Recommendation {
    /// The play, as it is intended.
    pub play: Play,
    /// What it does without errors.
    pub kind: PlayKind,
    /// The balls on the way to the pocket, first the cue ball, and the cushions that each meets
    /// without errors; empty unless the kind is [`PlayKind::Pot`].
    pub legs: Vec<PlayedLeg>,
    /// The route of a carom, without errors.
    pub route: Option<CaromRoute>,
    /// The ball that falls without errors, and its pocket.
    pub pot: Option<(BallIndex, PocketName)>,
    /// The estimated probability of winning the frame.
    pub win: f64,
    /// Its standard error, from the samples alone.
    pub error: f64,
    /// Samples after which the player has the turn again or has won.
    pub kept: Chance,
    /// Samples with a foul.
    pub foul: Chance,
    /// The probability of winning if the player keeps the turn; none if that never happened.
    pub win_if_kept: Option<f64>,
    /// The same if the player does not.
    pub win_if_missed: Option<f64>,
    /// Mean (m) and covariance (m²) of the cue ball's place of rest, file coordinates, where it
    /// stayed on the table.
    pub leave: Moments,
}

/// The best plays of a position.
#[derive(Clone, Debug, PartialEq)]
pub struct Analysis {
    /// The plays, the best first.
    pub plays: Vec<Recommendation>,
    /// What the search has spent.
    pub spent: Spent,
}

impl Searcher {
    /// The best plays of the situation's shot with their chances, at most `count` of them.
    ///
    /// # Errors
    /// As [`crate::Player::decide`], and [`Error::Input`] at `frame` if it asks for a choice and
    /// not for a shot, and at `count` for 0.
    pub fn analyse(
        &self,
        situation: &Situation<'_>,
        budget: &Budget<'_>,
        count: usize,
    ) -> Result<Analysis, Error> {
        let mut search = self.search(situation, budget, count)?;
        while search.play_round()? {}
        search.analysis()
    }
}

impl ShotSearch<'_> {
    /// The best plays that the rounds have found, at most the number that [`Searcher::search`] got.
    ///
    /// # Errors
    /// As [`Self::play_round`].
    pub fn analysis(self) -> Result<Analysis, Error> {
        let stated = self.rounds().stated();
        let Found { candidates, spent } = self.listed()?;
        let mut listed: Vec<&Candidate> = Vec::new();
        for candidate in candidates.iter().take(stated).filter(|play| !play.fresh.is_empty()) {
            // Caroms of one pattern are one solution, whose best strike stands for it.
            let is_new = !listed.iter().any(|other| other.aim() == candidate.aim());
            if candidate.pattern.is_none() || is_new {
                listed.push(candidate);
            }
        }
        let plays = listed.into_iter().map(recommend).collect();
        Ok(Analysis { plays, spent })
    }
}

fn recommend(candidate: &Candidate) -> Recommendation {
    let samples = &candidate.fresh;
    let count = samples.len() as f64;
    let mean = samples.iter().map(|sample| sample.value).sum::<f64>() / count;
    let squares: f64 = samples.iter().map(|s| (s.value - mean) * (s.value - mean)).sum();
    let share = |is: &dyn Fn(&PlayedVariant) -> bool| Chance {
        met: samples.iter().filter(|sample| is(sample)).count() as u64,
        variants: samples.len() as u64,
    };
    let mean_if = |kept: bool| {
        let of = || samples.iter().filter(move |sample| sample.kept == kept);
        let number = of().count();
        (number > 0).then(|| of().map(|sample| sample.value).sum::<f64>() / number as f64)
    };
    let mut leave = Moments::default();
    samples.iter().filter_map(|sample| sample.end).for_each(|end| leave.add(end));
    Recommendation {
        play: candidate.play,
        kind: candidate.kind,
        legs: candidate.legs.clone(),
        route: candidate.route.clone(),
        pot: candidate.pot,
        win: candidate.stated_win(),
        error: carom::math::sqrt(squares / (count * (count - 1.0).max(1.0))),
        kept: share(&|sample| sample.kept),
        foul: share(&|sample| sample.foul),
        win_if_kept: mean_if(true),
        win_if_missed: mean_if(false),
        leave,
    }
}
