//! The interface of an episode: a table with balls and the rules of a task.

use carom::math::Vec3;
use carom::resolve::cue_ball::Strike;
use carom::shot::{BallInSpace, Cling};
use carom::{Error, ErrorKind, Shot};
use carom_arena::LastShot;
use carom_rules::{BallIndex, Call, Choice, Fouls, Frame, FrameBall, FrameSimulator, Seat, Turn};

use crate::config::Config;
use crate::setup::Setup;

/// A strike before and after noise.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NoisyStrike {
    /// The strike that the player intended.
    pub(crate) intended: Strike,
    /// The strike that is played.
    pub(crate) actual: Strike,
    /// The contacts that cling.
    pub(crate) cling: Cling,
    /// Where a cue ball in hand is placed before the strike (file coordinates, m).
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
    /// The fouls.
    pub(crate) fouls: Fouls,
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

/// Why an episode ended in which a shot could not be played.
pub(crate) const UNPLAYABLE: &str = "a shot could not be played";

/// Where an episode starts, in place of its own start.
#[derive(Clone, Debug)]
pub enum EpisodeStart {
    /// From the balls of a shot on the same table with the same physics, as [`Frame::resume_at`]
    /// does.
    Shot(Shot),
    /// From a frame of the same game on the same table with the same physics, whatever it asks for
    /// next.
    Frame(Box<Frame>),
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
    /// Centre of `ball` (file coordinates, m); none if it is not on the table.
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
    /// Why the episode is over; none while it continues.
    fn why(&self) -> Option<&'static str>;
    /// Changes the table and the physics, for the next [`Self::restart`].
    fn set_up(&mut self, setup: &Setup, config: &Config) -> Result<(), Error>;
    /// Continues from `start`, right after [`Self::restart`].
    fn start_at(&mut self, start: &EpisodeStart, config: &Config) -> Result<(), Error>;
    /// The seat that answers its choices itself; none if all choices are answered here.
    fn set_chooser(&mut self, _chooser: Option<Seat>) {}
    /// Other racks from here on.
    fn reseed(&mut self, _seed: u64) {}
    /// The call that is made for a strike.
    fn call_of(&self, _simulator: &mut FrameSimulator, _strike: &NoisyStrike) -> Call {
        Call::Nothing
    }
    /// Appends everything that changes during an episode.
    fn write_to(&self, out: &mut Vec<u8>);
    /// Replaces the state by that which `bytes` begin with.
    fn read_from(&mut self, bytes: &mut &[u8]) -> Option<()>;
    /// Starts another episode.
    fn restart(&mut self, seed: u64) -> Result<(), Error>;
    /// The frame to whose requests a player answers; none if the task has no referee, and after a
    /// shot that could not be played.
    fn frame(&self) -> Option<&Frame> {
        None
    }
    /// The last shot of the frame, if a seat answers its choices itself; none before the first shot, and
    /// after [`Self::read_from`].
    fn last_shot(&self) -> Option<LastShot<'_>> {
        None
    }
    /// Takes a player's answer to a choice, or its concession (`None`), and answers every choice
    /// that follows from it, except those of the player. After an error the episode is over.
    fn choose(&mut self, _choice: Option<Choice>) -> Result<ShotResult, Error> {
        Err(ErrorKind::Unsupported.at("choice", "the task has no referee", "play a shot"))
    }
    /// Plays a shot, and answers every choice that follows from it, except those of a player. After
    /// an error the episode is over. The shot as it was played is added to `shots`.
    fn play(
        &mut self,
        simulator: &mut FrameSimulator,
        strike: &NoisyStrike,
        shots: Option<&mut Vec<Shot>>,
    ) -> Result<ShotResult, Error>;
    /// A copy.
    fn boxed(&self) -> Box<dyn Episode>;
}

/// An error if `start` is on another table than `base` or has other physics, unless `config` draws
/// them.
pub(crate) fn check_same_place(base: &Shot, start: &Shot, config: &Config) -> Result<(), Error> {
    let wrong = |what: &str, key: &str| {
        let remedy = format!("make the environment with {key}=, or give balls for its own");
        Err(ErrorKind::Mismatch.at(key, format!("the shot is {what} than the environment"), remedy))
    };
    let is_drawn = |of_table: bool| {
        config.randomize.iter().any(|one| one.path.starts_with("table.") == of_table)
    };
    if start.table() != base.table() && !is_drawn(true) {
        return wrong("on another table", "table");
    }
    if start.physics() != base.physics() && !is_drawn(false) {
        return wrong("with other physics", "physics");
    }
    Ok(())
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

    /// The other balls on the table: index, centre (file coordinates, m), radius (m).
    pub(crate) fn others(
        &self,
        ball: BallIndex,
    ) -> impl Iterator<Item = (BallIndex, [f64; 2], f64)> + '_ {
        (0..)
            .zip(self.balls())
            .filter(move |(i, _)| *i != ball)
            .filter_map(|(i, other)| self.place(i).map(|place| (i, place, other.ball.radius)))
    }

    /// The default elevation (rad) of `strike` on the ball `cue` at `place` (file coordinates, m).
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
