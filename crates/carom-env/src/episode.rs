//! The interface of an episode: a table with balls and the rules of a task.

use carom::math::Vec3;
use carom::resolve::cue_ball::Strike;
use carom::shot::{BallInSpace, Cling};
use carom::{Error, Shot};
use carom_rules::{BallIndex, Call, Choice, Frame, FrameBall, FrameSimulator, Seat, Turn};

/// A strike before and after noise.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NoisyStrike {
    /// The strike that the player intended.
    pub(crate) intended: Strike,
    /// The strike that is played.
    pub(crate) actual: Strike,
    /// The contacts that cling.
    pub(crate) cling: Cling,
    /// Where a cue ball in hand is placed before the strike (file frame, m).
    pub(crate) cue_ball: Option<[f64; 2]>,
    /// The call; `None` for the call that is made for the player.
    pub(crate) call: Option<Call>,
}

/// The result of a shot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct ShotResult {
    /// Whether the shot was no foul.
    pub(crate) legal: bool,
    /// Number of balls that a legal shot potted and that the shooter might pot. In the potting task
    /// at most 1.
    pub(crate) potted: u32,
    /// The change of each seat's score.
    pub(crate) points: [i32; 2],
}

/// The end of an episode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ending {
    /// This seat won.
    Won(Seat),
    /// A draw by the rules of the game.
    Drawn,
    /// There was no progress, or a shot could not be played.
    Stalemate,
}

/// Scores and fouls, scaled for observations to about 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Standing {
    /// Scores, divided by a good score for the game.
    pub(crate) scores: [f64; 2],
    /// Consecutive fouls, divided by the three that lose a rack.
    pub(crate) fouls: [f64; 2],
    /// Whether the next shot is the first after a rack.
    pub(crate) opening: bool,
}

/// A table with balls and the rules of a task.
pub(crate) trait Episode: Send + Sync {
    /// A shot on this table with its physics; the shot's balls are not those of the episode.
    fn base(&self) -> &Shot;
    /// The balls, on the table or not.
    fn balls(&self) -> &[FrameBall];
    /// Centre of `ball` (file frame, m); none if it is not on the table.
    fn place(&self, ball: BallIndex) -> Option<[f64; 2]>;
    /// The shot that comes next; none when the episode is over.
    fn turn(&self) -> Option<&Turn>;
    /// The end of the episode; none while it continues.
    fn ending(&self) -> Option<Ending>;
    /// Scores and fouls for observations.
    fn standing(&self) -> Standing;
    /// The score of each seat.
    fn scores(&self) -> [i32; 2];
    /// The ball at position `k` of the observation of `viewer`. The viewer's own balls come first.
    fn ball_seen(&self, _viewer: Seat, k: BallIndex) -> BallIndex {
        k
    }
    /// Starts another episode.
    fn restart(&mut self, seed: u64) -> Result<(), Error>;
    /// The frame to whose requests a player answers; none if the task has no referee, and after a
    /// shot that could not be played.
    fn frame(&self) -> Option<&Frame> {
        None
    }
    /// Takes a player's answer to a choice, or its concession (`None`), and answers every choice that
    /// follows from it, except those of the player. After an error the episode is over.
    fn choose(&mut self, _choice: Option<Choice>) -> Result<ShotResult, Error> {
        Err(Error::input("choice", "the task has no referee", "play a shot"))
    }
    /// Plays a shot, and answers every choice that follows from it, except those of a player. After
    /// an error the episode is over.
    fn play(
        &mut self,
        simulator: &mut FrameSimulator,
        strike: &NoisyStrike,
    ) -> Result<ShotResult, Error>;
    /// A copy.
    fn boxed(&self) -> Box<dyn Episode>;
}

impl Clone for Box<dyn Episode> {
    fn clone(&self) -> Self {
        self.as_ref().boxed()
    }
}

impl dyn Episode + '_ {
    /// Radius of `ball`, m.
    pub(crate) fn radius(&self, ball: BallIndex) -> f64 {
        self.balls()[usize::from(ball)].ball.radius
    }

    /// The other balls on the table: index, centre (file frame, m), radius (m).
    pub(crate) fn others(
        &self,
        ball: BallIndex,
    ) -> impl Iterator<Item = (BallIndex, [f64; 2], f64)> + '_ {
        (0..)
            .zip(self.balls())
            .filter(move |(i, _)| *i != ball)
            .filter_map(|(i, other)| self.place(i).map(|place| (i, place, other.ball.radius)))
    }

    /// The default elevation (rad) of `strike` on the ball `cue` at `place` (file frame, m).
    pub(crate) fn default_elevation(
        &self,
        cue: BallIndex,
        place: [f64; 2],
        strike: &Strike,
    ) -> f64 {
        let in_space =
            |[x, y]: [f64; 2], radius| BallInSpace { center: Vec3::new(x, y, radius), radius };
        let others = self.others(cue).map(|(_, place, radius)| in_space(place, radius));
        self.base().default_elevation_among(in_space(place, self.radius(cue)), others, strike)
    }

    /// The balls to aim at: the balls on, or every object ball where the rules name none.
    pub(crate) fn targets<'a>(
        &'a self,
        turn: &'a Turn,
    ) -> impl Iterator<Item = (BallIndex, [f64; 2], f64)> + 'a {
        self.others(turn.cue).filter(|(ball, ..)| turn.on.is_empty() || turn.on.contains(ball))
    }
}
