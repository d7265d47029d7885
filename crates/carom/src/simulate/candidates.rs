//! Candidates: what each ball may meet next.

use carom_roots::{Motion, Row};

use super::{Simulation, earlier};
use crate::Table;
use crate::detect::ball_ball::{ContactFinder, touching_distance};
use crate::detect::ball_table;

/// Pairs that are looked at together: one cache line, and a divisor of every capacity.
const BLOCK: usize = 8;

impl<const N: usize, F: ContactFinder> Simulation<N, F> {
    /// Finds every ball's candidates at time 0.
    pub(super) fn find_all(&mut self, table: &Table) {
        for i in 0..self.n {
            self.find_self(i, 0.0, table);
        }
        // A resting ball has no row of its own: its pairs are in the rows of those that move.
        let moves: [bool; N] = core::array::from_fn(|j| self.path[j].moves());
        for i in (0..self.n).filter(|&i| moves[i]) {
            self.find_row(i, 0.0, |j| j < i && moves[j]);
        }
        for i in 0..self.n {
            self.choose_partner(i);
        }
    }

    /// Finds anew, at `time`, the candidates of the balls in `touched`.
    pub(super) fn find(&mut self, touched: &[u16], time: f64, table: &Table) {
        for &i in touched {
            self.find_self(usize::from(i), time, table);
        }
        for (k, &i) in touched.iter().enumerate() {
            let done = &touched[..k];
            self.find_row(usize::from(i), time, |j| done.contains(&(j as u16)));
        }
        for &i in touched {
            self.choose_partner(usize::from(i));
        }
        for j in 0..self.n {
            if touched.contains(&(j as u16)) {
                continue;
            }
            if touched.contains(&self.partner[j]) {
                self.choose_partner(j);
            } else {
                for &i in touched {
                    let t = self.pair[j][usize::from(i)];
                    if t < self.contact[j] || (t == self.contact[j] && i < self.partner[j]) {
                        self.contact[j] = t;
                        self.partner[j] = i;
                    }
                }
            }
        }
    }

    /// When ball `i`'s motion state ends, and what of the table it meets before.
    #[inline(always)]
    pub(super) fn find_self(&mut self, i: usize, time: f64, table: &Table) {
        let path = &self.path[i];
        self.transition[i] = self.lanes.start[i] + path.duration;
        self.meeting[i] = f64::INFINITY;
        self.lanes.leave[i] = if path.motion.in_play() { f64::INFINITY } else { f64::NAN };
        if path.moves() {
            let motion = Motion {
                d: [path.position.x, path.position.y],
                v: [path.velocity.x, path.velocity.y],
                h: [path.half_acceleration.x, path.half_acceleration.y],
            };
            debug_assert_eq!(self.lanes.start[i], time);
            let meeting = ball_table::first_meeting(table, path.radius, &motion, path.duration);
            if let Some((t, feature)) = meeting {
                self.meeting[i] = time + t;
                self.feature[i] = feature;
            }
            self.lanes.leave[i] = earlier(self.transition[i], self.meeting[i]);
        }
    }

    /// First contacts of ball `i` with every ball for which `done` is false.
    #[inline(always)]
    fn find_row(&mut self, i: usize, time: f64, done: impl Fn(usize) -> bool) {
        for from in (0..self.n).step_by(BLOCK) {
            let row = self.row(i, from, time);
            let rejected = row.cannot_touch();
            for (k, &rejected) in rejected.iter().enumerate() {
                let j = from + k;
                if j == i || j >= self.n || done(j) {
                    continue;
                }
                let t =
                    if rejected { f64::INFINITY } else { self.first_contact(&row, i, j, k, time) };
                self.pair[i][j] = t;
                self.pair[j][i] = t;
            }
        }
    }

    /// The motions of [`BLOCK`] balls from `from` on relative to ball `i`, as of `time`.
    #[inline(always)]
    fn row(&self, i: usize, from: usize, time: f64) -> Row<BLOCK> {
        let lanes = &self.lanes;
        let age = time - lanes.start[i];
        let (x, vx) = advanced(lanes.x[i], lanes.vx[i], lanes.hx[i], age);
        let (y, vy) = advanced(lanes.y[i], lanes.vy[i], lanes.hy[i], age);
        let (hx, hy) = (lanes.hx[i], lanes.hy[i]);
        let (leave, radius) = (lanes.leave[i], lanes.radius[i]);
        let block = |lane: &[f64; N]| -> [f64; BLOCK] { core::array::from_fn(|k| lane[from + k]) };
        let (xs, ys, vxs, vys) =
            (block(&lanes.x), block(&lanes.y), block(&lanes.vx), block(&lanes.vy));
        let (hxs, hys, starts) = (block(&lanes.hx), block(&lanes.hy), block(&lanes.start));
        let (leaves, radii) = (block(&lanes.leave), block(&lanes.radius));
        let age: [f64; BLOCK] = core::array::from_fn(|k| time - starts[k]);
        let along =
            |x: &[f64; BLOCK], v: &[f64; BLOCK], h: &[f64; BLOCK], o: f64| -> [f64; BLOCK] {
                core::array::from_fn(|k| x[k] + (v[k] + h[k] * age[k]) * age[k] - o)
            };
        let speed = |v: &[f64; BLOCK], h: &[f64; BLOCK], o: f64| -> [f64; BLOCK] {
            core::array::from_fn(|k| v[k] + h[k] * (2.0 * age[k]) - o)
        };
        Row {
            dx: along(&xs, &vxs, &hxs, x),
            dy: along(&ys, &vys, &hys, y),
            vx: speed(&vxs, &hxs, vx),
            vy: speed(&vys, &hys, vy),
            hx: core::array::from_fn(|k| hxs[k] - hx),
            hy: core::array::from_fn(|k| hys[k] - hy),
            distance: core::array::from_fn(|k| radius + radii[k]),
            horizon: core::array::from_fn(|k| earlier(leave, leaves[k]) - time),
        }
    }
    #[inline(always)]
    fn first_contact(&self, row: &Row<BLOCK>, i: usize, j: usize, k: usize, time: f64) -> f64 {
        let motion = Motion {
            d: [row.dx[k], row.dy[k]],
            v: [row.vx[k], row.vy[k]],
            h: [row.hx[k], row.hy[k]],
        };
        let distance = touching_distance(self.lanes.radius[i], self.lanes.radius[j]);
        match F::first_contact(&motion, distance, row.horizon[k]) {
            Some(t) => time + t,
            None => f64::INFINITY,
        }
    }

    /// The earliest entry of row `i`; among equals the first ball.
    #[inline(always)]
    fn choose_partner(&mut self, i: usize) {
        let mut best = f64::INFINITY;
        let mut partner = 0;
        for (j, &t) in self.pair[i][..self.n].iter().enumerate() {
            if t < best {
                best = t;
                partner = j;
            }
        }
        self.contact[i] = best;
        self.partner[i] = partner as u16;
    }
}

/// Place and speed along one axis after `t` seconds on x + vt + ht².
#[inline(always)]
fn advanced(x: f64, v: f64, h: f64, t: f64) -> (f64, f64) {
    (x + (v + h * t) * t, v + h * (2.0 * t))
}
