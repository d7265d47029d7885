//! Clusters: balls that touch when one of them is hit. Their contacts are resolved together, not
//! one after another.

use super::step::StepContext;
use super::support::Support;
use super::{Simulation, SimulationError, earlier};
use crate::event::{EventKind, Recorder};
use crate::math::{Vec3, sqrt};
use crate::resolve::Body;
use crate::resolve::cue_ball::{self, Strike};
use crate::resolve::network::{
    MAX_BODIES, MAX_CONTACTS, NetworkImpact, TipReport, TipTouch, Touch, WallTouch,
    stiffness_of_time,
};
use crate::table::TOUCH_TOLERANCE;
use crate::{Ball, BallState, Physics};

/// An impact with at least this approach speed, m/s, is resolved together with all contacts of
/// balls that touch or nearly touch ([`CLOSING_TIME`]). A slower impact is resolved together with
/// contacts of the same instant only. Friction of the cloth causes thousands of slow contacts where
/// it presses balls together, most below 1 mm/s; each is so weak that it can be resolved alone.
const NETWORK_SPEED: f64 = 1e-2;

/// Gaps that the approach closes within this time, s, count as touching: a fifth of a contact's
/// duration (Alciatore: 250 to 300 µs). In a break, a rack with gaps of 0.1 mm acts as if it were
/// frozen, because the balls are compressed by 0.6 mm. Longer, and balls would visibly move before
/// they are touched; shorter, and a gap of 0.01 mm would change the result of a break.
pub(crate) const CLOSING_TIME: f64 = 5e-5;

/// Slow contacts belong to one instant if their gap is at most this, m: the accuracy of contact
/// times. Wider, and balls that do not touch would be pushed apart; narrower, and a symmetric rack
/// would move asymmetrically.
const SAME_INSTANT_GAP: f64 = 1e-14;

/// Contacts slower than this, m/s, are always resolved as pairs: they are rounding errors, or the
/// beginning of a persistent contact (`persistent_contact.rs`). It is ten thousand times the speed
/// that counts as 0.
const SLOWEST: f64 = 1e-9;

/// A disc infinitely far away: x, y, R.
const AWAY: [f64; 3] = [f64::INFINITY, 0.0, 0.0];

/// Number of balls tested together by vector instructions. It divides every capacity.
const BLOCK: usize = 8;

/// Balls that meet at one instant. Any that do not fit follow in further events of the same
/// instant.
struct Cluster {
    size: usize,
    balls: [u16; MAX_BODIES],
    before: [BallState; MAX_BODIES],
    after: [BallState; MAX_BODIES],
}

impl Cluster {
    /// A cluster of one ball.
    fn of(ball: u16, state: BallState) -> Self {
        let mut cluster = Self {
            size: 0,
            balls: [0; MAX_BODIES],
            before: [BallState::default(); MAX_BODIES],
            after: [BallState::default(); MAX_BODIES],
        };
        cluster.add(ball, state);
        cluster
    }

    fn add(&mut self, ball: u16, state: BallState) {
        self.balls[self.size] = ball;
        self.before[self.size] = state;
        self.size += 1;
    }

    fn balls(&self) -> &[u16] {
        &self.balls[..self.size]
    }

    /// The states before and after the impact.
    fn states(&self) -> (&[BallState], &[BallState]) {
        (&self.before[..self.size], &self.after[..self.size])
    }

    /// The place of `ball` in the cluster.
    fn place_of(&self, ball: u16) -> u8 {
        self.balls().iter().take_while(|&&b| b != ball).count() as u8
    }

    /// Moves `ball` to the first place; the others keep their order.
    fn put_first(&mut self, ball: u16) {
        let place = usize::from(self.place_of(ball));
        self.balls[..=place].rotate_right(1);
        self.before[..=place].rotate_right(1);
        self.after[..=place].rotate_right(1);
    }

    /// Removes the balls whose velocities have not changed. `first` and `second`, whose contact is
    /// the cause, stay in any case: a ball hit from straight above does not move, but takes part.
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

/// The event of a strike in a network.
fn strike_event(report: &TipReport) -> EventKind {
    EventKind::CueStrike {
        tip_contacts: report.contacts.clamp(1, u32::from(u8::MAX)) as u8,
        pushed: report.pushes,
    }
}

/// The slate under the ball at the place `own` of a cluster.
fn slate_under(own: u8, ball: &Ball, physics: &Physics) -> WallTouch {
    let Physics { slate, contact_times, .. } = physics;
    WallTouch {
        ball: own,
        normal: Vec3::new(0.0, 0.0, -1.0),
        stiffness: stiffness_of_time(ball.mass, contact_times.slate),
        restitution: slate.restitution,
        friction: slate.friction,
        frequency_ratio: None,
    }
}

impl<const N: usize> Simulation<N> {
    /// Two balls meet, or several that touch.
    #[inline(always)]
    pub(super) fn on_ball_contact<R: Recorder>(
        &mut self,
        i: usize,
        j: usize,
        step: &mut StepContext<'_, R>,
    ) {
        let (a, b) = (i.min(j), i.max(j));
        if self.is_crowded(a, b, step.time) && self.on_cluster_contact(a, b, step) {
            return;
        }
        self.on_pair_contact(a, b, step);
    }

    /// Whether a third ball may touch `a` or `b`. Conservative: false positives are possible, false
    /// negatives are not.
    #[inline(always)]
    fn is_crowded(&self, a: usize, b: usize, time: f64) -> bool {
        let l = &self.lanes;
        let relative_speed = |v: &[f64; N], h: &[f64; N]| {
            let speed = |k: usize| v[k] + 2.0 * h[k] * (time - l.start[k]);
            (speed(a) - speed(b)).abs()
        };
        // An upper bound of the approach speed.
        let fastest = relative_speed(&l.vx, &l.hx) + relative_speed(&l.vy, &l.hy);
        let near = TOUCH_TOLERANCE + CLOSING_TIME * fastest;
        let (p, q) = (clearance(self.disc(a, time), near), clearance(self.disc(b, time), near));
        let mut close = 0;
        for first in (0..self.n).step_by(BLOCK) {
            let mut clear = [0.0; BLOCK];
            for (j, clear) in clear.iter_mut().enumerate() {
                let disc = self.disc(first + j, time);
                *clear = earlier(p(disc), q(disc));
            }
            let present = &clear[..BLOCK.min(self.n - first)];
            close += present.iter().map(|&clear| u32::from(clear <= 0.0)).sum::<u32>();
        }
        // `a` and `b` themselves are close.
        close > 2
    }

    /// Position of ball `k` in the table plane and its radius: x, y, R, m.
    #[inline(always)]
    fn disc(&self, k: usize, time: f64) -> [f64; 3] {
        let l = &self.lanes;
        let t = time - l.start[k];
        let x = l.x[k] + t * (l.vx[k] + t * l.hx[k]);
        let y = l.y[k] + t * (l.vy[k] + t * l.hy[k]);
        [x, y, l.radius[k]]
    }

    /// Resolves the impact of `a` on `b` together with the balls that touch them. Returns `false`,
    /// and changes nothing, if there are no such balls.
    #[cold]
    fn on_cluster_contact<R: Recorder>(
        &mut self,
        a: usize,
        b: usize,
        step: &mut StepContext<'_, R>,
    ) -> bool {
        let time = step.time;
        let mut cluster = Cluster::of(a as u16, self.state(a, time));
        cluster.add(b as u16, self.state(b, time));
        let first = self.proximity(&cluster, 0, 1);
        if first.approach < SLOWEST {
            return false;
        }
        let together = |proximity: &Proximity| {
            if first.approach >= NETWORK_SPEED {
                proximity.gap <= TOUCH_TOLERANCE + CLOSING_TIME * first.approach
            } else {
                proximity.gap <= SAME_INSTANT_GAP && proximity.approach > 0.0
            }
        };
        // More than the largest gap of balls that act together, with a margin for rounding.
        let reach = 2.0 * TOUCH_TOLERANCE + CLOSING_TIME * first.approach;
        self.gather(&mut cluster, time, reach, together);
        if cluster.size == 2 {
            return false;
        }
        let all = |_: usize, _: usize, proximity: &Proximity| together(proximity);
        self.resolve_cluster(&mut cluster, reach, all, &[], None, step.physics);
        cluster.keep_struck([a as u16, b as u16]);
        if cluster.size <= 2 {
            return false;
        }
        self.begin_paths(&cluster, step);
        let (before, after) = cluster.states();
        step.record(EventKind::BallCollision, cluster.balls(), before, after);
        self.find_candidates(cluster.balls(), time, step.table);
        true
    }

    /// The cue strikes the resting ball `struck`, together with the slate that it presses the ball on
    /// and the balls that touch it. Alone, the tip would give the ball `velocity`.
    /// Returns `false`, and changes nothing, if it does act alone.
    ///
    /// # Errors
    /// If the strike cannot be played.
    pub(super) fn on_network_strike<R: Recorder>(
        &mut self,
        struck: usize,
        strike: &Strike,
        velocity: Vec3,
        step: &mut StepContext<'_, R>,
    ) -> Result<bool, SimulationError> {
        let (time, physics) = (step.time, step.physics);
        let speed = velocity.length();
        // While the tip is on the ball, the ball moves about half as far as at its final speed.
        let pushed = TOUCH_TOLERANCE + 0.5 * physics.contact_times.tip * speed;
        let closing = TOUCH_TOLERANCE + CLOSING_TIME * speed;
        let reach = TOUCH_TOLERANCE + pushed.max(closing);
        let is_pressed = velocity.z < 0.0;
        let near = clearance(self.disc(struck, time), reach);
        if (0..self.n).all(|k| k == struck || near(self.disc(k, time)) > 0.0) {
            if is_pressed {
                self.on_strike_on_slate(struck, strike, step)?;
            }
            return Ok(is_pressed);
        }
        let mut cluster = Cluster::of(struck as u16, self.state(struck, time));
        let is_met = |p: &Proximity| p.gap <= pushed && velocity.dot(p.normal) > 0.0;
        let mut free = self.free_discs(&cluster, time);
        self.gather_around(&mut cluster, 0, &mut free, time, reach, is_met);
        if cluster.size == 1 && !is_pressed {
            return Ok(false);
        }
        self.gather(&mut cluster, time, reach, |p| p.gap <= closing);
        let own = cluster.place_of(struck as u16);
        let slate = [slate_under(own, &self.ball[struck], physics)];
        let walls = if is_pressed { &slate[..] } else { &[] };
        let Physics { cue, contact_times, .. } = physics;
        let tip = cue_ball::tip_touch(cue, &self.ball[struck], strike, contact_times.tip, own)
            .map_err(SimulationError::Strike)?;
        let together = |p: usize, q: usize, proximity: &Proximity| {
            let widest = if [p, q].contains(&usize::from(own)) { pushed } else { closing };
            proximity.gap <= widest
        };
        let report = self.resolve_cluster(&mut cluster, reach, together, walls, Some(tip), physics);
        cluster.keep_struck([struck as u16; 2]);
        cluster.put_first(struck as u16);
        self.begin_paths(&cluster, step);
        let (before, after) = cluster.states();
        step.record(strike_event(&report), cluster.balls(), before, after);
        Ok(true)
    }

    /// The cue strikes the resting ball `struck`, far from all others, and presses it on the slate.
    ///
    /// # Errors
    /// If the strike cannot be played.
    fn on_strike_on_slate<R: Recorder>(
        &mut self,
        struck: usize,
        strike: &Strike,
        step: &mut StepContext<'_, R>,
    ) -> Result<(), SimulationError> {
        let (physics, ball) = (step.physics, self.ball[struck]);
        let before = self.state(struck, step.time);
        let tip = cue_ball::tip_touch(&physics.cue, &ball, strike, physics.contact_times.tip, 0)
            .map_err(SimulationError::Strike)?;
        let mut bodies = [Body::new(&ball, &before)];
        let walls = &[slate_under(0, &ball, physics)];
        let impact = NetworkImpact { law: &physics.ball_ball, touches: &[], walls, tip: Some(tip) };
        let report = impact.resolve(&mut bodies, &mut self.network).unwrap_or_default();
        let [Body { velocity, angular_velocity, .. }] = bodies;
        let support = Support::under(&before);
        let after = support.settled(&before, velocity, angular_velocity, &ball, physics);
        self.begin_path(struck, &after, step);
        self.push[struck].touch(step.time);
        step.record(strike_event(&report), &[struck as u16], &[before], &[after]);
        Ok(())
    }

    /// Gives the balls of a cluster their new paths.
    fn begin_paths<R>(&mut self, cluster: &Cluster, step: &StepContext<'_, R>) {
        for (&i, after) in cluster.balls().iter().zip(&cluster.after) {
            self.begin_path(usize::from(i), after, step);
            self.push[usize::from(i)].touch(step.time);
        }
    }

    /// Adds every ball within `reach` (m) that acts `together` with a ball of the cluster, then those
    /// that act together with the added balls, and so on. Finally sorts the balls in the shot's
    /// order.
    fn gather(
        &self,
        cluster: &mut Cluster,
        time: f64,
        reach: f64,
        together: impl Fn(&Proximity) -> bool,
    ) {
        let mut free = self.free_discs(cluster, time);
        let mut visited = 0;
        while visited < cluster.size {
            self.gather_around(cluster, visited, &mut free, time, reach, &together);
            visited += 1;
        }
        let size = cluster.size;
        cluster.balls[..size].sort_unstable();
        for k in 0..size {
            cluster.before[k] = self.state(usize::from(cluster.balls[k]), time);
        }
    }

    /// The discs of the balls that can join the cluster. Those of all others are infinitely far away.
    fn free_discs(&self, cluster: &Cluster, time: f64) -> [[f64; 3]; N] {
        let mut free = [AWAY; N];
        for (k, disc) in free[..self.n].iter_mut().enumerate() {
            if self.path[k].motion.in_play() {
                *disc = self.disc(k, time);
            }
        }
        for &ball in cluster.balls() {
            free[usize::from(ball)] = AWAY;
        }
        free
    }

    /// Adds every `free` ball within `reach` (m) that acts `together` with the ball at `place` in the
    /// cluster.
    fn gather_around(
        &self,
        cluster: &mut Cluster,
        place: usize,
        free: &mut [[f64; 3]; N],
        time: f64,
        reach: f64,
        together: impl Fn(&Proximity) -> bool,
    ) {
        let near = clearance(self.disc(usize::from(cluster.balls[place]), time), reach);
        for (k, disc) in free[..self.n].iter_mut().enumerate() {
            if near(*disc) > 0.0 || cluster.size == MAX_BODIES {
                continue;
            }
            cluster.balls[cluster.size] = k as u16;
            cluster.before[cluster.size] = self.state(k, time);
            if together(&self.proximity(cluster, place, cluster.size)) {
                cluster.size += 1;
                *disc = AWAY;
            }
        }
    }

    /// Computes the states after the impact, from all contacts among the cluster's balls, with
    /// walls and with the tip.
    fn resolve_cluster(
        &mut self,
        cluster: &mut Cluster,
        reach: f64,
        together: impl Fn(usize, usize, &Proximity) -> bool,
        walls: &[WallTouch],
        tip: Option<TipTouch>,
        physics: &Physics,
    ) -> TipReport {
        let size = cluster.size;
        let empty =
            Body { velocity: Vec3::ZERO, angular_velocity: Vec3::ZERO, mass: 0.0, radius: 0.0 };
        let mut bodies = [empty; MAX_BODIES];
        for (k, slot) in bodies[..size].iter_mut().enumerate() {
            *slot = Body::new(&self.ball[usize::from(cluster.balls[k])], &cluster.before[k]);
        }
        let bodies = &mut bodies[..size];
        let mut touches = [Touch { a: 0, b: 0, normal: Vec3::ZERO, gap: 0.0 }; MAX_CONTACTS];
        let mut count = 0;
        let mut discs = [AWAY; MAX_BODIES];
        for (k, disc) in discs[..size].iter_mut().enumerate() {
            let at = cluster.before[k].position;
            *disc = [at.x, at.y, self.ball[usize::from(cluster.balls[k])].radius];
        }
        for p in 0..size {
            let near = clearance(discs[p], reach);
            for (q, &disc) in discs[..size].iter().enumerate().skip(p + 1) {
                if near(disc) > 0.0 {
                    continue;
                }
                let proximity = self.proximity(cluster, p, q);
                if together(p, q, &proximity) && count < MAX_CONTACTS {
                    let (normal, gap) = (proximity.normal, proximity.gap);
                    touches[count] = Touch { a: p as u8, b: q as u8, normal, gap };
                    count += 1;
                }
            }
        }
        let impact =
            NetworkImpact { law: &physics.ball_ball, touches: &touches[..count], walls, tip };
        let report = impact.resolve(bodies, &mut self.network).unwrap_or_default();
        for (k, body) in bodies.iter().enumerate() {
            let (v, spin) = (body.velocity, body.angular_velocity);
            let (state, ball) = (&cluster.before[k], &self.ball[usize::from(cluster.balls[k])]);
            cluster.after[k] = if v == state.velocity && spin == state.angular_velocity {
                *state
            } else {
                Support::under(state).settled(state, v, spin, ball, physics)
            };
        }
        report
    }

    fn proximity(&self, cluster: &Cluster, p: usize, q: usize) -> Proximity {
        let (a, b) = (&cluster.before[p], &cluster.before[q]);
        let radius = |k: usize| self.ball[usize::from(cluster.balls[k])].radius;
        let d = b.position - a.position;
        let distance = sqrt(d.length_squared());
        let normal = d * (1.0 / distance);
        Proximity {
            normal,
            gap: distance - (radius(p) + radius(q)),
            approach: (a.velocity - b.velocity).dot(normal),
        }
    }
}

/// A function of another ball [x, y, R], positive where this ball is further than `reach` (m) from
/// the ball [px, py, radius], seen from above.
#[inline(always)]
fn clearance([px, py, radius]: [f64; 3], reach: f64) -> impl Fn([f64; 3]) -> f64 {
    let near = radius + reach;
    move |[x, y, radius]| {
        let (dx, dy, near) = (x - px, y - py, radius + near);
        dx * dx + dy * dy - near * near
    }
}

/// Relative position and motion of two balls.
struct Proximity {
    /// Unit vector from the first ball's centre to the second's.
    normal: Vec3,
    /// Distance between the surfaces, m.
    gap: f64,
    /// Approach speed, m/s.
    approach: f64,
}
