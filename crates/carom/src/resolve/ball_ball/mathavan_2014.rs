//! Mathavan, Jackson & Parkin, *Numerical simulations of the frictional collisions of solid balls
//! on a rough surface*, Sports Engineering 17 (2014) 227–237.
//!
//! The impact is integrated over the normal impulse P. Friction μ_bb between the balls acts against
//! the slip **u**. Its vertical part presses one of the balls on the cloth, whose friction μ_s acts
//! against that ball's slip **c**. With impulses per m* (so P is a speed), the normal h, and the
//! horizontal tangent t₁ = ẑ×h, ball a receives per dP
//!
//! * from b: −1 along h, −μ_bb·û₁ along t₁ and −μ_bb·û_z along ẑ;
//! * from the cloth, if û_z > 0: N = μ_bb·û_z upwards and −μ_s·N·ĉ in the plane;
//!
//! and b the opposite, pressed down if û_z < 0. The centres have no vertical velocity. Compression
//! ends where the approach speed w is 0, after the work W_c = ∫w dP; the impact ends when
//! restitution has returned the work e²·W_c (Stronge's energetic coefficient). μ_bb is that of the
//! initial slip.
//!
//! **Departures.** The paper takes steps of equal P. Here the step size is controlled with Dormand
//! & Prince's Runge–Kutta pair of order 5(4), each step accurate to `TOLERANCE` of the approach
//! speed, and the ends of both phases are met exactly. The results are converged to 1e-9 m/s (a
//! test compares them with 160 000 small steps). When the slip between the balls reaches zero,
//! friction ends, because nothing drives a new slip (the paper's equations are undefined there).
//! Unlike in the other models, the cloth changes the pair's momentum.
//!
//! The paper does not cover balls **off the cloth** or unequal balls, whose line of centres is
//! inclined. Without the terms of the cloth its equations keep the direction of the slip, and their
//! closed form is that of [`frictional`].

use super::contact::{Contact, TANGENT_COMPLIANCE};
use super::frictional;
use crate::math::{Vec2, pow, sqrt};
use crate::physics::{BallBall, Cloth};
use crate::resolve::{Body, SPIN_PER_IMPULSE, restitution};

/// Local error of a step, as a fraction of the approach speed.
const TOLERANCE: f64 = 1e-11;

/// A slip below this fraction of the approach speed counts as 0.
const STUCK: f64 = 1e-11;

/// Fraction of a slip's remaining duration that one step may take. The direction of the slip may
/// still change until it ends.
const SLIP_STEP: f64 = 0.75;

/// Accuracy of the ends of the two phases, as a fraction of the approach speed and of the work.
const PHASE_END: f64 = 1e-13;

/// The most steps; an impact takes 10 to 200. More are needed only if cloth and balls have so much
/// friction that the slip alternates (μ_bb·μ_s > 1/4). The rest of such an impact is computed
/// without friction.
const MAX_STEPS: usize = 2000;

/// Velocities and surface velocities Rω of both balls along h, t₁ and ẑ: v_h, v_1, Rω_h, Rω_1, Rω_z
/// of a, then of b; last the work W of the normal impulse, divided by the initial approach speed.
type State = [f64; 11];

/// Indices of the two balls' parts in a state.
const A: core::ops::Range<usize> = 0..5;
const B: core::ops::Range<usize> = 5..10;
const WORK: usize = 10;

/// The constants of one impact.
struct Integration {
    /// Horizontal unit vector h from a to b.
    direction: Vec2,
    /// m*/m_a.
    share_a: f64,
    /// m*/m_b.
    share_b: f64,
    /// μ_bb at the initial slip.
    friction: f64,
    /// μ_s.
    cloth: f64,
    /// Approach speed at the start, m/s.
    scale: f64,
}

/// Resolves `contact`.
pub fn resolve(law: &BallBall, cloth: &Cloth, contact: &Contact, a: &mut Body, b: &mut Body) {
    // Balls on the bed: their centres are at one height and have no vertical velocity.
    let on_bed = contact.normal.z == 0.0 && a.velocity.z == 0.0 && b.velocity.z == 0.0;
    if !on_bed {
        return frictional::resolve(law, contact, a, b);
    }
    let impact = Integration {
        direction: contact.normal.xy(),
        share_a: contact.share_a,
        share_b: contact.share_b,
        friction: law.friction.at(contact.slip_speed()),
        cloth: cloth.sliding_friction,
        scale: contact.approach,
    };
    let e = restitution::effective(law.restitution, contact.approach);
    let before = impact.state(a, b);
    let mut after = impact.integrate(before, e);
    // The approach that compression leaves within its accuracy, if there is no restitution.
    let approach = Integration::approach(&after).max(0.0);
    after[A.start] -= approach * contact.share_a;
    after[B.start] += approach * contact.share_b;
    let change: State = core::array::from_fn(|i| after[i] - before[i]);
    impact.add(&change, a, b);
}

impl Integration {
    fn state(&self, a: &Body, b: &Body) -> State {
        let (h, t1) = (self.direction, self.direction.perp());
        let of = |ball: &Body| {
            let (v, s) = (ball.velocity.xy(), ball.angular_velocity * ball.radius);
            [v.dot(h), v.dot(t1), s.xy().dot(h), s.xy().dot(t1), s.z]
        };
        join(of(a), of(b), 0.0)
    }

    fn add(&self, change: &State, a: &mut Body, b: &mut Body) {
        let (h, t1) = (self.direction, self.direction.perp());
        for (ball, c) in [(a, &change[A]), (b, &change[B])] {
            ball.velocity += (h * c[0] + t1 * c[1]).with_z(0.0);
            ball.angular_velocity += (h * c[2] + t1 * c[3]).with_z(c[4]) * (1.0 / ball.radius);
        }
    }

    /// Approach speed w.
    fn approach(state: &State) -> f64 {
        state[0] - state[5]
    }

    /// Slip u of a's surface over b's, along t₁ and ẑ.
    fn slip(s: &State) -> Vec2 {
        Vec2::new(s[1] - s[6] + (s[4] + s[9]), -(s[3] + s[8]))
    }

    /// d(state)/dP.
    fn rate(&self, s: &State) -> State {
        let u = Self::slip(s);
        let speed = sqrt(u.length_squared());
        let f = if speed > 0.0 { u * (self.friction / speed) } else { Vec2::ZERO };
        // The force is −1 along h and −f along t₁. The torque, along t₁ and ẑ, is the same for both
        // balls.
        let torque = Vec2::new(-f.y, f.x);
        let pressed = f.y;
        let of = |sign: f64, share: f64, ball: &[f64], load: f64| {
            let force = Vec2::new(-sign, -sign * f.x);
            let slip = Vec2::new(ball[0] - ball[3], ball[1] + ball[2]);
            let drive = Vec2::new(force.x + SPIN_PER_IMPULSE * torque.x, force.y);
            let drag = self.drag(slip, drive, load);
            let turn = |t: f64| -SPIN_PER_IMPULSE * share * t;
            [
                share * (force.x + drag.x),
                share * (force.y + drag.y),
                turn(-drag.y),
                turn(torque.x + drag.x),
                turn(torque.y),
            ]
        };
        let a = of(1.0, self.share_a, &s[A], pressed.max(0.0));
        let b = of(-1.0, self.share_b, &s[B], (-pressed).max(0.0));
        join(a, b, Self::approach(s) / self.scale)
    }

    /// Friction of the cloth under `load`, against the `slip`. Without slip it acts against
    /// `drive`, the rate of change of the slip without friction, and at most cancels it.
    fn drag(&self, slip: Vec2, drive: Vec2, load: f64) -> Vec2 {
        let most = self.cloth * load;
        if most == 0.0 {
            return Vec2::ZERO;
        }
        let speed = sqrt(slip.length_squared());
        if speed > STUCK * self.scale {
            return slip * (-most / speed);
        }
        let push = sqrt(drive.length_squared());
        if push == 0.0 {
            return Vec2::ZERO;
        }
        drive * -(most / push).min(1.0 / TANGENT_COMPLIANCE)
    }

    /// The state after the whole impact.
    fn integrate(&self, start: State, e: f64) -> State {
        let mut state = start;
        let mut rate = self.rate(&state);
        let mut compression_work = None;
        let mut step = 0.1 * self.scale;
        for _ in 0..MAX_STEPS {
            let approach = Self::approach(&state);
            if compression_work.is_none() && approach <= PHASE_END * self.scale {
                compression_work = Some(state[WORK]);
            }
            let left = compression_work.map(|most| state[WORK] - (1.0 - e * e) * most);
            if left.is_some_and(|left| left <= PHASE_END * self.scale) {
                return state;
            }
            let slip = Self::slip(&state);
            let speed = sqrt(slip.length_squared());
            if speed <= STUCK * self.scale {
                break;
            }
            // dw/dP is nearly constant, so this end of the phase is accurate except for rounding.
            let mut longest = f64::INFINITY;
            let fall = -Self::approach(&rate);
            if fall > 0.0 {
                let square =
                    left.map_or(0.0, |left| approach * approach + 2.0 * fall * left * self.scale);
                longest = (approach + sqrt(square)) / fall;
            }
            let decay = -Self::slip(&rate).dot(slip) / speed;
            if decay > 0.0 {
                longest = longest.min(SLIP_STEP * speed / decay);
            }
            let length = step.min(longest);
            let (next, next_rate, error) = self.runge_kutta(&state, &rate, length);
            let accuracy = error / (TOLERANCE * self.scale);
            if accuracy <= 1.0 {
                (state, rate) = (next, next_rate);
            }
            if accuracy > 1.0 || length == step {
                step = length * growth(accuracy);
            }
        }
        self.finish_without_friction(state, e, compression_work)
    }

    /// The end of the impact from `state` without friction, in closed form: w falls at rate 1.
    fn finish_without_friction(&self, state: State, e: f64, compression: Option<f64>) -> State {
        let approach = Self::approach(&state);
        let work = state[WORK] * self.scale;
        let most = compression.map_or(work + 0.5 * approach * approach, |w| w * self.scale);
        let left = work - (1.0 - e * e) * most;
        let impulse = approach + sqrt((approach * approach + 2.0 * left).max(0.0));
        let mut end = state;
        end[A.start] -= impulse * self.share_a;
        end[B.start] += impulse * self.share_b;
        end
    }

    /// One step of Dormand & Prince 1980, order 5: the state, its rate, and the estimated error.
    fn runge_kutta(&self, state: &State, rate: &State, step: f64) -> (State, State, f64) {
        let mut k = [*rate; 7];
        let mut next = *state;
        for (stage, weights) in DORMAND_PRINCE.iter().enumerate() {
            next = core::array::from_fn(|i| {
                let sum = weights[..=stage].iter().zip(&k).fold(0.0, |sum, (w, k)| sum + w * k[i]);
                state[i] + step * sum
            });
            k[stage + 1] = self.rate(&next);
        }
        let error = (0..next.len())
            .map(|i| DORMAND_PRINCE_ERROR.iter().zip(&k).fold(0.0, |sum, (w, k)| sum + w * k[i]))
            .fold(0.0, |most: f64, error| most.max((step * error).abs()));
        (next, k[6], error)
    }
}

fn join(a: [f64; 5], b: [f64; 5], work: f64) -> State {
    let mut state = [0.0; 11];
    state[A].copy_from_slice(&a);
    state[B].copy_from_slice(&b);
    state[WORK] = work;
    state
}

/// Factor for the next step size, given the error as a multiple of the allowed one.
fn growth(accuracy: f64) -> f64 {
    if accuracy == 0.0 { 5.0 } else { (0.9 * pow(accuracy, -0.2)).clamp(0.2, 5.0) }
}

/// Stages of the solution of order 5; the last stage is the solution.
const DORMAND_PRINCE: [[f64; 6]; 6] = [
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0],
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

/// Weights of order 5 minus weights of order 4.
const DORMAND_PRINCE_ERROR: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];
