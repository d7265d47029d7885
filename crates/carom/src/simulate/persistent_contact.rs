//! Persistent contact with a minimum separation speed: the rule for balls under a push.
//!
//! Friction of the cloth can press a ball against another ball, or against a cushion, that it
//! already touches. The cloth brakes each rebound, so the bounces would become ever shorter and
//! more frequent without end (Zeno's paradox). This module ends the sequence: bodies in such a
//! contact separate with at least a minimum speed, as if they had met that fast.
//!
//! ```text
//! after      = the impact by its model
//! approach   = approach speed before,  separation = separation speed in `after`
//! pushed     = the time for which both bodies have been pushed, on the bed
//! persistent = both bodies had another contact within PUSH_PERIOD, or pushed > LONG_PUSH
//! least      = MIN_SEPARATION, which grows in a long push
//! if separation > ε and (separation ≥ least or approach ≥ least or not persistent):
//!     return after                                   # an ordinary impact
//! if approach ≥ least:
//!     return after, its separation raised to 2ε      # restitution 0, or wedged by slate and nose
//! for v_min in [least, MIN_SEPARATION, MIN_SEPARATION_WITH_GAIN]:
//!     v = max(2ε, min(v_min, SEPARATION_SHARE · speeds of centres and surfaces) if persistent else 0)
//!     if separation ≥ v: return after
//!     pressed = the impact by its model, with the approach speed raised to v
//!     if energy(pressed) ≤ energy(before), possibly after the spins supply the excess:
//!         return pressed
//! return pressed                                     # gains at most ½m·MIN_SEPARATION_WITH_GAIN²
//! ```
//!
//! ε is the rounding error of a separation speed. At such low speeds restitution is 1
//! ([`restitution`](crate::resolve::restitution)), so that the bodies separate about as fast as
//! they meet. A ball that lies on another is pressed by gravity instead of cloth: there is no limit
//! by `SEPARATION_SHARE` for it, and no limit on its energy.

use super::earlier;
use super::support::on_plane;
use crate::math::{Vec3, sqrt};
use crate::{Ball, BallState, MotionState};

/// A contact is persistent if both bodies have had another contact within this time, s. Purpose: to
/// tell a push from a single gentle touch. Contacts under a push recur after 1 ms or less.
pub(super) const PUSH_PERIOD: f64 = 1e-3;

/// The minimum separation speed in a persistent contact, m/s. The contact then recurs after 2v/a, 1
/// ms under a sliding ball. Larger, and the bounces would become visible (now 0.25 µm under a
/// sliding ball, 10 µm under the weakest push of rolling balls); smaller, and there are more
/// events.
pub(super) const MIN_SEPARATION: f64 = 1e-3;

/// A push that lasts longer than this, s, has longer hops: 30 or more contacts have followed each
/// other. Shorter, and the pushes of played shots would be coarser.
const LONG_PUSH: f64 = 0.03;

/// The growth of the minimum separation speed in a long push, m/s². A hop under a sliding ball then
/// lasts a hundredth of the time of the push, so the number of hops grows with its logarithm only.
/// Twice this growth makes two thirds of the events, and twice the error of a row of three.
const SEPARATION_GROWTH: f64 = 1e-2;

/// In a long push the minimum separation speed is at most this share of the speeds of the bodies'
/// surfaces. So the energy of a hop is at most a ten-thousandth of that of the spin.
const LONG_PUSH_SHARE: f64 = 1e-2;

/// Contacts that follow each other within this time, s, belong to one push: four hops under a
/// sliding ball.
const PUSH_GAP: f64 = 4e-3;

/// In a long push the same holds within this share of its time after [`LONG_PUSH`]: twelve hops.
const LONG_PUSH_GAP: f64 = 0.125;

/// A ball's contacts with other balls and cushions that follow each other without a pause.
#[derive(Clone, Copy, Debug)]
pub(super) struct Push {
    /// Time of the first contact, s.
    since: f64,
    /// Time of the last one, s.
    last: f64,
    /// A contact at or before this time, s, continues the push.
    until: f64,
}

impl Push {
    /// No contact.
    pub(super) const NONE: Self =
        Self { since: 0.0, last: f64::NEG_INFINITY, until: f64::NEG_INFINITY };

    /// Counts a contact at `time`.
    #[inline(always)]
    pub(super) fn touch(&mut self, time: f64) {
        let until = time + PUSH_GAP;
        if time > self.until {
            *self = Self { since: time, last: time, until };
        } else {
            let longest = time + LONG_PUSH_GAP * (time - self.since - LONG_PUSH);
            self.last = time;
            self.until = if longest > until { longest } else { until };
        }
    }

    /// How long the ball has been pushed, s, if it has a contact at `time`.
    #[inline(always)]
    pub(super) fn lasted(&self, time: f64) -> f64 {
        if time > self.until { 0.0 } else { time - self.since }
    }

    /// Whether the last contact was within [`PUSH_PERIOD`].
    #[inline(always)]
    pub(super) fn is_recent(&self, time: f64) -> bool {
        time - self.last < PUSH_PERIOD
    }
}

/// After this time, s, balls in a push may count as smooth: see [`SLIPPERY`].
pub(super) const SLIPPERY_PUSH: f64 = 5e-3;

/// Below this coefficient of friction two balls in such a push count as smooth: their friction does
/// not make up for the energy of a hop. The measured friction falls to it at a slip of some m/s.
pub(super) const SLIPPERY: f64 = 1e-3;

/// The raised approach speed adds energy, which the friction of the same contact takes away again.
/// Where the contact has no friction, the spins that slip on the cloth and so cause the push supply
/// this energy, up to this share of their own. A sliding pool ball supplies about 1e-6, and the
/// cloth takes thousands of times more between two contacts. (With friction the spins may not
/// supply it: a ball's angular momentum about the contact is conserved.)
const SPIN_SHARE: f64 = 1e-3;

/// The minimum separation speed, m/s, where neither friction nor spins make up for the energy. The
/// gain is then at most ½mv², 1e-9 J for a pool ball.
const MIN_SEPARATION_WITH_GAIN: f64 = 1e-4;

/// The minimum separation speed is at most this share of the speeds of the bodies' centres and
/// surfaces. Purpose: bodies that hardly move gain hardly any speed.
const SEPARATION_SHARE: f64 = 0.1;

/// A separation speed below this fraction of the bodies' speeds is rounding error. Without this
/// limit the next contact would compute the same two velocities again, for ever.
const SEPARATION_ROUNDING: f64 = 16.0 * f64::EPSILON;

/// `state` after an impact, with other velocities.
fn with_velocities(state: &BallState, velocity: Vec3, spin: Vec3, radius: f64) -> BallState {
    if state.motion == MotionState::Airborne {
        return BallState { velocity, angular_velocity: spin, ..*state };
    }
    // The plane stops the vertical velocity, as it does after a ball's last hop.
    on_plane(state.position, velocity.xy().with_z(0.0), spin, radius)
}

/// Bodies that meet along `normal`: a ball and a wall (`K` = 1) or two balls (`K` = 2).
pub(super) struct Encounter<'a, const K: usize> {
    pub(super) before: &'a [BallState; K],
    pub(super) balls: &'a [Ball; K],
    pub(super) normal: Vec3,
    /// The direction in which the bodies can be pushed: horizontal for bodies on the slate.
    pub(super) push: Vec3,
    /// Whether both bodies had another contact within [`PUSH_PERIOD`].
    pub(super) recent: bool,
    /// How long both have been pushed on the bed, s.
    pub(super) pushed_for: f64,
    /// Whether no friction acts between the bodies at low speed.
    pub(super) smooth: bool,
}

impl<const K: usize> Encounter<'_, K> {
    /// The states after the impact by the rule of this module. `after` holds those by the impact's
    /// model; `raised` computes them for an approach speed raised by the given number of m/s.
    #[inline(always)]
    pub(super) fn settle(
        &self,
        after: [BallState; K],
        raised: impl Fn(f64) -> [BallState; K],
    ) -> [BallState; K] {
        let approach = -self.separation(self.before);
        let separation = self.separation(&after);
        let rounding = SEPARATION_ROUNDING * self.speeds(&after);
        let least = self.least_separation();
        if separation > rounding
            && (separation >= least || !self.is_persistent() || approach >= least)
        {
            return after;
        }
        if approach >= least {
            return self.separated(&after, 2.0 * rounding - separation);
        }
        self.pressed(after, separation, least, rounding, raised)
    }

    #[inline(always)]
    fn is_persistent(&self) -> bool {
        self.recent || self.pushed_for > LONG_PUSH
    }

    /// The minimum separation speed of a persistent contact, m/s.
    #[inline(always)]
    fn least_separation(&self) -> f64 {
        if self.pushed_for <= LONG_PUSH { MIN_SEPARATION } else { self.least_of_long_push() }
    }

    #[cold]
    fn least_of_long_push(&self) -> f64 {
        let grown = MIN_SEPARATION + SEPARATION_GROWTH * (self.pushed_for - LONG_PUSH);
        let share = LONG_PUSH_SHARE * self.surface_speeds();
        earlier(grown, share).max(MIN_SEPARATION)
    }

    /// The states after an impact with the minimum separation speed `least`. `separation` is the
    /// separation speed in `after`, and `rounding` its rounding error, m/s.
    #[cold]
    fn pressed(
        &self,
        after: [BallState; K],
        separation: f64,
        least: f64,
        rounding: f64,
        raised: impl Fn(f64) -> [BallState; K],
    ) -> [BallState; K] {
        let approach = -self.separation(self.before);
        // Gravity presses a ball on another even if both rest, until the upper ball falls off.
        let lies_on_ball = K == 2 && self.before.iter().any(|s| s.motion == MotionState::Airborne);
        let share = if lies_on_ball {
            f64::INFINITY
        } else {
            SEPARATION_SHARE * (self.speeds(self.before) + self.surface_speeds())
        };
        let mut result = after;
        for least in [least, MIN_SEPARATION, MIN_SEPARATION_WITH_GAIN] {
            let least = if self.is_persistent() { earlier(least, share) } else { 0.0 };
            let speed = if least > 2.0 * rounding { least } else { 2.0 * rounding };
            if separation >= speed {
                return after;
            }
            // The longer hop had too much energy, and the model's is not the shortest.
            if approach >= MIN_SEPARATION && approach >= speed {
                return if separation > rounding {
                    after
                } else {
                    self.separated(&after, 2.0 * rounding - separation)
                };
            }
            result = raised(speed - approach);
            if self.balance_energy(&mut result) || lies_on_ball {
                break;
            }
        }
        result
    }

    /// Whether `states` have no more energy than the bodies had before the impact. Where the rule
    /// allows it, spins about horizontal axes are first reduced by the excess.
    fn balance_energy(&self, states: &mut [BallState; K]) -> bool {
        let excess = self.energy(states) - self.energy(self.before);
        if excess <= 0.0 {
            return true;
        }
        let of = |(s, b): (&BallState, &Ball)| {
            let rolling = BallState {
                angular_velocity: s.angular_velocity.xy().with_z(0.0),
                ..BallState::default()
            };
            b.kinetic_energy(&rolling)
        };
        let spin_energy =
            states.iter().zip(self.balls).map(of).fold(0.0, |sum, energy| sum + energy);
        if !self.smooth || excess > SPIN_SHARE * spin_energy {
            return false;
        }
        let kept = sqrt(1.0 - excess / spin_energy);
        for (state, ball) in states.iter_mut().zip(self.balls) {
            let spin = state.angular_velocity;
            let spin = (spin.xy() * kept).with_z(spin.z);
            *state = with_velocities(state, state.velocity, spin, ball.radius);
        }
        true
    }

    /// `states` with a separation faster by `speed`, m/s. For bodies that an impact has left
    /// together, because its restitution is 0 or because slate and nose wedge the ball. Their
    /// separation speed is 0 up to rounding, and friction has already acted.
    #[cold]
    fn separated(&self, states: &[BallState; K], speed: f64) -> [BallState; K] {
        let mobility = self.balls.iter().fold(0.0, |sum, ball| sum + 1.0 / ball.mass);
        let along = self.push * (speed / mobility);
        let mut side = -1.0;
        let mut result = *states;
        for (state, ball) in result.iter_mut().zip(self.balls) {
            let velocity = state.velocity + along * (side / ball.mass);
            *state = with_velocities(state, velocity, state.angular_velocity, ball.radius);
            side = -side;
        }
        result
    }

    /// Speed at which the bodies separate, m/s. A wall does not move.
    fn separation(&self, states: &[BallState; K]) -> f64 {
        let along = states.iter().map(|s| s.velocity.dot(self.normal));
        along.zip([-1.0, 1.0]).fold(0.0, |sum, (speed, side)| sum + side * speed)
    }

    fn speeds(&self, states: &[BallState; K]) -> f64 {
        states.iter().fold(0.0, |sum, s| sum + s.velocity.length())
    }

    fn surface_speeds(&self) -> f64 {
        let of = |(s, b): (&BallState, &Ball)| b.radius * s.angular_velocity.length();
        self.before.iter().zip(self.balls).map(of).fold(0.0, |sum, speed| sum + speed)
    }

    fn energy(&self, states: &[BallState; K]) -> f64 {
        let of = |(s, b): (&BallState, &Ball)| b.kinetic_energy(s);
        states.iter().zip(self.balls).map(of).fold(0.0, |sum, energy| sum + energy)
    }
}
