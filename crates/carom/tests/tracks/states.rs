use carom::candidates::{Candidates, Variation};
use carom::error::ErrorKind;
use carom::resolve::cue_ball::Strike;
use carom::tracks::{SampledStates, StateQuestion, sample_states};
use carom::{BallState, Shot};

use super::{example, examples, runner, three_balls};

const ALL: StateQuestion<'static> =
    StateQuestion { times: &[], count: 0, balls: &[], velocity: true, angular_velocity: true };

fn sampled(candidates: &Candidates, times: &[f64], count: usize, balls: &[usize]) -> SampledStates {
    let question = StateQuestion { times, count, balls, ..ALL };
    sample_states(candidates, &question, &runner(2)).unwrap_or_else(|e| panic!("{e}"))
}

fn of_shot(shot: &Shot, times: &[f64]) -> SampledStates {
    let balls: Vec<usize> = (0..shot.balls().len()).collect();
    sampled(&Candidates::of_shots(vec![shot.clone()]), times, times.len(), &balls)
}

/// The bits of a state, so that NaN equals NaN and 0 differs from −0.
fn bits(position: [f64; 3], velocity: [f64; 3], spin: [f64; 3]) -> [u64; 9] {
    let mut all = [0; 9];
    let numbers = position.into_iter().chain(velocity).chain(spin);
    all.iter_mut().zip(numbers).for_each(|(bits, x)| *bits = x.to_bits());
    all
}

fn bits_at(found: &SampledStates, index: usize) -> [u64; 9] {
    bits(found.position[index], found.velocity[index], found.angular_velocity[index])
}

fn bits_of(state: &BallState) -> [u64; 9] {
    bits(state.position.to_array(), state.velocity.to_array(), state.angular_velocity.to_array())
}

/// Checks the states of `shot` at 40 times of the shot, at its events and behind its end.
fn agrees_with_its_trace(name: &str, shot: &Shot) {
    let trace = shot.simulate().unwrap_or_else(|e| panic!("{name}: {e}"));
    let end = trace.duration();
    let mut times: Vec<f64> = (0..40).map(|k| end * f64::from(k * 17 % 40) / 37.0).collect();
    times.extend(trace.events().map(|event| event.time));
    times.extend([0.0, end, end + 1.0, 2.0 * end]);
    let found = of_shot(shot, &times);
    assert!(found.errors.is_empty(), "{name}: {:?}", found.errors);
    let balls = shot.balls().len();
    for (t, &time) in times.iter().enumerate() {
        for (ball, state) in trace.at(time).unwrap_or_else(|e| panic!("{e}")).iter().enumerate() {
            let index = t * balls + ball;
            assert_eq!(bits_at(&found, index), bits_of(state), "{name} {time} {ball}");
            assert_eq!(found.in_play[index], state.motion.in_play(), "{name} {time} {ball}");
        }
    }
}

#[test]
fn states_have_the_bits_of_the_trace() {
    for (name, shot) in examples() {
        agrees_with_its_trace(&name, &shot);
    }
}

#[test]
fn states_of_a_shot_with_an_end_time_have_the_bits_of_the_trace() {
    for (name, until) in [("nine_ball_break", 0.7), ("masse", 1.3), ("follow_shot", 60.0)] {
        let shot = example(name).with_until(Some(until)).unwrap_or_else(|e| panic!("{e}"));
        agrees_with_its_trace(name, &shot);
    }
}

#[test]
fn a_simulation_that_stops_at_its_last_time_has_the_same_states() {
    let shot = three_balls();
    let times: Vec<f64> = (0..200).map(|k| 0.05 * f64::from(k)).collect();
    let whole = of_shot(&shot, &times);
    for count in [1, 20, 73] {
        let part = of_shot(&shot, &times[..count]);
        assert_eq!(part.position[..], whole.position[..3 * count]);
        assert_eq!(part.angular_velocity[..], whole.angular_velocity[..3 * count]);
    }
}

/// Strikes of `shot` with different azimuths, the last of them too fast.
fn strikes(shot: &Shot, count: usize) -> Candidates {
    let (_, own) = shot.strike().expect("a strike");
    let mut strikes: Vec<Strike> =
        (0..count).map(|k| Strike { azimuth: own.azimuth + 1e-3 * k as f64, ..own }).collect();
    strikes[count - 1].speed = 1e3;
    let variation = Variation { strikes: Some(strikes), ..Variation::default() };
    Candidates::new(vec![shot.clone()], vec![0; count], variation).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn every_number_of_threads_gives_the_same_bits() {
    let candidates = strikes(&three_balls(), 50);
    let times = [1.0, 0.5, 2.5];
    let question = StateQuestion { times: &times, count: 3, balls: &[2, 0], ..ALL };
    let all: Vec<SampledStates> = [1, 2, 5]
        .map(|threads| sample_states(&candidates, &question, &runner(threads)).expect("states"))
        .into();
    let bits = |states: &SampledStates| -> Vec<[u64; 9]> {
        (0..states.position.len()).map(|index| bits_at(states, index)).collect()
    };
    assert_eq!(bits(&all[0]), bits(&all[1]));
    assert_eq!(bits(&all[0]), bits(&all[2]));
    assert_eq!(all[0].errors, all[2].errors);
}

#[test]
fn candidates_may_have_their_own_times_and_numbers_of_balls() {
    let shots = vec![three_balls(), example("half_ball_cut")];
    let traces: Vec<_> = shots.iter().map(|shot| shot.simulate().expect("a trace")).collect();
    let candidates = Candidates::of_shots(shots);
    let times = [2.0, f64::NAN, 0.25, 0.1, 0.3, 0.2];
    let found = sampled(&candidates, &times, 3, &[2, 1]);
    assert_eq!(found.position.len(), 12);
    for (shot, trace) in traces.iter().enumerate() {
        for (t, time) in times[3 * shot..3 * shot + 3].iter().enumerate() {
            for (column, ball) in [2, 1].into_iter().enumerate() {
                let index = (3 * shot + t) * 2 + column;
                let state = if time.is_nan() { None } else { trace.at(*time).ok() };
                match state.as_ref().and_then(|states| states.get(ball)) {
                    Some(state) => assert_eq!(bits_at(&found, index), bits_of(state)),
                    None => {
                        assert!(found.position[index].iter().all(|x| x.is_nan()));
                        assert!(!found.in_play[index]);
                    }
                }
            }
        }
    }
}

#[test]
fn a_refused_candidate_has_an_error_and_no_numbers() {
    let candidates = strikes(&three_balls(), 11);
    let found = sampled(&candidates, &[0.5], 1, &[0, 1, 2]);
    let [(10, error)] = &found.errors[..] else { panic!("one error, got {:?}", found.errors) };
    assert_eq!(error.to_string(), candidates.shot(10).expect_err("too fast").to_string());
    assert!(error.to_string().starts_with("strike.speed: "), "{error}");
    assert!(found.position[30..].iter().flatten().all(|x| x.is_nan()));
    assert!(found.velocity[30..].iter().flatten().all(|x| x.is_nan()));
    assert!(found.position[..30].iter().flatten().all(|x| x.is_finite()));
}

#[test]
fn wrong_questions_are_refused() {
    let candidates = Candidates::of_shots(vec![three_balls(), three_balls()]);
    for (times, count, balls, kind) in [
        (&[0.5, -1.0][..], 2, &[0][..], ErrorKind::OutOfRange),
        (&[f64::INFINITY], 1, &[0], ErrorKind::OutOfRange),
        (&[0.5, 0.6, 0.7], 2, &[0], ErrorKind::WrongCount),
        (&[0.5], 1, &[3], ErrorKind::UnknownBall),
        (&[0.5], 1, &[1, 0, 1], ErrorKind::Duplicate),
    ] {
        let question = StateQuestion { times, count, balls, ..ALL };
        let error = sample_states(&candidates, &question, &runner(1)).expect_err("bad input");
        assert_eq!(error.kind(), kind, "{error}");
    }
}
