//! Contacts that share a ball in the same instant: resolved together, in no order.

use super::Simulation;
use super::impact::body;
use super::support::Support;
use crate::detect::ball_ball::ContactFinder;
use crate::event::{Event, EventKind, Recorder};
use crate::math::Vec3;
use crate::resolve::Body;
use crate::resolve::ball_ball::group;
use crate::{BallState, Physics, Table};

/// Contacts count as one instant up to this gap, m: the accuracy of their times. Wider, and balls
/// would be thrown apart that do not touch; narrower, and a symmetric rack would break unevenly.
const SAME_INSTANT_GAP: f64 = 1e-14;

/// Contacts later than this, s, are not even looked at: beyond it a ball that approaches faster
/// than 1e-5 m/s is more than [`SAME_INSTANT_GAP`] away.
const SAME_INSTANT_TIME: f64 = 1e-9;

/// Most balls in one cluster; more follow as further events of the same instant.
const MAX_MEMBERS: usize = 24;

/// Balls that meet at one instant, and how.
struct Cluster {
    size: usize,
    balls: [u16; MAX_MEMBERS],
    before: [BallState; MAX_MEMBERS],
}

impl Cluster {
    fn add(&mut self, ball: u16, state: BallState) {
        self.balls[self.size] = ball;
        self.before[self.size] = state;
        self.size += 1;
    }
    fn balls(&self) -> &[u16] {
        &self.balls[..self.size]
    }
}

impl<const N: usize, F: ContactFinder> Simulation<N, F> {
    /// Two balls meet, or several in the same instant.
    #[inline(always)]
    pub(super) fn collide<R: Recorder>(
        &mut self,
        i: usize,
        j: usize,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let (a, b) = (i.min(j), i.max(j));
        let soon = time + SAME_INSTANT_TIME;
        let alone = (0..self.n)
            .all(|k| k == a || k == b || (self.pair[a][k] > soon && self.pair[b][k] > soon));
        if alone {
            self.collide_pair(a, b, time, table, physics, recorder)
        } else {
            self.collide_cluster(a, b, time, table, physics, recorder)
        }
    }

    #[cold]
    fn collide_cluster<R: Recorder>(
        &mut self,
        a: usize,
        b: usize,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> u32 {
        let mut cluster = Cluster {
            size: 0,
            balls: [0; MAX_MEMBERS],
            before: [BallState::default(); MAX_MEMBERS],
        };
        for i in [a, b] {
            cluster.add(i as u16, self.state(i, time));
        }
        self.gather(&mut cluster, time);
        if cluster.size == 2 {
            return self.collide_pair(a, b, time, table, physics, recorder);
        }
        let mut after = [BallState::default(); MAX_MEMBERS];
        let first = [a as u16, b as u16];
        self.resolve_cluster(&mut cluster, &mut after, first, time, table, physics);
        for (&i, after) in cluster.balls().iter().zip(&after) {
            self.begin(usize::from(i), after, time, physics);
            self.touched[usize::from(i)] = time;
        }
        recorder.record(&Event {
            time,
            kind: EventKind::BallCollision,
            balls: cluster.balls(),
            before: &cluster.before[..cluster.size],
            after: &after[..cluster.size],
        });
        self.find(cluster.balls(), time, table);
        1
    }

    /// The states after the impact of all contacts among the cluster's balls. `first` is the
    /// contact that brought them here.
    fn resolve_cluster(
        &self,
        cluster: &mut Cluster,
        after: &mut [BallState; MAX_MEMBERS],
        first: [u16; 2],
        time: f64,
        table: &Table,
        physics: &Physics,
    ) {
        let size = cluster.size;
        cluster.balls[..size].sort_unstable();
        let mut bodies = [EMPTY; MAX_MEMBERS];
        for (k, slot) in bodies[..size].iter_mut().enumerate() {
            let i = usize::from(cluster.balls[k]);
            cluster.before[k] = self.state(i, time);
            *slot = body(&cluster.before[k], &self.ball[i]);
        }
        let bodies = &mut bodies[..size];
        let mut contacts = [(0, 0, Vec3::ZERO); group::MAX_CONTACTS];
        let mut count = 0;
        for p in 0..size {
            for q in p + 1..size {
                let meeting =
                    Meeting::of(&cluster.before[p], &cluster.before[q], &bodies[p], &bodies[q]);
                let due = meeting.due() || [cluster.balls[p], cluster.balls[q]] == first;
                if due && count < contacts.len() {
                    contacts[count] = (p as u8, q as u8, meeting.normal);
                    count += 1;
                }
            }
        }
        let contacts = &contacts[..count];
        group::resolve_group(&physics.ball_ball, &physics.cloth, physics.gravity, bodies, contacts);
        for (k, body) in bodies.iter().enumerate() {
            let (v, spin) = (body.velocity, body.angular_velocity);
            let (state, ball) = (&cluster.before[k], &self.ball[usize::from(cluster.balls[k])]);
            after[k] = Support::under(state, ball, table).settled(state, v, spin, ball, physics);
        }
    }

    /// Adds every ball that meets one of the cluster's at `time`, and so on from those.
    fn gather(&self, cluster: &mut Cluster, time: f64) {
        let mut seen = 0;
        while seen < cluster.size {
            let i = usize::from(cluster.balls[seen]);
            let a = cluster.before[seen];
            seen += 1;
            for k in 0..self.n {
                let known = cluster.balls().contains(&(k as u16));
                if known
                    || cluster.size == MAX_MEMBERS
                    || self.pair[i][k] > time + SAME_INSTANT_TIME
                {
                    continue;
                }
                let b = self.state(k, time);
                let (p, q) = (body(&a, &self.ball[i]), body(&b, &self.ball[k]));
                if Meeting::of(&a, &b, &p, &q).due() {
                    cluster.add(k as u16, b);
                }
            }
        }
    }
}

/// A place in a list that is not filled.
const EMPTY: Body =
    Body { velocity: Vec3::ZERO, angular_velocity: Vec3::ZERO, mass: 0.0, radius: 0.0 };

/// How two balls stand to each other.
struct Meeting {
    /// Unit vector from the first one's centre to the second's.
    normal: Vec3,
    /// Between the surfaces, m.
    gap: f64,
    /// m/s.
    approach: f64,
}

impl Meeting {
    fn of(a: &BallState, b: &BallState, p: &Body, q: &Body) -> Self {
        let d = b.position - a.position;
        let normal = d * (1.0 / d.length());
        Self {
            normal,
            gap: d.length() - (p.radius + q.radius),
            approach: (a.velocity - b.velocity).dot(normal),
        }
    }

    /// Whether they meet in this instant.
    fn due(&self) -> bool {
        self.gap <= SAME_INSTANT_GAP && self.approach > 0.0
    }
}
