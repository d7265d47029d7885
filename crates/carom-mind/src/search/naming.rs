//! The names of listed plays: what their strikes do without errors.
//!
//! A search moves the strikes of plays, and it tries hits anywhere. So a play that was found as a safety may
//! pot a ball in the end, and one that was found on a direct line may pot its ball off a cushion.

use carom::Error;
use carom::event::{Event, EventKind, Recorder};
use carom::table::{Part, PocketName, Table};
use carom_rules::{BallIndex, Call};

use super::candidate::{Candidate, PlayKind};
use super::explore::Explorer;
use crate::line::LineKind;
use carom_plan::{CaromRoute, Prepared};

/// Cosine of the least turn of an object ball at a cushion that makes a bank: 10°. A ball that only rubs along
/// the cushion still goes straight into the pocket.
const RUBS: f64 = 0.985;

/// A contact that may turn a ball on its way to a pocket. Balls are indices in the shot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Contact {
    /// Two balls meet.
    Balls(u16, u16),
    /// More than two balls meet at once: bit k stands for ball k.
    Cluster(u64),
    /// A ball meets a cushion.
    Cushion(u16),
    /// A ball rubs along a cushion, or meets the jaw of a pocket.
    Jaw(u16),
    /// A ball falls.
    Fall(u16, PocketName),
}

/// Collects the contacts of a shot.
struct ContactRecorder<'a> {
    table: &'a Table,
    contacts: Vec<Contact>,
}

impl Recorder for ContactRecorder<'_> {
    fn record(&mut self, event: &Event<'_>) {
        let contact = match (event.kind, event.balls) {
            (EventKind::CueStrike { .. } | EventKind::BallCollision, [a, b]) => {
                Contact::Balls(*a, *b)
            }
            (EventKind::CueStrike { .. } | EventKind::BallCollision, [_, _, _, ..]) => {
                Contact::Cluster(event.balls.iter().fold(0, |all, ball| all | bit(*ball)))
            }
            (EventKind::RailCollision(cushion), [ball, ..]) => {
                let [before, after] =
                    [event.before, event.after].map(|states| states[0].velocity.xy());
                let turns = before.dot(after) < RUBS * before.length() * after.length();
                match self.table.cushions[usize::from(cushion)].part {
                    Part::Nose if turns => Contact::Cushion(*ball),
                    _ => Contact::Jaw(*ball),
                }
            }
            (EventKind::PocketCollision(pocket), [ball, ..]) => {
                Contact::Fall(*ball, self.table.pockets[usize::from(pocket)].name)
            }
            _ => return,
        };
        self.contacts.push(contact);
    }
}

const fn bit(ball: u16) -> u64 {
    1 << (ball & 63)
}

/// How `object` got from the strike of `cue` into its pocket: the kind, and the balls on the way with the
/// number of cushions that each met. None if it is none of the kinds of a line.
fn way_of(contacts: &[Contact], cue: u16, object: u16) -> Option<(LineKind, Vec<(u16, u8)>)> {
    let mut legs = vec![(cue, 0_u8)];
    for contact in contacts {
        let (ball, cushions) = legs.last_mut()?;
        match *contact {
            Contact::Fall(fallen, _) if fallen == object => break,
            Contact::Balls(a, b) if a == *ball || b == *ball => {
                let other = if a == *ball { b } else { a };
                if *ball == object {
                    return None;
                }
                legs.push((other, 0));
            }
            Contact::Cluster(balls) if balls & (bit(*ball) | bit(object)) != 0 => return None,
            Contact::Cushion(other) if other == *ball => *cushions += 1,
            // The cue ball has met a cushion wherever it touched it.
            Contact::Jaw(other) if other == *ball && *ball == cue => *cushions += 1,
            // A ball that was passed on the way turns the object ball later, or comes back.
            Contact::Balls(a, b) if a == object || b == object => return None,
            _ => {}
        }
    }
    let kind = match legs.as_slice() {
        [(_, 0), (last, 0)] if *last == object => LineKind::Direct,
        [(_, 0), (last, _)] if *last == object => LineKind::Bank,
        [(_, _), (last, 0)] if *last == object => LineKind::Kick,
        [(_, 0), (_, 0), (last, 0)] if *last == object => LineKind::Combination,
        _ => return None,
    };
    Some((kind, legs))
}

impl Explorer<'_> {
    /// Gives a candidate the kind, the pot and the legs of what its strike does without errors. A break and a
    /// push-out stay what they are.
    ///
    /// # Errors
    /// As [`Explorer::ruled`].
    pub(crate) fn name(
        &mut self,
        candidate: &mut Candidate,
        prepared: &Prepared<'_>,
    ) -> Result<(), Error> {
        if matches!(candidate.kind, PlayKind::Break | PlayKind::PushOut) {
            return Ok(());
        }
        let table = prepared.shot().table();
        let mut recorder = ContactRecorder { table, contacts: Vec::new() };
        self.bench.plays += 1;
        let strike = &candidate.play.strike;
        if self.bench.sampler.simulate_recorded(prepared, strike, &mut recorder).is_err() {
            return Ok(());
        }
        let meant = match candidate.play.call {
            Call::Pocket(ball, pocket) => Some((ball, pocket)),
            _ => candidate.pot,
        };
        candidate.pot = None;
        candidate.legs.clear();
        (candidate.pattern, candidate.route) = (None, None);
        candidate.kind = PlayKind::Safety;
        let (_, is_legal) = self.ruled(prepared, candidate.play.call)?;
        if !is_legal || !self.keeps_turn() {
            return Ok(());
        }
        if self.task.frame().facts().is_carom() {
            candidate.kind = PlayKind::Carom;
            candidate.pattern = self.carom_pattern(prepared);
            let trace = self.task.frame().shot(&candidate.play)?.simulate()?;
            candidate.route = CaromRoute::new(&trace);
            return Ok(());
        }
        let falls =
            |pot: &(BallIndex, PocketName)| self.bench.sampler.outcome().pocketed.contains(pot);
        let Some(pot) = meant.filter(falls).or_else(|| self.potted()) else { return Ok(()) };
        candidate.pot = Some(pot);
        let in_shot = |ball| crate::aim::index_in_shot(prepared, ball);
        let way = in_shot(self.task.turn.cue)
            .zip(in_shot(pot.0))
            .and_then(|(cue, object)| way_of(&recorder.contacts, cue, object));
        let (kind, legs) = way
            .map_or((PlayKind::Indirect, Vec::new()), |(kind, legs)| (PlayKind::Pot(kind), legs));
        candidate.kind = kind;
        let in_frame = |(ball, cushions)| (prepared.balls()[usize::from(ball)], cushions);
        candidate.legs = legs.into_iter().map(in_frame).collect();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Contact, LineKind, way_of};
    use Contact::{Balls, Cluster, Cushion, Jaw};

    #[test]
    fn the_contacts_of_a_shot_tell_how_the_ball_got_into_the_pocket() {
        let kind = |contacts: &[Contact], object| way_of(contacts, 0, object).map(|way| way.0);
        assert_eq!(
            kind(&[Balls(0, 3), Cushion(0), Cluster(0b111), Jaw(3)], 3),
            Some(LineKind::Direct)
        );
        assert_eq!(kind(&[Balls(3, 0), Cushion(3)], 3), Some(LineKind::Bank));
        assert_eq!(kind(&[Cushion(0), Balls(0, 3)], 3), Some(LineKind::Kick));
        assert_eq!(kind(&[Jaw(0), Balls(0, 3)], 3), Some(LineKind::Kick));
        assert_eq!(kind(&[Balls(0, 5), Balls(5, 3)], 3), Some(LineKind::Combination));
        for other in [
            &[Cushion(0), Balls(0, 3), Cushion(3)][..],
            &[Balls(0, 5), Cushion(5), Balls(5, 3)],
            &[Balls(0, 5), Balls(0, 3)],
            &[Balls(0, 3), Balls(3, 5)],
            &[Balls(0, 3), Balls(0, 3)],
            &[Cluster(0b111)],
            &[Balls(0, 3), Cluster(0b111_1000)],
            &[Balls(0, 5), Balls(5, 6), Balls(6, 3)],
        ] {
            assert_eq!(kind(other, 3), None, "{other:?}");
        }
    }

    #[test]
    fn the_legs_count_the_cushions_of_every_ball_on_the_way() {
        let way = way_of(&[Cushion(0), Cushion(0), Balls(0, 3)], 0, 3);
        assert_eq!(way, Some((LineKind::Kick, vec![(0, 2), (3, 0)])));
    }
}
