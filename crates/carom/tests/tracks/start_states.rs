//! A state in the middle of a shot is a start like any other, and no start makes the engine panic.

use carom::candidates::{Candidates, Variation};
use carom::detect::ball_table;
use carom::error::ErrorKind;
use carom::math::Vec3;
use carom::sample::Sequence;
use carom::shot::{PlacedBall, StartState};
use carom::tracks::{StateQuestion, sample_states};
use carom::{BallState, MotionState, Shot, Trace};
use carom_roots::Motion;

use super::{example, examples, runner, three_balls};

/// The balls of `shot` that are in play at `time` of its trace, as the start of another shot.
fn from_the_middle(shot: &Shot, trace: &Trace, time: f64) -> Result<(Vec<usize>, Shot), ErrorKind> {
    let states = trace.at(time).unwrap_or_else(|e| panic!("{e}"));
    let left: Vec<usize> = (0..states.len()).filter(|&i| states[i].motion.in_play()).collect();
    let placed = |&i: &usize| PlacedBall { state: states[i], ..shot.balls()[i].clone() };
    let balls = left.iter().map(placed).collect();
    let begun = shot.with_balls(balls, None).map_err(|e| e.kind())?;
    Ok((left, begun))
}

fn is_near(a: &BallState, b: &BallState) -> bool {
    (a.position - b.position).length() < 1e-9 && (a.velocity - b.velocity).length() < 1e-7
}

#[test]
fn a_shot_goes_on_from_every_state_in_its_middle() {
    let (mut played, mut moving, mut flying) = (0, 0, 0);
    for (name, shot) in examples() {
        let trace = shot.simulate().unwrap_or_else(|e| panic!("{name}: {e}"));
        for k in 1..40 {
            let time = trace.duration() * f64::from(k) / 40.0;
            let (left, begun) = match from_the_middle(&shot, &trace, time) {
                Ok(begun) => begun,
                // A ball falls into a pocket, or none is left.
                Err(ErrorKind::OverPocket | ErrorKind::InSlate | ErrorKind::BallCount) => continue,
                Err(other) => panic!("{name} at {time}: {other:?}"),
            };
            let motions = begun.balls().iter().map(|ball| ball.state.motion);
            moving += usize::from(motions.clone().any(|motion| !motion.is_at_rest()));
            flying += usize::from(motions.clone().any(|motion| motion == MotionState::Airborne));
            played += 1;
            let again = begun.simulate().unwrap_or_else(|e| panic!("{name} at {time}: {e}"));
            // Up to the next event after this time rounding has not grown.
            let next = trace.events().map(|event| event.time).find(|t| *t > time + 1e-9);
            let Some(next) = next else { continue };
            let later = 0.5 * (time + next);
            let (old, new) = (trace.at(later), again.at(later - time));
            let (old, new) = (old.expect("states"), new.expect("states"));
            for (i, state) in left.iter().zip(&new) {
                assert!(is_near(&old[*i], state), "{name} at {time}: {:?} {state:?}", old[*i]);
            }
        }
    }
    assert!(played > 500 && moving > 400 && flying > 5, "{played} {moving} {flying}");
}

#[test]
fn a_candidate_may_start_in_flight() {
    let shot = three_balls();
    let shot = shot.with_balls(shot.balls().to_vec(), None).unwrap_or_else(|e| panic!("{e}"));
    let mut states: Vec<StartState> = shot
        .balls()
        .iter()
        .map(|ball| StartState { position: ball.state.position, ..StartState::default() })
        .collect();
    states[0].position.z = 0.2;
    states[0].velocity = Vec3::new(0.0, 1.0, 0.5);
    let variation = Variation { states: Some(states), ..Variation::default() };
    let all = Candidates::new(vec![shot], vec![0], variation).unwrap_or_else(|e| panic!("{e}"));
    let begun = all.shot(0).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(begun.balls()[0].state.motion, MotionState::Airborne);
    let question = StateQuestion {
        times: &[0.1],
        count: 1,
        balls: &[0],
        velocity: false,
        angular_velocity: false,
    };
    let found = sample_states(&all, &question, &runner(1)).unwrap_or_else(|e| panic!("{e}"));
    let [x, y, z] = found.position[0];
    let fallen = 0.2 + 0.05 - 0.5 * begun.physics().gravity * 0.01;
    assert!((x - 0.7).abs() < 1e-12 && (y - 0.7).abs() < 1e-12 && (z - fallen).abs() < 1e-12);
}

/// Numbers from 0 to 1.
fn random(index: u64) -> [f64; 21] {
    let mut point = [0.0; 21];
    Sequence::Random.point(7, index, &mut point);
    point
}

#[test]
fn no_start_state_makes_the_engine_panic() {
    let unbounded = r#"{"format": "carom-shot/1", "table": {"cloth": "unbounded"},
        "balls": [{"id": "a", "position": [0, 0]}, {"id": "b", "position": [1, 0]}]}"#;
    let shots = [
        three_balls(),
        example("half_ball_cut"),
        Shot::from_json(unbounded).unwrap_or_else(|e| panic!("{e}")),
    ];
    let (mut refused, mut played) = (0, 0);
    for shot in shots {
        let shot = shot.with_balls(shot.balls()[..2].to_vec(), None).expect("two balls");
        let radius = shot.balls()[0].ball.radius;
        let size = shot.table().size;
        let [width, length] = [size.x, size.y].map(|x| if x.is_finite() { x } else { 1.0 });
        let state = |p: &[f64]| {
            // A third of the balls is within a nanometre of a nose or a corner, or beyond it.
            let place = |u: f64, v: f64, size: f64| match v {
                v if v < 0.2 => radius + 2e-9 * (u - 0.5),
                v if v < 0.4 => size - radius + 2e-9 * (u - 0.5),
                v if v < 0.5 => size * (3.0 * u - 1.0),
                _ => size * u,
            };
            let speed = |u: f64| if u < 0.3 { 0.0 } else { 10.0 * (u - 0.65) };
            StartState {
                position: Vec3::new(
                    place(p[0], p[1], width),
                    place(p[2], p[3], length),
                    if p[4] < 0.8 { radius } else { radius + p[4] - 0.8 },
                ),
                velocity: Vec3::new(speed(p[5]), speed(p[6]), if p[7] < 0.9 { 0.0 } else { 1.0 }),
                angular_velocity: Vec3::new(p[8] - 0.5, p[9] - 0.5, p[7] - 0.5) * 200.0,
            }
        };
        let count = 2000;
        let states: Vec<StartState> = (0..count)
            .map(random)
            .flat_map(|point| [state(&point[..10]), state(&point[10..20])])
            .collect();
        let variation = Variation { states: Some(states), ..Variation::default() };
        let all =
            Candidates::new(vec![shot], vec![0; count as usize], variation).expect("candidates");
        let question = StateQuestion {
            times: &[0.0, 0.3, 3.0],
            count: 3,
            balls: &[0, 1],
            velocity: true,
            angular_velocity: false,
        };
        let found = sample_states(&all, &question, &runner(2)).expect("states");
        refused += found.errors.len();
        played += all.len() - found.errors.len();
        assert!(found.errors.iter().all(|(_, error)| error.is_bad_input()), "{:?}", found.errors);
        let finite = found.position.iter().filter(|p| p.iter().all(|x| x.is_finite())).count();
        assert_eq!(finite, 6 * (all.len() - found.errors.len()));
    }
    assert!(refused > 500 && played > 2000, "{refused} {played}");
}

/// A centre beyond the nose of a table without pockets was taken to be in a mouth, which does not
/// exist, and the search panicked. No valid shot has such a ball; `ball_table` is public.
#[test]
fn a_centre_beyond_the_nose_of_a_plain_table_meets_a_cushion() {
    let shot = three_balls();
    let table = shot.table();
    let half = [0.5 * table.size.x, 0.5 * table.size.y];
    let radius = shot.balls()[0].ball.radius;
    for k in 0..5000 {
        let point = random(k);
        let d = [0, 1].map(|axis| half[axis] * (2.6 * point[axis] - 1.3));
        let v = [4.0 * point[2] - 2.0, 4.0 * point[3] - 2.0];
        let h = [point[4] - 0.5, point[5] - 0.5];
        let _ = ball_table::first_meeting(table, radius, &Motion { d, v, h }, 3.0 * point[6]);
    }
    let path = Motion { d: [half[0] - 0.001, half[1] - 0.001], v: [1.0, 1.0], h: [0.0; 2] };
    let (time, _) = ball_table::first_meeting(table, radius, &path, 1.0).expect("a cushion");
    assert_eq!(time, 0.0);
}
