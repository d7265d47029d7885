//! A ball that falls over an edge. Its hops are computed here with the exact times of their
//! parabolas. They are compared with the textbook's ball, which rotates about the edge.

use crate::near::assert_near;
use crate::random::Random;
use carom::math::{Vec2, Vec3, sin_cos, sqrt};
use carom::physics::Surface;
use carom::resolve::Body;
use carom::resolve::ball_edge::{self, Edge};
use carom_roots::{Motion, first_contact};

const GRAVITY: f64 = 9.81;
const RADIUS: f64 = 0.028_575;
const MASS: f64 = 0.17;
/// Direction of the edge.
const ALONG: Vec2 = Vec2::new(0.0, 1.0);

fn straight(normal: Vec3, along: Vec2) -> Edge {
    Edge { normal, along, bend: 0.0, turn: 1.0 / RADIUS }
}

/// The state of a ball that has left the edge, and how it got there.
struct Fall {
    /// Cosine of the angle from the vertical at the last contact.
    cosine: f64,
    contacts: u32,
    /// Largest relative increase of the total energy in a contact.
    gain: f64,
    /// Time from the first contact to the last, s.
    time: f64,
    flight: [f64; 4],
}

fn energy(ball: &Body, height: f64) -> f64 {
    0.5 * ball.mass * ball.velocity.length_squared()
        + 0.2 * ball.mass * ball.radius * ball.radius * ball.angular_velocity.length_squared()
        + ball.mass * GRAVITY * height
}

/// A ball rolls at `speed` on to an edge along y.
fn tip(law: &Surface, speed: f64) -> Fall {
    tip_aslant(law, Vec2::new(speed, 0.0))
}

/// A ball rolls with `velocity` on to an edge along y.
fn tip_aslant(law: &Surface, velocity: Vec2) -> Fall {
    let mut ball = Body {
        velocity: velocity.with_z(0.0),
        angular_velocity: (velocity.perp() * (1.0 / RADIUS)).with_z(0.0),
        mass: MASS,
        radius: RADIUS,
    };
    let (mut x, mut z) = (0.0, RADIUS);
    let mut fall =
        Fall { cosine: 1.0, contacts: 0, gain: f64::NEG_INFINITY, time: 0.0, flight: [0.0; 4] };
    loop {
        let length = sqrt(x * x + z * z);
        let before = energy(&ball, 0.0);
        let normal = Vec3::new(-x / length, 0.0, -z / length);
        ball_edge::resolve(law, GRAVITY, &straight(normal, ALONG), &mut ball);
        fall.gain = fall.gain.max(energy(&ball, 0.0) / before - 1.0);
        fall.contacts += 1;
        fall.cosine = z / length;
        fall.flight = at_the_edges_height(x, z, ball.velocity, RADIUS * ball.angular_velocity.y);
        let motion =
            Motion { d: [x, z], v: [ball.velocity.x, ball.velocity.z], h: [0.0, -0.5 * GRAVITY] };
        let Some(t) = first_contact(&motion, RADIUS, 10.0) else { return fall };
        [x, z] = motion.at(t);
        ball.velocity.z -= GRAVITY * t;
        fall.time += t;
    }
}

/// Velocity, surface velocity Rω and position of the centre when it is at the height of the edge.
fn at_the_edges_height(x: f64, z: f64, velocity: Vec3, surface: f64) -> [f64; 4] {
    let rise = velocity.z;
    let fall = sqrt(rise * rise + 2.0 * GRAVITY * z);
    let t = (rise + fall) / GRAVITY;
    [velocity.x, -fall, surface, x + velocity.x * t]
}

/// The same fall from the equations of a ball held on its circle about the edge, with Coulomb
/// friction, in small steps of time: the cosine of lift-off, and the flight.
fn turned(friction: f64, speed: f64) -> (f64, [f64; 4]) {
    const STEP: f64 = 1e-6;
    let (mut angle, mut v, mut surface) = (0.0_f64, speed, speed);
    loop {
        let (s, c) = sin_cos(angle);
        let pull = GRAVITY * c - v * v / RADIUS;
        if pull <= 0.0 {
            let velocity = Vec3::new(v * c, 0.0, -v * s);
            return (c, at_the_edges_height(RADIUS * s, RADIUS * c, velocity, surface));
        }
        let held = GRAVITY * s * (2.0 / 7.0) + (v - surface) * (2.0 / 7.0 / STEP);
        let drag = held.min(friction * pull);
        v += (GRAVITY * s - drag) * STEP;
        surface += 2.5 * drag * STEP;
        angle += v / RADIUS * STEP;
    }
}

const SPEEDS: [f64; 9] = [0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5];

fn edge(friction: f64) -> Surface {
    Surface::new(0.5, friction)
}

#[test]
fn a_ball_that_rolls_slowly_over_an_edge_leaves_it_at_the_textbooks_angle() {
    /// Of the cosine: two hops of 0.04 rad.
    const LIFT_OFF: f64 = 0.08;
    for speed in SPEEDS {
        let fall = tip(&edge(1.0), speed);
        let expected = (10.0 + 7.0 * speed * speed / (GRAVITY * RADIUS)) / 17.0;
        assert_near(fall.cosine / expected, 1.0, LIFT_OFF);
    }
}

#[test]
fn a_ball_that_falls_over_an_edge_leaves_it_like_a_ball_held_on_it_with_the_same_friction() {
    const LIFT_OFF: f64 = 0.08;
    /// Of the centre, which has about 0.7, m/s.
    const VELOCITY: f64 = 0.0025;
    /// Of the ball's surface, which has about 0.3, m/s. Without friction nothing makes up for the
    /// loss of the first hops.
    const SURFACE: f64 = 0.02;
    /// Of the position, m.
    const PLACE: f64 = 1e-4;
    for friction in [0.0, 0.2, 1.0] {
        for speed in SPEEDS {
            let fall = tip(&edge(friction), speed);
            let (cosine, flight) = turned(friction, speed);
            assert_near(fall.cosine / cosine, 1.0, LIFT_OFF);
            for (i, tolerance) in [VELOCITY, VELOCITY, SURFACE, PLACE].into_iter().enumerate() {
                assert_near(fall.flight[i], flight[i], tolerance);
            }
        }
    }
}

#[test]
fn a_ball_falls_over_an_edge_in_a_bounded_number_of_hops_and_gains_no_energy() {
    const ROUNDING: f64 = 4e-15;
    for friction in [0.0, 0.2, 1.0] {
        for restitution in [0.0, 0.5, 1.0] {
            for (speed, most) in [(0.001, 900), (0.005, 200), (0.01, 120), (0.1, 60), (0.5, 20)] {
                let fall = tip(&Surface::new(restitution, friction), speed);
                assert!(fall.contacts <= most, "{speed} m/s, e {restitution}: {}", fall.contacts);
                assert!(fall.gain < ROUNDING, "{:e}", fall.gain);
                assert!(fall.time < 0.6, "{} s", fall.time);
            }
        }
    }
}

#[test]
fn from_the_speed_root_g_r_on_a_ball_leaves_the_edge_at_once_and_keeps_its_motion() {
    let speed = sqrt(GRAVITY * RADIUS) * (1.0 + 1e-9);
    let fall = tip(&edge(0.2), speed);
    assert_eq!(fall.contacts, 1);
    assert_near(fall.flight[0], speed, 1e-15);
    assert!(tip(&edge(0.2), 0.99 * speed).contacts > 1);
}

#[test]
fn a_ball_that_rolls_fast_along_an_edge_falls_over_it_like_one_that_only_crosses_it() {
    // Without friction the two motions are independent.
    let alone = tip(&edge(0.0), 0.1);
    let fast = tip_aslant(&edge(0.0), Vec2::new(0.1, 3.0));
    assert!(fast.contacts <= alone.contacts + 2, "{} contacts", fast.contacts);
    assert_near(fast.cosine / alone.cosine, 1.0, 0.08);
    // Friction along the edge couples them; the number of hops stays small.
    let rubbed = tip_aslant(&edge(0.2), Vec2::new(0.1, 3.0));
    assert!(rubbed.contacts > 10 && rubbed.contacts < 80, "{} contacts", rubbed.contacts);
    assert!(rubbed.gain < 4e-15);
}

#[test]
fn a_ball_that_drops_on_an_edge_bounces_with_the_surfaces_restitution_and_friction() {
    let normal = Vec3::new(-0.6, 0.0, -0.8);
    let mut ball = Body {
        velocity: Vec3::new(0.0, 0.5, -2.0),
        angular_velocity: Vec3::ZERO,
        mass: MASS,
        radius: RADIUS,
    };
    let before = ball;
    ball_edge::resolve(&edge(0.1), GRAVITY, &straight(normal, ALONG), &mut ball);
    assert_near(ball.velocity.dot(normal), -0.5 * 1.6, 1e-15);
    let kick = ball.velocity - before.velocity;
    let friction = kick - normal * kick.dot(normal);
    assert_near(friction.length(), 0.1 * 1.5 * 1.6, 1e-15);
    let slip = before.velocity - normal * 1.6;
    assert_near(friction.cross(slip).length(), 0.0, 1e-15);
    assert!(friction.dot(slip) < 0.0);
    // There is no torque about the point of contact.
    let moment = ball.angular_velocity * (0.4 * RADIUS) - normal.cross(kick);
    assert_near(moment.length(), 0.0, 1e-15);
}

#[test]
fn in_any_contact_energy_never_rises_the_ball_separates_and_mirrored_contacts_are_mirrored() {
    let mut random = Random(3);
    for _ in 0..100_000 {
        let surface =
            Surface::new([0.0, 0.5, 1.0][random.pick(3)], [0.0, 0.2, 1.0][random.pick(3)]);
        let (s, c) = sin_cos(random.between(0.0, core::f64::consts::TAU));
        let up = [-1.0, random.between(-1.0, 0.2)][random.pick(2)];
        let normal = Vec3::new(c, s, 0.0) * sqrt(1.0 - up * up) + Vec3::new(0.0, 0.0, up);
        let along = Vec2::new(-s, c);
        let size = [0.0, 1e-6, 1e-3, 0.1, 5.0][random.pick(5)];
        let spin = [0.0, 1.0, 3.0][random.pick(3)] * size / RADIUS;
        let before = Body {
            velocity: random.vector(size),
            angular_velocity: random.vector(spin),
            mass: MASS,
            radius: RADIUS,
        };
        let bend = [0.0, 30.0, -30.0][random.pick(3)];
        let turn = [0.0, 1.0 / RADIUS][random.pick(2)];
        let after = |mut ball: Body, normal: Vec3, along: Vec2| {
            ball_edge::resolve(&surface, GRAVITY, &Edge { normal, along, bend, turn }, &mut ball);
            ball
        };
        let ball = after(before, normal, along);
        assert!(ball.velocity.is_finite() && ball.angular_velocity.is_finite());
        assert!(energy(&ball, 0.0) <= energy(&before, 0.0) * (1.0 + 4e-15));
        assert!(ball.velocity.dot(normal) <= 1e-15 * before.velocity.length());
        let flip = |v: Vec3| Vec3 { x: -v.x, ..v };
        let mirror = |ball: Body| Body {
            velocity: flip(ball.velocity),
            angular_velocity: -flip(ball.angular_velocity),
            ..ball
        };
        let image = after(mirror(before), flip(normal), Vec2::new(-along.x, along.y));
        assert_eq!(image, mirror(ball));
    }
}

#[test]
fn a_ball_follows_a_round_wall_in_few_hops_and_gains_no_energy() {
    // The centre stays on a circle of this radius about the axis, m.
    const WAY: f64 = 0.035;
    let (mut x, mut y) = (WAY, 0.0);
    let mut ball = Body {
        velocity: Vec3::new(0.0, 1.0, 0.0),
        angular_velocity: Vec3::ZERO,
        mass: MASS,
        radius: RADIUS,
    };
    let (mut time, mut contacts) = (0.0, 0);
    while time < 0.1 {
        let normal = Vec3::new(x, y, 0.0) * (1.0 / WAY);
        let wall = Edge { normal, along: normal.xy().perp(), bend: 1.0 / WAY, turn: 0.0 };
        let before = energy(&ball, 0.0);
        ball_edge::resolve(&edge(0.0), GRAVITY, &wall, &mut ball);
        assert!(energy(&ball, 0.0) <= before * (1.0 + 4e-15));
        // Across the circle on a straight line.
        let v = ball.velocity;
        let t = -2.0 * (x * v.x + y * v.y) / (v.x * v.x + v.y * v.y);
        (x, y) = (x + v.x * t, y + v.y * t);
        time += t;
        contacts += 1;
    }
    assert!(contacts < 40, "{contacts}");
    assert_near(ball.velocity.length(), 1.0, 0.02);
}
