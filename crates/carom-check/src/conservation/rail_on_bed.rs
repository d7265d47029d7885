//! Checks of a rail's impulse on a ball on the bed.
//!
//! First without any law. The nose pushes with N along its normal and rubs across it with **T**; the
//! slate carries the ball with S and rubs with **F**. The change of spin gives T along the rail and
//! the sum of the rest; without friction of the slate it gives N, **T** and S. Then N ≥ 0,
//! |**T**| ≤ μN and S ≥ 0. Second, the motion after the impact is compared with that of the law,
//! which [`crate::rail_laws`] computes.

use carom::event::Event;
use carom::math::Vec3;
use carom::physics::{Cushion, CushionFriction, CushionModel, CushionRestitution};
use carom::shot::Shot;
use carom::{Ball, MotionState, Physics};

use super::{Circumstances, ROUNDING, SPIN_SHARE, STILL, last_hop_speed};
use crate::rail_laws::{REFLECTS, RailImpact, Rebound};
use crate::solid::Solid;
use crate::table::EdgeKind;
use crate::table_contact;

/// Checks a contact of a ball that lies on the bed with `part` of the table.
pub(super) fn audit(
    scene: &Circumstances<'_>,
    event: &Event<'_>,
    ball: &Ball,
    part: usize,
) -> Option<String> {
    let Circumstances { shot, solid, hop, .. } = *scene;
    let contact = BedContact::new(shot, solid, event, ball, part)?;
    let wrong = if hop > 0.0 && contact.impact.velocity.x <= hop {
        contact.check_hop(hop)
    } else if contact.impact.velocity.x <= REFLECTS {
        contact.check_slow()
    } else {
        contact.check_impulses().or_else(|| contact.check_law())
    };
    wrong.map(|what| format!("the rail gives ball {} {what}", event.balls[0]))
}

/// The law of a part of a rail: the cushion's, with the surface of the part.
pub(super) fn law_of(physics: &Physics, kind: EdgeKind) -> Cushion {
    let surface = match kind {
        EdgeKind::Nose => return physics.cushion,
        EdgeKind::Point | EdgeKind::Facing => physics.facing,
        EdgeKind::Liner => physics.liner,
        EdgeKind::Top => physics.slate,
    };
    Cushion {
        restitution: CushionRestitution::constant(surface.restitution),
        friction: CushionFriction { a: surface.friction, b: 0.0 },
        ..physics.cushion
    }
}

struct BedContact<'a> {
    shot: &'a Shot,
    kind: EdgeKind,
    impact: RailImpact,
    /// The result, in the frame of the impact.
    after: Rebound,
    flies: bool,
    /// Rounding error of the velocities, m/s.
    rounding: f64,
}

impl<'a> BedContact<'a> {
    fn new(
        shot: &'a Shot,
        solid: &Solid,
        event: &Event<'_>,
        ball: &Ball,
        part: usize,
    ) -> Option<Self> {
        let (before, after) = (event.before[0], event.after[0]);
        let kind = solid.plan.parts.get(part)?.1;
        let touched = table_contact::rail(solid, part, before.position, ball.radius)?;
        let away = touched.away.xy();
        let into = away * (-1.0 / away.length());
        let turned = |v: Vec3| Vec3::new(v.xy().dot(into), v.xy().dot(into.perp()), v.z);
        let surface = |w: Vec3| turned(w) * ball.radius;
        let impact = RailImpact {
            sin: -touched.away.z,
            cos: away.length(),
            velocity: turned(before.velocity),
            surface: surface(before.angular_velocity),
        };
        let (velocity, spin) = (turned(after.velocity), surface(after.angular_velocity));
        let speeds = impact.velocity.length() + impact.surface.length() + spin.length();
        Some(Self {
            shot,
            kind,
            impact,
            after: Rebound { velocity, surface: spin, accuracy: 0.0 },
            flies: after.motion == MotionState::Airborne,
            rounding: 8.0 * ROUNDING * speeds + 4.0 * STILL,
        })
    }

    /// The law of the part that is touched.
    fn law(&self) -> Cushion {
        law_of(self.shot.physics(), self.kind)
    }

    /// Checks the impulses of nose and slate that the changes imply, per unit mass.
    fn check_impulses(&self) -> Option<String> {
        let law = self.law();
        let RailImpact { sin, cos, velocity, surface } = self.impact;
        let push = self.after.velocity - velocity;
        let turn = (self.after.surface - surface) * 0.4;
        let rounding = self.rounding / cos;
        // Rotation about the vertical comes from T along the rail alone; F along the rail is left.
        let along = turn.z / cos;
        let ground = [turn.x + sin * along, push.y - along];
        let differ = (ground[0] - ground[1]).abs();
        let is_level = matches!(law.model, CushionModel::Restitution | CushionModel::Factors);
        if is_level {
            // The changes by these laws are not those of an impulse at one point.
            return None;
        }
        if differ > rounding {
            return Some(format!("a spin that its impulse does not explain, by {differ:e} m/s"));
        }
        let (_, mu) = self.impact.coefficients(&law);
        if law.model == CushionModel::Mathavan2010 {
            return None;
        }
        if ground[1].abs() > rounding {
            let rub = ground[1];
            return Some(format!("an impulse of the slate of {rub:e} m/s along the rail"));
        }
        let down = turn.y;
        let normal = (down * sin - push.x) / cos;
        let across = carom::math::sqrt(down * down + along * along);
        if normal < -rounding {
            return Some(format!("a pull of {:e} m/s", -normal));
        }
        if across > mu * normal + rounding {
            return Some(format!("friction of {across:e} m/s on {normal:e} m/s, μ = {mu}"));
        }
        let hop = if self.flies { 0.0 } else { last_hop_speed(self.shot) };
        let slate = push.z + normal * sin + down * cos;
        (slate < -hop - rounding).then(|| format!("a pull of the slate of {:e} m/s", -slate))
    }

    /// Compares the motion with that of the law.
    fn check_law(&self) -> Option<String> {
        let law = self.law();
        let expected = self.impact.rebound(&law, &self.shot.physics().cloth);
        let mut off = self.after.velocity - expected.velocity;
        // A small hop is left out.
        let rise = expected.velocity.z;
        if !self.flies && rise < last_hop_speed(self.shot) + expected.accuracy {
            off.z = self.after.velocity.z;
        }
        let turned = (self.after.surface - expected.surface).length();
        // A tangential impulse turns the surface 5/2 times as fast as it moves the centre.
        let most = 2.5 * expected.accuracy + self.rounding / self.impact.cos;
        let moved = off.length();
        (moved > most || turned > most).then(|| {
            format!(
                "{moved:e} m/s and a spin of {turned:e} m/s more than {:?}, allowed {most:e}",
                law.model
            )
        })
    }

    /// A hop in a long push: the ball separates, and no faster than in the longest hop.
    fn check_hop(&self, fastest: f64) -> Option<String> {
        let speed = -self.after.velocity.x;
        let is_hop = speed >= -self.rounding && speed <= fastest;
        (!is_hop).then(|| format!("{speed:e} m/s in a long push"))
    }

    /// A slow impact reflects the ball. In persistent contact the ball may leave faster, with at
    /// most the least speed of separation.
    fn check_slow(&self) -> Option<String> {
        let (came, left) = (self.impact.velocity, self.after.velocity);
        let along = (left.y - came.y).abs();
        let slow = came.x.max(0.0) - self.rounding;
        let fast = came.x.max(REFLECTS) + self.rounding;
        let speed = -left.x;
        let turned = (self.after.surface - self.impact.surface).length();
        let most = SPIN_SHARE * self.impact.surface.length() + self.rounding;
        (speed < slow || speed > fast || along > self.rounding || turned > most).then(|| {
            format!(
                "{speed:e} m/s for {:e}, {along:e} m/s along it and a spin of {turned:e} m/s",
                came.x
            )
        })
    }
}
