//! Candidates: what each ball may meet next.

use carom_roots::Motion;

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
        for i in 0..self.n {
            if self.path[i].moves() {
                self.find_row(i, 0.0, |j| j < i);
            }
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
        self.transition[i] = self.start[i] + path.duration;
        self.meeting[i] = f64::INFINITY;
        self.leave[i] = f64::INFINITY;
        if path.moves() {
            let motion = Motion {
                d: [path.position.x, path.position.y],
                v: [path.velocity.x, path.velocity.y],
                h: [path.half_acceleration.x, path.half_acceleration.y],
            };
            debug_assert_eq!(self.start[i], time);
            let meeting = ball_table::first_meeting(table, path.radius, &motion, path.duration);
            if let Some((t, feature)) = meeting {
                self.meeting[i] = time + t;
                self.feature[i] = feature;
            }
            self.leave[i] = earlier(self.transition[i], self.meeting[i]);
        }
    }

    /// First contacts of ball `i` with every ball for which `done` is false.
    #[inline(always)]
    fn find_row(&mut self, i: usize, time: f64, done: impl Fn(usize) -> bool) {
        let moves = self.path[i].moves();
        let in_play = self.path[i].motion.in_play();
        for j in 0..self.n {
            if j == i || done(j) {
                continue;
            }
            let other = &self.path[j];
            let t = if in_play && other.motion.in_play() && (moves || other.moves()) {
                self.first_contact(i, j, time)
            } else {
                f64::INFINITY
            };
            self.pair[i][j] = t;
            self.pair[j][i] = t;
        }
    }

    #[inline(always)]
    fn first_contact(&self, i: usize, j: usize, time: f64) -> f64 {
        let (a, b) = (&self.path[i], &self.path[j]);
        let (ta, tb) = (time - self.start[i], time - self.start[j]);
        let d = b.position_at(tb) - a.position_at(ta);
        let v = b.velocity_at(tb) - a.velocity_at(ta);
        let h = b.half_acceleration - a.half_acceleration;
        let motion = Motion { d: [d.x, d.y], v: [v.x, v.y], h: [h.x, h.y] };
        let distance = touching_distance(a.radius, b.radius);
        let horizon = earlier(self.leave[i], self.leave[j]) - time;
        match F::first_contact(&motion, distance, horizon) {
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
