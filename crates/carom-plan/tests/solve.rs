//! What is solved is brought about, and the likeliest comes first.

use carom::Shot;
use carom_plan::{Disc, Goal, Search, Solution, solve};

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
    Search { variants: 300, samples: 2048, ..Search::default() }
}

fn assert_in_order(solutions: &[Solution]) {
    assert!(solutions.windows(2).all(|pair| pair[0].met >= pair[1].met));
    for solution in solutions {
        let share = solution.met as f64 / solution.variants as f64;
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
    assert_eq!(best.way.kind(), "direct");
    assert!(best.met * 10 > best.variants * 8, "an easy cut, {best:?}");
}

fn kinds(shot: &Shot, ball: usize) -> Vec<String> {
    let goal = Goal { pot: Some((ball, None)), ..Goal::default() };
    let all = Search { wanted: 40, of_a_way: 1, ..search() };
    let solutions = solve(shot, &goal, &all).expect("solutions");
    solutions.iter().map(|s| s.way.kind()).collect()
}

#[test]
fn banks_and_kicks_are_found_too() {
    let found = kinds(&cut(), 1);
    for kind in ["direct", "bank", "kick"] {
        assert!(found.iter().any(|k| k == kind), "no {kind} among {found:?}");
    }
}

#[test]
fn combinations_are_found_too() {
    let shot = shot(
        r#"{"format": "carom-shot/1", "table": "wpa-9ft",
            "balls": [{"id": "cue", "position": [0.6, 1.8]}, {"id": "1", "position": [1.1, 2.37]},
                      {"id": "2", "position": [0.95, 2.22]}],
            "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 60.0}}"#,
    );
    let found = kinds(&shot, 1);
    assert!(found.iter().any(|k| k == "combination"), "{found:?}");
}

#[test]
fn caroms_are_found_too() {
    let shot = shot(
        r#"{"format": "carom-shot/1", "table": "wpa-9ft",
            "balls": [{"id": "cue", "position": [0.6, 1.6]}, {"id": "1", "position": [1.19, 2.46]},
                      {"id": "2", "position": [0.75, 2.0]}],
            "strike": {"ball": "cue", "speed": 2.0, "azimuth_deg": 60.0}}"#,
    );
    let found = kinds(&shot, 1);
    assert!(found.iter().any(|k| k == "carom"), "{found:?}");
}

#[test]
fn the_cue_ball_is_left_where_it_is_wanted() {
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
        // What the ball does afterwards is no part of the way.
        assert!(matches!(solution.way.kind().as_str(), "direct" | "kick"), "{:?}", solution.way);
    }
}

#[test]
fn threads_change_nothing() {
    let goal = Goal { pot: Some((1, None)), ..Goal::default() };
    let few = Search { samples: 512, variants: 100, ..search() };
    let alone = solve(&cut(), &goal, &Search { threads: Some(1), ..few }).expect("solutions");
    let together = solve(&cut(), &goal, &Search { threads: Some(2), ..few }).expect("solutions");
    assert_eq!(alone, together);
}

#[test]
fn nonsense_is_refused() {
    let shot = cut();
    let refuse = |goal: Goal| {
        let error = solve(&shot, &goal, &search()).expect_err("nonsense");
        assert!(error.to_string().starts_with("goal: "), "{error}");
    };
    refuse(Goal::default());
    refuse(Goal { pot: Some((0, None)), ..Goal::default() });
    refuse(Goal { pot: Some((1, Some(6))), ..Goal::default() });
    refuse(Goal { leave: Some(Disc { center: [0.0, 0.0], radius: 0.0 }), ..Goal::default() });
}
