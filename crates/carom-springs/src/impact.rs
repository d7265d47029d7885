//! The integration of an impact.

use differential_equations::interpolate::Interpolation;
use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::ode::OrdinaryNumericalMethod;
use differential_equations::status::Status;

use crate::motion::{Equations, Settings, WEAK};
use crate::network::Network;

/// The longest step, in units of the shortest contact's time: a tenth of a contact.
const LONGEST_STEP: f64 = 0.3;
/// The first step after a start, in the same units.
const FIRST_STEP: f64 = 0.01;
/// An approach that has stopped, in the same units.
const STILL: f64 = 1e-9;
/// The most steps of the search for the instant at which an approach stops.
const MAX_NARROWINGS: u32 = 60;
/// The most steps of an impact.
const MAX_STEPS: u64 = 200_000;
/// The most instants without a force. Slow balls may bounce for ever.
const MAX_PAUSES: usize = 400;

/// The result of an integration.
#[derive(Clone, Debug)]
pub struct SpringImpact {
    /// The bodies at every instant, after the first force, at which no contact carries one, and the
    /// time of it, s. The last one is the end.
    pub pauses: Vec<(f64, Network)>,
    /// Steps of the method, with those that it repeated.
    pub steps: u64,
    /// Evaluations of all forces.
    pub evaluations: u64,
    /// Sweeps of the iteration for forces.
    pub sweeps: u64,
}

impl SpringImpact {
    /// The bodies at the end.
    pub fn end(&self) -> &Network {
        &self.pauses[self.pauses.len() - 1].1
    }
}

/// The instant in [begin, end] at which `speed` has the sign that it has at the end for the first
/// time; it changes its sign once. `end` if it does not change its sign.
fn crossing(begin: f64, end: f64, mut speed: impl FnMut(f64) -> f64) -> f64 {
    let (mut low, mut high) = (begin, end);
    let (mut before, mut after) = (speed(begin), speed(end));
    if before * after >= 0.0 {
        return end;
    }
    for k in 0..MAX_NARROWINGS {
        // False position; every third time bisection.
        let share = if k % 3 == 2 { 0.5 } else { before / (before - after) };
        let middle = low + (high - low) * share;
        let found = speed(middle);
        if found.abs() < STILL {
            return middle;
        }
        if found * after > 0.0 {
            (high, after) = (middle, found);
        } else {
            (low, before) = (middle, found);
        }
    }
    high
}

/// Integrates an impact, from the first contact until bodies that do not touch meet no other for
/// `horizon` (s). `None` if no two bodies approach.
pub fn resolve(start: &Network, settings: &Settings, horizon: f64) -> Option<SpringImpact> {
    let (motion, mut state) = Equations::of(start, settings)?;
    let unit = motion.units.time;
    let mut impact = SpringImpact { pauses: Vec::new(), steps: 0, evaluations: 0, sweeps: 0 };
    let mut time = 0.0;
    let mut method = ExplicitRungeKutta::dopri5()
        .rtol(0.0)
        .atol(settings.tolerance)
        .h0(FIRST_STEP)
        .h_max(LONGEST_STEP)
        .max_steps(usize::MAX);
    let mut turned = Vec::new();
    while let Some(wait) = motion.next_contact(&state, WEAK) {
        let awaited = impact.pauses.is_empty() || wait * unit <= horizon;
        if !awaited || impact.pauses.len() >= MAX_PAUSES {
            break;
        }
        motion.drift(&mut state, wait);
        time += wait;
        let (mut restart, mut step) = (true, FIRST_STEP);
        loop {
            if restart {
                let end = f64::MAX;
                if let Err(error) = method.init(&motion, time, end, &state) {
                    panic!("the integration does not start: {error:?}");
                }
                method.set_h(step);
                restart = false;
            }
            impact.steps += 1;
            assert!(impact.steps < MAX_STEPS, "the impact does not end");
            match method.step(&motion) {
                Ok(evaluations) => impact.evaluations += evaluations.function as u64,
                // The method counts steps at the limit of its stability. They are accurate.
                Err(_) => {
                    (time, step, restart) = (method.t(), method.h(), true);
                    state.clone_from(method.y());
                    continue;
                }
            }
            if matches!(method.status(), Status::RejectedStep) {
                continue;
            }
            state.clone_from(method.y());
            time = method.t();
            motion.find_turned(&state, &mut turned);
            let turns = !turned.is_empty();
            if turns {
                let begin = method.t_prev();
                let mut at = |time: f64| method.interpolate(time).expect("a time in the step");
                let instants = turned
                    .iter()
                    .map(|&k| crossing(begin, time, |time| motion.approach(k, &at(time))));
                let first = instants.fold(time, f64::min);
                if first < time {
                    (time, state) = (first, at(first));
                }
                motion.turn(&turned, &state);
                motion.refresh(&state);
            }
            let changed = motion.finish_step(&mut state) || turns;
            if motion.is_free(&state) {
                break;
            }
            if changed {
                step = method.h();
                restart = true;
            }
        }
        impact.pauses.push((time * unit, motion.network(start, &state)));
    }
    impact.sweeps = motion.sweeps();
    (!impact.pauses.is_empty()).then_some(impact)
}
