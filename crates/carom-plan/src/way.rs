//! How motion comes from the cue to the ball that counts: which cushions, which balls.

use carom::event::{Event, EventKind};
use carom::table::{Part, Rail};
use carom::{Shot, Table};

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
}

/// How motion came from the cue to the ball that counts, from the strike on.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Way {
    /// Its steps.
    pub steps: Vec<Step>,
}

impl Way {
    /// What players call it: `direct`, or those of `kick`, `carom`, `combination`, `kiss`, `bank` that apply,
    /// joined by `+`.
    pub fn kind(&self) -> String {
        let handed = self.steps.iter().filter(|s| matches!(s, Step::Onto(_))).count();
        let first = self.steps.iter().position(|s| matches!(s, Step::Onto(_)));
        let before = &self.steps[..first.unwrap_or(self.steps.len())];
        let after = first.map_or(&[][..], |first| &self.steps[first + 1..]);
        let cushion = |s: &Step| matches!(s, Step::Cushion(_) | Step::Jaw(_));
        let off = |s: &Step| matches!(s, Step::Off(_));
        let names: Vec<&str> = [
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
            })
            .collect();
        words.join(", ")
    }
}

/// One contact.
#[derive(Clone, Copy, Debug)]
enum Contact {
    /// A ball and a cushion.
    Cushion(u16, u16),
    /// Two balls, and whether each moved before.
    Balls([(u16, bool); 2]),
}

/// The contacts of a shot, in order.
#[derive(Clone, Debug, Default)]
pub(crate) struct Log(Vec<Contact>);

impl Log {
    pub(crate) fn add(&mut self, event: &Event<'_>) {
        match event.kind {
            EventKind::RailCollision(cushion) => {
                self.0.push(Contact::Cushion(event.balls[0], cushion));
            }
            EventKind::BallCollision => {
                let speed = |k: usize| event.before[k].velocity.length();
                let fastest =
                    (0..event.balls.len()).fold(0, |a, b| if speed(b) > speed(a) { b } else { a });
                // In a many-ball contact all that rest get their motion from the one that comes.
                for k in (0..event.balls.len()).filter(|k| *k != fastest) {
                    self.0.push(Contact::Balls(
                        [fastest, k].map(|k| (event.balls[k], speed(k) > RESTING)),
                    ));
                }
            }
            _ => (),
        }
    }

    /// How motion came to `target` from the strike on `cue_ball`; without a target, the cue ball's own way.
    pub(crate) fn way(&self, cue_ball: usize, target: Option<usize>, table: &Table) -> Way {
        let mut current = target.unwrap_or(cue_ball) as u16;
        let mut steps = Vec::new();
        for contact in self.0.iter().rev() {
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
                Contact::Cushion(..) => (),
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
        use Step::{Cushion, Jaw, Off, Onto};
        for (steps, kind) in [
            (vec![Onto(1)], "direct"),
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
