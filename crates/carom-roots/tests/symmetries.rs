//! A contact must not depend on the choice of axes, of units or of the zero of time, nor on a third
//! dimension without motion.
//!
//! Mirrors, an exchange of axes and units that are powers of two change no rounding, so they must
//! not change a bit. A shift of time changes roundings; there the judge decides.

use carom_peers::families::{Case, Family, cluster_pair, uniform_pair};
use carom_peers::judge::{Verdict, judge};
use carom_peers::random::Random;
use carom_roots::{Motion, first_contact};

/// Depth of a graze about which rounding decides, m: ten times that of a single answer, because the
/// shifted motion is rounded, too.
const DEPTH: f64 = 1e-14;

fn every_case(check: impl Fn(&Case)) {
    let mut random = Random::new(2006);
    for _ in 0..4000 {
        for family in Family::ALL {
            check(&family.sample(&mut random));
        }
        check(&uniform_pair(&mut random));
        check(&cluster_pair(&mut random));
    }
}

fn contact(case: &Case) -> Option<f64> {
    first_contact(&case.motion, case.distance, case.horizon)
}

fn mapped(case: &Case, map: impl Fn([f64; 2]) -> [f64; 2]) -> Case {
    let Motion { d, v, h } = case.motion;
    Case { motion: Motion { d: map(d), v: map(v), h: map(h) }, ..*case }
}

#[test]
fn mirrors_and_a_swap_of_axes_change_no_bit() {
    every_case(|case| {
        let t = contact(case);
        assert_eq!(t, contact(&mapped(case, |[x, y]| [-x, y])), "{case:?}");
        assert_eq!(t, contact(&mapped(case, |[x, y]| [-x, -y])), "{case:?}");
        assert_eq!(t, contact(&mapped(case, |[x, y]| [y, x])), "{case:?}");
    });
}

#[test]
fn units_that_are_powers_of_two_change_no_bit() {
    every_case(|case| {
        let (metre, second) = (1024.0, 1.0 / 64.0);
        let Motion { d, v, h } = case.motion;
        let scaled = Case {
            motion: Motion {
                d: d.map(|x| x * metre),
                v: v.map(|x| x * (metre / second)),
                h: h.map(|x| x * (metre / (second * second))),
            },
            distance: case.distance * metre,
            horizon: case.horizon * second,
            ..*case
        };
        assert_eq!(contact(case).map(|t| t * second), contact(&scaled), "{case:?}");
    });
}

#[test]
fn a_later_zero_of_time_shifts_the_contact() {
    every_case(|case| {
        let Some(t) = contact(case).filter(|&t| t > 0.0) else { return };
        let start = 0.5 * t;
        let shifted = Motion {
            d: case.motion.at(start),
            v: case.motion.velocity_at(start),
            h: case.motion.h,
        };
        // Without a horizon, because at its end a rounding error decides about a contact.
        let later = first_contact(&shifted, case.distance, f64::INFINITY).map(|t| start + t);
        let open = Case { horizon: f64::INFINITY, ..*case };
        let verdict = judge(&open, later, DEPTH);
        assert!(matches!(verdict, Verdict::Right { .. }), "{t} {later:?}: {verdict:?} {case:?}");
    });
}

#[test]
fn a_third_dimension_at_rest_changes_no_bit() {
    every_case(|case| {
        let lift = |[x, y]: [f64; 2]| [x, y, 0.0];
        let Motion { d, v, h } = case.motion;
        let space = Motion { d: lift(d), v: lift(v), h: lift(h) };
        assert_eq!(contact(case), first_contact(&space, case.distance, case.horizon), "{case:?}");
    });
}
