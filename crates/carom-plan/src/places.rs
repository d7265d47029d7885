//! Where the balls are at each event, and which balls block a straight path.

use carom::event::Event;
use carom::math::Vec2;
use carom::{MotionState, Shot};

/// Overlap below which a ball does not count as blocking a path, m. A tenth of a millimetre is not
/// visible on a table; without the margin, grazing passes would be called jumps or curves.
const VISIBLE: f64 = 1e-4;

/// The place of each ball at its last event, in the engine's coordinates.
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

    /// Moves `ball` to `to` and returns where it was before.
    pub(crate) fn replace(&mut self, ball: usize, to: Vec2) -> Vec2 {
        std::mem::replace(&mut self.last[ball], to)
    }

    /// Updates which balls rest after an event.
    pub(crate) fn update_resting(&mut self, event: &Event<'_>) {
        for (ball, state) in event.balls.iter().zip(event.after) {
            self.rests[usize::from(*ball)] = state.motion == MotionState::Stationary;
        }
    }

    /// The resting balls that block the straight path of `ball` on the cloth from `from` to `to`.
    /// Balls that it touches at the start and the balls `met` at the end do not count.
    pub(crate) fn blocking<'a>(
        &'a self,
        ball: usize,
        from: Vec2,
        to: Vec2,
        met: &'a [u16],
    ) -> impl Iterator<Item = u16> + 'a {
        (0..self.count() as u16).filter(move |&other| {
            let i = usize::from(other);
            let near = self.radius[ball] + self.radius[i] - VISIBLE;
            i != ball
                && self.rests[i]
                // LLVM 22 cannot select WebAssembly's vectors for `met.contains(&other)`.
                && !met.iter().any(|ball| usize::from(*ball) == i)
                && (self.last[i] - from).length() >= near
                && distance(from, to, self.last[i]) < near
        })
    }
}

/// The distance of `point` from the segment `from`–`to`.
pub(crate) fn distance(from: Vec2, to: Vec2, point: Vec2) -> f64 {
    let (along, beside) = (to - from, point - from);
    let squared = along.length_squared();
    let share = if squared > 0.0 { (along.dot(beside) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (beside - along * share).length()
}
