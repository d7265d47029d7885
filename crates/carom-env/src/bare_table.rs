//! A table with balls, for the tasks that are not games of carom-rules.

use std::sync::Arc;

use carom::event::Recorder;
use carom::format::Node;
use carom::math::Vec3;
use carom::shot::PlacedBall;
use carom::{BallState, Error, ErrorKind, MotionState, Shot, Simulator};
use carom_rules::{BallIndex, FrameBall, StateBytes, through_degrees};

use crate::config::Config;
use crate::episode::{EpisodeStart, NoisyStrike, check_same_place};

/// A table with balls, without rules.
#[derive(Clone)]
pub(crate) struct BareTable {
    pub(crate) base: Shot,
    pub(crate) balls: Arc<[FrameBall]>,
    pub(crate) places: Vec<Option<[f64; 2]>>,
}

impl BareTable {
    /// A table without balls on it; `table` and `physics` as in a shot file.
    pub(crate) fn new(
        table: Node,
        physics: Option<Node>,
        ids: impl Iterator<Item = String>,
    ) -> Result<Self, Error> {
        let base = Shot::bare(table, physics)?;
        let ball = base.physics().ball;
        let balls: Arc<[FrameBall]> = ids.map(|id| FrameBall { id, ball }).collect();
        let places = vec![None; balls.len()];
        Ok(Self { base, balls, places })
    }

    /// Places the balls of `start`. Balls that it lacks are off the table.
    pub(crate) fn start_at(&mut self, start: &EpisodeStart, config: &Config) -> Result<(), Error> {
        let EpisodeStart::Shot(shot) = start else {
            let remedy = "give a shot, or a dict of one";
            return Err(ErrorKind::Unsupported.at("shot", "the task has no frames", remedy));
        };
        check_same_place(&self.base, shot, config)?;
        self.places.fill(None);
        for (i, PlacedBall { id, ball, state }) in shot.balls().iter().enumerate() {
            let ids =
                || self.balls.iter().map(|own| own.id.as_str()).collect::<Vec<_>>().join(", ");
            let wrong = |kind: ErrorKind, key: &str, what: String, remedy: String| {
                Err(kind.at(format!("balls[{i}]{key}"), what, remedy))
            };
            let Some(index) = self.balls.iter().position(|own| own.id == *id) else {
                let remedy =
                    format!("write one of {}, or make the environment with more balls", ids());
                return wrong(
                    ErrorKind::UnknownBall,
                    ".id",
                    format!("the task has no ball \"{id}\""),
                    remedy,
                );
            };
            if *ball != self.balls[index].ball {
                return wrong(
                    ErrorKind::Mismatch,
                    "",
                    "its mass or radius is not the task's".into(),
                    "leave them out".into(),
                );
            }
            if state.motion != MotionState::Stationary {
                return wrong(
                    ErrorKind::Moving,
                    "",
                    "it moves".into(),
                    "leave out its velocities".into(),
                );
            }
            self.places[index] = Some([state.position.x, state.position.y]);
        }
        Ok(())
    }

    /// Appends the places of the balls.
    pub(crate) fn write_to(&self, out: &mut Vec<u8>) {
        self.places.iter().for_each(|place| place.write_to(out));
    }

    /// Replaces the places by those that `bytes` begin with.
    pub(crate) fn read_from(&mut self, bytes: &mut &[u8]) -> Option<()> {
        for place in &mut self.places {
            *place = StateBytes::read_from(bytes)?;
        }
        Some(())
    }

    /// Plays `strike` on ball `cue` and moves the balls to where they come to rest.
    pub(crate) fn play(
        &mut self,
        simulator: &mut Simulator,
        cue: BallIndex,
        strike: &NoisyStrike,
        recorder: &mut impl Recorder,
        shots: Option<&mut Vec<Shot>>,
    ) -> Result<(), Error> {
        let on_table = |ball: &usize| self.places[*ball].is_some();
        let balls: Vec<usize> = (0..self.balls.len()).filter(on_table).collect();
        let placed = balls.iter().filter_map(|&ball| {
            let ([x, y], FrameBall { id, ball }) = (self.places[ball]?, &self.balls[ball]);
            let position = Vec3::new(x, y, ball.radius);
            let state = BallState { position, ..BallState::default() };
            Some(PlacedBall { id: id.clone(), ball: *ball, state })
        });
        let struck = balls.iter().position(|ball| *ball == usize::from(cue)).unwrap_or_default();
        let actual = through_degrees(&strike.actual);
        let mut shot = self.base.with_balls(placed.collect(), Some((struck, actual)))?;
        if !strike.cling.is_empty() {
            shot = shot.with_cling(strike.cling);
        }
        let summary = simulator.play(&shot, recorder)?;
        shots.into_iter().for_each(|shots| shots.push(shot.clone()));
        for (i, &ball) in balls.iter().enumerate() {
            let state = simulator.file_state(i, &shot, summary.duration);
            let gone = matches!(state.motion, MotionState::Pocketed | MotionState::OffTable);
            self.places[ball] = (!gone).then_some([state.position.x, state.position.y]);
        }
        Ok(())
    }
}
