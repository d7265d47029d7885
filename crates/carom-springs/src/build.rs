//! The network of a shot: its balls, the slate, the noses that they touch, and the tip.

use carom::Shot;
use carom::physics::{CushionModel, Physics, Tip};
use carom::resolve::cue_ball::Strike;

use crate::Vector;
use crate::law::{Friction, Law, Restitution, squirt, stiffness_of_time, tip_restitution};
use crate::network::{Network, Sides, Spring, SpringBall, SpringCue};

/// A ball touches a nose that is nearer than this, m.
const NEAR: f64 = 2e-3;

/// What the shot file does not contain.
#[derive(Clone, Copy, Debug)]
pub struct Springs {
    /// Balls nearer than this have a contact, m. The engine leaves wider gaps to later events.
    pub reach: f64,
    /// Whether the slate under every ball and the noses are part of the impact. The engine takes only
    /// the slate under a ball that a raised cue presses down.
    pub walls: bool,
    /// Whether the lines of centres keep their first directions; only for studies of this.
    pub keeps_normals: bool,
    /// Duration of a lossless contact at 1 m/s with a nose, s.
    pub cushion_time: f64,
}

impl Springs {
    /// What the engine does. The time of the noses is an estimate.
    pub const USUAL: Self =
        Self { reach: 2e-4, walls: false, keeps_normals: false, cushion_time: 4e-3 };
}

/// The bodies of `shot` at its start, with a contact wherever two are near.
pub fn network(shot: &Shot, springs: &Springs) -> Network {
    let physics = shot.physics();
    let balls = shot
        .balls()
        .iter()
        .map(|placed| {
            let state = &placed.state;
            let vector = |v: carom::math::Vec3| Vector::new(v.x, v.y, v.z);
            SpringBall {
                mass: placed.ball.mass,
                radius: placed.ball.radius,
                position: vector(state.position),
                velocity: vector(state.velocity),
                spin: vector(state.angular_velocity),
            }
        })
        .collect();
    let mut network = Network::of_balls(balls, ball_law(physics), springs.reach);
    network.keeps_normals = springs.keeps_normals;
    if springs.walls {
        (0..network.balls.len()).for_each(|k| add_slate(&mut network, k, physics));
        add_noses(&mut network, shot, springs);
    }
    if let Some((ball, strike)) = shot.strike() {
        if strike.elevation > 0.0 && !springs.walls {
            add_slate(&mut network, ball, physics);
        }
        add_tip(&mut network, ball, &strike, physics);
    }
    network
}

fn ball_law(physics: &Physics) -> Law {
    let law = &physics.ball_ball;
    let friction = Friction { a: law.friction.a, b: law.friction.b, c: law.friction.c };
    let traits = law.model.traits();
    Law {
        restitution: Restitution::constant(law.restitution),
        friction: if traits.friction { friction } else { Friction::constant(0.0) },
        frequency_ratio: traits.spring.then_some(law.frequency_ratio),
    }
}

fn add_slate(network: &mut Network, k: usize, physics: &Physics) {
    let law = Law::rigid(physics.slate.restitution, physics.slate.friction);
    let ball = network.balls[k];
    let stiffness = stiffness_of_time(ball.mass, physics.contact_times.slate);
    let gap = ball.position.z - ball.radius;
    if gap < NEAR {
        network.add_wall(k, -Vector::z(), gap, stiffness, law);
    }
}

fn add_noses(network: &mut Network, shot: &Shot, springs: &Springs) {
    let (table, rail) = (shot.table(), &shot.physics().cushion);
    if !table.size.x.is_finite() {
        return;
    }
    let is_smooth = matches!(rail.model, CushionModel::Restitution | CushionModel::Factors);
    let law = Law {
        restitution: Restitution {
            a: rail.restitution.a,
            b: rail.restitution.b,
            c: rail.restitution.c,
        },
        friction: Friction::constant(if is_smooth { 0.0 } else { rail.friction.a }),
        frequency_ratio: (rail.model == CushionModel::Stronge).then_some(rail.frequency_ratio),
    };
    for k in 0..network.balls.len() {
        let ball = network.balls[k];
        let above = table.cushion_height - ball.position.z;
        for (into, distance) in [
            (-Vector::x(), ball.position.x),
            (Vector::x(), table.size.x - ball.position.x),
            (-Vector::y(), ball.position.y),
            (Vector::y(), table.size.y - ball.position.y),
        ] {
            let away = distance.hypot(above);
            if away - ball.radius < NEAR {
                let sin = above / ball.radius;
                let normal = into * (1.0 - sin * sin).sqrt() + Vector::z() * sin;
                let stiffness = stiffness_of_time(ball.mass, springs.cushion_time);
                let (gap, measured) = (away - ball.radius, into);
                let sides = Sides::Wall { ball: k, normal, gap, measured };
                network.contacts.push(Spring { sides, stiffness, law });
            }
        }
    }
}

fn add_tip(network: &mut Network, ball: usize, strike: &Strike, physics: &Physics) {
    let cue = &physics.cue;
    let mass = network.balls[ball].mass;
    let (sin, cos) = strike.elevation.sin_cos();
    let (y, x) = strike.azimuth.sin_cos();
    let axis = Vector::new(x * cos, y * cos, -sin);
    let right = Vector::new(y, -x, 0.0);
    let up = right.cross(&axis);
    let offset = strike.side.hypot(strike.height);
    let arm = right * strike.side + up * strike.height - axis * (1.0 - offset * offset).sqrt();
    let angle = squirt(mass, cue.end_mass, strike.side);
    let launch = axis * angle.cos() - right * angle.sin();
    let central = match cue.tip {
        Tip::Restitution(e) => e,
        Tip::Efficiency(_) => panic!("a tip with an efficiency has no spring"),
    };
    let reduced = mass * cue.mass / (mass + cue.mass);
    network.add_tip(
        ball,
        SpringCue { mass: cue.mass, speed: strike.speed },
        [axis, launch, arm],
        stiffness_of_time(reduced, physics.contact_times.tip),
        tip_restitution(central, cue.tip_off_centre_loss, offset),
    );
}
