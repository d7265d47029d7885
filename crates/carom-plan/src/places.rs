//! Where balls are between their events, and who stands in whose way.

use carom::event::Event;
use carom::math::Vec2;
use carom::{MotionState, Shot};

/// What nobody sees, m: a ball that another passes by less is not said to have been in its way.
const SEEN: f64 = 1e-4;

/// Where each ball was at its last event, in the engine's frame.
#[derive(Clone, Debug)]
pub(crate) struct Places {
    last: Vec<Vec2>,
    radius: Vec<f64>,
    rests: Vec<bool>,
}

impl Places {
    pub(crate) fn new(shot: &Shot) -> Self {
        let (balls, center) = (shot.balls(), shot.table().center());
        Self {
            last: balls.iter().map(|b| b.state.position.xy() - center).collect(),
            radius: balls.iter().map(|b| b.ball.radius).collect(),
            rests: balls.iter().map(|b| b.state.motion == MotionState::Stationary).collect(),
        }
    }

    pub(crate) fn count(&self) -> usize {
        self.last.len()
    }

    pub(crate) fn last(&self, ball: usize) -> Vec2 {
        self.last[ball]
    }

    pub(crate) fn radius(&self, ball: usize) -> f64 {
        self.radius[ball]
    }

    /// `ball` is at `to` now; where it was before.
    pub(crate) fn go(&mut self, ball: usize, to: Vec2) -> Vec2 {
        std::mem::replace(&mut self.last[ball], to)
    }

    /// After an event, some of its balls rest.
    pub(crate) fn settle(&mut self, event: &Event<'_>) {
        for (ball, state) in event.balls.iter().zip(event.after) {
            self.rests[usize::from(*ball)] = state.motion == MotionState::Stationary;
        }
    }

    /// The resting balls that `ball` would touch on the cloth on a straight way from where it touches none,
    /// but for those `met` at its end.
    pub(crate) fn in_the_way<'a>(
        &'a self,
        ball: usize,
        from: Vec2,
        to: Vec2,
        met: &'a [u16],
    ) -> impl Iterator<Item = u16> + 'a {
        (0..self.count() as u16).filter(move |&other| {
            let i = usize::from(other);
            let near = self.radius[ball] + self.radius[i] - SEEN;
            i != ball
                && self.rests[i]
                && !met.contains(&other)
                && (self.last[i] - from).length() >= near
                && distance(from, to, self.last[i]) < near
        })
    }
}

/// From a point to a straight path.
pub(crate) fn distance(from: Vec2, to: Vec2, point: Vec2) -> f64 {
    let (along, beside) = (to - from, point - from);
    let squared = along.length_squared();
    let share = if squared > 0.0 { (along.dot(beside) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (beside - along * share).length()
}
