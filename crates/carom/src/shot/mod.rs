//! A shot: everything that is decided before it starts. Immutable.
//!
//! A [`Shot`] keeps the file that it was read from (`carom-shot/1`, or the same keys from Python
//! or from code) and, beside it, what the file means: table, physics, balls and strike, checked
//! and ready to simulate. A file comes in by [`Shot::from_node`] alone, so that every shot has passed
//! the same checks, and [`Shot::to_json`] gives back what was written. Programs that ask a lot change a
//! shot that they have ([`Shot::with_strike`], [`Shot::with_balls`]).

mod balls;
mod change;
#[cfg(feature = "json")]
mod json;
mod node;
mod obstruction;
mod path;
mod physics;
mod place;
pub(crate) mod read;
mod strike;
mod table;

use alloc::format;
use alloc::string::String;
use alloc::sync::Arc;

pub(crate) use balls::fits;
pub use node::Node;
pub use path::Path;
pub use physics::write as physics_to_node;
pub use strike::{Policy, StrikePolicy};

use crate::error::Error;
use crate::math::{Vec3, degrees};
use crate::outcome::Touched;
use crate::resolve::cue_ball::{Strike, miscue_limit};
use crate::simulate::SimulationError;
use crate::{Ball, BallState, Physics, Table};
use change::File;
use read::At;

/// What `format` says in a shot file.
pub const FORMAT: &str = "carom-shot/1";

/// Cap on the number of events where a file names none. The longest breaks seen need under a
/// thousand.
pub const DEFAULT_MAX_EVENTS: u32 = 100_000;

/// A ball placed on the table.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedBall {
    /// Unique name.
    pub id: String,
    /// Mass and radius.
    pub ball: Ball,
    /// State at time 0, in the file's frame (origin at the bottom left corner).
    pub state: BallState,
}

/// A validated shot.
#[derive(Clone, Debug)]
pub struct Shot {
    pub(crate) table: Arc<Table>,
    pub(crate) physics: Arc<Physics>,
    pub(crate) balls: Arc<[PlacedBall]>,
    pub(crate) strike: Option<(usize, Strike)>,
    pub(crate) max_events: u32,
    policy: StrikePolicy,
    /// Friction of the tip as the file has it; `physics` has what the strike is resolved with.
    tip_friction: f64,
    file: File,
}

/// Two shots are equal when they mean the same, however they are written.
impl PartialEq for Shot {
    fn eq(&self, other: &Self) -> bool {
        self.table == other.table
            && self.physics == other.physics
            && self.balls == other.balls
            && self.strike == other.strike
            && self.max_events == other.max_events
            && self.policy == other.policy
            && self.tip_friction == other.tip_friction
    }
}

impl AsRef<Shot> for Shot {
    fn as_ref(&self) -> &Self {
        self
    }
}

impl Shot {
    /// Reads a shot file.
    ///
    /// # Errors
    /// [`Error::Input`] for text that is not JSON and for everything that [`Self::from_node`]
    /// refuses.
    #[cfg(feature = "json")]
    pub fn from_json(text: &str) -> Result<Self, Error> {
        Self::from_node(Node::from_json(text)?)
    }

    /// Reads a shot from a tree of values.
    ///
    /// # Errors
    /// [`Error::Input`] with one sentence that names the place, what is wrong there, and what
    /// would be right.
    pub fn from_node(file: Node) -> Result<Self, Error> {
        let root = At::root(&file);
        // Before the keys: those of a trace or of a later format are no slips.
        root.known_fields()?
            .require("format", &format!("\"{FORMAT}\""))?
            .choice("format", &[(FORMAT, ())])?;
        let fields =
            root.fields(&["format", "table", "physics", "balls", "strike", "max_events"])?;
        let (table, default_physics) =
            table::read(&fields.require("table", "a table preset's name, or an object {...}")?)?;
        let mut physics = physics::read(fields.get("physics").as_ref(), &default_physics)?;
        let tip_friction = physics.cue.tip_friction;
        let balls = fields.require("balls", "a list of balls")?;
        let balls = balls::read(&balls, &physics.ball, &table)?;
        let mut policy = StrikePolicy::default();
        let mut strike = None;
        if let Some(at) = fields.get("strike") {
            policy = strike::read_policy(&at)?;
            if policy.miscue == Policy::Report {
                physics.cue.tip_friction = strike::TIP_THAT_HOLDS;
            }
            strike = Some(strike::read(&at, &balls, &physics)?);
        }
        let max_events = match fields.get("max_events") {
            Some(at) => at.whole(1, u32::MAX)?,
            None => DEFAULT_MAX_EVENTS,
        };
        let shot = Self {
            table,
            physics: physics.into(),
            balls: balls.into(),
            strike,
            max_events,
            policy,
            tip_friction,
            file: File::Read(file.into()),
        };
        if let Some((ball, strike)) = &shot.strike {
            shot.refuse_obstruction(*ball, strike)?;
        }
        Ok(shot)
    }

    /// The table.
    pub fn table(&self) -> &Arc<Table> {
        &self.table
    }

    /// The physics. Where a miscue is only to be reported, its `cue.tip_friction` is so large that
    /// the tip holds.
    pub fn physics(&self) -> &Arc<Physics> {
        &self.physics
    }

    /// The balls, in the order of the file; states in the file's frame.
    pub fn balls(&self) -> &[PlacedBall] {
        &self.balls
    }

    /// The struck ball's index and the strike, if there is one.
    pub const fn strike(&self) -> Option<(usize, Strike)> {
        self.strike
    }

    /// What to do about a strike that a player could not play cleanly.
    pub const fn strike_policy(&self) -> StrikePolicy {
        self.policy
    }

    /// More events than this are an error.
    pub const fn max_events(&self) -> u32 {
        self.max_events
    }

    /// The index of the ball with this id.
    pub fn ball_index(&self, id: &str) -> Option<usize> {
        self.balls.iter().position(|b| b.id == id)
    }

    /// The cue ball's index: the struck ball, else the ball with the id `cue`.
    pub fn cue_ball(&self) -> Option<usize> {
        self.strike.map(|(ball, _)| ball).or_else(|| self.ball_index("cue"))
    }

    /// Velocity (m/s) and spin (rad/s) that `strike` gives to the struck ball.
    ///
    /// # Errors
    /// [`Error::Input`] if there is nothing to strike, or the strike is out of range, off the
    /// ball, past the miscue limit, or out of the tip efficiency's reach, or if the cue is
    /// obstructed and the shot refuses that.
    pub fn resolve_strike(&self, strike: &Strike) -> Result<(Vec3, Vec3), Error> {
        let Some((ball, _)) = self.strike else {
            return Err(Error::input("strike", "the shot has no strike", "add one to vary it"));
        };
        strike::check_ranges("strike", strike)?;
        let struck = strike::check("strike", ball, strike, &self.balls, &self.physics)?;
        self.refuse_obstruction(ball, strike)?;
        Ok(struck)
    }

    /// The ball or rail that the cue would pass through, nearest to its tip. A strike at less than 5°
    /// is judged as if raised so far, should that be needed: players do.
    pub fn cue_obstruction(&self) -> Option<Touched> {
        let (ball, strike) = self.strike?;
        self.cue_on(ball, &strike).obstruction(strike.elevation)
    }

    /// The least elevation (rad) at which the cue would pass through nothing, all else of the strike
    /// the same; none without a strike, or if even an upright cue would.
    pub fn least_elevation(&self) -> Option<f64> {
        let (ball, strike) = self.strike?;
        self.cue_on(ball, &strike).least_elevation()
    }

    fn cue_on(&self, ball: usize, strike: &Strike) -> obstruction::Scene {
        obstruction::Scene::new(&self.table, &self.balls, ball, strike)
    }

    fn refuse_obstruction(&self, ball: usize, strike: &Strike) -> Result<(), Error> {
        if self.policy.obstruction == Policy::Report {
            return Ok(());
        }
        let cue = self.cue_on(ball, strike);
        let what = match cue.obstruction(strike.elevation) {
            None => return Ok(()),
            Some(Touched::Ball(i)) => format!("ball \"{}\"", self.balls[usize::from(i)].id),
            Some(Touched::Rail(rail)) => format!("the {} rail", rail.name()),
        };
        let raise = match cue.least_elevation().map(degrees) {
            // Rounded up.
            Some(least) => format!("raise the elevation to {:.2} degrees, ", least + 0.005),
            None => String::new(),
        };
        Err(Error::input(
            "strike.elevation_deg",
            format!("the cue would pass through {what}"),
            format!("{raise}turn the azimuth, or set strike.obstruction to \"report\""),
        ))
    }

    /// A state of ball `ball` in the engine's frame, in the file's. A coordinate that has not changed
    /// since the start is exactly what the file says, which shifting to and fro would round.
    pub fn to_file_frame(&self, ball: usize, state: &BallState) -> BallState {
        let written = &self.balls[ball].state;
        let start = self.table.to_engine_frame(written).position;
        let mut out = self.table.to_file_frame(state);
        if state.position.x == start.x {
            out.position.x = written.position.x;
        }
        if state.position.y == start.y {
            out.position.y = written.position.y;
        }
        out
    }

    /// What a failed simulation of this shot tells its user; `strike`, if it was played otherwise
    /// than the file says.
    pub fn explain(&self, failure: SimulationError, strike: Option<&Strike>) -> Error {
        let played = strike.copied().or(self.strike.map(|(_, strike)| strike));
        match (failure, played) {
            (SimulationError::Strike(e), Some(played)) => strike::explain("strike", &played, e),
            (SimulationError::Strike(e), None) => {
                Error::input("strike", format!("{e}"), "change the strike")
            }
            (SimulationError::TooManyEvents { max_events, .. }, _) => {
                let shot = strike.and_then(|s| self.with_strike(s).ok());
                let shot = shot.as_ref().unwrap_or(self).to_json();
                Error::TooManyEvents { cap: max_events, shot }
            }
        }
    }

    /// Whether the tip would slip off in this shot, which it only may on request.
    pub fn is_miscue(&self) -> bool {
        self.strike.is_some_and(|(_, strike)| strike.offset() > self.miscue_limit())
    }

    /// The largest tip offset √(side² + height²) that the friction of the tip holds, in ball radii.
    pub fn miscue_limit(&self) -> f64 {
        miscue_limit(self.tip_friction)
    }
}
