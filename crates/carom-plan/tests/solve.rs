//! Solutions reach their goal, and the most probable comes first.

use carom::Shot;
use carom_plan::{Disc, ErrorModel, Goal, Progress, Search, Solution, Stage};

fn shot(text: &str) -> Shot {
    Shot::from_json(text).expect("a shot")
}

/// A cut into the top right corner, another ball beside it.
fn cut() -> Shot {
    shot(
        r#"{"format": "carom-shot/1", "table": "wpa-9ft",
            "balls": [{"id": "cue", "position": [0.5, 1.2]}, {"id": "1", "position": [0.9, 1.9]},
                      {"id": "2", "position": [0.3, 1.9]}],
            "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 60.0}}"#,
    )
}

fn search() -> Search {
    Search { model: model(300), samples: 2048, ..Search::default() }
}

fn model(variants: u64) -> ErrorModel {
    ErrorModel { variants, ..ErrorModel::default() }
}

fn solve(shot: &Shot, goal: &Goal, search: &Search) -> Result<Vec<Solution>, carom::Error> {
    carom_plan::solve(shot, goal, search, &Progress::default())
}

fn assert_in_order(solutions: &[Solution]) {
    let share = |solution: &Solution| solution.chance.share();
    assert!(solutions.windows(2).all(|pair| share(&pair[0]) >= share(&pair[1])));
    for solution in solutions {
        let share = share(solution);
        assert!(solution.interval.low <= share && share <= solution.interval.high);
    }
}

#[test]
fn every_solution_pots_when_it_is_played() {
    let shot = cut();
    let top_right = 5;
    let goal = Goal { pot: Some((1, Some(top_right))), ..Goal::default() };
    let solutions = solve(&shot, &goal, &search()).expect("solutions");
    assert!(solutions.len() >= 5, "{}", solutions.len());
    for solution in &solutions {
        let trace =
            shot.with_strike(&solution.strike).expect("a shot").simulate().expect("a trace");
        let pocket = shot.table().pockets[top_right].name;
        assert!(trace.outcome().pocketed.contains(&(1, pocket)), "{solution:?}");
        assert!(!trace.outcome().cue_ball_scratched());
    }
    assert_in_order(&solutions);
    let best = &solutions[0];
    assert_eq!(best.route.kind(), "direct");
    assert!(best.chance.share() > 0.8, "an easy cut, {best:?}");
}

#[test]
fn every_strike_is_within_the_limits_of_the_search() {
    let goal = Goal { pot: Some((1, None)), ..Goal::default() };
    let all = Search { wanted: 40, speed: [1.5, 3.0], offset: 0.2, ..search() };
    let solutions = solve(&cut(), &goal, &all).expect("solutions");
    assert!(!solutions.is_empty());
    for strike in solutions.iter().map(|s| s.strike) {
        assert!((1.5..=3.0).contains(&strike.speed), "{strike:?}");
        assert!(strike.offset() <= 0.2, "{strike:?}");
    }
}

#[test]
fn the_cue_ball_stops_in_the_disc_that_was_asked_for() {
    let shot = cut();
    let area = Disc { center: [0.4, 0.8], radius: 0.15 };
    let goal = Goal { pot: Some((1, Some(5))), leave: Some(area), ..Goal::default() };
    let solutions = solve(&shot, &goal, &search()).expect("solutions");
    assert!(!solutions.is_empty());
    for solution in &solutions {
        let trace =
            shot.with_strike(&solution.strike).expect("a shot").simulate().expect("a trace");
        let end = trace.last()[0].position;
        let (x, y) = (end.x - 0.4, end.y - 0.8);
        assert!(x * x + y * y <= 0.15 * 0.15 + 1e-9, "{end:?}");
    }
    assert_in_order(&solutions);
}

#[test]
fn a_snooker_is_escaped() {
    let shot = shot(
        r#"{"format": "carom-shot/1", "table": "wpa-9ft",
            "balls": [{"id": "cue", "position": [0.3, 0.5]}, {"id": "8", "position": [0.3, 0.7]},
                      {"id": "1", "position": [0.3, 2.0]}],
            "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 90.0}}"#,
    );
    let goal = Goal { first: Some(2), ..Goal::default() };
    let solutions = solve(&shot, &goal, &search()).expect("solutions");
    assert!(!solutions.is_empty());
    for solution in &solutions {
        let trace =
            shot.with_strike(&solution.strike).expect("a shot").simulate().expect("a trace");
        assert_eq!(trace.outcome().first_contact, Some(2));
        // The route ends at the first contact.
        let kind = solution.route.kind();
        assert!(matches!(kind.as_str(), "direct" | "kick"), "{:?}", solution.route);
    }
}

#[test]
fn the_shot_of_a_solution_reproduces_it_to_the_bit() {
    let goal = Goal { pot: Some((1, None)), ..Goal::default() };
    let few = Search { samples: 512, model: model(100), ..search() };
    for Solution { strike, cue_ball_end, .. } in solve(&cut(), &goal, &few).expect("solutions") {
        let struck = cut().with_strike(&strike).expect("a shot");
        assert_eq!(struck.strike(), Some((0, strike)));
        let end = struck.simulate().expect("a trace").last()[0].position;
        assert_eq!([end.x, end.y], cue_ball_end);
    }
}

#[test]
fn solutions_are_the_same_for_any_number_of_threads() {
    let goal = Goal { pot: Some((1, None)), ..Goal::default() };
    let few = Search { samples: 512, model: model(100), ..search() };
    let alone =
        solve(&cut(), &goal, &Search { threads: Some(1), ..few.clone() }).expect("solutions");
    let together =
        solve(&cut(), &goal, &Search { threads: Some(2), ..few.clone() }).expect("solutions");
    assert_eq!(alone, together);
}

#[test]
fn bad_goals_and_limits_are_rejected_by_name() {
    let shot = cut();
    let refuse = |goal: Goal| {
        let error = solve(&shot, &goal, &search()).expect_err("nonsense");
        assert!(error.to_string().starts_with("goal: "), "{error}");
    };
    refuse(Goal::default());
    refuse(Goal { pot: Some((0, None)), ..Goal::default() });
    refuse(Goal { pot: Some((1, Some(6))), ..Goal::default() });
    refuse(Goal { leave: Some(Disc { center: [0.0, 0.0], radius: 0.0 }), ..Goal::default() });
    let goal = Goal { pot: Some((1, None)), ..Goal::default() };
    for elevation in [-0.1, core::f64::consts::FRAC_PI_2, f64::NAN] {
        let raised = Search { elevation: Some(elevation), ..search() };
        let error = solve(&shot, &goal, &raised).expect_err("no elevation of a cue");
        assert!(error.to_string().starts_with("elevation: "), "{error}");
    }
}

#[test]
fn chances_are_counted_until_they_are_as_precise_as_was_asked_for() {
    let goal = Goal { pot: Some((1, Some(5))), ..Goal::default() };
    let model = ErrorModel { half_width: Some(0.03), ..model(5000) };
    let few = Search { samples: 512, model, ..search() };
    let solutions = solve(&cut(), &goal, &few).expect("solutions");
    assert_in_order(&solutions);
    for solution in &solutions {
        assert!(solution.interval.half_width() <= 0.03, "{solution:?}");
    }
    let spent = |s: &Solution| s.chance.variants;
    let most = solutions.iter().map(spent).max();
    assert!(solutions.iter().map(spent).min() < most && most < Some(5000));
}

#[test]
fn poor_perception_lowers_the_chances() {
    let goal = Goal { pot: Some((1, Some(5))), ..Goal::default() };
    let best = |position| {
        let perception = carom::noise::Perception::round(position);
        let model = ErrorModel { perception, ..model(300) };
        let few = Search { samples: 512, model, ..search() };
        solve(&cut(), &goal, &few).expect("solutions")[0].chance.share()
    };
    assert!(best(0.0) > best(0.004) + 0.1);
}

#[test]
fn a_search_reports_its_last_stage_and_can_be_stopped() {
    let goal = Goal { pot: Some((1, None)), ..Goal::default() };
    let few = Search { samples: 512, model: model(100), ..search() };
    let progress = Progress::default();
    let found = carom_plan::solve(&cut(), &goal, &few, &progress).expect("solutions");
    let end = progress.read();
    assert_eq!(Stage::ALL[end.stage as usize], Stage::Rank);
    assert!(end.done == end.total && end.total >= found.len() as u64, "{end:?}");

    let stopped = Progress::default();
    stopped.stop();
    assert_eq!(carom_plan::solve(&cut(), &goal, &few, &stopped).expect("no error"), []);
}

#[test]
fn counts_out_of_range_are_rejected_by_name() {
    let goal = Goal { pot: Some((1, None)), ..Goal::default() };
    for (place, search) in [
        ("samples", Search { samples: usize::MAX, ..search() }),
        ("wanted", Search { wanted: 0, ..search() }),
        ("per_route", Search { per_route: usize::MAX, ..search() }),
    ] {
        let error = solve(&cut(), &goal, &search).expect_err("out of range").to_string();
        assert!(error.starts_with(&format!("{place}: ")), "{error}");
    }
}
