use carom::candidates::{Candidates, Variation};
use carom::error::ErrorKind;
use carom::resolve::cue_ball::Strike;
use carom::tracks::{
    BallTrack, BallTracks, Residuals, StateQuestion, TrackFrame, TrackQuestion, sample_states,
    track_residuals,
};
use carom::{Error, Shot};

use super::{example, runner, three_balls};

const ALL: TrackQuestion<'static> = TrackQuestion {
    clocks: &[0.0],
    frames: &[TrackFrame { offset: [0.0; 2], rotation: 0.0, scale: 1.0 }],
    horizons: &[f64::INFINITY],
    samples: true,
};

/// The track of ball `ball` of `shot` at `times`, seen `clock` later.
fn track(shot: &Shot, ball: usize, times: &[f64], clock: f64) -> BallTrack {
    let trace = shot.simulate().unwrap_or_else(|e| panic!("{e}"));
    let position = |time: &f64| {
        let state = trace.at(*time).unwrap_or_else(|e| panic!("{e}"))[ball];
        [state.position.x, state.position.y]
    };
    BallTrack {
        id: shot.balls()[ball].id.clone(),
        times: times.iter().map(|time| time + clock).collect(),
        positions: times.iter().map(position).collect(),
        sigmas: vec![1.0; times.len()],
    }
}

fn tracks(all: Vec<BallTrack>) -> BallTracks {
    BallTracks::new(all).unwrap_or_else(|e| panic!("{e}"))
}

/// `count` strikes of a shot, one of which is the shot's own, at index 0.
fn strikes(shot: &Shot, count: usize) -> Candidates {
    let (_, own) = shot.strike().expect("a strike");
    let strike = |k: usize| Strike { azimuth: own.azimuth + 1e-3 * k as f64, ..own };
    let strikes = Some((0..count).map(strike).collect());
    let variation = Variation { strikes, ..Variation::default() };
    Candidates::new(vec![shot.clone()], vec![0; count], variation).unwrap_or_else(|e| panic!("{e}"))
}

fn found(
    candidates: &Candidates,
    tracks: &[BallTracks],
    question: &TrackQuestion<'_>,
) -> Residuals {
    let tracks: Vec<&BallTracks> = tracks.iter().collect();
    track_residuals(candidates, &tracks, question, &runner(2)).unwrap_or_else(|e| panic!("{e}"))
}

fn refused(tracks: Vec<BallTrack>) -> (String, ErrorKind) {
    match BallTracks::new(tracks) {
        Err(Error::Input(e)) => (e.place, e.kind),
        other => panic!("expected a refusal, got {other:?}"),
    }
}

/// Unsorted times, different for each ball.
fn ragged(ball: usize) -> Vec<f64> {
    (0..30 + 7 * ball).map(|k| 0.2 * ((k * 11) % 37) as f64 + 0.01 * ball as f64).collect()
}

#[test]
fn the_shot_that_made_the_tracks_has_no_residual() {
    for shot in [three_balls(), example("nine_ball_break")] {
        let all = (0..3).map(|ball| track(&shot, ball, &ragged(ball), 0.0)).collect();
        let result = found(&Candidates::of_shots(vec![shot]), &[tracks(all)], &ALL);
        assert_eq!((result.samples, result.tracks), (111, 3));
        assert!(result.residual.iter().all(|r| *r == [0.0; 2]), "{:?}", result.residual);
        assert_eq!(result.sum, [0.0; 3]);
    }
}

#[test]
fn residuals_are_the_sampled_positions_minus_the_placed_track() {
    let shot = three_balls();
    let candidates = strikes(&shot, 9);
    let seen: Vec<BallTrack> = [2, 0]
        .map(|ball| BallTrack {
            sigmas: vec![0.002; ragged(ball).len()],
            ..track(&shot, ball, &ragged(ball), 0.4)
        })
        .into();
    let frame = TrackFrame { offset: [0.003, -0.002], rotation: 0.01, scale: 1.002 };
    let question = TrackQuestion { clocks: &[0.35], frames: &[frame], ..ALL };
    let result = found(&candidates, &[tracks(seen.clone())], &question);
    let (sin, cos) = carom::math::sin_cos(frame.rotation);
    let center = shot.table().center();
    let mut index = 0;
    for (column, track) in seen.iter().enumerate() {
        let ball = [2, 0][column];
        let times: Vec<f64> = track.times.iter().map(|t| t - 0.35).collect();
        let wanted = StateQuestion {
            times: &times,
            count: times.len(),
            balls: &[ball],
            velocity: false,
            angular_velocity: false,
        };
        let states = sample_states(&candidates, &wanted, &runner(1)).expect("states");
        let mut sums = [0.0; 9];
        for (k, [x, y]) in track.positions.iter().enumerate() {
            let (u, v) = (x - center.x, y - center.y);
            let placed = [
                center.x + frame.scale * (cos * u - sin * v) + frame.offset[0],
                center.y + frame.scale * (sin * u + cos * v) + frame.offset[1],
            ];
            for (candidate, sum) in sums.iter_mut().enumerate() {
                let position = states.position[candidate * times.len() + k];
                let residual = result.residual[candidate * result.samples + index + k];
                for axis in 0..2 {
                    let expected = (position[axis] - placed[axis]) / 0.002;
                    assert!((residual[axis] - expected).abs() < 1e-10, "{residual:?} {expected}");
                    *sum += expected * expected;
                }
            }
        }
        for (candidate, sum) in sums.iter().enumerate() {
            let found = result.sum[candidate * 2 + column];
            assert!((found / sum - 1.0).abs() < 1e-10, "{found} {sum}");
        }
        index += times.len();
    }
}

#[test]
fn before_the_strike_a_ball_is_at_its_start() {
    let shot = three_balls();
    let seen = BallTrack {
        id: "cue".into(),
        times: vec![-3.0, 0.9, 1.0],
        positions: vec![[0.7, 0.6]; 3],
        sigmas: vec![1.0; 3],
    };
    let question = TrackQuestion { clocks: &[1.0], ..ALL };
    let result = found(&Candidates::of_shots(vec![shot]), &[tracks(vec![seen])], &question);
    assert_eq!(result.residual, [[0.0; 2]; 3]);
}

#[test]
fn horizons_limit_the_sums_and_the_samples() {
    let shot = three_balls();
    let seen = tracks((0..3).map(|ball| track(&shot, ball, &ragged(ball), 0.0)).collect());
    let candidates = strikes(&shot, 4);
    let whole = found(&candidates, std::slice::from_ref(&seen), &ALL);
    let horizons = [0.5, 2.0, 3.01];
    let question = TrackQuestion { horizons: &horizons, ..ALL };
    let part = found(&candidates, std::slice::from_ref(&seen), &question);
    let times: Vec<f64> = (0..3).flat_map(ragged).collect();
    for candidate in 0..4 {
        let of = |result: &Residuals, k: usize| result.residual[candidate * times.len() + k];
        for (k, time) in times.iter().enumerate() {
            let expected = if *time <= 3.01 { of(&whole, k) } else { [0.0; 2] };
            assert_eq!(of(&part, k), expected);
        }
        let mut first = 0;
        for ball in 0..3 {
            for (h, horizon) in horizons.iter().enumerate() {
                let within: Vec<usize> =
                    (first..first + ragged(ball).len()).filter(|k| times[*k] <= *horizon).collect();
                assert_eq!(seen.count(ball, *horizon), within.len());
                let squares = within.iter().map(|k| of(&whole, *k)).map(|[x, y]| x * x + y * y);
                let (expected, sum) =
                    (squares.sum::<f64>(), part.sum[(candidate * 3 + ball) * 3 + h]);
                assert!((sum - expected).abs() <= 1e-12 * expected, "{sum} {expected}");
            }
            first += ragged(ball).len();
        }
    }
}

#[test]
fn every_number_of_threads_gives_the_same_bits_with_and_without_samples() {
    let shot = three_balls();
    let seen = [tracks((0..3).map(|ball| track(&shot, ball, &ragged(ball), 0.0)).collect())];
    let candidates = strikes(&shot, 40);
    let of = |threads: usize, samples: bool| {
        let question = TrackQuestion { samples, clocks: &[0.01], ..ALL };
        track_residuals(&candidates, &[&seen[0]], &question, &runner(threads)).expect("residuals")
    };
    let one = of(1, true);
    assert_eq!(one, of(2, true));
    assert_eq!(one, of(5, true));
    assert_eq!(of(2, false), Residuals { residual: Vec::new(), ..one });
}

#[test]
fn candidates_have_their_own_clocks_and_frames() {
    let shot = three_balls();
    let seen = [tracks(vec![track(&shot, 0, &ragged(0), 0.2)])];
    let (_, strike) = shot.strike().expect("a strike");
    let strikes = Some(vec![strike; 3]);
    let variation = Variation { strikes, ..Variation::default() };
    let candidates = Candidates::new(vec![shot], vec![0; 3], variation).expect("candidates");
    let exact = TrackFrame::default();
    let moved = TrackFrame { offset: [0.01, 0.0], ..exact };
    let question =
        TrackQuestion { clocks: &[0.2, 0.2, 0.3], frames: &[exact, moved, exact], ..ALL };
    let result = found(&candidates, &seen, &question);
    let samples = ragged(0).len() as f64;
    assert!(result.sum[0] < 1e-24, "{}", result.sum[0]);
    assert!((result.sum[1] - samples * 1e-4).abs() < 1e-12, "{}", result.sum[1]);
    assert!(result.sum[2] > 0.01);
}

#[test]
fn samples_of_a_pocketed_ball_are_counted() {
    let shot = example("bank_shot");
    let trace = shot.simulate().expect("a trace");
    let falls = trace
        .events()
        .find(|e| e.after.iter().any(|s| !s.motion.in_play()))
        .map(|e| (e.time, usize::from(e.balls[0])));
    let (time, ball) = falls.expect("a ball falls");
    let times = [time - 0.1, time, time + 1.0, time + 50.0];
    let seen = [tracks(vec![track(&shot, ball, &times, 0.0)])];
    let result = found(&Candidates::of_shots(vec![shot]), &seen, &ALL);
    assert_eq!(result.out_of_play, [3]);
    assert_eq!(result.sum, [0.0]);
}

#[test]
fn each_shot_may_have_its_own_tracks() {
    let shots = vec![three_balls(), example("half_ball_cut")];
    let seen: Vec<BallTracks> = shots
        .iter()
        .enumerate()
        .map(|(s, shot)| {
            tracks((0..=s).map(|ball| track(shot, ball, &ragged(ball), 0.0)).collect())
        })
        .collect();
    let result = found(&Candidates::of_shots(shots), &seen, &ALL);
    assert_eq!((result.samples, result.tracks), (67, 2));
    assert!(result.sum.iter().all(|sum| *sum == 0.0));
}

#[test]
fn a_refused_candidate_has_an_error_and_no_numbers() {
    let shot = three_balls();
    let seen = [tracks(vec![track(&shot, 0, &[0.5, 1.0], 0.0)])];
    let frame = TrackFrame { scale: 0.0, ..TrackFrame::default() };
    for (clock, frame, place) in [
        (f64::NAN, TrackFrame::default(), "clock: "),
        (0.0, frame, "scale: "),
        (0.0, TrackFrame { rotation: f64::INFINITY, ..TrackFrame::default() }, "rotation: "),
        (0.0, TrackFrame { offset: [0.0, f64::NAN], ..TrackFrame::default() }, "offset: "),
    ] {
        let candidates = Candidates::of_shots(vec![shot.clone()]);
        let question = TrackQuestion { clocks: &[clock], frames: &[frame], ..ALL };
        let result = found(&candidates, &seen, &question);
        let [(0, error)] = &result.errors[..] else { panic!("{:?}", result.errors) };
        assert!(error.to_string().starts_with(place), "{error}");
        assert!(result.residual.iter().flatten().chain(&result.sum).all(|x| x.is_nan()));
    }
}

#[test]
fn wrong_tracks_and_questions_are_refused() {
    let shot = three_balls();
    let good = track(&shot, 0, &[0.5, 1.0], 0.0);
    for (bad, place, kind) in [
        (
            BallTrack { times: vec![0.5, f64::NAN], ..good.clone() },
            "cue.times[1]",
            ErrorKind::OutOfRange,
        ),
        (
            BallTrack { sigmas: vec![1.0, 0.0], ..good.clone() },
            "cue.sigmas[1]",
            ErrorKind::OutOfRange,
        ),
        (
            BallTrack { positions: vec![[0.0; 2], [f64::INFINITY, 0.0]], ..good.clone() },
            "cue.positions[1]",
            ErrorKind::OutOfRange,
        ),
        (BallTrack { sigmas: vec![1.0], ..good.clone() }, "cue.sigmas", ErrorKind::WrongCount),
    ] {
        assert_eq!(refused(vec![bad]), (place.into(), kind));
    }
    assert_eq!(refused(vec![good.clone(), good.clone()]), ("cue".into(), ErrorKind::Duplicate));

    let candidates = Candidates::of_shots(vec![shot.clone(), shot]);
    let seen = tracks(vec![good.clone()]);
    let other = tracks(vec![BallTrack { id: "eight".into(), ..good }]);
    for (tracks, question, kind) in [
        (vec![other], ALL, ErrorKind::UnknownBall),
        (vec![seen.clone(); 3], ALL, ErrorKind::WrongCount),
        (vec![seen.clone()], TrackQuestion { clocks: &[0.0; 3], ..ALL }, ErrorKind::WrongCount),
        (vec![seen.clone()], TrackQuestion { frames: &[], ..ALL }, ErrorKind::WrongCount),
        (vec![seen.clone()], TrackQuestion { horizons: &[], ..ALL }, ErrorKind::OutOfRange),
        (vec![seen], TrackQuestion { horizons: &[2.0, 1.0], ..ALL }, ErrorKind::OutOfRange),
    ] {
        let tracks: Vec<&BallTracks> = tracks.iter().collect();
        let error =
            track_residuals(&candidates, &tracks, &question, &runner(1)).expect_err("bad input");
        assert_eq!(error.kind(), kind, "{error}");
    }
}
