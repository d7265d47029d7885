//! All finders of a first contact behind one interface.

use carom_roots::Motion;

use crate::quartic::{Quartic, Roots, smallest_approaching_root};
use crate::{algorithm_1010, companion, ferrari};

/// A way to find the first contact of two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Finder {
    /// The finder of this project.
    Carom,
    /// [`crate::ferrari`].
    Ferrari,
    /// [`crate::companion`].
    Companion,
    /// [`crate::algorithm_1010`].
    Algorithm1010,
    /// `kurbo::common::solve_quartic`, similar to Algorithm 1010.
    Kurbo,
    /// `polycool`, Yuksel 2022: Newton's method bracketed by the roots of the derivatives.
    Polycool,
}

impl Finder {
    /// All of them, this project's first.
    pub const ALL: [Finder; 6] = [
        Finder::Carom,
        Finder::Ferrari,
        Finder::Companion,
        Finder::Algorithm1010,
        Finder::Kurbo,
        Finder::Polycool,
    ];

    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Finder::Carom => "carom-roots",
            Finder::Ferrari => "Ferrari, textbook",
            Finder::Companion => "companion eigenvalues",
            Finder::Algorithm1010 => "Algorithm 1010",
            Finder::Kurbo => "kurbo 0.13",
            Finder::Polycool => "polycool 0.4",
        }
    }

    /// First contact within `horizon` (s) of centres that touch at `distance` (m).
    ///
    /// All but this project's finder return the smallest real root in [0, horizon] at which the
    /// bodies approach, or 0 if they touch and approach at the start.
    pub fn first_contact(self, motion: &Motion<2>, distance: f64, horizon: f64) -> Option<f64> {
        let by_roots = |solve: fn(&Quartic) -> Roots| {
            smallest_approaching_root(motion, distance, horizon, solve)
        };
        match self {
            Finder::Carom => carom_roots::first_contact(motion, distance, horizon),
            Finder::Ferrari => by_roots(ferrari::real_roots),
            Finder::Companion => by_roots(companion::real_roots),
            Finder::Algorithm1010 => by_roots(algorithm_1010::real_roots),
            Finder::Kurbo => by_roots(kurbo_roots),
            Finder::Polycool => smallest_approaching_root(motion, distance, horizon, |quartic| {
                polycool_roots(quartic, horizon)
            }),
        }
    }
}

fn kurbo_roots(quartic: &Quartic) -> Roots {
    let [c0, c1, c2, c3, c4] = quartic.0;
    collected(kurbo::common::solve_quartic(c0, c1, c2, c3, c4))
}

fn polycool_roots(quartic: &Quartic, horizon: f64) -> Roots {
    // Fujiwara's bound on the magnitude of every root stands in for an infinite horizon.
    let [a, b, c, d] = quartic.monic();
    let bound = 2.0 * a.abs().max(b.abs().sqrt()).max(c.abs().cbrt()).max(d.abs().sqrt().sqrt());
    let end = horizon.min(bound);
    let accuracy = f64::EPSILON * end;
    collected(polycool::Poly::new(quartic.0).roots_between(0.0, end, accuracy))
}

fn collected(list: impl IntoIterator<Item = f64>) -> Roots {
    let mut roots = Roots::default();
    list.into_iter().take(4).for_each(|root| roots.push(root));
    roots
}

#[cfg(test)]
mod tests {
    use super::Finder;
    use carom_roots::Motion;

    /// All finders agree on an easy contact to this, s.
    const EASY: f64 = 1e-12;

    #[test]
    fn every_finder_finds_an_easy_contact_on_a_curved_path() {
        let motion = Motion { d: [1.0, 0.3], v: [-2.0, -0.4], h: [0.3, -0.2] };
        let ours = Finder::Carom.first_contact(&motion, 0.1, 10.0).expect("a contact");
        for finder in Finder::ALL {
            let t = finder.first_contact(&motion, 0.1, 10.0);
            assert!(t.is_some_and(|t| (t - ours).abs() < EASY), "{}: {t:?}", finder.name());
        }
    }

    #[test]
    fn every_finder_finds_a_contact_on_a_straight_path() {
        let motion = Motion { d: [1.0, 0.0], v: [-2.0, 0.0], h: [0.0, 0.0] };
        for finder in Finder::ALL {
            let t = finder.first_contact(&motion, 0.5, f64::INFINITY);
            assert!(t.is_some_and(|t| (t - 0.25).abs() < EASY), "{}: {t:?}", finder.name());
        }
    }

    #[test]
    fn no_finder_reports_a_contact_where_bodies_miss_or_separate() {
        let miss = Motion { d: [1.0, 0.5], v: [-2.0, 0.0], h: [0.1, 0.0] };
        let apart = Motion { d: [1.0, 0.0], v: [2.0, 0.0], h: [0.1, 0.2] };
        for finder in Finder::ALL {
            assert_eq!(finder.first_contact(&miss, 0.4, 1.0), None, "{}", finder.name());
            assert_eq!(finder.first_contact(&apart, 0.4, 1.0), None, "{}", finder.name());
        }
    }
}
