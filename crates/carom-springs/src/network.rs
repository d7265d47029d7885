//! Bodies and the contacts between them.

use crate::Vector;
use crate::law::{Law, ball_stiffness};

/// A ball.
#[derive(Clone, Copy, Debug)]
pub struct SpringBall {
    /// kg.
    pub mass: f64,
    /// m.
    pub radius: f64,
    /// Of the centre, m.
    pub position: Vector,
    /// m/s.
    pub velocity: Vector,
    /// rad/s.
    pub spin: Vector,
}

/// A cue, which moves along its axis.
#[derive(Clone, Copy, Debug)]
pub struct SpringCue {
    /// kg.
    pub mass: f64,
    /// m/s.
    pub speed: f64,
}

/// The bodies that meet in a contact.
#[derive(Clone, Copy, Debug)]
pub enum Sides {
    /// Two balls; the normal follows their centres.
    Balls {
        /// Index of the first ball.
        a: usize,
        /// Index of the second ball.
        b: usize,
    },
    /// A ball and a fixed body.
    Wall {
        /// Index of the ball.
        ball: usize,
        /// Unit vector from the ball's centre to the wall.
        normal: Vector,
        /// Distance of the surfaces, m.
        gap: f64,
        /// The restitution is that of the fastest speed along this vector.
        measured: Vector,
    },
    /// The cue's tip and a ball. The tip pushes the centre along `launch`, and turns the ball like a
    /// force along the cue's axis.
    Tip {
        /// Index of the ball.
        ball: usize,
        /// Unit vector: the axis turned by squirt.
        launch: Vector,
        /// Arm of the contact in ball radii × the axis.
        turn: Vector,
    },
}

/// A spring.
#[derive(Clone, Copy, Debug)]
pub struct Spring {
    /// What meets.
    pub sides: Sides,
    /// k, N/m^(3/2).
    pub stiffness: f64,
    /// Restitution and friction.
    pub law: Law,
}

/// Bodies and springs.
#[derive(Clone, Debug, Default)]
pub struct Network {
    /// The balls.
    pub balls: Vec<SpringBall>,
    /// The cue, if there is one.
    pub cue: Option<SpringCue>,
    /// The contacts.
    pub contacts: Vec<Spring>,
    /// Whether the lines of centres keep their first directions; only for studies of this.
    pub keeps_normals: bool,
}

impl Network {
    /// Balls, with a contact for every two that are nearer than `reach` (m).
    pub fn of_balls(balls: Vec<SpringBall>, law: Law, reach: f64) -> Self {
        let mut network = Self { balls, ..Self::default() };
        for a in 0..network.balls.len() {
            for b in a + 1..network.balls.len() {
                let (p, q) = (&network.balls[a], &network.balls[b]);
                if (q.position - p.position).norm() - p.radius - q.radius < reach {
                    let stiffness = ball_stiffness(p.radius, q.radius);
                    let sides = Sides::Balls { a, b };
                    network.contacts.push(Spring { sides, stiffness, law });
                }
            }
        }
        network
    }

    /// Adds a fixed body. `normal` points from the ball's centre to it.
    pub fn add_wall(&mut self, ball: usize, normal: Vector, gap: f64, stiffness: f64, law: Law) {
        let normal = normal.normalize();
        let sides = Sides::Wall { ball, normal, gap, measured: normal };
        self.contacts.push(Spring { sides, stiffness, law });
    }

    /// Adds a cue whose tip touches a ball. `arm` is the contact point from the ball's centre, in
    /// ball radii.
    pub fn add_tip(
        &mut self,
        ball: usize,
        cue: SpringCue,
        [axis, launch, arm]: [Vector; 3],
        stiffness: f64,
        restitution: f64,
    ) {
        self.cue = Some(cue);
        let sides = Sides::Tip { ball, launch, turn: arm.cross(&axis) };
        self.contacts.push(Spring { sides, stiffness, law: Law::rigid(restitution, 0.0) });
    }

    /// 1/m* along the normal of a contact, 1/kg.
    pub fn mobility(&self, contact: &Spring) -> f64 {
        match contact.sides {
            Sides::Balls { a, b } => 1.0 / self.balls[a].mass + 1.0 / self.balls[b].mass,
            Sides::Wall { ball, .. } => 1.0 / self.balls[ball].mass,
            Sides::Tip { ball, turn, .. } => {
                let cue = self.cue.map_or(0.0, |cue| 1.0 / cue.mass);
                cue + (1.0 + 2.5 * turn.norm_squared()) / self.balls[ball].mass
            }
        }
    }

    /// Sum of the balls' m**v**, kg·m/s.
    pub fn momentum(&self) -> Vector {
        self.balls.iter().map(|ball| ball.velocity * ball.mass).sum()
    }

    /// Kinetic energy of all bodies, J.
    pub fn energy(&self) -> f64 {
        let balls: f64 = self
            .balls
            .iter()
            .map(|ball| {
                let surface = ball.spin.norm_squared() * ball.radius * ball.radius;
                0.5 * ball.mass * (ball.velocity.norm_squared() + 0.4 * surface)
            })
            .sum();
        balls + self.cue.map_or(0.0, |cue| 0.5 * cue.mass * cue.speed * cue.speed)
    }

    /// The fastest speed of a body, m/s.
    pub fn fastest(&self) -> f64 {
        let cue = self.cue.map_or(0.0, |cue| cue.speed.abs());
        self.balls.iter().map(|ball| ball.velocity.norm()).fold(cue, f64::max)
    }
}
