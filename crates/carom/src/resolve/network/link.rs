//! A contact of two balls, or of a ball and a wall, during the impact.

use super::step::TimeStep;
use super::{STILL, Stepping, Touch, Units, WALL, WallTouch, ball_stiffness, larger, smaller};
use crate::math::{Vec2, Vec3, sqrt};
use crate::physics::{BallBall, BallBallModel, SlipFriction};
use crate::resolve::ball_ball::contact::TANGENT_COMPLIANCE;
use crate::resolve::{Body, restitution};
use crate::table::TOUCH_TOLERANCE;

/// μ is computed again when the slip has grown by this fraction of the fastest approach. Between,
/// it follows its tangent.
const SLIP_STEP: f64 = 1.0 / 64.0;

/// The spring along the normal.
#[derive(Clone, Copy, Default)]
pub(super) struct NormalSpring {
    /// k.
    pub(super) stiffness: f64,
    /// m* and 1/m*.
    pub(super) mass: f64,
    pub(super) mobility: f64,
    /// How quickly the force changes (`Units::quickness`).
    pub(super) quickness: f64,
    /// δ, negative where there is a gap.
    pub(super) depth: f64,
    /// Half the rate at which the turning line of centres slows the approach. The approach speed is
    /// that at the end of a step; its mean in the step is faster by this times the step.
    bend: f64,
    /// Whether the gap is closed, now or earlier.
    pub(super) has_touched: bool,
    /// The present approach speed, and its change in the last step.
    pub(super) approach: f64,
    speedup: f64,
    /// Its own effect on the approach speed in the last step.
    own: f64,
    /// The fastest approach speed so far, and e² for it; −1 if that is not known yet.
    fastest: f64,
    open: f64,
    /// Coefficient of restitution, and m/s per unit of speed.
    restitution: f64,
    speed_unit: f64,
    /// F/δ in this step.
    pub(super) tightness: f64,
}

impl NormalSpring {
    pub(super) fn new(
        approach: f64,
        stiffness: f64,
        mobility: f64,
        gap: f64,
        restitution: f64,
        units: &Units,
    ) -> Self {
        Self {
            stiffness: units.stiffness(stiffness),
            mass: 1.0 / (mobility * units.mass),
            mobility: mobility * units.mass,
            quickness: units.quickness(stiffness, mobility),
            depth: (-gap / units.length()).min(0.0),
            has_touched: gap <= TOUCH_TOLERANCE,
            approach,
            restitution,
            speed_unit: units.speed,
            open: -1.0,
            ..Self::default()
        }
    }

    /// Moves on by `drift`, and returns the impulse of this step; `None` without a force. Raises
    /// `greatest_square` to the square of the speed for which steps are chosen.
    #[inline(always)]
    pub(super) fn impulse(
        &mut self,
        approach: f64,
        drift: f64,
        step: &TimeStep,
        stepping: &Stepping,
        greatest_square: &mut f64,
    ) -> Option<f64> {
        let (speedup, last) = (approach - self.approach, self.speedup);
        (self.approach, self.speedup) = (approach, speedup);
        self.depth += (approach + self.bend * step.length) * drift;
        let lead = stepping.ahead * step.length;
        let depth = self.depth + lead * (speedup + stepping.trend * (speedup - last));
        // While the contact closes or opens within the step, the force acts in a part of it.
        let half = 0.5 * step.length * approach.abs();
        let reach = depth + half;
        if reach <= 0.0 {
            self.own = 0.0;
            if approach > STILL {
                *greatest_square = larger(*greatest_square, self.quickness * approach * approach);
            }
            return None;
        }
        let others = speedup + self.own;
        self.has_touched = true;
        let full = if depth < half {
            self.tightness = self.stiffness * sqrt(0.5 * reach);
            0.2 * self.stiffness * reach * reach * sqrt(reach) / (half / step.length)
        } else {
            self.tightness = self.stiffness * sqrt(depth);
            self.tightness * depth * step.length
        };
        let tension = 0.8 * self.tightness * self.mobility * depth * depth;
        let square = self.quickness * (approach * approach + tension);
        *greatest_square = larger(*greatest_square, square);
        if approach > self.fastest {
            self.fastest = approach;
            self.open = -1.0;
        }
        // The part of the step in which the contact closes.
        let change = others - full * self.mobility;
        let end = approach + change;
        let impulse =
            if approach > 0.0 && end >= 0.0 { full } else { self.open(full, end, change) };
        self.own = impulse * self.mobility;
        (impulse != 0.0).then_some(impulse)
    }

    /// The impulse of a step in which the contact opens, at least in a part of the step. `full` is
    /// that of a closing contact, `end` the approach speed at the end of the step, and `change` its
    /// change.
    #[inline(always)]
    fn open(&mut self, full: f64, end: f64, change: f64) -> f64 {
        if self.open < 0.0 {
            let speed = self.fastest * self.speed_unit;
            let e = restitution::effective(self.restitution, speed);
            self.open = e * e;
        }
        let closing = if end < 0.0 && self.approach > 0.0 {
            self.approach / -change
        } else if end > 0.0 {
            end / change
        } else {
            0.0
        };
        full * (self.open + (1.0 - self.open) * closing)
    }

    /// The (speed)² of the approach, for the choice of steps.
    pub(super) fn square_speed(&self) -> f64 {
        let approach = larger(self.approach, 0.0);
        self.quickness * approach * approach
    }

    /// The time until the bodies meet; infinite if they do not approach.
    pub(super) fn time_to_contact(&self) -> f64 {
        if self.approach > STILL { larger(-self.depth, 0.0) / self.approach } else { f64::INFINITY }
    }
}

/// Friction at a contact.
#[derive(Clone, Copy, Default)]
pub(super) struct Grip {
    /// Whether there is friction.
    pub(super) rubs: bool,
    /// (5/4)(2/7)(ω_t/ω_n)², 0 for a rigid contact.
    stiffness: f64,
    /// Whether μ depends on the slip.
    varies: bool,
    /// μ at the fastest slip so far, and the square of this slip.
    friction: f64,
    fastest: f64,
    /// A slip, μ and its slope there, and the slip up to which they serve.
    base: f64,
    base_friction: f64,
    slope: f64,
    known: f64,
    /// Whether the contact carried a force in the last step.
    pub(super) presses: bool,
    /// Friction on b, and the stiffness of its spring, in the last step with a force.
    pull: Vec2,
    tightness: f64,
    /// The slip in the last step, and what the friction changed of it.
    slip: Vec2,
    own: Vec2,
}

/// The state of a contact.
#[derive(Clone, Copy, Default)]
pub(super) struct Link {
    pub(super) a: usize,
    /// The second ball, or [`WALL`].
    pub(super) b: usize,
    /// Set of the balls, one bit each.
    pub(super) both: u32,
    pub(super) normal: Vec3,
    pub(super) tangents: TangentBasis,
    /// The normal at the start, and 1/(distance of the centres); 0 for a wall.
    pub(super) first_normal: Vec3,
    per_distance: f64,
    /// Whether there was a gap at the start.
    has_gap: bool,
    pub(super) spring: NormalSpring,
    pub(super) grip: Grip,
    /// 1 / (number of contacts of the ball that has more).
    pub(super) share: f64,
}

impl Link {
    /// Becomes a contact of two balls.
    pub(super) fn join(&mut self, touch: &Touch, law: &BallBall, bodies: &[Body], units: &Units) {
        let (a, b) = touch.bodies(bodies);
        let mobility = 1.0 / a.mass + 1.0 / b.mass;
        let stiffness = ball_stiffness(a, b);
        let e = law.restitution;
        let n = touch.normal;
        let approach = (a.velocity * (1.0 / units.speed) - b.velocity * (1.0 / units.speed)).dot(n);
        let sprung = law.model == BallBallModel::Compliant;
        let distance = a.radius + b.radius + touch.gap;
        *self = Self {
            a: usize::from(touch.a),
            b: usize::from(touch.b),
            both: 1 << touch.a | 1 << touch.b,
            normal: n,
            first_normal: n,
            per_distance: units.length() / distance,
            has_gap: touch.gap > TOUCH_TOLERANCE,
            tangents: TangentBasis::of(n),
            spring: NormalSpring::new(approach, stiffness, mobility, touch.gap, e, units),
            grip: Grip {
                rubs: !law.is_smooth(),
                stiffness: grip_stiffness(sprung.then_some(law.frequency_ratio)),
                varies: law.friction.b != 0.0,
                friction: law.friction.at(0.0),
                known: -1.0,
                ..Grip::default()
            },
            share: 1.0,
        };
    }

    /// Becomes a contact of a ball with a wall.
    pub(super) fn join_wall(&mut self, wall: &WallTouch, bodies: &[Body], units: &Units) {
        let ball = &bodies[usize::from(wall.ball)];
        let n = wall.normal;
        let approach = (ball.velocity * (1.0 / units.speed)).dot(n);
        let (k, e) = (wall.stiffness, wall.restitution);
        *self = Self {
            a: usize::from(wall.ball),
            b: WALL,
            both: 1 << wall.ball,
            normal: n,
            first_normal: n,
            per_distance: 0.0,
            has_gap: false,
            tangents: TangentBasis::of(n),
            spring: NormalSpring::new(approach, k, 1.0 / ball.mass, 0.0, e, units),
            grip: Grip {
                rubs: wall.friction > 0.0,
                stiffness: grip_stiffness(wall.frequency_ratio),
                friction: wall.friction,
                ..Grip::default()
            },
            share: 1.0,
        };
    }

    /// Turns the line of centres to where it is after the further time `ahead`. b has moved `apart`
    /// relative to a, and moves with `velocity`.
    #[inline(always)]
    pub(super) fn turn(&mut self, apart: Vec3, velocity: Vec3, ahead: f64) {
        if self.per_distance == 0.0 {
            return;
        }
        let line = self.first_normal + (apart + velocity * ahead) * self.per_distance;
        self.normal = line * (1.0 / line.length());
        self.tangents = TangentBasis::of(self.normal);
        let along = velocity.dot(self.normal);
        let across = velocity.length_squared() - along * along;
        self.spring.bend = 0.5 * across * self.per_distance;
    }

    /// Whether a gap has closed since the start.
    pub(super) fn met_across_gap(&self) -> bool {
        self.has_gap && self.spring.has_touched
    }

    /// The friction impulse of one step on b. `law` is that of the balls.
    #[inline(always)]
    pub(super) fn friction_impulse(
        &mut self,
        slip: Vec2,
        normal: f64,
        step: &TimeStep,
        law: &SlipFriction,
    ) -> Vec2 {
        let Self { grip, spring, .. } = self;
        let square = slip.length_squared();
        if square > grip.fastest {
            grip.fastest = square;
            grip.follow(law, step.speed);
        }
        let most = grip.friction * normal;
        if grip.stiffness > 0.0 {
            return grip.spring(slip, most, spring, step.length);
        }
        grip.rigid(slip, most, spring.mass / TANGENT_COMPLIANCE)
    }
}

impl Grip {
    /// Computes μ at a new fastest slip.
    fn follow(&mut self, law: &SlipFriction, speed: f64) {
        if !self.varies {
            return;
        }
        let slip = sqrt(self.fastest);
        if slip > self.known {
            self.base = slip;
            self.base_friction = law.at(slip * speed);
            self.slope = -law.c * speed * (self.base_friction - law.a);
            self.known = slip + SLIP_STEP;
        }
        self.friction = self.base_friction + self.slope * (slip - self.base);
    }

    /// Friction that stops the slip, of at most the impulse `most`. The impulse `stop` per slip
    /// would stop it, if the contact were alone.
    #[inline(always)]
    fn rigid(&mut self, slip: Vec2, most: f64, stop: f64) -> Vec2 {
        // What other contacts change of the slip in a step.
        let others = if self.presses { slip - self.slip + self.own } else { Vec2::ZERO };
        self.presses = true;
        self.slip = slip;
        let mut impulse = (slip + others) * stop;
        if impulse.length_squared() > most * most {
            // The surfaces slide: friction acts against the slip in the middle of the step.
            let middle = slip + (others - self.own) * 0.5;
            let speed = middle.length();
            let unit = if speed > 0.0 { middle * (1.0 / speed) } else { Vec2::ZERO };
            impulse = unit * most;
        }
        self.own = impulse * (1.0 / stop);
        impulse
    }

    /// Friction of a spring, of at most the impulse `most` in a step of `time`. `spring` is
    /// that along the normal.
    #[inline(always)]
    fn spring(&mut self, slip: Vec2, most: f64, spring: &NormalSpring, time: f64) -> Vec2 {
        let stiffness = self.stiffness * spring.tightness;
        let steady = self.presses;
        if steady {
            if stiffness < self.tightness {
                self.pull = self.pull * (stiffness / self.tightness) + slip * (stiffness * time);
            } else {
                self.pull += slip * (0.5 * (stiffness + self.tightness) * time);
            }
        } else {
            // The contact has closed within this step, and its stiffness has risen as √δ.
            let since = smaller(time, larger(spring.depth, 0.0) / larger(spring.approach, STILL));
            self.pull = slip * (2.0 / 3.0 * stiffness * since);
            self.presses = true;
        }
        self.tightness = stiffness;
        let (change, pull) = (slip - self.slip, self.pull);
        self.slip = slip;
        let impulse = pull * time;
        if impulse.length_squared() <= most * most {
            return impulse;
        }
        // The surfaces slide: friction acts along the slip in the middle of the step.
        let along = if steady { pull + change * (0.5 * stiffness * time) } else { pull };
        let impulse = along * (most / along.length());
        self.pull = impulse * (1.0 / time);
        impulse
    }
}

/// The tangential stiffness of a compliant contact, per F/δ; 0 for a rigid one.
fn grip_stiffness(frequency_ratio: Option<f64>) -> f64 {
    frequency_ratio.map_or(0.0, |ratio| 1.25 / TANGENT_COMPLIANCE * ratio * ratio)
}

/// Two unit vectors in the tangent plane; **n** × the first is the second.
#[derive(Clone, Copy, Default)]
pub(super) struct TangentBasis {
    /// Horizontal.
    first: Vec2,
    second: Vec3,
}

impl TangentBasis {
    fn of(normal: Vec3) -> Self {
        let level = normal.xy();
        let length = level.length();
        let first = if length > 0.0 { level.perp() * (1.0 / length) } else { Vec2::new(1.0, 0.0) };
        Self { first, second: normal.cross(first.with_z(0.0)) }
    }

    /// The components of the slip, from the velocity of the first ball's centre relative to the
    /// second's and the sum of both Rω.
    #[inline(always)]
    pub(super) fn slip(&self, velocity: Vec3, surface: Vec3) -> Vec2 {
        let Self { first, second } = *self;
        Vec2::new(
            velocity.xy().dot(first) + surface.dot(second),
            velocity.dot(second) - surface.xy().dot(first),
        )
    }

    /// The vector with these components.
    #[inline(always)]
    pub(super) fn vector(&self, x: f64, y: f64) -> Vec3 {
        let level = self.first * x + self.second.xy() * y;
        level.with_z(self.second.z * y)
    }
}
