//! Systems of linear equations.

use carom::math::sqrt;

pub(super) fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

/// A solution of equations and the freedom that they leave.
pub(super) struct Solution {
    /// The smallest solution, or the nearest one if the equations contradict each other.
    pub(super) least: Vec<f64>,
    /// Orthonormal vectors that change nothing in the equations.
    pub(super) free: Vec<Vec<f64>>,
}

/// What is left of an equation counts as 0 below this, relative to the largest equation.
const DEPENDENT: f64 = 1e-9;

/// Solves `equations` (each a row of coefficients) for these right sides, by orthogonalising the
/// rows, the largest first (Householder 1958; Businger & Golub 1965).
pub(super) fn solve(
    mut equations: Vec<Vec<f64>>,
    mut right: Vec<f64>,
    unknowns: usize,
) -> Solution {
    // After k steps, row k is zero behind its element k in the reflected unknowns.
    let mut mirrors: Vec<Vec<f64>> = Vec::new();
    let first = equations.iter().map(|row| dot(row, row)).fold(0.0, f64::max);
    let mut rank = 0;
    while rank < equations.len().min(unknowns) {
        let size = |row: &Vec<f64>| dot(&row[rank..], &row[rank..]);
        let largest = (rank..equations.len())
            .max_by(|&i, &j| size(&equations[i]).total_cmp(&size(&equations[j])));
        let Some(largest) = largest else { break };
        let square = size(&equations[largest]);
        if square <= DEPENDENT * DEPENDENT * first {
            break;
        }
        equations.swap(rank, largest);
        right.swap(rank, largest);
        let mut mirror = vec![0.0; unknowns];
        mirror[rank..].copy_from_slice(&equations[rank][rank..]);
        mirror[rank] += sqrt(square).copysign(mirror[rank]);
        let scale = 1.0 / sqrt(dot(&mirror, &mirror));
        mirror.iter_mut().for_each(|x| *x *= scale);
        for row in &mut equations[rank..] {
            reflect(row, &mirror);
        }
        mirrors.push(mirror);
        rank += 1;
    }
    let mut least = vec![0.0; unknowns];
    for k in 0..rank {
        least[k] = (right[k] - dot(&equations[k][..k], &least[..k])) / equations[k][k];
    }
    let unreflected = |mut v: Vec<f64>| {
        mirrors.iter().rev().for_each(|mirror| reflect(&mut v, mirror));
        v
    };
    let unit = |k: usize| {
        let mut unit = vec![0.0; unknowns];
        unit[k] = 1.0;
        unit
    };
    Solution {
        least: unreflected(least),
        free: (rank..unknowns).map(|k| unreflected(unit(k))).collect(),
    }
}

/// Reflects `v` in the plane across the unit vector `mirror`.
fn reflect(v: &mut [f64], mirror: &[f64]) {
    let along = 2.0 * dot(v, mirror);
    v.iter_mut().zip(mirror).for_each(|(v, m)| *v -= along * m);
}

/// What is added to the diagonal of a symmetric matrix, relative to the diagonal.
const REGULAR: f64 = 1e-14;

/// The solution x of `matrix` x = `right`, for a symmetric matrix without negative squares
/// (Cholesky).
pub(super) fn solve_symmetric(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    for i in 0..matrix.len() {
        let (above, rest) = matrix.split_at_mut(i);
        let row = &mut rest[0];
        for (j, other) in above.iter().enumerate() {
            row[j] = (row[j] - dot(&row[..j], other)) / other[j];
        }
        let least = REGULAR * row[i] + f64::MIN_POSITIVE;
        row[i] = sqrt((row[i] + least - dot(&row[..i], &row[..i])).max(least));
    }
    for i in 0..right.len() {
        right[i] = (right[i] - dot(&matrix[i][..i], &right[..i])) / matrix[i][i];
    }
    for i in (0..right.len()).rev() {
        right[i] /= matrix[i][i];
        let known = right[i];
        right[..i].iter_mut().zip(&matrix[i]).for_each(|(x, l)| *x -= l * known);
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_a_symmetric_system() {
        let matrix = vec![vec![4.0, 1.0, 0.5], vec![1.0, 3.0, -1.0], vec![0.5, -1.0, 2.0]];
        let right = vec![1.0, -2.0, 3.0];
        let x = solve_symmetric(matrix.clone(), right.clone());
        for (row, right) in matrix.iter().zip(right) {
            assert!((dot(row, &x) - right).abs() < 1e-12);
        }
    }

    #[test]
    fn finds_the_smallest_solution_and_the_freedom_of_dependent_equations() {
        let equations =
            vec![vec![1.0, 1.0, 0.0, 0.0], vec![0.0, 0.0, 1.0, 2.0], vec![1.0, 1.0, 1.0, 2.0]];
        let solution = solve(equations.clone(), vec![2.0, 5.0, 7.0], 4);
        let expected = [1.0, 1.0, 1.0, 2.0];
        assert!(solution.least.iter().zip(expected).all(|(x, e)| (x - e).abs() < 1e-14));
        assert_eq!(solution.free.len(), 2);
        for free in &solution.free {
            assert!((dot(free, free) - 1.0).abs() < 1e-14);
            assert!(equations.iter().all(|row| dot(row, free).abs() < 1e-14));
        }
    }
}
