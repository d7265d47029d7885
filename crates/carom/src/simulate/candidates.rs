//! Candidates: what each ball may meet next.

use carom_roots::Motion;

use super::ball_set::BallSet;
use super::row::Open;
use super::{Simulation, earlier};
use crate::detect::ball_ball::ContactFinder;
use crate::detect::ball_table::{self, TableFeature};
use crate::detect::{flight, rail_top};
use crate::motion::Path;
use crate::{MotionState, Table};

/// The partner of a ball that is to meet none.
const NOBODY: u16 = u16::MAX;

impl<const N: usize, F: ContactFinder> Simulation<N, F> {
    /// Finds every ball's candidates at time 0.
    pub(super) fn find_all(&mut self, table: &Table) {
        for i in 0..self.n {
            self.partner[i] = NOBODY;
            self.find_self(i, 0.0, table);
            if !self.path[i].moves() {
                self.enter_lanes(i);
            }
        }
        // A resting ball has no row of its own: its pairs are in the rows of those that move.
        for i in 0..self.n {
            if self.path[i].moves() {
                self.find_row(i, 0.0);
            }
        }
    }

    /// Finds anew, at `time`, the candidates of the balls in `touched`.
    #[inline(always)]
    pub(super) fn find(&mut self, touched: &[u16], time: f64, table: &Table) {
        let mut forsaken = BallSet::EMPTY;
        for &i in touched {
            let i = usize::from(i);
            self.contact[i] = f64::INFINITY;
            self.partner[i] = NOBODY;
            self.find_self(i, time, table);
            forsaken = forsaken.and(self.may_meet[i]);
            self.may_meet[i] = BallSet::EMPTY;
        }
        // Who was to meet a touched ball looks through what is left in its row.
        let changed = BallSet::of(touched);
        for j in forsaken.balls() {
            self.may_meet[j] = self.may_meet[j].without(changed);
            if holds(touched, self.partner[j]) {
                self.choose_partner(j);
            }
        }
        for &i in touched {
            self.find_row(usize::from(i), time);
        }
    }

    /// When ball `i`'s motion state ends, and what of the table it meets before.
    #[inline(always)]
    pub(super) fn find_self(&mut self, i: usize, time: f64, table: &Table) {
        let path = &self.path[i];
        self.transition[i] = self.lanes.start[i] + path.duration;
        self.meeting[i] = f64::INFINITY;
        if path.moves() {
            debug_assert_eq!(self.lanes.start[i], time);
            let meeting = if self.aloft[i] {
                self.first_meeting_aloft(i, table)
            } else {
                ball_table::first_meeting(table, path.radius, &in_plan(path), path.duration)
            };
            if let Some((t, feature)) = meeting {
                self.meeting[i] = time + t;
                self.feature[i] = feature;
            }
        }
        self.soonest[i] = earlier(earlier(self.transition[i], self.meeting[i]), self.contact[i]);
    }

    /// Puts ball `i` into the lanes, so that it is in the rows of other balls.
    #[inline(always)]
    pub(super) fn enter_lanes(&mut self, i: usize) {
        self.lanes.leave[i] = self.leaves_at(i);
    }

    /// Until when other balls may rely on the path of ball `i`: see [`Lanes::leave`](super::Lanes).
    #[inline(always)]
    fn leaves_at(&self, i: usize) -> f64 {
        let path = &self.path[i];
        if path.moves() {
            earlier(self.transition[i], self.meeting[i])
        } else if path.motion.in_play() {
            f64::INFINITY
        } else {
            f64::NAN
        }
    }

    /// First contacts of ball `i`, which is not in the lanes yet, with all that are; then it enters them.
    #[inline(always)]
    fn find_row(&mut self, i: usize, time: f64) {
        if !self.path[i].motion.in_play() {
            return;
        }
        let mut open = Open::NONE;
        if F::PROOFS {
            open.look(&self.lanes, (i, self.leaves_at(i)), self.n, time, self.wide);
        } else {
            open.fill(&self.lanes, self.n);
        }
        self.enter_lanes(i);
        for &j in open.balls() {
            let j = usize::from(j);
            let (motion, distance, horizon) = self.lanes.pair(i, j, time);
            let contact = if self.aloft[i] || self.aloft[j] {
                self.first_contact_aloft(i, j, &motion, time, horizon)
            } else {
                F::first_contact(&motion, distance, horizon)
            };
            if let Some(t) = contact {
                self.meet(i, j, time + t);
            }
        }
    }

    /// What of the table a ball off the slate meets first.
    #[cold]
    fn first_meeting_aloft(&self, i: usize, table: &Table) -> Option<(f64, TableFeature)> {
        let path = &self.path[i];
        if path.motion != MotionState::Airborne {
            return rail_top::first_leaving(table, &in_plan(path), path.duration);
        }
        let motion = Motion {
            d: path.position.to_array(),
            v: path.velocity.to_array(),
            h: path.half_acceleration.to_array(),
        };
        flight::first_meeting(table, path.radius, &motion, path.duration)
    }

    /// First contact of two balls of which one is off the slate, `plan` being their relative motion seen
    /// from above.
    #[cold]
    fn first_contact_aloft(
        &self,
        i: usize,
        j: usize,
        plan: &Motion<2>,
        time: f64,
        horizon: f64,
    ) -> Option<f64> {
        let height = |k: usize| {
            let (path, age) = (&self.path[k], time - self.lanes.start[k]);
            (path.position_at(age).z, path.velocity_at(age).z, path.half_acceleration.z)
        };
        let ((zi, vi, hi), (zj, vj, hj)) = (height(i), height(j));
        let motion = Motion {
            d: [plan.d[0], plan.d[1], zj - zi],
            v: [plan.v[0], plan.v[1], vj - vi],
            h: [plan.h[0], plan.h[1], hj - hi],
        };
        let distance = self.ball[i].radius + self.ball[j].radius;
        carom_roots::first_contact(&motion, distance, horizon)
    }

    /// Notes that balls `i` and `j` are to meet at `t`.
    #[inline(always)]
    fn meet(&mut self, i: usize, j: usize, t: f64) {
        for (a, b) in [(i, j), (j, i)] {
            self.pair[a][b] = t;
            self.may_meet[a] = self.may_meet[a].with(b);
            let b = b as u16;
            if t < self.contact[a] || (t == self.contact[a] && b < self.partner[a]) {
                self.contact[a] = t;
                self.partner[a] = b;
                self.soonest[a] = earlier(t, self.soonest[a]);
            }
        }
    }

    /// The earliest entry of row `i`; among equals the first ball.
    #[inline(always)]
    fn choose_partner(&mut self, i: usize) {
        let mut best = f64::INFINITY;
        let mut partner = NOBODY;
        for j in self.may_meet[i].balls() {
            let t = self.pair[i][j];
            if t < best {
                best = t;
                partner = j as u16;
            }
        }
        self.contact[i] = best;
        self.partner[i] = partner;
        self.soonest[i] = earlier(earlier(self.transition[i], self.meeting[i]), best);
    }
}

/// A path seen from above.
#[inline(always)]
fn in_plan(path: &Path) -> Motion<2> {
    Motion {
        d: [path.position.x, path.position.y],
        v: [path.velocity.x, path.velocity.y],
        h: [path.half_acceleration.x, path.half_acceleration.y],
    }
}

/// Whether a list, mostly of one or two, holds `ball`.
#[inline(always)]
#[expect(
    clippy::manual_contains,
    reason = "`contains` calls a search meant for long lists: 15 % of a break"
)]
fn holds(list: &[u16], ball: u16) -> bool {
    list.iter().any(|&b| b == ball)
}
