//! Candidate plays and what is known about them.

use carom::resolve::cue_ball::Strike;
use carom::table::PocketName;
use carom_plan::{CaromPattern, CaromRoute};
use carom_rules::{BallIndex, Play};

use crate::line::{Line, LineKind};

/// A ball on the way to a pocket, and the number of cushions that it meets.
pub type PlayedLeg = (BallIndex, u8);

/// Number of samples that count as much as the prior in the mean value of a candidate.
pub(crate) const PRIOR_SAMPLES: f64 = 4.0;

/// What a play is meant to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PlayKind {
    /// To pot a ball along a line.
    Pot(LineKind),
    /// To pot a ball in any other way: off cushions before and after the contact, or off another
    /// ball.
    Indirect,
    /// To leave the other player a difficult shot.
    Safety,
    /// To score with the cue ball (carom games).
    Carom,
    /// To break.
    Break,
    /// To lay the cue ball where neither player wants to shoot from, after a break.
    PushOut,
}

impl PlayKind {
    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pot(kind) => kind.name(),
            Self::Indirect => "indirect",
            Self::Safety => "safety",
            Self::Carom => "carom",
            Self::Break => "break",
            Self::PushOut => "push-out",
        }
    }
}

/// One variant of a play.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlayedVariant {
    /// Number of its errors.
    pub index: u64,
    /// The strike that was executed.
    pub executed: Strike,
    /// Its value: the probability that the player wins.
    pub value: f64,
    /// Whether the player kept the turn or won.
    pub kept: bool,
    /// Whether the shot was a foul.
    pub foul: bool,
    /// Where the cue ball came to rest, m, file coordinates; none if it did not stay on the table.
    pub end: Option<[f64; 2]>,
}

/// A play that the search considers.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// The play.
    pub play: Play,
    /// What it is meant to do.
    pub kind: PlayKind,
    /// The line of a pot.
    pub line: Option<Line>,
    /// The ball that is to fall, and the pocket.
    pub pot: Option<(BallIndex, PocketName)>,
    /// The balls on the way to the pocket, first the cue ball, and the cushions that each meets
    /// without errors. Only plays of a list have them; a play that pots nothing, and an indirect
    /// one, has none.
    pub legs: Vec<PlayedLeg>,
    /// The pattern of a carom, by what the strike does without errors.
    pub pattern: Option<CaromPattern>,
    /// The route of a carom. Only plays of a list have it.
    pub route: Option<CaromRoute>,
    /// Number of the prepared position: the place of a cue ball in hand.
    pub place: usize,
    /// Estimated value before any sample: a probability of winning.
    pub prior: f64,
    /// Where the cue ball comes to rest without errors, m, file coordinates; none if it does not
    /// stay on the table.
    pub end: Option<[f64; 2]>,
    /// The samples so far, by which candidates are compared.
    pub samples: Vec<PlayedVariant>,
    /// Samples with errors that took no part in the choice. Only they give chances without the
    /// bias of a choice: the best of many noisy means is too high.
    pub fresh: Vec<PlayedVariant>,
    /// Correction of the mean value by the search of replies.
    pub correction: f64,
}

/// What distinguishes one recommended play from another: the kind, the ball and the pocket, and the pattern of a carom.
pub(crate) type PlayAim = (PlayKind, Option<(BallIndex, PocketName)>, Option<CaromPattern>);

impl Candidate {
    /// Its aim.
    pub(crate) const fn aim(&self) -> PlayAim {
        (self.kind, self.pot, self.pattern)
    }

    /// The mean value of the samples and of the prior, which counts as much as
    /// four of them, with the correction.
    pub fn mean(&self) -> f64 {
        let sum: f64 = self.samples.iter().map(|sample| sample.value).sum();
        let count = self.samples.len() as f64;
        (PRIOR_SAMPLES * self.prior + sum) / (PRIOR_SAMPLES + count) + self.correction
    }

    /// The probability of winning by the fresh samples alone, with the correction of the replies.
    pub fn stated_win(&self) -> f64 {
        if self.fresh.is_empty() {
            return self.mean().clamp(0.0, 1.0);
        }
        let sum: f64 = self.fresh.iter().map(|sample| sample.value).sum();
        (sum / self.fresh.len() as f64 + self.correction).clamp(0.0, 1.0)
    }

    /// The share of samples for which `is` holds; NaN without samples.
    pub fn share(&self, is: impl Fn(&PlayedVariant) -> bool) -> f64 {
        self.samples.iter().filter(|sample| is(sample)).count() as f64 / self.samples.len() as f64
    }
}
