//! The fouls of a stroke and their penalties (WPBSA, section 3, rules 8, 10 and 12).

use carom::outcome::Touched;

use super::balls::{BLACK_VALUE, Balls, CUE, On};
use super::hidden;
use crate::games::game::PlayedShot;
use crate::layout::{BallList, FROZEN};
use crate::play::Call;
use crate::referee::NearHit;
use crate::ruling::{Foul, Fouls};
use crate::state::FrameState;

/// The smallest penalty, in points.
const LEAST_PENALTY: i32 = 4;

/// The nominated balls that must not be left in the way of the next player.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum KeptClear {
    /// The free ball (rule 12b).
    FreeBall,
    /// The free ball and a nominated colour.
    AnyNominated,
}

/// A stroke, compared with what was on.
pub(super) struct Stroke {
    /// The kind of ball that was on.
    on: On,
    /// Whether the player had a free ball.
    has_free_ball: bool,
    /// Balls that may be pocketed.
    may_pot: BallList,
    /// Points for the ball on.
    pub(super) value: i32,
    /// Balls that touched the cue ball before the stroke.
    touching: BallList,
    /// Whether the first ball hit was not on.
    pub(super) missed: bool,
    /// Whether a ball on could have been hit full in a straight line (rule 14d).
    pub(super) full_ball: bool,
}

impl Stroke {
    /// The stroke `shot`, played when `kind` was on.
    pub(super) fn of(kind: On, has_free_ball: bool, shot: &PlayedShot<'_>) -> Self {
        let on = kind.balls(shot.before);
        let value = |ball| Balls::of(shot.before).value(ball);
        let one = |ball| BallList::from(&[ball][..]);
        let nominated = match shot.call {
            Call::On(ball) => Some(ball),
            _ => None,
        };
        // A nominated red stands for any red; a ball that is on cannot be a free ball (rule 12a).
        let free = nominated.filter(|ball| has_free_ball && !on.contains(ball));
        let (may_hit, may_pot) = match (kind, free, nominated) {
            (_, Some(free), _) => (one(free), on.iter().copied().chain([free]).collect()),
            (On::Color, None, Some(color)) => (one(color), one(color)),
            _ => (on, on),
        };
        let value_on = match kind {
            On::Red => 1,
            On::Color => nominated.map_or(BLACK_VALUE, value),
            On::Sequence => on.first().map_or(0, |ball| value(*ball)),
        };
        let touching = shot.before.touching(CUE, FROZEN);
        let played_away = touching.iter().any(|ball| may_hit.contains(ball));
        let hit = shot.first_contact().is_some_and(|first| may_hit.contains(&first));
        let could_be_on = if free.is_some() { &may_hit } else { &on };
        let full_ball = hidden::is_full_ball_open(shot.before, could_be_on);
        let missed = !hit && !played_away;
        Self { on: kind, has_free_ball, may_pot, value: value_on, touching, missed, full_ball }
    }

    /// The fouls, and the largest of their penalties.
    pub(super) fn fouls(
        &self,
        state: &FrameState,
        shot: &PlayedShot<'_>,
        kept_clear: KeptClear,
    ) -> (Fouls, i32) {
        let value = |ball| Balls::of(shot.before).value(ball);
        let (mut fouls, mut penalty) = (Fouls::NONE, LEAST_PENALTY.max(self.value));
        let mut foul = |committed: bool, foul, concerned: i32| {
            fouls.add_if(committed, foul);
            if committed {
                penalty = penalty.max(concerned);
            }
        };
        foul(shot.is_scratch(), Foul::Scratch, 0);
        foul(shot.is_cue_ball_off_table(), Foul::CueBallOffTable, 0);
        foul(shot.is_double_hit(NearHit::Full), Foul::DoubleHit, 0);
        match shot.first_contact() {
            // Playing away from a touching ball that is on counts as hitting it (rule 8c).
            None => foul(self.missed, Foul::NoContact, 0),
            Some(first) => {
                let touched = shot.outcome.cue_ball_touched.first();
                let at_once = touched == Some(&Touched::Ball(first));
                foul(at_once && self.touching.contains(&first), Foul::Push, value(first));
                let concerned =
                    shot.outcome.met_during_strike.iter().map(|ball| value(*ball)).max();
                foul(
                    shot.is_push_shot(NearHit::Full),
                    Foul::PushShot,
                    concerned.unwrap_or_default(),
                );
                foul(self.missed, Foul::WrongBallFirst, value(first));
            }
        }
        for ball in shot.potted() {
            foul(!self.may_pot.contains(&ball), Foul::WrongBallPocketed, value(ball));
        }
        for ball in shot.thrown_off() {
            foul(true, Foul::BallOffTable, value(ball));
        }
        foul(shot.travel.jumped_before_contact, Foul::Jump, 0);
        let applies = self.has_free_ball || kept_clear == KeptClear::AnyNominated;
        let behind = applies && is_behind_nominated(self.on, state, shot);
        foul(behind, Foul::SnookeredByFreeBall, 0);
        (fouls, penalty)
    }
}

/// Whether the shot leaves the next player snookered by the nominated ball. This is allowed when only
/// pink and black remain (rule 12b).
fn is_behind_nominated(on: On, state: &FrameState, shot: &PlayedShot<'_>) -> bool {
    let Call::On(nominated) = shot.call else { return false };
    let on = on.after_a_miss(&state.layout).balls(&state.layout);
    let few = state.layout.on_table().filter(|ball| *ball != CUE).count() <= 2;
    let goes_on = shot.potted().next().is_some();
    if few || goes_on || on.contains(&nominated) || state.layout.is_down(CUE) {
        return false;
    }
    hidden::is_snookered_by(&state.layout, nominated, &on)
}
