//! A ball during the impact.

use super::Units;
use crate::math::Vec3;
use crate::resolve::{Body, SPIN_PER_IMPULSE};

/// A ball during the impact.
#[derive(Clone, Copy, Default)]
#[repr(align(128))]
pub(super) struct Ball {
    /// Impulse.
    pub(super) push: Vec3,
    /// Σ n × (impulse on the second ball of the contact). It turns both balls in the same sense.
    pub(super) turn: Vec3,
    /// Velocity.
    pub(super) velocity: Vec3,
    /// Surface velocity Rω.
    pub(super) surface: Vec3,
    /// Velocity and surface velocity before the impact.
    pub(super) first_velocity: Vec3,
    pub(super) first_surface: Vec3,
    /// Displacement at the last impulse, and the time of that impulse.
    shift: Vec3,
    since: f64,
    /// 1/mass.
    pub(super) mobility: f64,
    /// Set of its contacts, one bit each.
    pub(super) links: u64,
}

impl Ball {
    pub(super) fn begin(&mut self, body: &Body, units: &Units) {
        let per_speed = 1.0 / units.speed;
        self.velocity = body.velocity * per_speed;
        self.surface = body.angular_velocity * (body.radius * per_speed);
        self.first_velocity = self.velocity;
        self.first_surface = self.surface;
        self.mobility = units.mass / body.mass;
    }

    /// Computes the velocities after an impulse at the time `now`. Returns the set of contacts that
    /// this changes.
    #[inline(always)]
    pub(super) fn update(&mut self, now: f64) -> u64 {
        self.shift = self.shift_at(now);
        self.since = now;
        self.accelerate();
        self.links
    }

    /// Computes the velocities after an impulse.
    #[inline(always)]
    pub(super) fn accelerate(&mut self) {
        self.velocity = self.first_velocity + self.push * self.mobility;
        self.surface = self.first_surface + self.turn * (-SPIN_PER_IMPULSE * self.mobility);
    }

    /// The displacement at the time `now`.
    #[inline(always)]
    pub(super) fn shift_at(&self, now: f64) -> Vec3 {
        self.shift + self.velocity * (now - self.since)
    }

    /// What its impulse takes of the energy, in the first and in the second order, where velocities
    /// are relative to `frame`.
    pub(super) fn work_and_cost(&self, frame: Vec3) -> (f64, f64) {
        let velocity = self.first_velocity - frame;
        let work = self.first_surface.dot(self.turn) - velocity.dot(self.push);
        let change = self.push.length_squared();
        let surface = SPIN_PER_IMPULSE * self.turn.length_squared();
        (work, 0.5 * self.mobility * (change + surface))
    }

    /// Gives the body the impulse, scaled by `share`. Without an impulse it keeps its bits.
    pub(super) fn apply(&self, share: f64, units: &Units, body: &mut Body) {
        if self.push != Vec3::ZERO || self.turn != Vec3::ZERO {
            let scale = share * units.speed * self.mobility;
            body.velocity += self.push * scale;
            body.angular_velocity -= self.turn * (SPIN_PER_IMPULSE * scale / body.radius);
        }
    }
}
