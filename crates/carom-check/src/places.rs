//! Checks where each kind of event happens, and the motion of its balls afterwards.

use carom::event::{Event, EventKind};
use carom::math::{Vec2, Vec3};
use carom::shot::Shot;
use carom::{BallState, MotionState};

use crate::motion_states::SMOOTH;
use crate::rolling;
use crate::solid::{NamedPiece, Solid};
use crate::table_contact::{self, TableContact};

/// Largest allowed distance of a ball from the part of the table that it touches in an event, or
/// from the line that it crosses, m: a hundredth of an atom. For pairs of balls it is
/// [`CONTACT_GAP`](crate::CONTACT_GAP).
pub const TABLE_GAP: f64 = 1e-12;

/// Rounding error of speeds up to 100 m/s, m/s: below it, bodies neither approach nor separate.
const NO_SPEED: f64 = 1e-12;

/// A ball slower than this, m/s, may stop at a lip on any cloth.
const HANGS_BELOW: f64 = 1e-3;

/// Largest distance beyond a lip, in radii, at which a slow ball may rest as on the slate: the
/// engine's `LIP_OVERHANG`, rounded up.
const LIP_OVERHANG: f64 = 1.000_001e-4;

/// A jammed ball is at most this far from the parts between which it jams, m: its hops on an edge
/// are up to 0.08 mm high.
const JAM_GAP: f64 = 1e-4;

/// Sine of the least angle between the directions in which two such parts push the ball.
const JAM_TURN: f64 = 0.01;

/// Distance after which a ball at the edge of a rail's top must be beyond it, m.
const STEP: f64 = 1e-9;

/// Distance of `p` beyond a lip, m, if a ball may rest there; 0 elsewhere.
pub(crate) fn overhang(solid: &Solid, p: Vec2, radius: f64) -> f64 {
    let over = solid.over_hole(p);
    if over > 0.0 && over <= LIP_OVERHANG * radius { over } else { 0.0 }
}

/// Height by which a ball that rests beyond a lip is raised to the level of the slate, m.
pub(crate) fn raised(solid: &Solid, state: &BallState, radius: f64) -> f64 {
    let over = overhang(solid, state.position.xy(), radius);
    0.5 * over * over / radius
}

/// A surface that supports a ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ground {
    Bed,
    Top,
}

/// The surface that supports a ball with its centre at this height; `None` for other heights.
pub(crate) fn ground(solid: &Solid, state: &BallState, radius: f64) -> Option<Ground> {
    let z = state.position.z;
    if (z - radius).abs() <= TABLE_GAP {
        Some(Ground::Bed)
    } else if (z - solid.height - radius).abs() <= TABLE_GAP && !solid.rails.is_empty() {
        Some(Ground::Top)
    } else {
        None
    }
}

/// The error in where an event happens, if there is one.
pub(crate) fn audit(shot: &Shot, solid: &Solid, event: &Event<'_>) -> Option<String> {
    let check = EventCheck { shot, solid, event };
    if let Some(k) = event.before.iter().position(|s| !s.motion.in_play()) {
        let (ball, motion) = (event.balls[k], event.before[k].motion.name());
        return Some(format!("ball {ball} is {motion}, and out of play"));
    }
    let wrong = match event.kind {
        EventKind::CueStrike { .. } => None,
        EventKind::BallCollision => check.balls_approach(),
        EventKind::RailCollision(k) => {
            let (c, radius) = (event.before[0].position, check.radius(0));
            let touched = table_contact::rail(solid, usize::from(k), c, radius);
            touched.map_or(Some(format!("there is no part {k}")), |t| check.touches_part(t))
        }
        EventKind::SlateCollision => check.touches_part(table_contact::slate(
            solid,
            event.before[0].position,
            check.radius(0),
        )),
        EventKind::PocketCollision(k) => check.is_pocketed(usize::from(k)),
        EventKind::OffTable => check.is_off(),
        EventKind::MotionTransition { from, to } => check.is_continuous(from, to),
    };
    wrong.or_else(|| check.is_supported())
}

struct EventCheck<'a> {
    shot: &'a Shot,
    solid: &'a Solid,
    event: &'a Event<'a>,
}

impl EventCheck<'_> {
    fn radius(&self, k: usize) -> f64 {
        self.shot.balls()[usize::from(self.event.balls[k])].ball.radius
    }

    /// Balls of which one flies must approach each other.
    fn balls_approach(&self) -> Option<String> {
        let [p, q] = self.event.before else { return None };
        let flies = [p, q].iter().any(|s| s.motion == MotionState::Airborne);
        let line = q.position - p.position;
        let parting = (q.velocity - p.velocity).dot(line) / line.length();
        (flies && parting > NO_SPEED)
            .then(|| format!("balls {:?} meet parting at {parting:e} m/s", self.event.balls))
    }

    /// The ball must touch the part, approach it before the event and not approach it afterwards.
    fn touches_part(&self, touched: TableContact) -> Option<String> {
        let (before, after) = (self.event.before[0], self.event.after[0]);
        let ball = self.event.balls[0];
        if touched.gap.abs() > TABLE_GAP {
            let gap = touched.gap;
            return Some(format!("ball {ball} is {gap:e} m from the part that it touches"));
        }
        let rounding = NO_SPEED * (1.0 + before.velocity.length());
        let (came, went) = (before.velocity.dot(touched.away), after.velocity.dot(touched.away));
        if before.motion == MotionState::Airborne && came > rounding {
            return Some(format!("ball {ball} leaves the part that it meets at {came:e} m/s"));
        }
        (went < -rounding)
            .then(|| format!("ball {ball} moves on into the part that it met at {:e} m/s", -went))
    }

    /// A pocketed ball must be unable to come back.
    fn is_pocketed(&self, k: usize) -> Option<String> {
        let Some(pocket) = self.solid.plan.pockets.get(k) else {
            return Some(format!("there is no pocket {k}"));
        };
        let (s, radius, ball) = (self.event.before[0], self.radius(0), self.event.balls[0]);
        let z = s.position.z;
        let after = self.event.after[0];
        if after.motion != MotionState::Pocketed {
            return Some(format!("ball {ball} is {} when pocketed", after.motion.name()));
        }
        if self.solid.plan.has_mouth_lines {
            let beyond = (s.position.xy() - pocket.mouth[0]).dot(pocket.axis);
            return (beyond.abs() > TABLE_GAP || z > self.solid.height + radius + TABLE_GAP)
                .then(|| format!("ball {ball} is pocketed {beyond:e} m behind the mouth"));
        }
        let inside = pocket.radius - (s.position.xy() - pocket.center).length();
        if inside < -TABLE_GAP || z > TABLE_GAP {
            return Some(format!(
                "ball {ball} is pocketed {inside:e} m in the hole at z = {z:e} m"
            ));
        }
        let gravity = self.shot.physics().gravity;
        let energy = 0.5 * s.velocity.length_squared()
            + 0.2 * radius * radius * s.angular_velocity.length_squared();
        let reaches = z + energy / gravity;
        (z > -radius + TABLE_GAP && reaches > radius + TABLE_GAP).then(|| {
            format!("ball {ball} is pocketed at z = {z:e} m but could come up to {reaches:e} m")
        })
    }

    /// A ball off the table must be beyond the rails, or at rest on them.
    fn is_off(&self) -> Option<String> {
        let (s, after) = (self.event.before[0], self.event.after[0]);
        let (radius, ball) = (self.radius(0), self.event.balls[0]);
        if after.motion != MotionState::OffTable || after.velocity.length() != 0.0 {
            return Some(format!("ball {ball} is {} off the table", after.motion.name()));
        }
        let on_top = ground(self.solid, &s, radius) == Some(Ground::Top)
            && self.solid.beside_tops(s.position.xy()) <= TABLE_GAP;
        let rests = on_top && s.velocity.length() <= SMOOTH;
        let outside = self.beyond_border(s.position.xy());
        (!rests && outside < -TABLE_GAP && !self.is_jammed(&s, radius))
            .then(|| format!("ball {ball} is off the table {:e} m inside its border", -outside))
    }

    /// Whether a ball off the bed touches the table in two places that face different ways.
    fn is_jammed(&self, s: &BallState, radius: f64) -> bool {
        let pieces = || self.solid.rails.iter().chain([&self.solid.bed]);
        let near = |part: &NamedPiece| {
            let distance = part.piece.distance(s.position);
            (distance.value <= radius + JAM_GAP).then_some(distance.away)
        };
        let touched: Vec<Vec3> = pieces().filter_map(near).collect();
        let unlike = |a: &Vec3| touched.iter().any(|b| a.cross(*b).length() > JAM_TURN);
        s.motion == MotionState::Airborne && touched.iter().any(unlike)
    }

    fn beyond_border(&self, p: Vec2) -> f64 {
        (p.x.abs() - self.solid.border.x).max(p.y.abs() - self.solid.border.y)
    }

    /// Largest distance over a hole at which ball `k` of the event may rest, m.
    fn on_brink(&self, k: usize) -> f64 {
        TABLE_GAP + LIP_OVERHANG * self.radius(k)
    }

    /// Where a motion state ends, position and velocity must be continuous.
    fn is_continuous(&self, from: MotionState, to: MotionState) -> Option<String> {
        let (before, after) = (self.event.before[0], self.event.after[0]);
        let (radius, ball) = (self.radius(0), self.event.balls[0]);
        if (before.motion, after.motion) != (from, to) {
            return Some(format!("ball {ball} does not go from {} to {}", from.name(), to.name()));
        }
        if from == MotionState::Airborne {
            return Some(format!("the flight of ball {ball} ends without a contact"));
        }
        let p = before.position.xy();
        let at_edge = match ground(self.solid, &before, radius) {
            Some(Ground::Bed) => (-TABLE_GAP..=self.on_brink(0)).contains(&self.solid.over_hole(p)),
            Some(Ground::Top) => {
                let way = before.velocity.xy();
                let on = p + way * (STEP / way.length());
                self.solid.beside_tops(p) <= TABLE_GAP && self.solid.beside_tops(on) > 0.0
            }
            None => false,
        };
        if to == MotionState::Airborne && !at_edge {
            return Some(format!("ball {ball} takes off where there is ground"));
        }
        let jump = (after.velocity - before.velocity).length();
        let speed = before.velocity.length();
        let physics = self.shot.physics();
        let surface = radius * before.angular_velocity.xy().length();
        let friction = rolling::band(&physics.cloth, speed.max(surface)).0;
        let holding = friction * (physics.gravity * radius).sqrt();
        let hangs = at_edge
            && after.velocity.length() == 0.0
            && speed <= holding.max(HANGS_BELOW) * (1.0 + SMOOTH);
        (jump > SMOOTH * (1.0 + speed) && !hangs)
            .then(|| format!("the velocity of ball {ball} jumps by {jump:e} m/s"))
    }

    /// A ball that does not fly must be supported and have no vertical velocity.
    fn is_supported(&self) -> Option<String> {
        for (k, s) in self.event.after.iter().enumerate() {
            let ball = self.event.balls[k];
            if !s.motion.in_play() || s.motion == MotionState::Airborne {
                continue;
            }
            let p = s.position.xy();
            let over = self.solid.over_hole(p);
            let supported = match ground(self.solid, s, self.radius(k)) {
                Some(Ground::Bed) => over <= self.on_brink(k),
                Some(Ground::Top) => self.solid.beside_tops(p) <= TABLE_GAP,
                None => false,
            };
            if !supported || s.velocity.z != 0.0 {
                return Some(format!(
                    "ball {ball} is {} at z = {:e} m, {over:e} m in a hole, with v_z = {:e} m/s",
                    s.motion.name(),
                    s.position.z,
                    s.velocity.z
                ));
            }
        }
        None
    }
}
