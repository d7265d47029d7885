//! Plays candidates of a three-cushion shot in one way, for counts of instructions
//! (benches/tracks.py): `track_cost <way> <candidates>`.
//!
//! - `play`: up to 8 s, without any result
//! - `states`: 400 sampled positions of each of the three balls
//! - `sums`, `residuals`: sums of squares, or all residuals, of as many samples
//! - `physics`: `sums`, with two numbers of the physics, start states and a strike of its own for each
//!   candidate

use carom::candidates::{Candidates, Variation};
use carom::event::NullRecorder;
use carom::format::PhysicsNumber;
use carom::resolve::cue_ball::Strike;
use carom::runner::Runner;
use carom::shot::StartState;
use carom::tracks::{
    BallTrack, BallTracks, StateQuestion, TrackFrame, TrackQuestion, sample_states, track_residuals,
};
use carom::{Error, Shot, Simulator};

/// Time of the last sample, s.
const END: f64 = 8.0;
/// Samples of each ball.
const SAMPLES: usize = 400;

const SHOT: &str = r#"{"format": "carom-shot/1", "table": "carom-10ft",
    "balls": [{"id": "cue", "position": [0.7, 0.6]}, {"id": "1", "position": [0.9, 2.2]},
              {"id": "2", "position": [0.4, 2.0]}],
    "strike": {"ball": "cue", "speed": 4, "azimuth_deg": 78, "elevation_deg": 3, "side": 0.3,
               "height": 0.2}}"#;

fn main() -> Result<(), Error> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [way, count] = &words[..] else { panic!("usage: track_cost <way> <candidates>") };
    let count: usize = count.parse().expect("a number of candidates");
    let shot = Shot::from_json(SHOT)?;
    let (_, own) = shot.strike().expect("a strike");
    let strikes: Vec<Strike> =
        (0..count).map(|k| Strike { azimuth: own.azimuth + 1e-5 * k as f64, ..own }).collect();
    let times: Vec<f64> = (1..=SAMPLES).map(|k| END * k as f64 / SAMPLES as f64).collect();
    if way == "play" {
        let mut simulator = Simulator::new();
        let mut events = 0;
        for strike in strikes {
            let strike = Some((0, strike));
            events += simulator.play_until(&shot, strike, END, &mut NullRecorder)?.events;
        }
        println!("{events}");
        return Ok(());
    }
    let mut variation = Variation { strikes: Some(strikes), ..Variation::default() };
    if way == "physics" {
        let keys = ["cloth.sliding_friction", "cushion.restitution.a"];
        variation.numbers =
            keys.iter().map(|key| PhysicsNumber::find(key)).collect::<Result<_, _>>()?;
        let physics = shot.physics();
        let values = [physics.cloth.sliding_friction, physics.cushion.restitution.a];
        variation.values = values.repeat(count);
        let start = |ball: &carom::shot::PlacedBall| StartState {
            position: ball.state.position,
            ..StartState::default()
        };
        variation.states = Some(shot.balls().iter().map(start).collect::<Vec<_>>().repeat(count));
    }
    let candidates = Candidates::new(vec![shot.clone()], vec![0; count], variation)?;
    let runner = Runner::new(Some(1))?;
    if way == "states" {
        let question = StateQuestion {
            times: &times,
            count: SAMPLES,
            balls: &[0, 1, 2],
            velocity: false,
            angular_velocity: false,
        };
        let found = sample_states(&candidates, &question, &runner)?;
        println!("{:?}", found.position.last());
        return Ok(());
    }
    let trace = shot.simulate()?;
    let mut tracks = Vec::new();
    for (ball, placed) in shot.balls().iter().enumerate() {
        let mut positions = Vec::new();
        for time in &times {
            let state = trace.at(*time)?[ball];
            positions.push([state.position.x, state.position.y]);
        }
        let sigmas = vec![0.001; SAMPLES];
        tracks.push(BallTrack { id: placed.id.clone(), times: times.clone(), positions, sigmas });
    }
    let question = TrackQuestion {
        clocks: &[0.0],
        frames: &[TrackFrame::default()],
        horizons: &[f64::INFINITY],
        samples: way == "residuals",
    };
    let found = track_residuals(&candidates, &[&BallTracks::new(tracks)?], &question, &runner)?;
    println!("{:?}", found.sum.last());
    Ok(())
}
