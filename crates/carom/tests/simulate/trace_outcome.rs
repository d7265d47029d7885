//! The outcome has the facts that rules need: most follow from the order of events, the others from
//! the balls' positions.

use carom::math::{Vec3, radians, sin_cos};
use carom::outcome::{Collector, Outcome, OutcomeRecorder, Touched};
use carom::simulate::simulate;
use carom::table::{Part, PocketName, Rail};
use carom::trace::{TraceEvent, TraceEventKind};
use carom::{BallState, MotionState, Shot};

/// A strike whose tip meets the cue ball once.
const STRIKE: TraceEventKind = TraceEventKind::CueStrike { tip_contacts: 1, pushed: false };

const HIT: TraceEventKind = TraceEventKind::BallCollision;
const RADIUS: f64 = 0.028575;

const fn nose(rail: Rail) -> TraceEventKind {
    TraceEventKind::RailCollision { rail, part: Part::Nose }
}

/// Balls in a row down the middle of the table; the one with the given index is the cue ball.
fn row(cue_ball: Option<usize>) -> Shot {
    let balls: Vec<[f64; 2]> = (0..6).map(|i| [0.635, 0.4 + 0.2 * f64::from(i)]).collect();
    placed("\"wpa-9ft\"", cue_ball, &balls)
}

fn placed(table: &str, cue_ball: Option<usize>, balls: &[[f64; 2]]) -> Shot {
    let ball = |(i, position): (usize, &[f64; 2])| {
        let id = if Some(i) == cue_ball { "cue".into() } else { format!("ball {i}") };
        format!(r#"{{"id": "{id}", "position": {position:?}}}"#)
    };
    let balls: Vec<String> = balls.iter().enumerate().map(ball).collect();
    shot(table, &balls.join(", "))
}

fn shot(table: &str, balls: &str) -> Shot {
    Shot::from_json(&format!(
        r#"{{"format": "carom-shot/1", "table": {table}, "balls": [{balls}]}}"#
    ))
    .unwrap_or_else(|e| panic!("{e}"))
}

/// The outcome of events without motion.
fn collected(cue_ball: Option<usize>, events: &[(TraceEventKind, &[u16])]) -> Outcome {
    let shot = row(cue_ball);
    let mut collector = Collector::new(&shot);
    for (what, balls) in events {
        let states: Vec<BallState> =
            balls.iter().map(|&i| shot.balls()[usize::from(i)].state).collect();
        collector.add(&TraceEvent {
            time: 0.0,
            kind: *what,
            balls,
            before: &states,
            after: &states,
        });
    }
    collector.finish(&[])
}

#[test]
fn the_first_contact_is_the_first_of_the_cue_ball() {
    let outcome = collected(Some(0), &[(HIT, &[3, 4]), (HIT, &[0, 2]), (HIT, &[0, 1])]);
    assert_eq!(outcome.first_contact, Some(2));
    assert_eq!(outcome.cue_ball_touched, [Touched::Ball(2), Touched::Ball(1)]);
}

#[test]
fn in_a_many_ball_contact_the_cue_ball_touches_only_the_balls_next_to_it() {
    // The cue ball, 2, lies against 0 and 3; 1 touches 3 alone; 4 is 0.2 mm away.
    let d = 2.0 * RADIUS;
    let apart = [[-d, 0.0], [2.0 * d, 0.0], [0.0, 0.0], [d, 0.0], [0.0, d + 2e-4]];
    let places = apart.map(|[x, y]| [0.6 + x, 1.2 + y]);
    let shot = placed("\"wpa-9ft\"", Some(2), &places);
    let touched = |velocity: Vec3| {
        let mut states: Vec<BallState> = shot.balls().iter().map(|b| b.state).collect();
        states[2].velocity = velocity;
        let mut collector = Collector::new(&shot);
        collector.add(&event(0.0, HIT, &[0, 1, 2, 3, 4], &states, &states));
        collector.finish(&[]).cue_ball_touched
    };
    let of = |balls: &[u16]| balls.iter().map(|&ball| Touched::Ball(ball)).collect::<Vec<_>>();
    let slow = touched(Vec3::new(0.5, 0.0, 0.0));
    assert!(slow.len() == 2 && of(&[0, 3]).iter().all(|t| slow.contains(t)), "{slow:?}");
    let fast = touched(Vec3::new(8.0, 0.0, 0.0));
    assert_eq!(fast.len(), 3, "0.2 mm close within the contact: {fast:?}");
    assert_eq!(fast.last(), Some(&Touched::Ball(4)), "the nearest first");

    let outcome = collected(Some(1), &[(HIT, &[0, 1, 2])]);
    assert_eq!(outcome.cue_ball_touched.len(), 1, "at least the nearest");
    let elsewhere = collected(Some(5), &[(HIT, &[0, 1, 2])]);
    assert_eq!(elsewhere.first_contact, None);
}

/// The outcome of a level strike straight up the table at 2 m/s, with `balls` at these gaps (m)
/// from the cue ball and angles (degrees) from its line.
fn struck(balls: &[(f64, f64)]) -> Outcome {
    let place = |(i, (gap, angle)): (usize, &(f64, f64))| {
        let apart = 2.0 * RADIUS + gap;
        let (sin, cos) = sin_cos(radians(*angle));
        let (x, y) = (0.6 + apart * sin, 0.6 + apart * cos);
        format!(r#", {{"id": "{}", "position": [{x}, {y}]}}"#, i + 1)
    };
    let balls: String = balls.iter().enumerate().map(place).collect();
    let shot = Shot::from_json(&format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft",
        "balls": [{{"id": "cue", "position": [0.6, 0.6]}}{balls}],
        "strike": {{"ball": "cue", "speed": 2.0, "azimuth_deg": 90.0, "elevation_deg": 0.0,
            "side": 0.0, "height": 0.0}}}}"#
    ));
    let shot = shot.unwrap_or_else(|e| panic!("{e}"));
    shot.simulate().unwrap_or_else(|e| panic!("{e}")).outcome().clone()
}

#[test]
fn a_strike_lists_the_balls_that_the_cue_ball_meets_at_once() {
    let frozen = struck(&[(0.0, 0.0)]);
    assert_eq!((frozen.pushed, &frozen.met_during_strike[..]), (false, &[1][..]));
    let near = struck(&[(1e-3, 0.0)]);
    assert_eq!((near.pushed, &near.met_during_strike[..]), (true, &[1][..]));
    let far = struck(&[(1e-2, 0.0)]);
    assert_eq!((far.pushed, far.first_contact), (false, Some(1)));
    assert!(far.met_during_strike.is_empty(), "it met the ball later");
    assert!(struck(&[(0.0, 95.0)]).met_during_strike.is_empty(), "it leaves the ball");
}

#[test]
fn a_strike_into_a_row_meets_only_its_first_ball() {
    let d = 2.0 * RADIUS;
    let outcome = struck(&[(d, 0.0), (0.0, 0.0)]);
    assert_eq!((outcome.first_contact, &outcome.met_during_strike[..]), (Some(2), &[2][..]));
}

#[test]
fn a_strike_meets_the_ball_first_that_is_nearest_along_its_way() {
    // The first ball is nearer, but at 70° from the line the cue ball comes to it later.
    let outcome = struck(&[(3e-4, 70.0), (5e-4, 0.0)]);
    assert_eq!(outcome.first_contact, Some(2));
    assert_eq!(outcome.met_during_strike, [2, 1]);
    assert_eq!(outcome.cue_ball_touched[..2], [Touched::Ball(2), Touched::Ball(1)]);
}

#[test]
fn rails_count_from_the_first_contact_on() {
    let outcome = collected(
        Some(0),
        &[
            (nose(Rail::Left), &[0]),
            (nose(Rail::Top), &[3]),
            (HIT, &[3, 2]),
            (nose(Rail::Bottom), &[2]),
            (HIT, &[0, 1]),
            (nose(Rail::Right), &[1]),
            (TraceEventKind::RailCollision { rail: Rail::Right, part: Part::Facing }, &[1]),
            (nose(Rail::Top), &[0]),
        ],
    );
    assert_eq!(
        outcome.rails_after_first_contact,
        [(1, Rail::Right), (1, Rail::Right), (0, Rail::Top)]
    );
    assert!(outcome.rails_before_first_contact().eq([Rail::Left]));
    assert_eq!(outcome.driven_to_rail, [0, 3, 2, 1]);
    assert_eq!(
        outcome.cue_ball_touched,
        [Touched::Rail(Rail::Left), Touched::Ball(1), Touched::Rail(Rail::Top)]
    );
}

#[test]
fn the_top_of_a_rail_and_a_pockets_liner_do_not_count_as_cushions() {
    let part = |part| TraceEventKind::RailCollision { rail: Rail::Top, part };
    let (top, liner, point) = (part(Part::Top), part(Part::Liner), part(Part::Point));
    let outcome = collected(Some(0), &[(HIT, &[0, 1]), (top, &[0]), (liner, &[1]), (point, &[2])]);
    assert_eq!(outcome.driven_to_rail, [2]);
    assert_eq!(outcome.rails_after_first_contact, [(2, Rail::Top)]);
    assert_eq!(outcome.cue_ball_touched, [Touched::Ball(1)]);
}

#[test]
fn without_a_cue_ball_rails_count_from_the_first_collision_of_any_balls() {
    let events: &[(TraceEventKind, &[u16])] =
        &[(nose(Rail::Top), &[0]), (HIT, &[0, 1]), (nose(Rail::Left), &[1])];
    let outcome = collected(None, events);
    assert_eq!(outcome.first_contact, None);
    assert_eq!(outcome.rails_after_first_contact, [(1, Rail::Left)]);
    assert!(outcome.cue_ball_touched.is_empty());
    assert!(!outcome.cue_ball_scratched());
}

#[test]
fn pocketed_balls_are_listed_in_order_and_a_scratch_is_noted() {
    let events: &[(TraceEventKind, &[u16])] = &[
        (STRIKE, &[2]),
        (TraceEventKind::PocketCollision(PocketName::Left), &[4]),
        (TraceEventKind::PocketCollision(PocketName::TopRight), &[2]),
        (TraceEventKind::PocketCollision(PocketName::Left), &[0]),
    ];
    let outcome = collected(Some(2), events);
    let (left, top_right) = (PocketName::Left, PocketName::TopRight);
    assert_eq!(outcome.pocketed, [(4, left), (2, top_right), (0, left)]);
    assert!(outcome.cue_ball_scratched());
    assert!(!collected(Some(3), events).cue_ball_scratched());
    assert_eq!(outcome.events, 4);
}

#[test]
fn balls_off_the_table_are_listed_in_the_order_in_which_they_left_it() {
    let outcome =
        collected(Some(0), &[(TraceEventKind::OffTable, &[3]), (TraceEventKind::OffTable, &[1])]);
    assert_eq!(outcome.off_table, [3, 1]);
}

#[test]
fn only_moving_balls_that_no_friction_stops_are_listed_as_never_resting() {
    let with = |motion, velocity: f64, spin: f64| BallState {
        motion,
        velocity: Vec3::new(velocity, 0.0, 0.0),
        angular_velocity: Vec3::new(0.0, velocity / RADIUS, spin),
        ..BallState::default()
    };
    let last = [
        with(MotionState::Stationary, 0.0, 0.0),
        with(MotionState::Rolling, 1.0, 0.0),
        with(MotionState::Pocketed, 0.0, 0.0),
        with(MotionState::Spinning, 0.0, 2.0),
        with(MotionState::OffTable, 0.0, 0.0),
        with(MotionState::Airborne, 1.0, 2.0),
    ];
    let never_resting = |cloth: &str| {
        let table = format!(r#""wpa-9ft", "physics": {{"cloth": {{{cloth}}}}}"#);
        let balls: Vec<[f64; 2]> = (0..6).map(|i| [0.635, 0.4 + 0.2 * f64::from(i)]).collect();
        Collector::new(&placed(&table, None, &balls)).finish(&last).never_resting
    };
    assert_eq!(never_resting(r#""rolling_friction": 0, "spin_deceleration": 0"#), [1, 3]);
    assert_eq!(never_resting(r#""rolling_friction": 0"#), [1]);
    assert_eq!(never_resting(r#""spin_deceleration": 0"#), [3]);
    assert!(never_resting(r#""sliding_friction": 0.2"#).is_empty());
}

/// The outcome for a ball at the distance `gap` (m) from the left rail of a plain table, 0 if it is
/// frozen, which starts with the velocity `speed` (m/s) along x.
fn frozen(gap: f64, speed: f64) -> Outcome {
    let reach = carom::table::nose_reach(0.635 * 2.0 * RADIUS, RADIUS).expect("the nose meets it");
    let ball = format!(
        r#"{{"id": "a", "position": [{:?}, 0.5], "velocity": [{speed:?}, 0, 0]}}"#,
        reach + gap
    );
    let shot = shot(r#"{"width": 1.0, "length": 1.0, "pockets": "none"}"#, &ball);
    shot.simulate().unwrap_or_else(|e| panic!("{e}")).outcome().clone()
}

#[test]
fn a_frozen_ball_that_is_pressed_into_its_rail_is_not_driven_to_it() {
    let outcome = frozen(0.0, -0.4);
    assert_eq!(outcome.events, frozen(1e-3, -0.4).events, "it does touch the rail");
    assert!(outcome.driven_to_rail.is_empty(), "{outcome:?}");
    // At 3 m/s it reaches the other rail, which counts.
    assert_eq!(frozen(0.0, -3.0).driven_to_rail, [0]);
}

#[test]
fn a_ball_that_was_not_frozen_is_driven_to_the_rail_that_it_touches() {
    assert_eq!(frozen(1e-3, -0.4).driven_to_rail, [0]);
    assert_eq!(frozen(2e-9, -0.4).driven_to_rail, [0]);
}

#[test]
fn a_frozen_ball_that_left_its_rail_is_driven_to_it_when_it_comes_back() {
    let placed = one_frozen_ball();
    let rail = nose(Rail::Left);
    // Friction pulls it back after 0.05 mm and after 9 cm.
    for (speed, driven) in [(0.014, false), (0.6, true)] {
        let spin = Vec3::new(0.0, -20.0 * speed / RADIUS, 0.0);
        let start = BallState {
            velocity: Vec3::new(speed, 0.0, 0.0),
            angular_velocity: spin,
            motion: MotionState::Sliding,
            ..placed.balls()[0].state
        };
        let still = placed.balls()[0].state;
        let back =
            2.0 * speed / (placed.physics().cloth.sliding_friction * placed.physics().gravity);
        let mut collector = Collector::new(&placed);
        collector.add(&event(0.0, HIT, &[0, 1], &[still, still], &[start, still]));
        collector.add(&event(back, rail, &[0], &[still], &[still]));
        let outcome = collector.finish(&[]);
        assert_eq!(outcome.driven_to_rail == [0], driven, "{speed} m/s");
        assert_eq!(outcome.rails_after_first_contact.len(), 1);
    }
}

/// One ball frozen to the left rail, and one in the middle.
fn one_frozen_ball() -> Shot {
    let reach = carom::table::nose_reach(0.635 * 2.0 * RADIUS, RADIUS).expect("the nose meets it");
    placed(r#"{"width": 1.0, "length": 1.0, "pockets": "none"}"#, None, &[[reach, 0.5], [0.5, 0.5]])
}

fn event<'a>(
    time: f64,
    kind: TraceEventKind,
    balls: &'a [u16],
    before: &'a [BallState],
    after: &'a [BallState],
) -> TraceEvent<'a> {
    TraceEvent { time, kind, balls, before, after }
}

/// Ball 0 flies past ball 1 at the distance `aside` (m) in plan, at 2 m/s upwards and 1 m/s along,
/// from the first event to the last.
fn flight(aside: f64, first: (TraceEventKind, &[u16]), last: (TraceEventKind, &[u16])) -> Outcome {
    let shot = placed("\"wpa-9ft\"", Some(0), &[[0.4, 0.5], [0.6, 0.5 + aside]]);
    let up = 2.0;
    let still: Vec<BallState> = shot.balls().iter().map(|b| b.state).collect();
    let off =
        BallState { velocity: Vec3::new(1.0, 0.0, up), motion: MotionState::Airborne, ..still[0] };
    let down = 2.0 * up / shot.physics().gravity;
    let landed = BallState {
        position: off.position + Vec3::new(down, 0.0, 0.0),
        velocity: Vec3::ZERO,
        motion: MotionState::Stationary,
        ..off
    };
    let after = |first: BallState| [first, still[1]];
    let mut collector = Collector::new(&shot);
    collector.add(&event(
        0.0,
        first.0,
        first.1,
        &still[..first.1.len()],
        &after(off)[..first.1.len()],
    ));
    collector.add(&event(
        down,
        last.0,
        last.1,
        &after(landed)[..last.1.len()],
        &after(landed)[..last.1.len()],
    ));
    collector.finish(&[])
}

#[test]
fn a_ball_in_the_air_jumps_a_ball_that_it_would_have_hit_on_the_cloth() {
    let (strike, slate) = ((STRIKE, &[0u16][..]), (TraceEventKind::SlateCollision, &[0u16][..]));
    for aside in [0.0, 0.03, 2.0 * RADIUS - 2e-4] {
        assert_eq!(flight(aside, strike, slate).jumped, [(0, 1)], "{aside}");
    }
    assert_eq!(flight(2.0 * RADIUS - 0.5e-4, strike, slate).jumped, []);
    assert_eq!(flight(0.2, strike, slate).jumped, []);
}

#[test]
fn a_ball_that_touches_another_in_its_flight_has_not_jumped_it() {
    let (strike, slate) = ((STRIKE, &[0u16][..]), (TraceEventKind::SlateCollision, &[0u16][..]));
    let touch = (HIT, &[0u16, 1][..]);
    assert_eq!(flight(0.03, touch, slate).jumped, [], "it takes off from it");
    assert_eq!(flight(0.03, strike, touch).jumped, [], "it lands on it");
}

#[test]
fn only_the_upper_of_two_balls_jumps_the_other() {
    // Two balls in flight, one above the other.
    let ball = |id: &str, z: f64, speed: f64| {
        format!(r#"{{"id": "{id}", "position": [0.5, 0.5, {z:?}], "velocity": [{speed:?}, 0, 0]}}"#)
    };
    let shot = shot(
        r#"{"cloth": "unbounded"}"#,
        &[ball("low", 0.2, 0.0), ball("high", 0.4, 1.0)].join(", "),
    );
    let mut collector = Collector::new(&shot);
    for (i, height) in [(0, 0.2), (1, 0.4)] {
        let time = (2.0 * (height - RADIUS) / shot.physics().gravity).sqrt();
        let state = BallState { motion: MotionState::Stationary, ..shot.balls()[i].state };
        let balls = [i as u16];
        collector.add(&event(time, TraceEventKind::SlateCollision, &balls, &[state], &[state]));
    }
    assert_eq!(collector.finish(&[]).jumped, [(1, 0)]);
}

#[test]
fn a_ball_at_rest_over_the_edge_of_a_hole_hangs() {
    let table = carom::Table::preset("wpa-9ft").expect("a preset");
    let corner = &table.pockets[0];
    let at = |overhang: f64| {
        let from_center = corner.radius + RADIUS - overhang;
        let p = corner.center + table.center() - corner.axis * from_center;
        let shot = placed("\"wpa-9ft\"", None, &[[p.x, p.y]]);
        shot.simulate().unwrap_or_else(|e| panic!("{e}")).outcome().hanging.clone()
    };
    assert_eq!(at(1e-3), [(0, PocketName::BottomLeft)]);
    assert_eq!(at(0.9 * RADIUS), [(0, PocketName::BottomLeft)]);
    assert_eq!(at(-1e-3), []);
}

#[test]
fn an_outcome_without_a_trace_is_that_of_the_trace() {
    for name in ["nine_ball_break", "frozen_to_rail", "three_cushion"] {
        let path = format!("{}/../../shots/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
        let shot = Shot::from_json(&text).unwrap_or_else(|e| panic!("{e}"));
        let trace = shot.simulate().unwrap_or_else(|e| panic!("{e}"));
        let mut recorder = OutcomeRecorder::new(&shot);
        simulate(&shot, &mut recorder).unwrap_or_else(|e| panic!("{e:?}"));
        let last: Vec<BallState> =
            trace.last().iter().map(|state| shot.table().to_engine_coordinates(state)).collect();
        assert_eq!(&recorder.finish(&last), trace.outcome());
    }
}
