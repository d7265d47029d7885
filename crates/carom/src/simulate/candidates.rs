//! Candidate events: what each ball may meet next, and when.

use carom_roots::Motion;

use super::ball_set::BallSet;
use super::row::PossiblePartners;
use super::{Simulation, earlier};
use crate::MotionState;
use crate::detect::ball_table;
use crate::detect::{flight, rail_top};
use crate::motion::Path;
use crate::table::TableFeature;
use crate::table::TableGeometry;

/// The partner of a ball without a contact.
const NO_PARTNER: u16 = u16::MAX;

impl<const N: usize> Simulation<N> {
    /// Finds every ball's candidates at time 0.
    pub(super) fn find_all_candidates(&mut self, table: &TableGeometry) {
        for i in 0..self.n {
            self.partner[i] = NO_PARTNER;
            self.find_own_candidates(i, 0.0, table);
            if !self.path[i].moves() {
                self.make_visible(i);
            }
        }
        // A resting ball needs no search: the searches of the moving balls find its contacts.
        for i in 0..self.n {
            if self.path[i].moves() {
                self.find_contacts(i, 0.0);
            }
        }
    }

    /// Recomputes, at `time`, the candidates of the balls in `changed`, which have new paths.
    #[inline(always)]
    pub(super) fn find_candidates(&mut self, changed: &[u16], time: f64, table: &TableGeometry) {
        let mut others = BallSet::EMPTY;
        for &i in changed {
            let i = usize::from(i);
            self.contact[i] = f64::INFINITY;
            self.partner[i] = NO_PARTNER;
            self.find_own_candidates(i, time, table);
            others = others.union(self.partners[i]);
            self.partners[i] = BallSet::EMPTY;
        }
        // A ball whose next partner was one of these takes the earliest contact that is left.
        let set = BallSet::of(changed);
        for j in others.balls() {
            self.partners[j] = self.partners[j].without(set);
            if contains(changed, self.partner[j]) {
                self.choose_partner(j);
            }
        }
        for &i in changed {
            self.find_contacts(usize::from(i), time);
        }
    }

    /// Finds the time at which ball `i`'s motion state ends, and what it meets on the table before
    /// that time.
    #[inline(always)]
    pub(super) fn find_own_candidates(&mut self, i: usize, time: f64, table: &TableGeometry) {
        let path = &self.path[i];
        self.transition[i] = self.lanes.start[i] + path.duration;
        self.feature_time[i] = f64::INFINITY;
        if path.moves() {
            debug_assert_eq!(self.lanes.start[i], time);
            let meeting = if self.off_bed[i] {
                self.first_feature_off_bed(i, table)
            } else {
                ball_table::first_meeting(table, path.radius, &in_plan(path), path.duration)
            };
            if let Some((t, feature)) = meeting {
                self.feature_time[i] = time + t;
                self.feature[i] = feature;
            }
        }
        self.earliest[i] =
            earlier(earlier(self.transition[i], self.feature_time[i]), self.contact[i]);
    }

    /// Makes ball `i` take part in the searches of other balls.
    #[inline(always)]
    pub(super) fn make_visible(&mut self, i: usize) {
        self.lanes.valid_until[i] = self.valid_until(i);
    }

    /// The time until which the path of ball `i` is valid: see
    /// [`Lanes::valid_until`](super::Lanes).
    #[inline(always)]
    pub(super) fn valid_until(&self, i: usize) -> f64 {
        let path = &self.path[i];
        if path.moves() {
            earlier(self.transition[i], self.feature_time[i])
        } else if path.motion.in_play() {
            f64::INFINITY
        } else {
            f64::NAN
        }
    }

    /// Finds the first contacts of ball `i` with all visible balls, then makes it visible itself.
    #[inline(always)]
    fn find_contacts(&mut self, i: usize, time: f64) {
        if !self.path[i].motion.in_play() {
            return;
        }
        #[cfg(feature = "peers")]
        if let Some(peer) = super::peer::PeerFinder::chosen() {
            self.find_contacts_by(peer, i, time);
            return;
        }
        let mut possible = PossiblePartners::NONE;
        possible.search(&self.lanes, i, self.valid_until(i), self.n, time, self.wide);
        self.add_contacts(i, &possible, time, carom_roots::first_contact);
    }

    /// Stores the contacts of ball `i` with the balls of `possible`, then makes it visible itself.
    #[inline(always)]
    pub(super) fn add_contacts(
        &mut self,
        i: usize,
        possible: &PossiblePartners<N>,
        time: f64,
        first_contact: impl Fn(&Motion<2>, f64, f64) -> Option<f64>,
    ) {
        self.make_visible(i);
        for &j in possible.balls() {
            let j = usize::from(j);
            let (motion, distance, horizon) = self.lanes.pair(i, j, time);
            let contact = if self.off_bed[i] || self.off_bed[j] {
                self.first_contact_off_bed(i, j, &motion, time, horizon)
            } else {
                first_contact(&motion, distance, horizon)
            };
            if let Some(t) = contact {
                self.add_contact(i, j, time + t);
            }
        }
    }

    /// The first feature of the table that a ball off the bed meets.
    #[cold]
    fn first_feature_off_bed(
        &self,
        i: usize,
        table: &TableGeometry,
    ) -> Option<(f64, TableFeature)> {
        let path = &self.path[i];
        if path.motion != MotionState::Airborne {
            return rail_top::first_loss_of_support(table, &in_plan(path), path.duration);
        }
        let motion = Motion {
            d: path.position.to_array(),
            v: path.velocity.to_array(),
            h: path.half_acceleration.to_array(),
        };
        flight::first_meeting(table, path.radius, &motion, path.duration)
    }

    /// First contact of two balls of which at least one is off the bed. `plan` is their relative
    /// motion seen from above.
    #[cold]
    fn first_contact_off_bed(
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

    /// Stores that balls `i` and `j` meet at time `t`, s.
    #[inline(always)]
    fn add_contact(&mut self, i: usize, j: usize, t: f64) {
        for (a, b) in [(i, j), (j, i)] {
            self.pair[a][b] = t;
            self.partners[a] = self.partners[a].with(b);
            let b = b as u16;
            if t < self.contact[a] || (t == self.contact[a] && b < self.partner[a]) {
                self.contact[a] = t;
                self.partner[a] = b;
                self.earliest[a] = earlier(t, self.earliest[a]);
            }
        }
    }

    /// Takes the earliest contact of ball `i`; of equal times the one with the lowest index.
    #[inline(always)]
    fn choose_partner(&mut self, i: usize) {
        let mut best = f64::INFINITY;
        let mut partner = NO_PARTNER;
        for j in self.partners[i].balls() {
            let t = self.pair[i][j];
            if t < best {
                best = t;
                partner = j as u16;
            }
        }
        self.contact[i] = best;
        self.partner[i] = partner;
        self.earliest[i] = earlier(earlier(self.transition[i], self.feature_time[i]), best);
    }
}

/// The path seen from above.
#[inline(always)]
fn in_plan(path: &Path) -> Motion<2> {
    Motion {
        d: [path.position.x, path.position.y],
        v: [path.velocity.x, path.velocity.y],
        h: [path.half_acceleration.x, path.half_acceleration.y],
    }
}

/// Whether a list, mostly of one or two balls, contains `ball`.
#[inline(always)]
#[expect(
    clippy::manual_contains,
    reason = "`<[_]>::contains` is written for long lists; here it took 15 % of a break"
)]
fn contains(list: &[u16], ball: u16) -> bool {
    list.iter().any(|&b| b == ball)
}
