//! Checks of conservation at every event: energy, momentum, angular momentum, and finite states.

mod balls;
mod impulses;
mod linear;
mod network;
mod pair_law;
mod rail_on_bed;
mod table;

use carom::event::{Event, EventKind};
use carom::physics::BallBall;
use carom::shot::Shot;
use carom::{Ball, BallState, MotionState};

pub(crate) use network::still_approaching;

use crate::places::{self, TABLE_GAP};
use crate::solid::Solid;

/// Allowed relative rounding error of sums over the balls of an event.
const ROUNDING: f64 = 1e-12;

/// Largest energy that a persistent contact may add to balls of at most [`USUAL_MASS`], J: that of
/// `MIN_SEPARATION_WITH_GAIN` in the engine's `simulate/persistent_contact.rs`.
pub const PUSH_ENERGY: f64 = 2e-9;

/// The energies of persistent contacts are those of balls of up to this mass, kg; those of heavier
/// balls are larger in proportion.
const USUAL_MASS: f64 = 0.3;

/// The same if one of the balls is in the air, J: that of `MIN_SEPARATION` there.
const PUSH_ENERGY_IN_AIR: f64 = 1.5e-7;

/// Largest fraction of a spin that a persistent contact of smooth balls may take: `SPIN_SHARE`
/// there.
const SPIN_SHARE: f64 = 1e-3;

/// Speed below which the engine puts a ball at rest, m/s: `STILL` in its `motion`.
const STILL: f64 = 1e-13;

/// Height below which the engine suppresses a hop, m.
const LAST_HOP: f64 = 1e-4;

/// Upward speed, m/s, below which a ball on the bed may be kept on it.
fn last_hop_speed(shot: &Shot) -> f64 {
    (2.0 * shot.physics().gravity * LAST_HOP).sqrt() * (1.0 + ROUNDING)
}

/// What an event is checked against.
#[derive(Clone, Copy)]
pub(crate) struct Circumstances<'a> {
    pub(crate) shot: &'a Shot,
    pub(crate) solid: &'a Solid,
    /// The law of two balls that meet: that of the physics, or with the friction of a cling.
    pub(crate) law: &'a BallBall,
    /// Balls less than this apart, m, touch.
    pub(crate) gap: f64,
    /// Speed up to which the event may be a hop in a long push, m/s ([`crate::pushes`]).
    pub(crate) hop: f64,
}

/// The violation of a conservation law in an event, if there is one.
pub(crate) fn audit(scene: &Circumstances<'_>, event: &Event<'_>) -> Option<String> {
    let Circumstances { shot, solid, .. } = *scene;
    let balls: Vec<Ball> = event.balls.iter().map(|&i| shot.balls()[usize::from(i)].ball).collect();
    for (k, s) in event.after.iter().enumerate() {
        if !(s.position.is_finite() && s.velocity.is_finite() && s.angular_velocity.is_finite()) {
            return Some(format!("ball {} is not finite after {:?}", event.balls[k], event.kind));
        }
        // A ball that comes to rest on a surface is placed exactly at its height.
        let moved = (event.before[k].position - s.position).length();
        let most = TABLE_GAP + places::raised(solid, s, balls[k].radius);
        if moved > most && s.motion != MotionState::Pocketed {
            let ball = event.balls[k];
            return Some(format!("ball {ball} jumps by {moved:e} m at {:?}", event.kind));
        }
    }
    let energy = |states: &[BallState]| -> f64 {
        states.iter().zip(&balls).map(|(s, b)| b.kinetic_energy(s)).sum()
    };
    let (before, after) = (energy(event.before), energy(event.after));
    let given = after - before;
    if let EventKind::CueStrike { .. } = event.kind {
        // Only the strike in the shot itself is known here.
        let (_, strike) = shot.strike()?;
        let had = 0.5 * shot.physics().cue.mass * strike.speed * strike.speed;
        return (given > had * (1.0 + ROUNDING))
            .then(|| format!("the cue gives {given:e} J but had only {had:e} J"));
    }
    let flies = |s: &BallState| s.motion == MotionState::Airborne;
    let in_air = event.kind == EventKind::BallCollision && event.before.iter().any(flies);
    let heaviest = balls.iter().fold(USUAL_MASS, |most, ball| ball.mass.max(most));
    let pushed = if in_air { PUSH_ENERGY_IN_AIR } else { PUSH_ENERGY };
    let allowed = pushed * (heaviest / USUAL_MASS);
    if after > before * (1.0 + ROUNDING) + allowed {
        return Some(format!("{:?} raises the energy by {given:e} J", event.kind));
    }
    match event.kind {
        EventKind::BallCollision => balls::audit(scene, event, &balls),
        EventKind::RailCollision(k) => table::rail(scene, event, &balls[0], usize::from(k)),
        EventKind::SlateCollision => table::slate(shot, solid, event, &balls[0]),
        _ => None,
    }
}
