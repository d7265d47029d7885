//! The springs along the normals of contacts, several side by side for vector instructions.

#![expect(
    clippy::needless_range_loop,
    reason = "a loop over the lanes of several arrays becomes vector instructions"
)]

use super::step::TimeStep;
use super::{STILL, Stepping, Units, WallTouch, larger, smaller};
use crate::math::sqrt;
use crate::resolve::{Body, restitution};
use crate::table::TOUCH_TOLERANCE;

/// The springs of `L` contacts.
#[derive(Clone, Copy)]
pub(super) struct NormalSprings<const L: usize> {
    /// k.
    stiffness: [f64; L],
    /// m* and 1/m*.
    mass: [f64; L],
    mobility: [f64; L],
    /// How quickly the force changes (`Units::quickness`).
    quickness: [f64; L],
    /// δ, negative where there is a gap.
    depth: [f64; L],
    /// Half the rate at which the turning line of centres slows the approach. The approach speed is
    /// that at the end of a step; its mean in the step is faster by this times the step.
    pub(super) bend: [f64; L],
    /// The present approach speed, and its change in the last step.
    approach: [f64; L],
    speedup: [f64; L],
    /// Its own effect on the approach speed in the last step.
    own: [f64; L],
    others: [f64; L],
    /// Whether the gap is closed, now or earlier.
    has_touched: [bool; L],
    /// The fastest approach speed so far, and e² for it; −1 if that is not known yet.
    fastest: [f64; L],
    open: [f64; L],
    /// Coefficient of restitution, and m/s per unit of speed.
    restitution: [f64; L],
    speed_unit: f64,
    /// F/δ in this step.
    tightness: [f64; L],
}

/// A spring at the start of an impact.
pub(super) struct Spring {
    /// Approach speed, in units of V.
    pub(super) approach: f64,
    /// k, N/m^(3/2).
    pub(super) stiffness: f64,
    /// 1/m*, 1/kg.
    pub(super) mobility: f64,
    /// Distance of the surfaces, m.
    pub(super) gap: f64,
    pub(super) restitution: f64,
}

impl Spring {
    /// That of a ball on a wall.
    pub(super) fn of_wall(wall: &WallTouch, ball: &Body, units: &Units) -> Self {
        Self {
            approach: (ball.velocity * (1.0 / units.speed)).dot(wall.normal),
            stiffness: wall.stiffness,
            mobility: 1.0 / ball.mass,
            gap: 0.0,
            restitution: wall.restitution,
        }
    }
}

/// One of the springs, at present.
pub(super) struct SpringState {
    /// m*.
    pub(super) mass: f64,
    /// δ, negative where there is a gap.
    pub(super) depth: f64,
    pub(super) approach: f64,
    /// Whether the gap is closed, now or earlier.
    pub(super) has_touched: bool,
    /// F/δ in this step.
    pub(super) tightness: f64,
}

impl SpringState {
    /// The time until the bodies meet; infinite if they do not approach.
    pub(super) fn time_to_contact(&self) -> f64 {
        if self.approach > STILL { larger(-self.depth, 0.0) / self.approach } else { f64::INFINITY }
    }
}

/// How far springs are compressed in a step.
pub(super) struct Compression<const L: usize> {
    /// δ at the extrapolated position.
    depth: [f64; L],
    /// How far δ changes within half of the step.
    half: [f64; L],
    /// Their sum: positive where the contact carries a force in a part of the step.
    reach: [f64; L],
}

impl<const L: usize> Compression<L> {
    /// Set of the contacts that carry a force, one bit each.
    #[inline(always)]
    pub(super) fn loaded(&self) -> u64 {
        let mut loaded = 0;
        for (lane, &reach) in self.reach.iter().enumerate() {
            loaded |= u64::from(reach > 0.0) << lane;
        }
        loaded
    }
}

impl<const L: usize> NormalSprings<L> {
    /// Springs that never touch.
    pub(super) const NONE: Self = Self {
        stiffness: [0.0; L],
        mass: [0.0; L],
        mobility: [0.0; L],
        quickness: [0.0; L],
        depth: [-1.0; L],
        bend: [0.0; L],
        approach: [0.0; L],
        speedup: [0.0; L],
        own: [0.0; L],
        others: [0.0; L],
        has_touched: [false; L],
        fastest: [0.0; L],
        open: [-1.0; L],
        restitution: [0.0; L],
        speed_unit: 0.0,
        tightness: [0.0; L],
    };

    /// Puts a spring in its lane.
    pub(super) fn set(&mut self, lane: usize, spring: &Spring, units: &Units) {
        self.stiffness[lane] = units.stiffness(spring.stiffness);
        self.mass[lane] = 1.0 / (spring.mobility * units.mass);
        self.mobility[lane] = spring.mobility * units.mass;
        self.quickness[lane] = units.quickness(spring.stiffness, spring.mobility);
        self.depth[lane] = (-spring.gap / units.length()).min(0.0);
        self.has_touched[lane] = spring.gap <= TOUCH_TOLERANCE;
        self.approach[lane] = spring.approach;
        self.restitution[lane] = spring.restitution;
        self.speed_unit = units.speed;
    }

    /// Moves on by `drift`. Raises `greatest_square` to the square of the speed for which steps are
    /// chosen.
    #[inline(always)]
    pub(super) fn advance(
        &mut self,
        approach: [f64; L],
        drift: f64,
        step: &TimeStep,
        stepping: &Stepping,
        greatest_square: &mut f64,
    ) -> Compression<L> {
        let (length, trend) = (step.length, stepping.trend);
        let lead = stepping.ahead * length;
        let mut now = Compression { depth: [0.0; L], half: [0.0; L], reach: [0.0; L] };
        let mut square = [0.0; L];
        for k in 0..L {
            self.depth[k] += (approach[k] + self.bend[k] * length) * drift;
        }
        for k in 0..L {
            let speedup = approach[k] - self.approach[k];
            let next = speedup + trend * (speedup - self.speedup[k]);
            now.depth[k] = self.depth[k] + lead * next;
            self.speedup[k] = speedup;
        }
        self.approach = approach;
        for k in 0..L {
            // While the contact closes or opens within the step, the force acts in a part of it.
            now.half[k] = 0.5 * length * approach[k].abs();
            now.reach[k] = now.depth[k] + now.half[k];
        }
        for k in 0..L {
            let closing = larger(approach[k], 0.0);
            square[k] = self.quickness[k] * closing * closing;
        }
        for square in square {
            *greatest_square = larger(*greatest_square, square);
        }
        now
    }

    /// The impulse of this step in a lane that carries a force. `steady` tells whether it carried one
    /// in the last step as well.
    #[inline(always)]
    pub(super) fn impulse(
        &mut self,
        k: usize,
        steady: bool,
        now: &Compression<L>,
        step: &TimeStep,
        greatest_square: &mut f64,
    ) -> f64 {
        let (approach, speedup) = (self.approach[k], self.speedup[k]);
        let (depth, half, reach) = (now.depth[k], now.half[k], now.reach[k]);
        let last = if steady { speedup + self.own[k] } else { speedup };
        let others = if steady { last + (last - self.others[k]) } else { last };
        self.others[k] = last;
        self.has_touched[k] = true;
        let full = if depth < half {
            self.tightness[k] = self.stiffness[k] * sqrt(0.5 * reach);
            0.2 * self.stiffness[k] * reach * reach * sqrt(reach) / (half / step.length)
        } else {
            self.tightness[k] = self.stiffness[k] * sqrt(depth);
            self.tightness[k] * depth * step.length
        };
        let tension = 0.8 * self.tightness[k] * self.mobility[k] * depth * depth;
        let square = self.quickness[k] * (approach * approach + tension);
        *greatest_square = larger(*greatest_square, square);
        if approach > self.fastest[k] {
            self.fastest[k] = approach;
            self.open[k] = -1.0;
        }
        let impulse = if approach > 0.0 && approach + others >= full * self.mobility[k] {
            full
        } else {
            self.open(k, full, others)
        };
        self.own[k] = impulse * self.mobility[k];
        impulse
    }

    /// The impulse of a step in which the contact does not close all the time. `full` is that of a
    /// closing contact, and the other contacts change the approach speed by `others`.
    ///
    /// A contact that opens has e² times the force. If this is too little against the others, and
    /// the force of a closing contact too much, then the others hold the contact: it neither opens
    /// nor closes, and its force is theirs.
    #[inline(always)]
    fn open(&mut self, k: usize, full: f64, others: f64) -> f64 {
        if self.open[k] < 0.0 {
            let speed = self.fastest[k] * self.speed_unit;
            let e = restitution::effective(self.restitution[k], speed);
            self.open[k] = e * e;
        }
        let (approach, mobility) = (self.approach[k], self.mobility[k]);
        let opening = self.open[k] * full;
        let held = smaller(larger(others * self.mass[k], opening), full);
        // The part of the step until the approach speed is 0.
        let (before, part) = if approach > 0.0 {
            (full, approach / (full * mobility - others))
        } else {
            let speedup = others - opening * mobility;
            (opening, if speedup > -approach { -approach / speedup } else { 1.0 })
        };
        held + (before - held) * part
    }

    /// The spring in a lane.
    pub(super) fn at(&self, k: usize) -> SpringState {
        SpringState {
            mass: self.mass[k],
            depth: self.depth[k],
            approach: self.approach[k],
            has_touched: self.has_touched[k],
            tightness: self.tightness[k],
        }
    }

    /// The largest (speed)² of the approaches, for the choice of steps.
    pub(super) fn square_speed(&self) -> f64 {
        let mut most = 0.0;
        for k in 0..L {
            let approach = larger(self.approach[k], 0.0);
            most = larger(most, self.quickness[k] * approach * approach);
        }
        most
    }
}
