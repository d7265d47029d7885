//! Checks the states that a trace returns at sampled times.

use carom::shot::Shot;
use carom::{BallState, Trace};

use crate::solid::Solid;
use crate::{Fault, FaultKind};

/// Largest allowed overlap at a sampled time, m: [`DEPTH`](crate::DEPTH), and the rounding errors
/// of a position on the table and of a path from its last event to the sample.
pub const SAMPLED_DEPTH: f64 = 2e-12;

/// Checks `trace` of `shot` at `samples` + 1 evenly spaced times (at least 2): no ball may overlap
/// another one or the table, or be in play beyond the table's border.
pub fn check_samples(shot: &Shot, trace: &Trace, samples: u32) -> Vec<Fault> {
    let solid = Solid::of(shot.table());
    let mut faults = Vec::new();
    let samples = samples.max(1);
    for k in 0..=samples {
        let time = trace.duration() * f64::from(k) / f64::from(samples);
        let states = match trace.at(time) {
            Ok(states) => states,
            Err(error) => {
                let what = format!("no states at this time: {error}");
                return vec![Fault { time, kind: FaultKind::OffPath, what }];
            }
        };
        let mut report = |depth: f64, what: String| {
            if depth > SAMPLED_DEPTH || depth.is_nan() {
                let what = format!("{what} overlap by {depth:e} m");
                faults.push(Fault { time, kind: FaultKind::Overlap, what });
            }
        };
        report_depths(shot, &solid, &states, &mut report);
    }
    faults
}

/// Calls `report` with the overlap (m; negative if clear) of each ball with the table, the border
/// and every other ball.
fn report_depths(
    shot: &Shot,
    solid: &Solid,
    states: &[BallState],
    report: &mut impl FnMut(f64, String),
) {
    let radius = |i: usize| shot.balls()[i].ball.radius;
    for (i, state) in states.iter().enumerate().filter(|(_, s)| s.motion.in_play()) {
        let c = state.position - solid.plan.center().with_z(0.0);
        let (depth, name) = solid.depth(c, radius(i));
        report(depth, format!("ball {i} and {name}"));
        let beyond = (c.x.abs() - solid.border.x).max(c.y.abs() - solid.border.y);
        report(beyond, format!("ball {i} and the border"));
        for (j, other) in states[..i].iter().enumerate().filter(|(_, s)| s.motion.in_play()) {
            let apart = (state.position - other.position).length();
            report(radius(i) + radius(j) - apart, format!("balls {j} and {i}"));
        }
    }
}
