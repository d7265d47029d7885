//! Candidates: what each ball may meet next.

use carom_roots::{Motion, Row};

use super::{Simulation, earlier};
use crate::Table;
use crate::detect::ball_ball::{ContactFinder, touching_distance};
use crate::detect::ball_table;

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
        let row = self.row(i, time);
        let margins = row.margins();
        for (j, &margin) in margins[..self.n].iter().enumerate() {
            if j == i || done(j) {
                continue;
            }
            let t = if margin < 0.0 { self.first_contact(&row, i, j, time) } else { f64::INFINITY };
            self.pair[i][j] = t;
            self.pair[j][i] = t;
        }
    }

    /// The motions of all balls relative to ball `i`, as of `time`.
    #[inline(always)]
    fn row(&self, i: usize, time: f64) -> Row<N> {
        let lanes = &self.lanes;
        let mut row = Row {
            dx: [0.0; N],
            dy: [0.0; N],
            vx: [0.0; N],
            vy: [0.0; N],
            hx: [0.0; N],
            hy: [0.0; N],
            distance: [0.0; N],
            horizon: [0.0; N],
        };
        let age = time - lanes.start[i];
        let (x, vx) = advanced(lanes.x[i], lanes.vx[i], lanes.hx[i], age);
        let (y, vy) = advanced(lanes.y[i], lanes.vy[i], lanes.hy[i], age);
        let (leave, radius) = (lanes.leave[i], lanes.radius[i]);
        for j in 0..N {
            let age = time - lanes.start[j];
            let (xj, vxj) = advanced(lanes.x[j], lanes.vx[j], lanes.hx[j], age);
            let (yj, vyj) = advanced(lanes.y[j], lanes.vy[j], lanes.hy[j], age);
            row.dx[j] = xj - x;
            row.dy[j] = yj - y;
            row.vx[j] = vxj - vx;
            row.vy[j] = vyj - vy;
            row.hx[j] = lanes.hx[j] - lanes.hx[i];
            row.hy[j] = lanes.hy[j] - lanes.hy[i];
            row.distance[j] = radius + lanes.radius[j];
            row.horizon[j] = earlier(leave, lanes.leave[j]) - time;
        }
        row
    }
    #[inline(always)]
    fn first_contact(&self, row: &Row<N>, i: usize, j: usize, time: f64) -> f64 {
        let motion = Motion {
            d: [row.dx[j], row.dy[j]],
            v: [row.vx[j], row.vy[j]],
            h: [row.hx[j], row.hy[j]],
        };
        let distance = touching_distance(self.lanes.radius[i], self.lanes.radius[j]);
        match F::first_contact(&motion, distance, row.horizon[j]) {
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
