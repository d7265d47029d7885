//! Balls that jam: caught off the bed between edges that are too close for them.
//!
//! The facings of a pocket converge, so a ball that is too large for its pocket does not fall: two
//! facings carry it, or two facings and the lip. Its bounces between them shrink without end, or
//! the rule for persistent contacts keeps them at its least speed ([`super::persistent_contact`]).
//! Such a ball is at rest, though not on the bed. It is then off the table, like a ball that comes
//! to rest on the top of a rail: the rules of pool and snooker count every ball so that rests
//! neither on the bed nor in a pocket.

use crate::math::Vec3;

/// A ball that meets this many things, one after the other, and hardly moves meanwhile is jammed.
/// Fewer, and a ball that turns slowly between a lip and a facing would be stopped; more, and a jam
/// would cost more events.
const JAM_CONTACTS: u32 = 2000;

/// Within this distance a jammed ball stays during [`JAM_CONTACTS`] contacts, m, in addition to its
/// way at [`JAM_SPEED`]: a thousandth of a millimetre.
const LEAST_WAY: f64 = 1e-6;

/// A ball that moves along its edges more slowly than this, m/s, is jammed: one centimetre per
/// second. During [`JAM_CONTACTS`] contacts, two tenths of a second or more, gravity would give it a
/// larger speed, unless the edges are level to a hundredth, where the rolling resistance of a real
/// ball holds it.
const JAM_SPEED: f64 = 1e-2;

/// A ball that has met this many things off the bed is jammed in any case. It rolls slowly between
/// two parallel facings that are hardly narrower than it is, and meets them every 0.06 ms. This
/// number bounds the events of a shot.
const MOST_CONTACTS: u32 = 30_000;

/// A ball that moves by less than this, m, between two contacts with the same thing stands still
/// there: the size of ten atoms. A ball that turns about a lip moves farther in each hop.
const STANDSTILL: f64 = 1e-9;

/// The first contacts off the bed in a shot are only counted: a ball that falls has some dozens.
const FIRST_CONTACTS: u32 = 100;

/// What a ball off the bed touches: a ball that lies on other balls does not jam, it moves them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Touched {
    /// The lip of a pocket's hole.
    Lip(u8),
    /// A part of a cushion.
    Cushion(u16),
}

/// The contacts of a ball off the bed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jam {
    /// The ball's centre, m, at the first of its recent contacts, and their number.
    place: Vec3,
    recent: u32,
    /// The time of that contact, s, and the largest squared distance from there since, m².
    since: f64,
    farthest: f64,
    /// What the ball touched last, and its centre then, m.
    last: Touched,
    before: Vec3,
    /// All contacts in the shot. After the first ones, a contact with the same thing as before counts
    /// only if the ball has not moved in between.
    all: u32,
}

impl Jam {
    /// No contact yet.
    pub(super) const NONE: Self = Self {
        place: Vec3::ZERO,
        recent: 0,
        since: 0.0,
        farthest: 0.0,
        last: Touched::Lip(0),
        before: Vec3::ZERO,
        all: 0,
    };

    /// Forgets all contacts: a shot begins.
    #[inline(always)]
    pub(super) fn forget(&mut self) {
        self.all = 0;
    }

    /// Counts a contact, up to [`FIRST_CONTACTS`], and returns whether there were fewer.
    #[inline(always)]
    pub(super) fn count_early(&mut self) -> bool {
        self.all += u32::from(self.all < FIRST_CONTACTS);
        self.all < FIRST_CONTACTS
    }

    /// Counts a later contact of a ball off the bed with its centre at `position` (m) at `time` (s).
    /// Returns whether the ball is jammed.
    pub(super) fn touch(&mut self, touched: Touched, position: Vec3, time: f64) -> bool {
        if self.all == FIRST_CONTACTS {
            *self = Self { all: FIRST_CONTACTS + 1, ..Self::NONE };
        }
        let stands = (position - self.before).length_squared() < STANDSTILL * STANDSTILL;
        let counts = u32::from(stands || touched != self.last);
        (self.last, self.before) = (touched, position);
        if self.recent == 0 {
            (self.place, self.since, self.farthest) = (position, time, 0.0);
        }
        self.farthest = self.farthest.max((position - self.place).length_squared());
        self.recent += counts;
        self.all += counts;
        if self.recent < JAM_CONTACTS {
            return false;
        }
        self.recent = 0;
        let way = LEAST_WAY + JAM_SPEED * (time - self.since);
        self.farthest < way * way || self.all >= MOST_CONTACTS
    }
}

#[cfg(test)]
mod tests {
    use super::{JAM_CONTACTS, JAM_SPEED, Jam, MOST_CONTACTS, Touched};
    use crate::math::Vec3;

    /// Whether a ball jams that moves at `speed` (m/s) and touches one of the `things` after the
    /// other, each 0.2 ms after the last, `contacts` times.
    fn jams_within(contacts: u32, speed: f64, things: &[Touched]) -> bool {
        let mut jam = Jam::NONE;
        (0..contacts).any(|k| {
            let time = 2e-4 * f64::from(k);
            !jam.count_early()
                && jam.touch(
                    things[k as usize % things.len()],
                    Vec3::new(speed * time, 0.0, 0.03),
                    time,
                )
        })
    }

    fn jams(speed: f64, things: &[Touched]) -> bool {
        jams_within(2 * JAM_CONTACTS, speed, things)
    }

    #[test]
    fn a_ball_that_stays_between_two_edges_is_jammed() {
        for speed in [0.0, 0.9 * JAM_SPEED] {
            assert!(jams(speed, &[Touched::Cushion(3), Touched::Cushion(4)]));
            assert!(jams(speed, &[Touched::Lip(2), Touched::Cushion(4)]));
        }
    }

    #[test]
    fn a_ball_that_stands_still_on_one_edge_is_jammed() {
        assert!(jams(0.0, &[Touched::Lip(2)]));
    }

    #[test]
    fn a_ball_that_moves_along_two_edges_or_turns_about_one_is_not_jammed() {
        assert!(!jams(1.2 * JAM_SPEED, &[Touched::Cushion(3), Touched::Cushion(4)]));
        assert!(!jams(1e-3, &[Touched::Lip(2)]));
    }

    #[test]
    fn a_ball_that_meets_two_edges_without_end_is_jammed() {
        let edges = [Touched::Cushion(3), Touched::Cushion(4)];
        assert!(jams_within(MOST_CONTACTS + JAM_CONTACTS, 1.0, &edges));
        assert!(!jams_within(MOST_CONTACTS - 1, 1.0, &edges));
    }

    #[test]
    fn a_ball_that_climbs_and_turns_back_is_not_jammed() {
        let mut jam = Jam::NONE;
        for k in 0..2 * JAM_CONTACTS {
            let time = 2e-4 * (f64::from(k) - f64::from(JAM_CONTACTS));
            let place = Vec3::new(0.5 * time * time, 0.0, 0.03);
            let jams = !jam.count_early() && jam.touch(Touched::Cushion(k as u16 % 2), place, time);
            assert!(!jams, "at {time}");
        }
    }
}
