//! How motion comes from the cue to the ball that counts: which cushions, which balls.

use carom::MotionState;
use carom::event::{Event, EventKind};
use carom::math::Vec2;
use carom::table::{Part, Rail};
use carom::{Shot, Table};

use crate::places::Places;

/// Slower balls count as resting, m/s: a neighbour's breath.
const RESTING: f64 = 1e-9;

/// The longest way that is told apart from others; longer ones are cut at their end.
const LONGEST: usize = 8;

/// One step of a [`Way`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// Off the nose of this rail.
    Cushion(Rail),
    /// Off a jaw at the end of this rail, and on to something else: what rattles and falls makes no step.
    Jaw(Rail),
    /// The motion goes on with this ball.
    Onto(u16),
    /// The ball that moves goes on, off this one.
    Off(u16),
    /// It flies over this one, which rests.
    Over(u16),
    /// The struck ball comes to what it first meets on a curve: this ball, which rests, stands in the straight
    /// line.
    Around(u16),
}

/// How motion came from the cue to the ball that counts, from the strike on.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Way {
    /// Its steps.
    pub steps: Vec<Step>,
}

impl Way {
    /// What players call it: `direct`, or those of `jump`, `massé`, `kick`, `carom`, `combination`, `kiss`,
    /// `bank` that apply, joined by `+`. A slight massé is a swerve to them.
    pub fn kind(&self) -> String {
        let handed = self.steps.iter().filter(|s| matches!(s, Step::Onto(_))).count();
        let first = self.steps.iter().position(|s| matches!(s, Step::Onto(_)));
        let before = &self.steps[..first.unwrap_or(self.steps.len())];
        let after = first.map_or(&[][..], |first| &self.steps[first + 1..]);
        let cushion = |s: &Step| matches!(s, Step::Cushion(_) | Step::Jaw(_));
        let off = |s: &Step| matches!(s, Step::Off(_));
        let over = |s: &Step| matches!(s, Step::Over(_));
        let around = |s: &Step| matches!(s, Step::Around(_));
        let names: Vec<&str> = [
            (self.steps.iter().any(over), "jump"),
            (self.steps.iter().any(around), "massé"),
            (before.iter().any(cushion), "kick"),
            (before.iter().any(off), "carom"),
            (handed > 1, "combination"),
            (after.iter().any(off), "kiss"),
            (after.iter().any(cushion), "bank"),
        ]
        .into_iter()
        .filter_map(|(applies, name)| applies.then_some(name))
        .collect();
        if names.is_empty() { "direct".into() } else { names.join("+") }
    }

    /// Leaves out what comes after the first contact with `ball`.
    pub(crate) fn end_at(&mut self, ball: usize) {
        let contact = |s: &Step| matches!(s, Step::Onto(b) if usize::from(*b) == ball);
        if let Some(end) = self.steps.iter().position(contact) {
            self.steps.truncate(end + 1);
        }
    }

    /// The steps in words: rails by name, balls by id.
    pub fn words(&self, shot: &Shot) -> String {
        let ball = |i: &u16| shot.balls()[usize::from(*i)].id.as_str();
        let words: Vec<String> = self
            .steps
            .iter()
            .map(|step| match step {
                Step::Cushion(rail) => format!("{} rail", rail.name()),
                Step::Jaw(rail) => format!("{} jaw", rail.name()),
                Step::Onto(i) => ball(i).into(),
                Step::Off(i) => format!("off {}", ball(i)),
                Step::Over(i) => format!("over {}", ball(i)),
                Step::Around(i) => format!("around {}", ball(i)),
            })
            .collect();
        words.join(", ")
    }
}

/// What a way may be made of.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Contact {
    /// A ball and a cushion.
    Cushion(u16, u16),
    /// Two balls, and whether each moved before.
    Balls([(u16, bool); 2]),
    /// A ball passes another.
    Passed(u16, Step),
}

/// The contacts of a shot, in order.
#[derive(Clone, Debug)]
pub(crate) struct Log {
    cue_ball: usize,
    /// Where that lies, until it has met something.
    start: Option<Vec2>,
    contacts: Vec<Contact>,
}

impl Log {
    pub(crate) fn new(cue_ball: usize, places: &Places) -> Self {
        Self { cue_ball, start: Some(places.last(cue_ball)), contacts: Vec::new() }
    }

    /// Notes an event; `places` are those before it.
    pub(crate) fn add(&mut self, event: &Event<'_>, places: &Places) {
        for (ball, state) in event.balls.iter().zip(event.before) {
            if state.motion == MotionState::Airborne {
                let (i, to) = (usize::from(*ball), state.position.xy());
                for under in places.in_the_way(i, places.last(i), to, event.balls) {
                    self.contacts.push(Contact::Passed(*ball, Step::Over(under)));
                }
            }
        }
        match event.kind {
            EventKind::RailCollision(cushion) => {
                self.meet(event, places);
                self.contacts.push(Contact::Cushion(event.balls[0], cushion));
            }
            EventKind::BallCollision => {
                self.meet(event, places);
                let speed = |k: usize| event.before[k].velocity.length();
                let fastest =
                    (0..event.balls.len()).fold(0, |a, b| if speed(b) > speed(a) { b } else { a });
                // In a many-ball contact all that rest get their motion from the one that comes.
                for k in (0..event.balls.len()).filter(|k| *k != fastest) {
                    self.contacts.push(Contact::Balls(
                        [fastest, k].map(|k| (event.balls[k], speed(k) > RESTING)),
                    ));
                }
            }
            _ => (),
        }
    }

    /// The first contact of the cue ball, if `event` is that: around which balls it has come.
    fn meet(&mut self, event: &Event<'_>, places: &Places) {
        let own = event.balls.iter().position(|ball| usize::from(*ball) == self.cue_ball);
        if let Some(own) = own
            && let Some(from) = self.start.take()
        {
            let to = event.before[own].position.xy();
            let cue_ball = self.cue_ball as u16;
            for other in places.in_the_way(self.cue_ball, from, to, event.balls) {
                let over = |c: &Contact| *c == Contact::Passed(cue_ball, Step::Over(other));
                if !self.contacts.iter().any(over) {
                    self.contacts.push(Contact::Passed(cue_ball, Step::Around(other)));
                }
            }
        }
    }

    /// How motion came to `target` from the strike; without a target, the cue ball's own way.
    pub(crate) fn way(&self, target: Option<usize>, table: &Table) -> Way {
        let mut current = target.unwrap_or(self.cue_ball) as u16;
        let mut steps = Vec::new();
        for contact in self.contacts.iter().rev() {
            match *contact {
                Contact::Cushion(ball, cushion) if ball == current => {
                    let part = &table.cushions[usize::from(cushion)];
                    if part.part == Part::Nose {
                        steps.push(Step::Cushion(part.rail));
                    } else if !steps.is_empty() && steps.last() != Some(&Step::Jaw(part.rail)) {
                        steps.push(Step::Jaw(part.rail));
                    }
                }
                Contact::Balls(pair) => {
                    let Some(own) = pair.iter().position(|(ball, _)| *ball == current) else {
                        continue;
                    };
                    let (other, _) = pair[1 - own];
                    if pair[own].1 {
                        steps.push(Step::Off(other));
                    } else {
                        steps.push(Step::Onto(current));
                        current = other;
                    }
                }
                Contact::Passed(ball, step) if ball == current => {
                    // One ball may be flown over in several hops.
                    if steps.last() != Some(&step) {
                        steps.push(step);
                    }
                }
                Contact::Cushion(..) | Contact::Passed(..) => (),
            }
        }
        steps.reverse();
        steps.truncate(LONGEST);
        Way { steps }
    }
}

#[cfg(test)]
mod tests {
    use super::{Rail, Step, Way};

    #[test]
    fn ways_have_the_names_that_players_give_them() {
        use Step::{Around, Cushion, Jaw, Off, Onto, Over};
        for (steps, kind) in [
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
            assert_eq!(Way { steps }.kind(), kind);
        }
    }
}
