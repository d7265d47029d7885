//! Balls that touch when one of them is hit: resolved together, in no order.

use super::impact::body;
use super::support::Support;
use super::{Simulation, earlier};
use crate::detect::ball_ball::ContactFinder;
use crate::event::{Event, EventKind, Recorder};
use crate::math::{Vec3, sqrt};
use crate::resolve::Body;
use crate::resolve::ball_ball::network::{self, MAX_BODIES, MAX_CONTACTS, Touch};
use crate::table::TOUCH_TOLERANCE;
use crate::{BallState, Physics, Table};

/// A ball hit at this approach speed, m/s, or faster takes with it the balls that it touches, or
/// nearly touches ([`CLOSING_TIME`]). In slower impacts only those contacts act together that come about in the same instant: cloth
/// friction makes thousands of them where it presses balls together, most below 1 mm/s, and
/// there each is so weak that it is settled in a bounce of its own.
const NETWORK_SPEED: f64 = 1e-2;

/// Gaps that the approach closes within this time, s, count as touching: a fifth of a contact's
/// duration (Alciatore: 250 to 300 µs). A rack whose balls are 0.1 mm apart is hit by a break as if
/// frozen, for the balls yield by 0.6 mm. Longer, and balls would seem to move before they are
/// touched; shorter, and a hundredth of a millimetre would decide how a rack breaks.
pub(crate) const CLOSING_TIME: f64 = 5e-5;

/// Slow contacts count as one instant up to this gap, m: the accuracy of their times. Wider, and
/// balls would be thrown apart that do not touch; narrower, and a symmetric rack would be pushed
/// unevenly.
const SAME_INSTANT_GAP: f64 = 1e-14;

/// Slower contacts than this, m/s, are a matter of pairs: rounding, and the beginning of a push, of
/// which the rule for pushes makes a bounce (`impact.rs`). Ten thousand times faster than what
/// counts as no speed at all.
const SLOWEST: f64 = 1e-9;

/// Balls that are looked at together, by vector instructions; every capacity is a multiple.
const BLOCK: usize = 8;

/// Balls that meet at one instant. More than fit follow in further events of that instant.
struct Cluster {
    size: usize,
    balls: [u16; MAX_BODIES],
    before: [BallState; MAX_BODIES],
    after: [BallState; MAX_BODIES],
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

    /// Leaves out the balls that the impact of `first` on `second` has not reached. These two stay: a
    /// ball hit from straight above is held by the slate, as it was.
    fn keep_struck(&mut self, [first, second]: [u16; 2]) {
        let mut kept = 0;
        for k in 0..self.size {
            let (ball, before, after) = (self.balls[k], &self.before[k], &self.after[k]);
            if ball == first
                || ball == second
                || before.velocity != after.velocity
                || before.angular_velocity != after.angular_velocity
            {
                self.balls[kept] = ball;
                self.before[kept] = self.before[k];
                self.after[kept] = self.after[k];
                kept += 1;
            }
        }
        self.size = kept;
    }
}

impl<const N: usize, F: ContactFinder> Simulation<N, F> {
    /// Two balls meet, or several that touch. Returns the number of events.
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
        if self.is_crowded(a, b, time) && self.collide_cluster(a, b, time, table, physics, recorder)
        {
            return 1;
        }
        self.collide_pair(a, b, time, table, physics, recorder)
    }

    /// Whether a third ball seems to touch `a` or `b`: no contact is missed, a few are invented.
    #[inline(always)]
    fn is_crowded(&self, a: usize, b: usize, time: f64) -> bool {
        let l = &self.lanes;
        let faster = |v: &[f64; N], h: &[f64; N]| {
            let speed = |k: usize| v[k] + 2.0 * h[k] * (time - l.start[k]);
            (speed(a) - speed(b)).abs()
        };
        let fastest = faster(&l.vx, &l.hx) + faster(&l.vy, &l.hy);
        let near = TOUCH_TOLERANCE + CLOSING_TIME * fastest;
        let (p, q) = (clearance(self.place(a, time), near), clearance(self.place(b, time), near));
        let mut close = 0;
        for first in (0..self.n).step_by(BLOCK) {
            let mut clear = [0.0; BLOCK];
            for (j, clear) in clear.iter_mut().enumerate() {
                let place = self.place(first + j, time);
                *clear = earlier(p(place), q(place));
            }
            let there = &clear[..BLOCK.min(self.n - first)];
            close += there.iter().map(|&clear| u32::from(clear <= 0.0)).sum::<u32>();
        }
        // The two themselves are there.
        close > 2
    }

    /// Where ball `k` is on the table, and its radius: x, y, R.
    #[inline(always)]
    fn place(&self, k: usize, time: f64) -> [f64; 3] {
        let l = &self.lanes;
        let t = time - l.start[k];
        let x = l.x[k] + t * (l.vx[k] + t * l.hx[k]);
        let y = l.y[k] + t * (l.vy[k] + t * l.hy[k]);
        [x, y, l.radius[k]]
    }

    /// Resolves the impact of `a` on `b` with all that they touch; `false`, and nothing is done,
    /// if it is between these two alone.
    #[cold]
    fn collide_cluster<R: Recorder>(
        &mut self,
        a: usize,
        b: usize,
        time: f64,
        table: &Table,
        physics: &Physics,
        recorder: &mut R,
    ) -> bool {
        let mut cluster = Cluster {
            size: 0,
            balls: [0; MAX_BODIES],
            before: [BallState::default(); MAX_BODIES],
            after: [BallState::default(); MAX_BODIES],
        };
        for i in [a, b] {
            cluster.add(i as u16, self.state(i, time));
        }
        let first = self.meeting_of(&cluster, 0, 1);
        if first.approach < SLOWEST {
            return false;
        }
        let together = |meeting: &Meeting| {
            if first.approach >= NETWORK_SPEED {
                meeting.gap <= TOUCH_TOLERANCE + CLOSING_TIME * first.approach
            } else {
                meeting.gap <= SAME_INSTANT_GAP && meeting.approach > 0.0
            }
        };
        // More than the gap of balls that act together, whatever the rounding.
        let reach = 2.0 * TOUCH_TOLERANCE + CLOSING_TIME * first.approach;
        self.gather(&mut cluster, time, reach, together);
        if cluster.size == 2 {
            return false;
        }
        self.resolve_cluster(&mut cluster, reach, together, physics);
        cluster.keep_struck([a as u16, b as u16]);
        if cluster.size <= 2 {
            return false;
        }
        for (&i, after) in cluster.balls().iter().zip(&cluster.after) {
            self.begin(usize::from(i), after, time, physics);
            self.touched[usize::from(i)] = time;
        }
        recorder.record(&Event {
            time,
            kind: EventKind::BallCollision,
            balls: cluster.balls(),
            before: &cluster.before[..cluster.size],
            after: &cluster.after[..cluster.size],
        });
        self.find(cluster.balls(), time, table);
        true
    }

    /// Adds every ball that acts `together` with one of the cluster's, within `reach`, and so on
    /// from those; then puts them into the order of the shot.
    fn gather(
        &self,
        cluster: &mut Cluster,
        time: f64,
        reach: f64,
        together: impl Fn(&Meeting) -> bool,
    ) {
        let places: [[f64; 3]; N] = core::array::from_fn(|k| self.place(k, time));
        let mut seen = 0;
        while seen < cluster.size {
            let near = clearance(places[usize::from(cluster.balls[seen])], reach);
            for (k, &place) in places[..self.n].iter().enumerate() {
                if near(place) > 0.0
                    || cluster.size == MAX_BODIES
                    || cluster.balls().contains(&(k as u16))
                    || !self.path[k].motion.in_play()
                {
                    continue;
                }
                cluster.balls[cluster.size] = k as u16;
                cluster.before[cluster.size] = self.state(k, time);
                if together(&self.meeting_of(cluster, seen, cluster.size)) {
                    cluster.size += 1;
                }
            }
            seen += 1;
        }
        let size = cluster.size;
        cluster.balls[..size].sort_unstable();
        for k in 0..size {
            cluster.before[k] = self.state(usize::from(cluster.balls[k]), time);
        }
    }

    /// Finds the states after the impact of all contacts among the cluster's balls.
    fn resolve_cluster(
        &self,
        cluster: &mut Cluster,
        reach: f64,
        together: impl Fn(&Meeting) -> bool,
        physics: &Physics,
    ) {
        let size = cluster.size;
        let empty =
            Body { velocity: Vec3::ZERO, angular_velocity: Vec3::ZERO, mass: 0.0, radius: 0.0 };
        let mut bodies = [empty; MAX_BODIES];
        for (k, slot) in bodies[..size].iter_mut().enumerate() {
            *slot = body(&cluster.before[k], &self.ball[usize::from(cluster.balls[k])]);
        }
        let bodies = &mut bodies[..size];
        let mut touches = [Touch { a: 0, b: 0, normal: Vec3::ZERO, gap: 0.0 }; MAX_CONTACTS];
        let mut count = 0;
        let place = |k: usize| {
            let at = cluster.before[k].position;
            [at.x, at.y, self.ball[usize::from(cluster.balls[k])].radius]
        };
        for p in 0..size {
            let near = clearance(place(p), reach);
            for q in p + 1..size {
                if near(place(q)) > 0.0 {
                    continue;
                }
                let meeting = self.meeting_of(cluster, p, q);
                if together(&meeting) && count < MAX_CONTACTS {
                    let (normal, gap) = (meeting.normal, meeting.gap);
                    touches[count] = Touch { a: p as u8, b: q as u8, normal, gap };
                    count += 1;
                }
            }
        }
        network::resolve(&physics.ball_ball, bodies, &touches[..count]);
        for (k, body) in bodies.iter().enumerate() {
            let (v, spin) = (body.velocity, body.angular_velocity);
            let (state, ball) = (&cluster.before[k], &self.ball[usize::from(cluster.balls[k])]);
            cluster.after[k] = if v == state.velocity && spin == state.angular_velocity {
                *state
            } else {
                Support::under(state).settled(state, v, spin, ball, physics)
            };
        }
    }

    fn meeting_of(&self, cluster: &Cluster, p: usize, q: usize) -> Meeting {
        let (a, b) = (&cluster.before[p], &cluster.before[q]);
        let radius = |k: usize| self.ball[usize::from(cluster.balls[k])].radius;
        let d = b.position - a.position;
        let distance = sqrt(d.length_squared());
        let normal = d * (1.0 / distance);
        Meeting {
            normal,
            gap: distance - (radius(p) + radius(q)),
            approach: (a.velocity - b.velocity).dot(normal),
        }
    }
}

/// How far another ball at [x, y, R] is clear of that at [px, py, radius] and `reach` around it, seen
/// from above: a number that is positive where it is.
#[inline(always)]
fn clearance([px, py, radius]: [f64; 3], reach: f64) -> impl Fn([f64; 3]) -> f64 {
    let near = radius + reach;
    move |[x, y, radius]| {
        let (dx, dy, near) = (x - px, y - py, radius + near);
        dx * dx + dy * dy - near * near
    }
}

/// How two balls stand to each other.
struct Meeting {
    /// Unit vector from the first one's centre to the second's.
    normal: Vec3,
    /// Between the surfaces, m.
    gap: f64,
    /// m/s.
    approach: f64,
}
