//! The contacts of the balls, with balls or with walls, during the impact.

#![expect(
    clippy::needless_range_loop,
    reason = "a loop over the lanes of several arrays becomes vector instructions"
)]

use super::directions::Directions;
use super::grip::Grip;
use super::spring::{NormalSprings, Spring};
use super::{BALL_SLOTS, Touch, Units, WALL, WallTouch, ball_stiffness};
use crate::math::{Vec2, Vec3, sqrt};
use crate::physics::BallBall;
use crate::resolve::Body;
use crate::table::TOUCH_TOLERANCE;

/// Number of contacts processed together: the doubles in an AVX2 register.
pub(super) const LANES: usize = 4;

/// One number for each contact of a block.
type Lane = [f64; LANES];

/// The x, y and z components of a vector of each ball.
pub(super) type PerBall = [[f64; BALL_SLOTS]; 3];

/// What is not needed in every step of a contact.
#[derive(Clone, Copy, Default)]
pub(super) struct Link {
    pub(super) a: usize,
    /// The second ball, or [`WALL`].
    pub(super) b: usize,
    /// Set of the balls, one bit each.
    pub(super) both: u32,
    /// Whether there was a gap at the start.
    pub(super) has_gap: bool,
    pub(super) grip: Grip,
    /// 1 / (number of contacts of the ball that has more).
    pub(super) share: f64,
}

/// [`LANES`] contacts side by side.
#[derive(Clone, Copy)]
pub(super) struct Block {
    a: [usize; LANES],
    b: [usize; LANES],
    pub(super) normal: [Lane; 3],
    /// Two unit vectors in the tangent plane; **n** × the first is the second. The first is
    /// horizontal.
    first_tangent: [Lane; 2],
    second_tangent: [Lane; 3],
    /// The normal at the start, and 1/(distance of the centres); 0 for a wall.
    first_normal: [Lane; 3],
    per_distance: Lane,
    pub(super) springs: NormalSprings<LANES>,
}

impl Block {
    /// Lanes without contacts.
    pub(super) const NONE: Self = Self {
        a: [WALL; LANES],
        b: [WALL; LANES],
        normal: [[0.0; LANES], [0.0; LANES], [1.0; LANES]],
        first_tangent: [[0.0; LANES]; 2],
        second_tangent: [[0.0; LANES]; 3],
        first_normal: [[0.0; LANES], [0.0; LANES], [1.0; LANES]],
        per_distance: [0.0; LANES],
        springs: NormalSprings::NONE,
    };

    /// Puts a contact of two balls in a lane.
    pub(super) fn join(
        &mut self,
        lane: usize,
        touch: &Touch,
        law: &BallBall,
        bodies: &[Body],
        units: &Units,
    ) -> Link {
        let (a, b) = touch.bodies(bodies);
        let n = touch.normal;
        let approach = (a.velocity * (1.0 / units.speed) - b.velocity * (1.0 / units.speed)).dot(n);
        let spring = Spring {
            approach,
            stiffness: ball_stiffness(a, b),
            mobility: 1.0 / a.mass + 1.0 / b.mass,
            gap: touch.gap,
            restitution: law.restitution,
        };
        self.springs.set(lane, &spring, units);
        (self.a[lane], self.b[lane]) = (usize::from(touch.a), usize::from(touch.b));
        self.point(lane, n);
        self.per_distance[lane] = units.length() / (a.radius + b.radius + touch.gap);
        Link {
            a: usize::from(touch.a),
            b: usize::from(touch.b),
            both: 1 << touch.a | 1 << touch.b,
            has_gap: touch.gap > TOUCH_TOLERANCE,
            grip: Grip::of_balls(law),
            share: 1.0,
        }
    }

    /// Puts a contact of a ball with a wall in a lane.
    pub(super) fn join_wall(
        &mut self,
        lane: usize,
        wall: &WallTouch,
        bodies: &[Body],
        units: &Units,
    ) -> Link {
        let ball = &bodies[usize::from(wall.ball)];
        let spring = Spring::of_wall(wall, ball, units);
        self.springs.set(lane, &spring, units);
        (self.a[lane], self.b[lane]) = (usize::from(wall.ball), WALL);
        self.point(lane, wall.normal);
        Link {
            a: usize::from(wall.ball),
            b: WALL,
            both: 1 << wall.ball,
            has_gap: false,
            grip: Grip::of_wall(wall),
            share: 1.0,
        }
    }

    /// Sets the normal at the start.
    fn point(&mut self, lane: usize, n: Vec3) {
        for (first, n) in self.first_normal.iter_mut().zip([n.x, n.y, n.z]) {
            first[lane] = n;
        }
        self.normal = self.first_normal;
    }

    /// The normal at the start.
    pub(super) fn first_normal(&self, lane: usize) -> Vec3 {
        vector(&self.first_normal, lane)
    }

    /// Velocities of the first balls relative to the second ones.
    #[inline(always)]
    pub(super) fn velocity(&self, velocities: &PerBall) -> [Lane; 3] {
        let mut relative = [[0.0; LANES]; 3];
        for (relative, velocity) in relative.iter_mut().zip(velocities) {
            for k in 0..LANES {
                relative[k] = velocity[self.a[k] % BALL_SLOTS] - velocity[self.b[k] % BALL_SLOTS];
            }
        }
        relative
    }

    /// The components of relative velocities along the normals.
    #[inline(always)]
    pub(super) fn approach(&self, velocity: &[Lane; 3]) -> Lane {
        let ([x, y, z], [nx, ny, nz]) = (velocity, &self.normal);
        let mut approach = [0.0; LANES];
        for k in 0..LANES {
            approach[k] = x[k] * nx[k] + y[k] * ny[k] + z[k] * nz[k];
        }
        approach
    }

    /// Turns the lines of centres to where they are after the further time `ahead`. `shifts` are the
    /// displacements of the balls.
    #[inline(always)]
    pub(super) fn turn(&mut self, velocities: &PerBall, shifts: &PerBall, ahead: f64) {
        let velocity = self.velocity(velocities);
        let mut line = [[0.0; LANES]; 3];
        for i in 0..3 {
            for k in 0..LANES {
                let (a, b) = (shifts[i][self.a[k] % BALL_SLOTS], shifts[i][self.b[k] % BALL_SLOTS]);
                let apart = (b - a) - velocity[i][k] * ahead;
                line[i][k] = self.first_normal[i][k] + apart * self.per_distance[k];
            }
        }
        let [x, y, z] = &line;
        let mut scale = [0.0; LANES];
        for k in 0..LANES {
            scale[k] = 1.0 / sqrt(x[k] * x[k] + y[k] * y[k] + z[k] * z[k]);
        }
        for i in 0..3 {
            for k in 0..LANES {
                self.normal[i][k] = line[i][k] * scale[k];
            }
        }
        let along = self.approach(&velocity);
        let [x, y, z] = &velocity;
        for k in 0..LANES {
            let square = x[k] * x[k] + y[k] * y[k] + z[k] * z[k];
            let across = square - along[k] * along[k];
            self.springs.bend[k] = 0.5 * across * self.per_distance[k];
        }
        self.set_tangents();
    }

    /// Sets the tangents from the normals.
    #[inline(always)]
    pub(super) fn set_tangents(&mut self) {
        let [nx, ny, nz] = self.normal;
        let (mut x, mut y) = ([1.0; LANES], [0.0; LANES]);
        for k in 0..LANES {
            let square = nx[k] * nx[k] + ny[k] * ny[k];
            let scale = 1.0 / sqrt(square);
            x[k] = if square > 0.0 { -ny[k] * scale } else { 1.0 };
            y[k] = if square > 0.0 { nx[k] * scale } else { 0.0 };
        }
        self.first_tangent = [x, y];
        for k in 0..LANES {
            self.second_tangent[0][k] = -nz[k] * y[k];
        }
        for k in 0..LANES {
            self.second_tangent[1][k] = nz[k] * x[k];
        }
        for k in 0..LANES {
            self.second_tangent[2][k] = nx[k] * y[k] - ny[k] * x[k];
        }
    }

    /// The directions of a contact.
    #[inline(always)]
    pub(super) fn directions(&self, lane: usize) -> Directions {
        Directions {
            normal: vector(&self.normal, lane),
            first: Vec2::new(self.first_tangent[0][lane], self.first_tangent[1][lane]),
            second: vector(&self.second_tangent, lane),
        }
    }
}

/// The vector of one contact.
#[inline(always)]
pub(super) fn vector(lanes: &[Lane; 3], lane: usize) -> Vec3 {
    Vec3::new(lanes[0][lane], lanes[1][lane], lanes[2][lane])
}
