//! The way of one ball through a recorded shot: what it meets, where, and how it moves there.

use carom::Trace;
use carom::table::{Part, Rail};
use carom::trace::{TraceEvent, TraceEventKind};

/// What a ball meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Obstacle {
    /// The nose of a rail.
    Cushion(Rail),
    /// Another ball, and its place (m, file coordinates).
    Ball(u16, [f64; 2]),
    /// Several balls at once, a jaw, a pocket, or the end of the table.
    Other,
}

/// A meeting of the ball with an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Meeting {
    pub(crate) with: Obstacle,
    /// The ball's place, m, file coordinates.
    pub(crate) at: [f64; 2],
    /// Its velocity before, m/s.
    pub(crate) by: [f64; 2],
}

/// The way of a ball from a place on.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BallWay {
    /// Where it begins, m, file coordinates.
    pub(crate) start: [f64; 2],
    pub(crate) meetings: Vec<Meeting>,
}

impl BallWay {
    /// The way of ball number `ball` behind event number `from`, or from the beginning. `None` if the ball does not
    /// exist or takes no part in that event.
    pub(crate) fn new(trace: &Trace, ball: u16, from: Option<usize>) -> Option<Self> {
        let placed = trace.shot().balls().get(usize::from(ball))?;
        let start = match from {
            None => placed.state.position,
            Some(number) => {
                let event = trace.events().nth(number)?;
                event.after[own(&event, ball)?].position
            }
        };
        let behind = trace.events().skip(from.map_or(0, |number| number + 1));
        let meetings = behind.filter_map(|event| meeting(&event, ball)).collect();
        Some(Self { start: [start.x, start.y], meetings })
    }
}

/// The place of `ball` among the balls of an event.
fn own(event: &TraceEvent<'_>, ball: u16) -> Option<usize> {
    event.balls.iter().position(|other| *other == ball)
}

fn meeting(event: &TraceEvent<'_>, ball: u16) -> Option<Meeting> {
    let k = own(event, ball)?;
    let with = match event.kind {
        TraceEventKind::MotionTransition { .. } | TraceEventKind::SlateCollision => return None,
        TraceEventKind::CueStrike { .. } if event.balls.len() == 1 => return None,
        TraceEventKind::RailCollision { rail, part: Part::Nose } => Obstacle::Cushion(rail.whole()),
        TraceEventKind::BallCollision if event.balls.len() == 2 => {
            let other = event.before[1 - k].position;
            Obstacle::Ball(event.balls[1 - k], [other.x, other.y])
        }
        _ => Obstacle::Other,
    };
    let state = event.before[k];
    let (at, by) = (state.position, state.velocity);
    Some(Meeting { with, at: [at.x, at.y], by: [by.x, by.y] })
}
