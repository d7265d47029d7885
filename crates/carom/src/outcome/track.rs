//! The balls' paths between their events.

use alloc::vec::Vec;

use crate::BallState;
use crate::motion::Path;
use crate::shot::Shot;
use crate::simulate::BallSet;

/// A ball's path since its last event, in the file's coordinates.
#[derive(Clone, Debug)]
pub(super) struct Track {
    /// Time of that event, s since the strike.
    pub(super) since: f64,
    pub(super) path: Path,
}

impl Track {
    /// The greatest height of a path in the air, m.
    pub(super) fn apex(&self) -> f64 {
        let rise = self.path.velocity.z.max(0.0);
        self.path.position.z - 0.25 * rise * rise / self.path.half_acceleration.z
    }
}

/// The frame of reference in which the states of events are given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Origin {
    /// That of files and traces.
    #[default]
    File,
    /// That of the engine.
    Engine,
}

impl Origin {
    /// A `state` of ball `ball`, given in this frame, in the file's coordinates.
    pub(super) fn in_file(self, shot: &Shot, ball: u16, state: &BallState) -> BallState {
        match self {
            Self::File => *state,
            Self::Engine => shot.to_file_coordinates(usize::from(ball), state),
        }
    }
}

/// Every ball's state after its last event. Few facts of a shot depend on paths, so a path is
/// computed only where one does.
#[derive(Clone, Debug, Default)]
pub(super) struct Tracks {
    pub(super) origin: Origin,
    /// The balls that have had an event. Only their entries of `last` are used.
    moved: BallSet,
    /// Time (s) and state of each ball's last event.
    last: Vec<(f64, BallState)>,
}

impl Tracks {
    /// Begins again with `count` balls. The states of events will be given in the frame `origin`.
    pub(super) fn restart(&mut self, count: usize, origin: Origin) {
        (self.origin, self.moved) = (origin, BallSet::EMPTY);
        if self.last.len() < count {
            self.last.resize(count, (0.0, BallState::default()));
        }
    }

    /// Sets the `state` of ball `ball` after an event at `time` (s).
    #[inline]
    pub(super) fn set(&mut self, ball: u16, time: f64, state: &BallState) {
        let ball = usize::from(ball);
        self.last[ball] = (time, *state);
        self.moved = self.moved.with(ball);
    }

    /// The greatest height (m) of the flight of ball `ball` of `shot`, to rounding, and the ball's
    /// radius, m.
    #[inline]
    pub(super) fn apex(&self, shot: &Shot, ball: u16) -> (f64, f64) {
        let placed = &shot.balls()[usize::from(ball)];
        let moved = self.moved.contains(usize::from(ball));
        let state = if moved { &self.last[usize::from(ball)].1 } else { &placed.state };
        let rise = state.velocity.z.max(0.0);
        (state.position.z + 0.5 * rise * rise / shot.physics().gravity, placed.ball.radius)
    }

    /// The path of ball `ball` of `shot` since its last event.
    pub(super) fn of(&self, shot: &Shot, ball: u16) -> Track {
        let placed = &shot.balls()[usize::from(ball)];
        let (since, state) = if self.moved.contains(usize::from(ball)) {
            let (since, state) = &self.last[usize::from(ball)];
            (*since, self.origin.in_file(shot, ball, state))
        } else {
            (0.0, placed.state)
        };
        let physics = shot.physics();
        Track { since, path: Path::new(&state, &placed.ball, &physics.cloth, physics.gravity) }
    }
}
