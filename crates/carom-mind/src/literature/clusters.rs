//! Clusters of similar states.
//!
//! CueCard (Archibald, Altman & Shoham 2009) searches a few representatives of the states that a
//! shot may leave, and weights each by the number of states that it stands for. **Guess:** the
//! paper names no method. Here the first centres are chosen far apart (Gonzalez, *Clustering to
//! minimize the maximum intercluster distance*, 1985) and then moved by Lloyd's iteration (*Least
//! squares quantization in PCM*, 1982). Nothing is random.

use carom_rules::Frame;

/// Most rounds of Lloyd's iteration. Fifty states settle in three or four.
const ROUNDS: usize = 12;

/// A state that stands for a cluster.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Representative {
    /// The state's number.
    pub(crate) state: usize,
    /// Number of states in its cluster.
    pub(crate) count: usize,
}

/// The places of all balls as one point: x and y of each ball, m. A ball that is down is one table
/// length outside, so states with different balls on the table are far apart.
pub(crate) fn point(frame: &Frame) -> Vec<f64> {
    let outside = -frame.base().table().size.y;
    let layout = frame.layout();
    (0..)
        .take(layout.len())
        .flat_map(|ball| layout.place(ball).unwrap_or([outside, outside]))
        .collect()
}

/// At most `count` representatives of `points`, which have equal lengths. With at least as many as
/// there are points, each point represents itself.
pub(crate) fn representatives(points: &[Vec<f64>], count: usize) -> Vec<Representative> {
    if points.len() <= count {
        return (0..points.len()).map(|state| Representative { state, count: 1 }).collect();
    }
    let mut centers = far_apart(points, count.max(1));
    let mut owners = vec![0; points.len()];
    for _ in 0..ROUNDS {
        let next: Vec<usize> = points.iter().map(|point| nearest(&centers, point)).collect();
        let is_settled = next == owners;
        owners = next;
        for (k, center) in centers.iter_mut().enumerate() {
            let own = points.iter().zip(&owners).filter(|(_, owner)| **owner == k);
            if let Some(mean) = mean(own.map(|(point, _)| point)) {
                *center = mean;
            }
        }
        if is_settled {
            break;
        }
    }
    let of_cluster = |k: usize| {
        let own = || (0..points.len()).filter(|n| owners[*n] == k);
        let gap = |n: &usize| squared(&points[*n], &centers[k]);
        let state = own().min_by(|a, b| gap(a).total_cmp(&gap(b)))?;
        Some(Representative { state, count: own().count() })
    };
    (0..centers.len()).filter_map(of_cluster).collect()
}

/// `count` of the points: the first, then each time the one farthest from those chosen.
fn far_apart(points: &[Vec<f64>], count: usize) -> Vec<Vec<f64>> {
    let mut centers = vec![points[0].clone()];
    let mut gaps: Vec<f64> = points.iter().map(|point| squared(point, &points[0])).collect();
    while centers.len() < count {
        let farthest =
            (0..points.len()).max_by(|a, b| gaps[*a].total_cmp(&gaps[*b]).then(b.cmp(a)));
        let Some(farthest) = farthest.filter(|n| gaps[*n] > 0.0) else { break };
        centers.push(points[farthest].clone());
        for (gap, point) in gaps.iter_mut().zip(points) {
            *gap = gap.min(squared(point, &points[farthest]));
        }
    }
    centers
}

fn nearest(centers: &[Vec<f64>], point: &[f64]) -> usize {
    let gap = |k: &usize| squared(&centers[*k], point);
    (0..centers.len()).min_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or_default()
}

fn mean<'a>(points: impl Iterator<Item = &'a Vec<f64>>) -> Option<Vec<f64>> {
    let mut count = 0.0;
    let mut sum: Vec<f64> = Vec::new();
    for point in points {
        sum.resize(point.len(), 0.0);
        sum.iter_mut().zip(point).for_each(|(sum, x)| *sum += x);
        count += 1.0;
    }
    (count > 0.0).then(|| sum.into_iter().map(|x| x / count).collect())
}

fn squared(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum()
}

#[cfg(test)]
mod tests {
    use super::{Representative, representatives};

    #[test]
    fn two_heaps_of_points_become_two_clusters() {
        let points: Vec<Vec<f64>> =
            [0.0, 0.1, 5.0, 0.2, 5.1].into_iter().map(|x| vec![x, -x]).collect();
        let found = representatives(&points, 2);
        let expected =
            [Representative { state: 1, count: 3 }, Representative { state: 2, count: 2 }];
        assert_eq!(found, expected);
    }

    #[test]
    fn every_point_is_counted_once_and_equal_points_make_one_cluster() {
        let points: Vec<Vec<f64>> = (0..50).map(|k| vec![f64::from(k * k % 17)]).collect();
        for count in 1..20 {
            let found = representatives(&points, count);
            assert_eq!(found.iter().map(|own| own.count).sum::<usize>(), 50, "{count}");
            assert!(found.len() <= count);
        }
        let equal = vec![vec![1.0, 2.0]; 7];
        assert_eq!(representatives(&equal, 3), [Representative { state: 0, count: 7 }]);
    }

    #[test]
    fn with_enough_clusters_every_point_represents_itself() {
        let points: Vec<Vec<f64>> = (0..4).map(|k| vec![f64::from(k)]).collect();
        let found = representatives(&points, 4);
        assert!(found.iter().enumerate().all(|(k, own)| (own.state, own.count) == (k, 1)));
    }
}
