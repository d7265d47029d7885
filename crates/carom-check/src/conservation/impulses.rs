//! Whether impulses at a set of contacts can explain given changes of motion.
//!
//! Every contact gives its two bodies opposite impulses at one point: a normal part N ≥ 0, for
//! bodies cannot pull each other, and a tangential part of at most μN. With few contacts the
//! impulses follow from the changes; in a rack they do not, and it is asked whether some exist. So
//! the least pull p is sought with which N + p ≥ 0 and the tangential parts of at most μ(N + p)
//! give the changes: an optimisation over second-order cones, solved by an interior-point method
//! (Boyd & Vandenberghe, *Convex Optimization*, 2004, section 11.4). It stops as soon as p is small
//! enough, or is proved not to become so.
//!
//! A contact may also be with a body that does not move, such as a rail or the slate.

use carom::math::{Vec3, sqrt};

use super::linear::{dot, solve, solve_symmetric};

/// The contact of body `a` with body `b`, or with a body of infinite mass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    pub(super) a: usize,
    pub(super) b: Option<usize>,
    /// Unit vector from the centre of `a` to the contact.
    pub(super) normal: Vec3,
    /// Largest coefficient of friction.
    pub(super) friction: f64,
}

/// The change of a ball's motion, in any unit of momentum.
#[derive(Clone, Copy, Debug)]
pub(super) struct Change {
    /// Of its momentum.
    pub(super) momentum: Vec3,
    /// Of its angular momentum, divided by its radius.
    pub(super) spin: Vec3,
    /// Limits of an upward impulse that the contacts do not give: of the slate, or a hop that is
    /// left out.
    pub(super) lift: [f64; 2],
}

/// Why impulses cannot explain changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Unexplained {
    /// No impulses at the contacts give the changes: the largest difference.
    Inconsistent(f64),
    /// Only impulses that pull do: the least pull.
    Pulled(f64),
}

/// The most steps of the method. Most events need about ten.
const MOST_STEPS: u32 = 200;

/// Growth of the weight of the pull from step to step.
const SHARPER: f64 = 5.0;

/// Largest part of the way to the surface of a cone that one step goes.
const SHARE: f64 = 0.9;

/// Components of a ball's change: three of its momentum and three of its spin.
const ROWS: usize = 6;

/// Whether impulses with a pull of at most `most` give the changes to the accuracy `goal`.
pub(super) fn explain(
    contacts: &[Contact],
    changes: &[Change],
    most: f64,
    goal: f64,
) -> Result<(), Unexplained> {
    let problem = Problem::new(contacts, changes);
    let (equations, wanted) = problem.equations();
    let solution = solve(equations.clone(), wanted.clone(), problem.unknowns());
    let error = |(row, wanted): (&Vec<f64>, &f64)| (dot(row, &solution.least) - wanted).abs();
    let largest = equations.iter().zip(&wanted).map(error).fold(0.0, f64::max);
    if largest > goal {
        return Err(Unexplained::Inconsistent(largest));
    }
    problem.least_pull(solution.least, &solution.free, most)
}

/// The unknowns are a vector for each contact, and then the lift of each ball that can have one. The
/// vector is the impulse on the second body with its tangential part divided by μ, so that the cones
/// are right ones.
struct Problem<'a> {
    contacts: &'a [Contact],
    changes: &'a [Change],
    /// The balls that can have a lift.
    lifted: Vec<usize>,
}

impl Contact {
    /// `j` with its part across the normal multiplied by μ.
    fn rubbed(&self, j: Vec3) -> Vec3 {
        let along = self.normal * j.dot(self.normal);
        along + (j - along) * self.friction
    }
}

/// The vector of contact `k`.
fn vector(x: &[f64], k: usize) -> Vec3 {
    Vec3::new(x[3 * k], x[3 * k + 1], x[3 * k + 2])
}

/// `v` mirrored in the direction of `normal`, so that N² − T² = v · mirrored.
fn mirrored(normal: Vec3, v: Vec3) -> Vec3 {
    normal * (2.0 * v.dot(normal)) - v
}

impl<'a> Problem<'a> {
    fn new(contacts: &'a [Contact], changes: &'a [Change]) -> Self {
        let can = |k: &usize| changes[*k].lift[0] < changes[*k].lift[1];
        Self { contacts, changes, lifted: (0..changes.len()).filter(can).collect() }
    }

    fn unknowns(&self) -> usize {
        3 * self.contacts.len() + self.lifted.len()
    }

    /// The equations of the changes, and their right sides.
    fn equations(&self) -> (Vec<Vec<f64>>, Vec<f64>) {
        let mut rows = vec![vec![0.0; self.unknowns()]; ROWS * self.changes.len()];
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
        for (k, contact) in self.contacts.iter().enumerate() {
            for (i, axis) in axes.into_iter().enumerate() {
                let push = contact.rubbed(axis);
                // The arms are R_a n and −R_b n, so both balls turn in the same sense.
                let turn = -contact.normal.cross(push);
                let mut add = |ball: usize, push: Vec3| {
                    let all = push.to_array().into_iter().chain(turn.to_array());
                    for (row, value) in rows[ROWS * ball..].iter_mut().zip(all) {
                        row[3 * k + i] += value;
                    }
                };
                add(contact.a, -push);
                if let Some(b) = contact.b {
                    add(b, push);
                }
            }
        }
        for (k, ball) in self.lifted.iter().enumerate() {
            rows[ROWS * ball + 2][3 * self.contacts.len() + k] = 1.0;
        }
        let wanted = |c: &Change| c.momentum.to_array().into_iter().chain(c.spin.to_array());
        (rows, self.changes.iter().flat_map(wanted).collect())
    }

    /// How far beyond the limits of each lift `x` is, m.
    fn beyond(&self, x: &[f64]) -> impl Iterator<Item = [f64; 2]> {
        let lifts = &x[3 * self.contacts.len()..];
        self.lifted.iter().zip(lifts).map(|(&ball, lift)| {
            let [low, high] = self.changes[ball].lift;
            [low - lift, lift - high]
        })
    }

    /// The largest pull of these impulses, or transgression of a lift's limit.
    fn pull(&self, x: &[f64]) -> f64 {
        let of_contact = |(k, contact): (usize, &Contact)| {
            let j = vector(x, k);
            let along = j.dot(contact.normal);
            sqrt((j.length_squared() - along * along).max(0.0)) - along
        };
        let contacts = self.contacts.iter().enumerate().map(of_contact);
        contacts.chain(self.beyond(x).flatten()).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Seeks a pull of at most `most` among the impulses `x` plus multiples of the vectors `free`.
    fn least_pull(&self, mut x: Vec<f64>, free: &[Vec<f64>], most: f64) -> Result<(), Unexplained> {
        let size = x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let mut pull = self.pull(&x).max(0.0) + size;
        let mut weight = 1.0 / pull;
        let mut least = self.pull(&x);
        for _ in 0..MOST_STEPS {
            if least <= most || free.is_empty() {
                break;
            }
            let share = self.step(&mut x, &mut pull, weight, free);
            least = least.min(self.pull(&x));
            // On the central path the pull is at most the number of cones and limits, twice, over
            // the weight above the least one.
            let barrier = 2.0 * (self.contacts.len() + self.lifted.len()) as f64;
            if share == 1.0 && barrier < 0.1 * most * weight {
                break;
            }
            if share > 0.5 {
                weight *= SHARPER;
            }
        }
        if least <= most { Ok(()) } else { Err(Unexplained::Pulled(least)) }
    }

    /// Slope of the barrier, and its bend times a vector, where the pull is the last component of
    /// both.
    fn slope(&self, x: &[f64], pull: f64) -> Vec<f64> {
        let mut slope = vec![0.0; x.len() + 1];
        for (k, contact) in self.contacts.iter().enumerate() {
            let u = vector(x, k) + contact.normal * pull;
            let m = mirrored(contact.normal, u);
            let g = m * (-2.0 / u.dot(m));
            slope[3 * k..3 * k + 3].copy_from_slice(&g.to_array());
            slope[x.len()] += g.dot(contact.normal);
        }
        for (k, [low, high]) in self.beyond(x).enumerate() {
            let (below, above) = (1.0 / (pull - low), 1.0 / (pull - high));
            slope[3 * self.contacts.len() + k] = above - below;
            slope[x.len()] -= above + below;
        }
        slope
    }

    fn bend(&self, x: &[f64], pull: f64, v: &[f64]) -> Vec<f64> {
        let mut bend = vec![0.0; x.len() + 1];
        let rise = v[x.len()];
        for (k, contact) in self.contacts.iter().enumerate() {
            let u = vector(x, k) + contact.normal * pull;
            let m = mirrored(contact.normal, u);
            let square = u.dot(m);
            let j = vector(v, k) + contact.normal * rise;
            let h = m * (4.0 * m.dot(j) / (square * square))
                - mirrored(contact.normal, j) * (2.0 / square);
            bend[3 * k..3 * k + 3].copy_from_slice(&h.to_array());
            bend[x.len()] += h.dot(contact.normal);
        }
        for (k, [low, high]) in self.beyond(x).enumerate() {
            let at = 3 * self.contacts.len() + k;
            let (below, above) = (1.0 / (pull - low), 1.0 / (pull - high));
            let (down, up) = (below * below * (v[at] + rise), above * above * (rise - v[at]));
            bend[at] = down - up;
            bend[x.len()] += down + up;
        }
        bend
    }

    /// One step of Newton's method. Returns the part of it that was taken.
    fn step(&self, x: &mut [f64], pull: &mut f64, weight: f64, free: &[Vec<f64>]) -> f64 {
        let mut directions: Vec<Vec<f64>> =
            free.iter().map(|v| v.iter().copied().chain([0.0]).collect()).collect();
        let mut rise = vec![0.0; x.len() + 1];
        rise[x.len()] = 1.0;
        directions.push(rise);
        let mut slope = self.slope(x, *pull);
        slope[x.len()] += weight;
        let bends: Vec<Vec<f64>> = directions.iter().map(|v| self.bend(x, *pull, v)).collect();
        let matrix = bends.iter().map(|b| directions.iter().map(|v| dot(b, v)).collect()).collect();
        let right = directions.iter().map(|v| -dot(v, &slope)).collect();
        let mut step = vec![0.0; x.len() + 1];
        for (v, length) in directions.iter().zip(solve_symmetric(matrix, right)) {
            step.iter_mut().zip(v).for_each(|(s, v)| *s += length * v);
        }
        let at = |share: f64| {
            let moved: Vec<f64> = x.iter().zip(&step).map(|(x, s)| x + share * s).collect();
            (moved, *pull + share * step[x.len()])
        };
        let mut share = 1.0;
        let (mut moved, mut raised) = at(share);
        while self.pull(&moved) >= raised && share > f64::EPSILON {
            share *= SHARE;
            (moved, raised) = at(share);
        }
        if share < 1.0 {
            (moved, raised) = at(SHARE * share);
        }
        x.copy_from_slice(&moved);
        *pull = raised;
        share
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOST: f64 = 1e-7;
    const GOAL: f64 = 1e-10;

    /// The contacts of balls at these places (in diameters), with this friction.
    fn contacts(places: &[(f64, f64)], friction: f64) -> Vec<Contact> {
        let mut contacts = Vec::new();
        for (a, p) in places.iter().enumerate() {
            for (b, q) in places.iter().enumerate().skip(a + 1) {
                let d = Vec3::new(q.0 - p.0, q.1 - p.1, 0.0);
                if d.length() < 1.0 + 1e-9 {
                    contacts.push(Contact { a, b: Some(b), normal: d, friction });
                }
            }
        }
        contacts
    }

    fn pushed(momenta: &[[f64; 3]]) -> Vec<Change> {
        let change =
            |m: &[f64; 3]| Change { momentum: Vec3::from(*m), spin: Vec3::ZERO, lift: [0.0; 2] };
        momenta.iter().map(change).collect()
    }

    const ROW: [(f64, f64); 3] = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)];

    #[test]
    fn a_push_through_a_row_is_explained() {
        let changes = pushed(&[[-1.0, 0.0, 0.0], [0.2, 0.0, 0.0], [0.8, 0.0, 0.0]]);
        assert_eq!(explain(&contacts(&ROW, 0.1), &changes, MOST, GOAL), Ok(()));
    }

    #[test]
    fn a_pull_is_not_explained() {
        let changes = pushed(&[[-1.0, 0.0, 0.0], [1.1, 0.0, 0.0], [-0.1, 0.0, 0.0]]);
        let result = explain(&contacts(&ROW, 0.1), &changes, MOST, GOAL);
        let Err(Unexplained::Pulled(pull)) = result else { panic!("{result:?}") };
        assert!((pull - 0.1).abs() < MOST, "{pull}");
    }

    #[test]
    fn momentum_that_is_not_conserved_is_not_explained() {
        let changes = pushed(&[[-1.0, 0.0, 0.0], [0.2, 0.0, 0.0], [0.9, 0.0, 0.0]]);
        let result = explain(&contacts(&ROW, 0.1), &changes, MOST, GOAL);
        assert!(matches!(result, Err(Unexplained::Inconsistent(_))), "{result:?}");
    }

    #[test]
    fn a_tangential_impulse_needs_friction_and_spin() {
        // The impulse (1, 0.05, 0) on the second ball.
        let mut changes = pushed(&[[-1.0, -0.05, 0.0], [1.0, 0.05, 0.0], [0.0, 0.0, 0.0]]);
        let row = contacts(&ROW, 0.06);
        assert!(explain(&row, &changes, MOST, GOAL).is_err());
        changes[0].spin.z = -0.05;
        changes[1].spin.z = -0.05;
        assert_eq!(explain(&row, &changes, MOST, GOAL), Ok(()));
        assert!(explain(&contacts(&ROW, 0.049), &changes, MOST, GOAL).is_err());
    }

    #[test]
    fn impulses_in_a_triangle_need_not_be_unique() {
        let h = 0.75_f64.sqrt();
        let places =
            [(0.0, 0.0), (-0.5, h), (0.5, h), (-1.0, 2.0 * h), (0.0, 2.0 * h), (1.0, 2.0 * h)];
        let rack = contacts(&places, 0.06);
        assert_eq!(rack.len(), 9);
        let changes = pushed(&[[0.0; 3]; 6]);
        let (equations, _) = Problem::new(&rack, &changes).equations();
        // Normal impulses of 1 to 9, and friction across the contacts.
        let impulse = |(k, c): (usize, &Contact)| {
            let n = 1.0 + k as f64;
            c.normal * n + Vec3::new(0.0, 0.0, 0.9 * n)
        };
        let chosen: Vec<f64> =
            rack.iter().enumerate().flat_map(|all| impulse(all).to_array()).collect();
        let sums: Vec<f64> = equations.iter().map(|row| dot(row, &chosen)).collect();
        let given: Vec<Change> = sums
            .as_chunks::<ROWS>()
            .0
            .iter()
            .map(|s| Change {
                momentum: Vec3::new(s[0], s[1], s[2]),
                spin: Vec3::new(s[3], s[4], s[5]),
                lift: [0.0; 2],
            })
            .collect();
        assert_eq!(explain(&rack, &given, MOST, GOAL), Ok(()));
    }

    #[test]
    fn a_wall_pushes_and_does_not_pull() {
        let wall = [Contact { a: 0, b: None, normal: Vec3::new(1.0, 0.0, 0.0), friction: 0.2 }];
        assert_eq!(explain(&wall, &pushed(&[[-1.0, 0.0, 0.0]]), MOST, GOAL), Ok(()));
        assert!(explain(&wall, &pushed(&[[1.0, 0.0, 0.0]]), MOST, GOAL).is_err());
    }
}
