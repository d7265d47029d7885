//! The route of a shot: the cushions and balls by which the cue's motion reaches a target ball.

use carom::MotionState;
use carom::event::{Event, EventKind};
use carom::math::Vec2;
use carom::table::{Part, Rail};
use carom::{Shot, Table};

use crate::places::Places;

/// Balls slower than this count as resting, m/s. Rounding moves a ball of a frozen cluster by less;
/// every strike and collision by far more. A larger value would miss slow kisses.
const RESTING: f64 = 1e-9;

/// Legs that distinguish one route from another; longer routes are truncated. More would split
/// routes that players count as one, fewer would merge different ones.
const MOST_LEGS: usize = 8;

/// One leg of a [`Route`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Leg {
    /// The moving ball bounces off the nose of this rail.
    Cushion(Rail),
    /// The moving ball bounces off a jaw at the end of this rail and then meets something else. A
    /// ball that rattles in the jaws and falls adds no leg.
    Jaw(Rail),
    /// The moving ball hits this resting ball, whose motion counts from here on.
    Onto(u16),
    /// The moving ball hits this ball, and its own motion still counts.
    Off(u16),
    /// The moving ball flies over this resting ball.
    Over(u16),
    /// The struck ball curves around this resting ball, which blocks the straight line to the first
    /// contact.
    Around(u16),
}

/// The cushions and balls by which the cue's motion reached the target ball, from the strike on.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Route {
    /// Its legs, in order.
    pub legs: Vec<Leg>,
}

impl Route {
    /// The players' name for it: `direct`, or those of `jump`, `massé`, `kick`, `carom`, `combination`,
    /// `kiss` and `bank` that apply, joined by `+`. Players call a slight massé a swerve.
    pub fn kind(&self) -> String {
        let transfers = self.legs.iter().filter(|leg| matches!(leg, Leg::Onto(_))).count();
        let first = self.legs.iter().position(|leg| matches!(leg, Leg::Onto(_)));
        let before = &self.legs[..first.unwrap_or(self.legs.len())];
        let after = first.map_or(&[][..], |first| &self.legs[first + 1..]);
        let cushion = |leg: &Leg| matches!(leg, Leg::Cushion(_) | Leg::Jaw(_));
        let off = |leg: &Leg| matches!(leg, Leg::Off(_));
        let over = |leg: &Leg| matches!(leg, Leg::Over(_));
        let around = |leg: &Leg| matches!(leg, Leg::Around(_));
        let names: Vec<&str> = [
            (self.legs.iter().any(over), "jump"),
            (self.legs.iter().any(around), "massé"),
            (before.iter().any(cushion), "kick"),
            (before.iter().any(off), "carom"),
            (transfers > 1, "combination"),
            (after.iter().any(off), "kiss"),
            (after.iter().any(cushion), "bank"),
        ]
        .into_iter()
        .filter_map(|(applies, name)| applies.then_some(name))
        .collect();
        if names.is_empty() { "direct".into() } else { names.join("+") }
    }

    /// Removes the legs after the first contact with `ball`.
    pub(crate) fn end_at(&mut self, ball: usize) {
        let contact = |leg: &Leg| matches!(leg, Leg::Onto(b) if usize::from(*b) == ball);
        if let Some(end) = self.legs.iter().position(contact) {
            self.legs.truncate(end + 1);
        }
    }

    /// The legs in words: rails by name, balls by id.
    pub fn words(&self, shot: &Shot) -> String {
        let ball = |i: &u16| shot.balls()[usize::from(*i)].id.as_str();
        let words: Vec<String> = self
            .legs
            .iter()
            .map(|leg| match leg {
                Leg::Cushion(rail) => format!("{} rail", rail.name()),
                Leg::Jaw(rail) => format!("{} jaw", rail.name()),
                Leg::Onto(i) => ball(i).into(),
                Leg::Off(i) => format!("off {}", ball(i)),
                Leg::Over(i) => format!("over {}", ball(i)),
                Leg::Around(i) => format!("around {}", ball(i)),
            })
            .collect();
        words.join(", ")
    }
}

/// An event that may become a leg.
#[derive(Clone, Copy, Debug, PartialEq)]
enum LoggedEvent {
    /// A ball met a cushion.
    Cushion(u16, u16),
    /// Two balls met; whether each moved before.
    Balls([(u16, bool); 2]),
    /// A ball passed another, over or around it.
    Passed(u16, Leg),
}

/// The events of a shot that may become legs of a route, in order.
#[derive(Clone, Debug)]
pub(crate) struct RouteLog {
    cue_ball: usize,
    /// Where the cue ball started; None after its first contact.
    start: Option<Vec2>,
    events: Vec<LoggedEvent>,
}

impl RouteLog {
    pub(crate) fn new(cue_ball: usize, places: &Places) -> Self {
        Self { cue_ball, start: Some(places.last(cue_ball)), events: Vec::new() }
    }

    /// Adds an event; `places` are the balls' places before it.
    pub(crate) fn add(&mut self, event: &Event<'_>, places: &Places) {
        for (ball, state) in event.balls.iter().zip(event.before) {
            if state.motion == MotionState::Airborne {
                let (i, to) = (usize::from(*ball), state.position.xy());
                for under in places.blocking(i, places.last(i), to, event.balls) {
                    self.events.push(LoggedEvent::Passed(*ball, Leg::Over(under)));
                }
            }
        }
        match event.kind {
            EventKind::RailCollision(cushion) => {
                self.log_curve(event, places);
                self.events.push(LoggedEvent::Cushion(event.balls[0], cushion));
            }
            EventKind::BallCollision | EventKind::CueStrike { .. } if event.is_ball_contact() => {
                self.log_curve(event, places);
                let speed = |k: usize| event.before[k].velocity.length();
                let fastest =
                    (0..event.balls.len()).fold(0, |a, b| if speed(b) > speed(a) { b } else { a });
                // In a strike all balls rest, and the first one, the cue ball, moves the others.
                let is_strike = event.kind != EventKind::BallCollision;
                let moves = |k: usize| speed(k) > RESTING || (is_strike && k == fastest);
                // In a contact of many balls, all resting balls get their motion from the fastest.
                for k in (0..event.balls.len()).filter(|k| *k != fastest) {
                    self.events
                        .push(LoggedEvent::Balls([fastest, k].map(|k| (event.balls[k], moves(k)))));
                }
            }
            _ => (),
        }
    }

    /// If `event` is the cue ball's first contact: logs the balls that it has curved around.
    fn log_curve(&mut self, event: &Event<'_>, places: &Places) {
        let own = event.balls.iter().position(|ball| usize::from(*ball) == self.cue_ball);
        if let Some(own) = own
            && let Some(from) = self.start.take()
        {
            let to = event.before[own].position.xy();
            let cue_ball = self.cue_ball as u16;
            for other in places.blocking(self.cue_ball, from, to, event.balls) {
                let over = |c: &LoggedEvent| *c == LoggedEvent::Passed(cue_ball, Leg::Over(other));
                if !self.events.iter().any(over) {
                    self.events.push(LoggedEvent::Passed(cue_ball, Leg::Around(other)));
                }
            }
        }
    }

    /// The route of the motion from the cue to `target`; without a target, the cue ball's own.
    pub(crate) fn route(&self, target: Option<usize>, table: &Table) -> Route {
        let mut current = target.unwrap_or(self.cue_ball) as u16;
        let mut legs = Vec::new();
        for event in self.events.iter().rev() {
            match *event {
                LoggedEvent::Cushion(ball, cushion) if ball == current => {
                    let part = &table.cushions[usize::from(cushion)];
                    if part.part == Part::Nose {
                        legs.push(Leg::Cushion(part.rail));
                    } else if !legs.is_empty() && legs.last() != Some(&Leg::Jaw(part.rail)) {
                        legs.push(Leg::Jaw(part.rail));
                    }
                }
                LoggedEvent::Balls(pair) => {
                    let Some(own) = pair.iter().position(|(ball, _)| *ball == current) else {
                        continue;
                    };
                    let (other, _) = pair[1 - own];
                    if pair[own].1 {
                        legs.push(Leg::Off(other));
                    } else {
                        legs.push(Leg::Onto(current));
                        current = other;
                    }
                }
                LoggedEvent::Passed(ball, leg) if ball == current => {
                    // A ball may fly over another in several hops.
                    if legs.last() != Some(&leg) {
                        legs.push(leg);
                    }
                }
                LoggedEvent::Cushion(..) | LoggedEvent::Passed(..) => (),
            }
        }
        legs.reverse();
        legs.truncate(MOST_LEGS);
        Route { legs }
    }
}

#[cfg(test)]
mod tests {
    use super::{Leg, Rail, Route};

    #[test]
    fn routes_have_the_names_that_players_give_them() {
        use Leg::{Around, Cushion, Jaw, Off, Onto, Over};
        for (legs, kind) in [
            (vec![Onto(1)], "direct"),
            (vec![Over(2), Onto(1)], "jump"),
            (vec![Around(2), Onto(1), Cushion(Rail::Left)], "massé+bank"),
            (vec![Onto(1), Cushion(Rail::Left)], "bank"),
            (vec![Cushion(Rail::Left), Onto(1)], "kick"),
            (vec![Jaw(Rail::Left), Onto(1)], "kick"),
            (vec![Onto(2), Onto(1)], "combination"),
            (vec![Onto(2), Cushion(Rail::Top), Onto(1)], "combination+bank"),
            (vec![Off(2), Onto(1)], "carom"),
            (vec![Onto(1), Off(2)], "kiss"),
            (
                vec![Cushion(Rail::Top), Onto(2), Onto(1), Cushion(Rail::Left)],
                "kick+combination+bank",
            ),
        ] {
            assert_eq!(Route { legs }.kind(), kind);
        }
    }
}
