//! The definition of a contact with a round edge, g ≤ 0 and g′ < 0, on paths whose contact is known
//! in closed form.

use carom_roots::{Motion, first_contact, first_ring_contact};

const NEVER: f64 = f64::INFINITY;

/// Tolerance of a time: a few rounding errors.
const ROUNDING: f64 = 4e-15;

/// Half the acceleration of gravity, m/s².
const FALL: f64 = -4.9;

/// A pool pocket's lip and ball, m.
const LIP: f64 = 0.06;
const BALL: f64 = 0.028;

fn assert_at(motion: &Motion<3>, ring: f64, distance: f64, expected: f64) {
    let t = first_ring_contact(motion, ring, distance, 0.0, NEVER).expect("a contact");
    assert!((t - expected).abs() <= ROUNDING * (1.0 + expected), "{t} is not {expected}");
    // With a horizon equal to the time, and with a later start.
    let bounded = first_ring_contact(motion, ring, distance, 0.5 * t, t);
    assert_eq!(bounded, Some(t), "from half its time to its time");
    assert_eq!(first_ring_contact(motion, ring, distance, 0.0, 0.99 * t), None);
}

fn straight(d: [f64; 3], v: [f64; 3]) -> Motion<3> {
    Motion { d, v, h: [0.0; 3] }
}

#[test]
fn a_ball_meets_the_outer_side_of_the_ring_at_its_level() {
    assert_at(&straight([5.0, 0.0, 0.0], [-1.0, 0.0, 0.0]), 2.0, 0.5, 2.5);
    assert_at(&straight([0.0, -5.0, 0.0], [0.0, 2.0, 0.0]), 2.0, 0.5, 1.25);
    // 0.3 above the ring, R = 0.5: 0.4 outside it
    assert_at(&straight([5.0, 0.0, 0.3], [-1.0, 0.0, 0.0]), 2.0, 0.5, 2.6);
}

#[test]
fn a_ball_meets_the_far_side_of_the_ring_from_inside() {
    assert_at(&straight([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]), 2.0, 0.5, 2.5);
    assert_at(&straight([-1.0, 0.0, -0.3], [1.0, 0.0, 0.0]), 2.0, 0.5, 2.6);
    // Off the axis: ρ² = 0.9² + 1.2² = 1.5².
    assert_at(&straight([-1.0, 0.9, 0.0], [1.0, 0.0, 0.0]), 2.0, 0.5, 2.2);
}

#[test]
fn a_ball_falls_on_top_of_the_ring() {
    // Exactly above the edge, where the torus touches its box: 4.9 t² = 1.225.
    assert_at(&Motion { d: [0.0, 2.0, 1.725], v: [0.0; 3], h: [0.0, 0.0, FALL] }, 2.0, 0.5, 0.5);
    // 0.3 away from it: contact at the height 0.4
    let beside = Motion { d: [1.7, 0.0, 1.625], v: [0.0; 3], h: [0.0, 0.0, FALL] };
    assert_at(&beside, 2.0, 0.5, 0.5);
}

#[test]
fn a_ball_that_falls_through_the_ring_without_touching_has_no_contact() {
    let motion = Motion { d: [0.1, 0.2, 3.0], v: [0.0; 3], h: [0.0, 0.0, FALL] };
    assert_eq!(first_ring_contact(&motion, 2.0, 0.5, 0.0, NEVER), None);
    let grazing = Motion { d: [1.5 - 1e-12, 0.0, 3.0], v: [0.0; 3], h: [0.0, 0.0, FALL] };
    assert_eq!(first_ring_contact(&grazing, 2.0, 0.5, 0.0, NEVER), None);
}

#[test]
fn inside_a_ring_smaller_than_the_ball_the_near_side_is_the_contact() {
    // On the axis, falling: √(a² + z²) = R at z = 0.4.
    let axis = Motion { d: [0.0, 0.0, 1.625], v: [0.0; 3], h: [0.0, 0.0, FALL] };
    assert_at(&axis, 0.3, 0.5, 0.5);
    // Deep inside, within R of every point of the ring, and moving away from the nearest one: the
    // polynomial of degree eight is positive there, but the ball overlaps the ring. It falls on to
    // the edge beyond the axis.
    let inside = straight([-0.1, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let t = first_ring_contact(&inside, 0.3, 0.5, 0.0, NEVER).expect("beyond the axis");
    assert!((t - 0.1).abs() <= ROUNDING, "{t}");
}

#[test]
fn a_touching_start_is_a_contact_only_if_it_approaches() {
    let from_outside = |speed| straight([2.5, 0.0, 0.0], [speed, 3.0, 0.0]);
    assert_eq!(first_ring_contact(&from_outside(-1e-9), 2.0, 0.5, 0.0, 1.0), Some(0.0));
    assert_eq!(first_ring_contact(&from_outside(1e-9), 2.0, 0.5, 0.0, 1.0), None);
    for rounding in [-1.0, 0.0, 1.0] {
        let x = 1.5 + rounding * f64::EPSILON;
        let inward = straight([x, 0.0, 0.0], [-1.0, 0.0, 0.0]);
        assert_eq!(first_ring_contact(&inward, 2.0, 0.5, 0.0, 2.9), None);
        // Across the hole, to the other side.
        let t = first_ring_contact(&inward, 2.0, 0.5, 0.0, 4.0).expect("the far side");
        assert!((t - 3.0).abs() <= ROUNDING, "{t}");
    }
}

#[test]
fn a_ball_over_the_lip_turns_about_it_when_slow_and_flies_off_when_fast() {
    // f = t²(v² − gR) + g²t⁴/4 with v inward from the top of the lip
    let limit = (2.0 * -FALL * BALL).sqrt();
    for [cos, sin] in [[1.0, 0.0], [0.96, 0.28], [-0.6, 0.8]] {
        for (speed, touches) in [(0.005, true), (0.5, true), (0.9, false), (2.0, false)] {
            assert_eq!(speed < limit, touches, "by hand");
            let motion = Motion {
                d: [LIP * cos, LIP * sin, BALL],
                v: [-speed * cos, -speed * sin, 0.0],
                h: [0.0, 0.0, FALL],
            };
            let t = first_ring_contact(&motion, LIP, BALL, 0.0, 0.06);
            assert_eq!(t.is_some_and(|t| t < 1e-6), touches, "{speed} at {cos}: {t:?}");
        }
    }
}

#[test]
fn a_ring_of_no_radius_is_a_point() {
    let motion = Motion { d: [0.3, -0.2, 0.4], v: [-1.0, 0.6, 0.5], h: [0.1, 0.0, FALL] };
    let t = first_contact(&motion, BALL * 4.0, 1.0);
    assert!(t.is_some());
    assert_eq!(first_ring_contact(&motion, 0.0, BALL * 4.0, 0.0, 1.0), t);
    let late = first_ring_contact(&motion, 0.0, BALL * 4.0, 0.1, 1.0).expect("the same contact");
    assert!((late - t.unwrap()).abs() <= ROUNDING);
}

#[test]
fn paths_at_rest_or_with_nan_never_touch() {
    assert_eq!(
        first_ring_contact(&straight([2.5, 0.0, 0.0], [0.0; 3]), 2.0, 0.5, 0.0, NEVER),
        None
    );
    assert_eq!(first_ring_contact(&straight([2.1, 0.0, 0.0], [0.0; 3]), 2.0, 0.5, 0.0, 1.0), None);
    let nan = straight([f64::NAN, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    assert_eq!(first_ring_contact(&nan, 2.0, 0.5, 0.0, NEVER), None);
    let good = straight([5.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    assert_eq!(first_ring_contact(&good, 2.0, 0.5, 0.0, f64::NAN), None);
    assert_eq!(first_ring_contact(&good, 2.0, 0.5, 1.0, 0.5), None);
    assert_eq!(first_ring_contact(&good, f64::NAN, 0.5, 0.0, NEVER), None);
}
