//! Clocks: how much a player may spend, in simulated shots or in seconds.

use carom::{Error, ErrorKind};
use carom_mind::Spent;
use carom_rules::games::eight_ball::Group;
use carom_rules::{Frame, Objective, Seat};

/// Thinking time of a frame and side, s: the ten minutes of the Computational Olympiad (Archibald,
/// Altman & Shoham 2009).
const OLYMPIAD: f64 = 600.0;

/// Part of the budget's formula, clock / ([`SHARE`] · expected own shots + [`RESERVE`]): half as
/// many shots again as expected, because misses and safeties prolong a frame.
const SHARE: f64 = 1.5;
/// The rest of the formula: at most a third of the clock goes into one decision.
const RESERVE: f64 = 3.0;

/// Own shots for each point that is missing in three-cushion. Estimated: good players average about
/// one point an inning, which is two shots a point.
const SHOTS_PER_CAROM: f64 = 2.0;
/// Own shots for each object ball that both players may pot. Estimated: each pots half of them.
const SHOTS_PER_SHARED_BALL: f64 = 0.5;

/// What a clock counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClockUnit {
    /// Simulated shots, as the player counts them. Matches between built-in players are then the
    /// same on every machine.
    Simulations,
    /// Seconds of wall-clock time.
    Seconds,
}

/// What the amount of a clock is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClockPeriod {
    /// For every decision. The amount is a budget that the player is given. Exceeding it has no
    /// consequence here: a search completes the round that it has begun.
    Decision,
    /// For the decisions of a whole frame. The player who has used it up loses the frame.
    Frame,
}

/// How much one player may spend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// What is counted.
    pub unit: ClockUnit,
    /// What the amount is for.
    pub period: ClockPeriod,
    /// The amount, in simulated shots or in seconds; above 0.
    pub amount: f64,
}

impl Default for Clock {
    /// Ten minutes a frame.
    fn default() -> Self {
        Self { unit: ClockUnit::Seconds, period: ClockPeriod::Frame, amount: OLYMPIAD }
    }
}

impl Clock {
    /// This number of simulated shots for every decision.
    pub const fn simulations(amount: u32) -> Self {
        let (unit, period) = (ClockUnit::Simulations, ClockPeriod::Decision);
        Self { unit, period, amount: amount as f64 }
    }

    /// This many seconds for every decision.
    pub const fn seconds(amount: f64) -> Self {
        Self { unit: ClockUnit::Seconds, period: ClockPeriod::Decision, amount }
    }

    /// The same amount for a whole frame.
    #[must_use]
    pub const fn per_frame(self) -> Self {
        Self { period: ClockPeriod::Frame, ..self }
    }

    /// Rejects an amount that is not a positive number, and one of simulated shots that is not a
    /// whole number up to 2³² − 1.
    ///
    /// # Errors
    /// [`Error::Input`] at `clock`.
    pub fn check(&self) -> Result<(), Error> {
        let whole = self.amount == f64::from(self.amount as u32);
        let (valid, remedy) = match self.unit {
            ClockUnit::Simulations => (whole, "write a whole number from 1 to 4294967295"),
            ClockUnit::Seconds => (self.amount.is_finite(), "write a number above 0"),
        };
        if self.amount > 0.0 && valid {
            return Ok(());
        }
        let what = format!("{:?} is not an amount for a clock", self.amount);
        Err(ErrorKind::OutOfRange.at("clock", what, remedy))
    }

    /// What a decision costs on this clock.
    pub(crate) fn charge(&self, cost: &Cost) -> f64 {
        match self.unit {
            ClockUnit::Simulations => cost.spent.simulations as f64,
            ClockUnit::Seconds => cost.seconds,
        }
    }

    /// The budget of the next decision of `seat` in `frame`, with this much left on the clock.
    pub(crate) fn budget(&self, left: f64, frame: &Frame, seat: Seat) -> f64 {
        match self.period {
            ClockPeriod::Decision => self.amount,
            ClockPeriod::Frame => left.max(0.0) / (SHARE * expected_shots(frame, seat) + RESERVE),
        }
    }
}

/// What a decision has cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Simulated shots and rounds.
    pub spent: Spent,
    /// Wall-clock time, s. 0 if the clock counts simulated shots, so that a match has the same
    /// record on every machine.
    pub seconds: f64,
}

/// The number of shots that `seat` is expected to play until the end of `frame`. A rough estimate
/// from the balls on the table or the points that are missing; it only divides the clock.
pub fn expected_shots(frame: &Frame, seat: Seat) -> f64 {
    let layout = frame.layout();
    let left = layout.on_table().count().saturating_sub(1) as f64;
    let missing = || f64::from((frame.options().points - frame.scores()[seat]).max(1));
    let facts = frame.facts();
    match facts.objective {
        Objective::Caroms { .. } => SHOTS_PER_CAROM * missing(),
        _ if facts.has_target() => missing(),
        _ if facts.players == 1 => left,
        Objective::AnyBall | Objective::LowestFirst => SHOTS_PER_SHARED_BALL * left,
        Objective::Groups => match frame.group(seat) {
            None => 1.0 + SHOTS_PER_SHARED_BALL * (left - 1.0).max(0.0),
            Some(group) => {
                let own = layout.on_table().filter(|ball| Group::of(*ball) == Some(group));
                1.0 + own.count() as f64
            }
        },
        // A colour follows every red.
        Objective::RedsAndColors => {
            let reds = (left - 6.0).max(0.0);
            SHOTS_PER_SHARED_BALL * (left + reds)
        }
    }
    .max(1.0)
}

#[cfg(test)]
mod tests {
    use super::{Clock, Cost, expected_shots};
    use carom_mind::Spent;
    use carom_rules::{Frame, Game, Options};

    fn frame(game: Game) -> Frame {
        Frame::new(game, Options::default(), None, None, 0).unwrap()
    }

    #[test]
    fn expected_shots_follow_from_the_balls_and_the_missing_points() {
        for (game, shots) in [
            (Game::NineBall, 4.5),
            (Game::TenBall, 5.0),
            (Game::EightBall, 8.0),
            (Game::Snooker, 18.0),
            (Game::StraightPool, 40.0),
            (Game::ThreeCushion, 80.0),
            (Game::Practice, 15.0),
        ] {
            assert_eq!(expected_shots(&frame(game), 0), shots, "{}", game.name());
        }
    }

    #[test]
    fn a_clock_for_a_frame_is_divided_among_the_expected_shots() {
        let frame = frame(Game::NineBall);
        let clock = Clock::seconds(600.0).per_frame();
        assert_eq!(clock.budget(600.0, &frame, 0), 600.0 / (1.5 * 4.5 + 3.0));
        assert_eq!(clock.budget(-1.0, &frame, 0), 0.0);
        assert_eq!(Clock::simulations(500).budget(0.0, &frame, 0), 500.0);
    }

    #[test]
    fn a_clock_charges_its_own_unit() {
        let cost = Cost { spent: Spent { simulations: 70, rounds: 2 }, seconds: 1.5 };
        assert_eq!(Clock::simulations(500).charge(&cost), 70.0);
        assert_eq!(Clock::default().charge(&cost), 1.5);
    }

    #[test]
    fn rejects_an_amount_that_is_not_positive() {
        for amount in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let error = Clock::seconds(amount).check().unwrap_err().to_string();
            assert!(error.starts_with("clock: "), "{error}");
        }
        assert!(Clock { amount: 0.5, ..Clock::simulations(1) }.check().is_err());
        assert!(Clock::seconds(0.5).check().is_ok());
        assert!(Clock::simulations(1).check().is_ok());
    }
}
