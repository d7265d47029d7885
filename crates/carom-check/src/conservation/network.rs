//! Checks of a collision of more than two balls. All contacts act at once (docs/many-balls.md).
//!
//! Balls are in contact if they touch, or if the gap between them is so small that the approach of
//! the balls that touch would close it while their contact lasts. Impulses at these contacts, which
//! do not pull and whose friction stays within its cone, must explain all changes of velocity and
//! spin together, up to the angle by which the lines of centres turn while the balls touch. The
//! horizontal momentum of all balls is conserved up to rounding.

use carom::event::Event;
use carom::math::Vec3;
use carom::shot::Shot;
use carom::table::TOUCH_TOLERANCE;
use carom::{Ball, MotionState};

use super::impulses::{Change, Contact, Unexplained, explain};
use super::last_hop_speed;
use crate::places::ground;
use crate::solid::Solid;

/// Time in which gaps close that count as contacts, s: a fifth of the duration of a contact, 250 to
/// 300 µs (Alciatore, TP B.29).
const CLOSING_TIME: f64 = 5e-5;

/// Approach speed from which gaps count, m/s.
const NETWORK_SPEED: f64 = 1e-2;

/// Largest difference of the changes from those by impulses, as a fraction of the heaviest ball's
/// momentum at the fastest approach; and as a fraction of the balls' own speeds.
const UNEXPLAINED: [f64; 2] = [1e-8, 1e-14];

/// How long a contact of two balls lasts at an approach of 1 m/s, s (TP B.29); at the speed V it
/// lasts V^(−1/5) times as long. Together with the fastest relative velocity, and with the number of
/// such times that an impact may last, this gives the angle by which lines may turn.
const CONTACT_TIME: f64 = 3.3e-4;

/// Contacts that follow one another.
const SUCCESSIVE_CONTACTS: f64 = 4.0;

/// The same with the times between contacts in which balls move without a force, up to three contact
/// times each. Of the 18 impacts for which 4 was too little in 1.5 million random shots, 8 is for
/// one, and 16 for none.
const LONGEST_IMPACT: f64 = 16.0;

/// Largest angle that [`LONGEST_IMPACT`] allows, rad: a faster impact that lasts so long would
/// explain impulses between balls that do not touch.
const MOST_LATE_TURN: f64 = 0.05;

/// The same for two balls that move so fast across their line before or after the impact. In 2.2
/// million random shots one impact turns a line by more than 0.05: its last contact follows after
/// 1.4 ms without a force, and the line has turned by 0.058.
const MOST_SEEN_TURN: f64 = 0.08;

/// Largest angle by which a line of centres may turn, rad: in a break at 13 m/s it is 0.02.
const MOST_TURN: f64 = 0.2;

/// Up to this number of contacts, each may act along lines of centres that turn. In a larger network the
/// lines stay, and the turn is added to the accuracy: the search would take too long.
const MOST_TURNING: usize = 12;

/// Largest change of the momentum of all balls, as a fraction of the sum of their changes.
const MOMENTUM: f64 = 1e-12;

/// Largest pull at a contact, in the same unit: the accuracy of the search for the impulses.
const PULL: f64 = 1e-4;

/// A slate with less restitution counts as one with this.
const LEAST_BOUNCE: f64 = 1e-3;

/// Slack of the cones of friction, for impulses on their surfaces.
const CONE_SLACK: f64 = 1e-6;

/// Two balls of the event.
struct Proximity {
    a: usize,
    b: usize,
    normal: Vec3,
    gap: f64,
    /// Approach speeds before and after, m/s.
    before: f64,
    after: f64,
    /// The faster speed across the line, before or after, m/s.
    across: f64,
}

fn proximities(event: &Event<'_>, balls: &[Ball]) -> Vec<Proximity> {
    let mut list = Vec::new();
    for b in 1..balls.len() {
        for a in 0..b {
            let line = event.before[b].position - event.before[a].position;
            let distance = line.length();
            let normal = line * (1.0 / distance);
            let relative = |s: &[carom::BallState]| s[a].velocity - s[b].velocity;
            let across = |s| relative(s).cross(normal).length();
            list.push(Proximity {
                a,
                b,
                normal,
                gap: distance - (balls[a].radius + balls[b].radius),
                before: relative(event.before).dot(normal),
                after: relative(event.after).dot(normal),
                across: across(event.before).max(across(event.after)),
            });
        }
    }
    list
}

/// The error in a collision of more than two balls, if there is one.
pub(super) fn audit(
    shot: &Shot,
    solid: &Solid,
    event: &Event<'_>,
    balls: &[Ball],
    gap: f64,
) -> Option<String> {
    let mut pairs = proximities(event, balls);
    // At the start of a shot, balls may overlap within the tolerance of the shot file.
    let meets = if event.time == 0.0 { gap.max(TOUCH_TOLERANCE) } else { gap };
    let fastest = pairs
        .iter()
        .filter(|p| p.gap.abs() <= meets)
        .map(|p| p.before)
        .fold(f64::NEG_INFINITY, f64::max);
    if fastest <= 0.0 || fastest.is_nan() {
        return Some(format!("balls {:?} collide, and none approaches another", event.balls));
    }
    let closed =
        if fastest >= NETWORK_SPEED { TOUCH_TOLERANCE + CLOSING_TIME * fastest } else { 0.0 };
    let reach = closed.max(2.0 * meets);
    let friction = &shot.physics().ball_ball.friction;
    let most = friction.a.max(friction.a + friction.b).max(0.0);
    let smooth = shot.physics().ball_ball.is_smooth();
    let friction = if smooth { 0.0 } else { most * (1.0 + CONE_SLACK) };
    let nearest = pairs.iter().map(|p| balls[p.a].radius + balls[p.b].radius).fold(1.0, f64::min);
    let apart = |p: &Proximity| (event.before[p.a].velocity - event.before[p.b].velocity).length();
    let apart = pairs.iter().map(apart).fold(0.0, f64::max);
    let time = CONTACT_TIME * carom::math::pow(fastest, -0.2);
    let rate = apart * time / nearest;
    let late = (LONGEST_IMPACT * rate).min(MOST_LATE_TURN);
    let turn = (SUCCESSIVE_CONTACTS * rate).max(late).min(MOST_TURN);
    let seen = |p: &Proximity| (LONGEST_IMPACT * p.across * time / nearest).min(MOST_SEEN_TURN);
    let contact = |p: &Proximity| Contact { a: p.a, b: Some(p.b), normal: p.normal, friction };
    pairs.retain(|p| p.gap <= reach);
    let count = pairs.len();
    let turns = turn > 0.0 && count <= MOST_TURNING;
    let contacts: Vec<Contact> = if turns {
        pairs.iter().flat_map(|p| turned(&contact(p), turn.max(seen(p)))).collect()
    } else {
        pairs.iter().map(contact).collect()
    };
    let (slack, pull) = if turn > 0.0 && !turns { (turn, f64::INFINITY) } else { (0.0, PULL) };
    let heaviest = balls.iter().map(|b| b.mass).fold(0.0, f64::max);
    let unit = heaviest * fastest;
    let changes: Vec<Change> =
        (0..balls.len()).map(|k| change(shot, solid, event, &balls[k], k, unit)).collect();
    let speeds = event
        .before
        .iter()
        .zip(balls)
        .map(|(s, ball)| s.velocity.length() + ball.radius * s.angular_velocity.length());
    let rounding = UNEXPLAINED[0] + UNEXPLAINED[1] * speeds.fold(0.0, f64::max) / fastest;
    let goal = rounding + slack;
    let named = &event.balls;
    let total = changes.iter().fold(Vec3::ZERO, |sum, c| sum + c.momentum).xy().length();
    let sum = changes.iter().map(|c| c.momentum.length()).fold(0.0, f64::max);
    if total > MOMENTUM * sum + rounding {
        return Some(format!("balls {named:?} gain the momentum {total:e} together"));
    }
    let wrong = match explain(&contacts, &changes, pull, goal) {
        Ok(()) => None,
        Err(Unexplained::Inconsistent(error)) => Some(format!("explain {error:e} of the changes")),
        Err(Unexplained::Pulled(pull)) => Some(format!("without a pull of {pull:e} explain them")),
    };
    wrong.map(|what| format!("no impulses at the {count} contacts of balls {named:?} {what}"))
}

/// Contacts whose normals surround all those that lean from `contact`'s by at most `turn`, rad.
fn turned(contact: &Contact, turn: f64) -> [Contact; 3] {
    let n = contact.normal;
    let helper = if n.z.abs() < 0.5 { Vec3::new(0.0, 0.0, 1.0) } else { Vec3::new(1.0, 0.0, 0.0) };
    let across = n.cross(helper);
    let first = across * (1.0 / across.length());
    let second = n.cross(first);
    // The corners of a triangle around the circle of radius `turn`.
    [[2.0, 0.0], [-1.0, 3.0_f64.sqrt()], [-1.0, -(3.0_f64.sqrt())]].map(|[x, y]| {
        let leaning = n + (first * x + second * y) * turn;
        Contact { normal: leaning * (1.0 / leaning.length()), ..*contact }
    })
}

/// The largest approach of two touching balls after a collision, as a fraction of the fastest before
/// it; 0 if all separate. The balls meet again at the same instant.
pub(crate) fn still_approaching(shot: &Shot, event: &Event<'_>) -> f64 {
    let ball = |i: &u16| shot.balls()[usize::from(*i)].ball;
    let balls: Vec<Ball> = event.balls.iter().map(ball).collect();
    let mut pairs = proximities(event, &balls);
    pairs.retain(|p| p.gap <= TOUCH_TOLERANCE);
    let greatest = |of: fn(&Proximity) -> f64| pairs.iter().map(of).fold(0.0, f64::max);
    let (before, after) = (greatest(|p| p.before), greatest(|p| p.after));
    if before > 0.0 { after / before } else { 0.0 }
}

/// The change of ball `k` in units of the momentum `unit`, and the slate's part in it.
fn change(
    shot: &Shot,
    solid: &Solid,
    event: &Event<'_>,
    ball: &Ball,
    k: usize,
    unit: f64,
) -> Change {
    let (before, after) = (event.before[k], event.after[k]);
    let stands = ground(solid, &before, ball.radius).is_some();
    let held = stands && after.motion != MotionState::Airborne;
    let mass = ball.mass / unit;
    let hop = mass * last_hop_speed(shot);
    // A ball driven down stays if its bounce would be too low.
    let bounce = shot.physics().slate.restitution;
    let lift = if held { [-hop, hop / bounce.max(LEAST_BOUNCE)] } else { [0.0; 2] };
    Change {
        momentum: (after.velocity - before.velocity) * mass,
        spin: (after.angular_velocity - before.angular_velocity) * (0.4 * mass * ball.radius),
        lift,
    }
}
