//! What may be hit and pocketed in a stroke, and what it costs (WPBSA, section 3, rules 8, 10 and 12).

use super::{BLACK, CUE, On, Snooker, hidden, value};
use crate::BallIndex;
use crate::facts::Touch;
use crate::frame::State;
use crate::games::Played;
use crate::play::Call;
use crate::ruling::{Foul, Fouls};

/// The least penalty for a foul.
const LEAST_PENALTY: i32 = 4;

/// Balls nearer than this touch, m: the same that the shot file calls touching.
const TOUCHING: f64 = carom::table::TOUCH_TOLERANCE;

/// A stroke, against what was on.
pub(super) struct Stroke {
    /// Balls that may be pocketed.
    may_pot: Vec<BallIndex>,
    /// Points for the ball on.
    pub(super) value: i32,
    /// Balls that touched the cue ball before.
    touching: Vec<BallIndex>,
    /// Whether no ball on was hit first.
    pub(super) missed: bool,
    /// Whether a ball on could have been hit full in a straight line (rule 14d).
    pub(super) full_ball: bool,
}

impl Stroke {
    pub(super) fn of(game: &Snooker, shot: &Played<'_>) -> Self {
        let on = game.balls_on(shot.before);
        let nominated = match shot.play.call {
            Call::On(ball) => Some(ball),
            _ => None,
        };
        // Any red may be hit when one is nominated; a ball on is no free ball (rule 12a).
        let free = nominated.filter(|ball| game.free_ball && !on.contains(ball));
        let (may_hit, may_pot) = match (game.on, free, nominated) {
            (_, Some(free), _) => (vec![free], on.iter().copied().chain([free]).collect()),
            (On::Color, None, Some(color)) => (vec![color], vec![color]),
            _ => (on.clone(), on.clone()),
        };
        let value_on = match game.on {
            On::Red => 1,
            On::Color => nominated.map_or(value(BLACK), value),
            On::Sequence => on.first().map_or(0, |ball| value(*ball)),
        };
        let touching = shot.before.touching(CUE, TOUCHING);
        let played_away = touching.iter().any(|ball| may_hit.contains(ball));
        let hit = shot.facts.first_contact().is_some_and(|first| may_hit.contains(&first));
        let could_be_on = if free.is_some() { &may_hit } else { &on };
        let full_ball = hidden::is_full_ball_open(shot.before, could_be_on);
        let missed = !hit && !played_away;
        Self { may_pot, value: value_on, touching, missed, full_ball }
    }

    /// The fouls, and what the dearest of them costs.
    pub(super) fn fouls(&self, game: &Snooker, state: &State, shot: &Played<'_>) -> (Fouls, i32) {
        let facts = shot.facts;
        let (mut fouls, mut penalty) = (Fouls::NONE, LEAST_PENALTY.max(self.value));
        let mut foul = |committed: bool, foul, concerned: i32| {
            fouls.add_if(committed, foul);
            if committed {
                penalty = penalty.max(concerned);
            }
        };
        foul(facts.is_scratch(), Foul::Scratch, 0);
        foul(facts.off_table.contains(&CUE), Foul::CueBallOffTable, 0);
        match facts.first_contact() {
            // Who plays away from a touching ball that is on has hit it (rule 8c).
            None => foul(self.missed, Foul::NoContact, 0),
            Some(first) => {
                let at_once = facts.touched.first() == Some(&Touch::Ball(first));
                foul(at_once && self.touching.contains(&first), Foul::Push, value(first));
                foul(self.missed, Foul::WrongBallFirst, value(first));
            }
        }
        for ball in facts.potted() {
            foul(!self.may_pot.contains(&ball), Foul::WrongBallPocketed, value(ball));
        }
        for ball in facts.thrown_off() {
            foul(true, Foul::BallOffTable, value(ball));
        }
        foul(facts.jumped_first, Foul::Jump, 0);
        let behind = game.free_ball && Self::is_behind_free_ball(game, state, shot);
        foul(behind, Foul::SnookeredByFreeBall, 0);
        (fouls, penalty)
    }

    /// Whether the shot leaves the next player snookered by the free ball, which only pink and black may
    /// (rule 12b).
    fn is_behind_free_ball(game: &Snooker, state: &State, shot: &Played<'_>) -> bool {
        let Call::On(free) = shot.play.call else { return false };
        let on = game.balls_on(&state.layout);
        let few = state.layout.on_table().filter(|ball| *ball != CUE).count() <= 2;
        let goes_on = shot.facts.potted().next().is_some();
        if few || goes_on || on.contains(&free) || state.layout.is_down(CUE) {
            return false;
        }
        hidden::is_snookered_by(&state.layout, free, &on)
    }
}
