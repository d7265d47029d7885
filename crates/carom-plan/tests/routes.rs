//! Layouts in which a ball can fall on one kind of route: the search finds it, names it and ranks it
//! first.

use carom::Shot;
use carom_plan::{Disc, ErrorModel, Goal, Progress, Search, Solution, solve};

const TOP_RIGHT: usize = 5;
/// Strikes with a smaller chance succeed by luck and are not checked.
const LUCK: f64 = 0.1;
/// Largest elevation of jumps and massés, rad.
const RAISED: f64 = 1.2;

fn shot(balls: &[(&str, [f64; 2])]) -> Shot {
    shot_with("\"pool\"", balls)
}

/// A jump cue: light, with a phenolic tip (TP A.30).
const JUMP_CUE: &str =
    r#"{"cue": {"mass": 0.25, "tip_restitution": 0.87}, "contact_times": {"tip": 8e-4}}"#;

fn shot_with(physics: &str, balls: &[(&str, [f64; 2])]) -> Shot {
    let balls: Vec<String> = balls
        .iter()
        .map(|(id, [x, y])| format!(r#"{{"id": "{id}", "position": [{x}, {y}]}}"#))
        .collect();
    let text = format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "physics": {physics}, "balls": [{}],
            "strike": {{"ball": "cue", "speed": 2.0, "azimuth_deg": 90.0, "obstruction": "report"}}}}"#,
        balls.join(", ")
    );
    Shot::from_json(&text).expect("a shot")
}

fn search() -> Search {
    let model = ErrorModel { variants: 200, ..ErrorModel::default() };
    Search { model, samples: 2048, wanted: 40, per_route: 1, ..Search::default() }
}

/// The solutions without jumps and massés.
fn found(shot: &Shot, goal: Goal) -> Vec<Solution> {
    solutions(shot, goal, &search())
}

/// The solutions with jumps and massés.
fn found_raised(shot: &Shot, goal: Goal) -> Vec<Solution> {
    solutions(shot, goal, &Search { elevation: Some(RAISED), ..search() })
}

/// The solutions of a search. Each is played again and must reach the goal.
fn solutions(shot: &Shot, goal: Goal, search: &Search) -> Vec<Solution> {
    let solutions = solve(shot, &goal, search, &Progress::default()).expect("solutions");
    for solution in &solutions {
        let again = shot.with_strike(&solution.strike).expect("a shot");
        let trace = again.simulate().expect("a trace");
        let outcome = trace.outcome();
        assert!(!outcome.cue_ball_scratched(), "{solution:?}");
        if let Some((ball, pocket)) = goal.pot {
            let into = pocket.map(|pocket| shot.table().pockets[pocket].name);
            let fell = outcome.pocketed.iter().find(|(b, _)| usize::from(*b) == ball);
            assert!(fell.is_some_and(|(_, p)| into.is_none_or(|i| i == *p)), "{solution:?}");
        }
        if let Some(first) = goal.first {
            assert_eq!(outcome.first_contact, Some(first as u16), "{solution:?}");
        }
    }
    solutions
}

fn pot(ball: usize, pocket: usize) -> Goal {
    Goal { pot: Some((ball, Some(pocket))), ..Goal::default() }
}

fn is_of(solution: &Solution, kind: &str) -> bool {
    solution.route.kind().split('+').any(|name| name == kind)
}

fn without_cushions(solution: &Solution) -> bool {
    !is_of(solution, "kick") && !is_of(solution, "bank")
}

#[test]
fn a_frozen_ball_is_potted_by_the_strike_itself() {
    // The line of centres points at the corner pocket.
    let along = [1.27 - 0.9, 2.54 - 1.9];
    let length = carom::math::sqrt(along[0] * along[0] + along[1] * along[1]);
    let diameter = 2.0 * 0.028575;
    let cue = [0, 1].map(|k| [0.9, 1.9][k] - diameter * along[k] / length);
    let frozen = shot(&[("cue", cue), ("1", [0.9, 1.9])]);
    let solutions = found(&frozen, pot(1, TOP_RIGHT));
    // Routes on which the balls meet again pot it as surely: the first of them is a matter of one
    // variant in 200.
    let direct = solutions.iter().find(|s| s.route.kind() == "direct").expect("a direct route");
    assert_eq!(direct.route.words(&frozen), "1");
    assert!(direct.chance.share() > 0.95, "{direct:?}");
    assert_eq!(solutions[0].route.words(&frozen).split(", ").next(), Some("1"), "no kick");
}

#[test]
fn the_direct_route_comes_first_when_nothing_blocks_it() {
    let open = shot(&[("cue", [0.5, 1.2]), ("1", [0.9, 1.9])]);
    let solutions = found(&open, pot(1, TOP_RIGHT));
    assert_eq!(solutions[0].route.kind(), "direct");
    for kind in ["bank", "kick"] {
        assert!(solutions.iter().any(|s| s.route.kind() == kind), "no {kind}");
    }
}

#[test]
fn only_banks_pot_a_ball_whose_line_to_the_pocket_is_blocked() {
    let hidden = shot(&[("cue", [0.45, 1.3]), ("1", [0.635, 1.75]), ("2", [0.93, 2.18])]);
    let solutions = found(&hidden, Goal { first: Some(1), ..pot(1, TOP_RIGHT) });
    assert_eq!(solutions[0].route.kind(), "bank");
    for solution in solutions.iter().filter(|s| s.chance.share() > LUCK) {
        assert!(is_of(solution, "bank") || is_of(solution, "kiss"), "{solution:?}");
        assert!(!is_of(solution, "direct"), "{solution:?}");
    }
}

#[test]
fn only_kicks_pot_a_ball_that_is_hidden_from_the_cue_ball() {
    let hidden = shot(&[("cue", [0.3, 0.9]), ("1", [1.21, 2.48]), ("2", [0.345, 0.98])]);
    let solutions = found(&hidden, Goal { first: Some(1), ..pot(1, TOP_RIGHT) });
    assert_eq!(solutions[0].route.kind(), "kick");
    for solution in &solutions {
        assert!(is_of(solution, "kick"), "{solution:?}");
    }
}

#[test]
fn a_combination_pots_a_ball_behind_the_one_to_be_hit_first() {
    let behind = shot(&[("cue", [0.6, 1.8]), ("1", [1.2, 2.47]), ("2", [1.08, 2.35])]);
    let solutions = found(&behind, Goal { first: Some(2), ..pot(1, TOP_RIGHT) });
    assert_eq!(solutions[0].route.kind(), "combination");
    for solution in solutions.iter().filter(|s| without_cushions(s)) {
        assert!(is_of(solution, "combination"), "{solution:?}");
    }
}

#[test]
fn a_carom_pots_a_ball_that_no_combination_can_reach() {
    // Ball 1 is beside ball 2, which can only be driven forward.
    let aside = shot(&[("cue", [0.7, 1.0]), ("1", [1.24, 1.27]), ("2", [0.7, 1.4])]);
    let right = aside.table().pockets.iter().position(|p| p.name.name() == "right");
    let goal = Goal { first: Some(2), ..pot(1, right.expect("a side pocket")) };
    let solutions = found(&aside, goal);
    let mut bare = solutions.iter().filter(|s| without_cushions(s)).peekable();
    assert!(bare.peek().is_some_and(|s| s.chance.share() > LUCK), "{solutions:?}");
    for solution in bare {
        assert!(is_of(solution, "carom") && !is_of(solution, "combination"), "{solution:?}");
    }
}

#[test]
fn a_pot_and_a_position_of_the_cue_ball_are_reached_together() {
    let open = shot(&[("cue", [0.5, 1.2]), ("1", [0.9, 1.9])]);
    let area = Disc { center: [0.6, 1.6], radius: 0.2 };
    let both = found(&open, Goal { leave: Some(area), ..pot(1, TOP_RIGHT) });
    let alone = found(&open, pot(1, TOP_RIGHT));
    assert!(both.len() >= 3);
    for solution in &both {
        let [x, y] = solution.cue_ball_end;
        let (dx, dy) = (x - area.center[0], y - area.center[1]);
        assert!(dx * dx + dy * dy <= area.radius * area.radius, "{solution:?}");
    }
    assert!(both[0].chance.share() < alone[0].chance.share(), "two goals are harder than one");
}

#[test]
fn an_escape_from_a_snooker_leaves_the_cue_ball_in_the_disc() {
    let hidden = shot(&[("cue", [0.3, 0.5]), ("8", [0.3, 0.7]), ("1", [0.3, 2.0])]);
    let area = Disc { center: [0.8, 0.4], radius: 0.4 };
    let safe = found(&hidden, Goal { first: Some(2), leave: Some(area), ..Goal::default() });
    assert!(!safe.is_empty());
    for solution in &safe {
        let [x, y] = solution.cue_ball_end;
        let (dx, dy) = (x - area.center[0], y - area.center[1]);
        assert!(dx * dx + dy * dy <= area.radius * area.radius, "{solution:?}");
    }
}

/// A layout in which a ball blocks the straight line to the object ball.
fn blocked() -> Shot {
    shot_with(JUMP_CUE, &[("cue", [0.4, 0.75]), ("1", [0.9, 1.9]), ("2", [0.57, 1.13])])
}

#[test]
fn a_jump_is_found_over_a_blocking_ball_if_the_cue_may_be_raised() {
    let goal = Goal { first: Some(1), ..pot(1, TOP_RIGHT) };
    for solution in found(&blocked(), goal) {
        assert!(is_of(&solution, "kick"), "{solution:?}");
    }
    let solutions = found_raised(&blocked(), goal);
    let jump = solutions.iter().find(|s| s.route.kind() == "jump").expect("a jump");
    assert_eq!(jump.route.words(&blocked()), "over 2, 1");
    assert!(jump.chance.share() > LUCK, "{jump:?}");
    assert!((0.2..=RAISED).contains(&jump.strike.elevation), "{jump:?}");
}

#[test]
fn a_jump_flies_over_the_blocking_ball_and_a_masse_curves_around_it() {
    let hidden = shot(&[("cue", [0.5, 0.5]), ("1", [0.5, 1.2]), ("8", [0.5, 0.8])]);
    let solutions = found_raised(&hidden, Goal { first: Some(1), ..Goal::default() });
    for solution in &solutions {
        let played = hidden.with_strike(&solution.strike).and_then(|shot| shot.simulate());
        let trace = played.expect("a trace");
        let jumped = trace.outcome().jumped.contains(&(0, 2));
        assert!(!is_of(solution, "jump") || jumped, "{solution:?}");
        assert!(is_of(solution, "massé") || jumped || is_of(solution, "kick"), "{solution:?}");
    }
    let curved = solutions.iter().find(|s| s.route.kind() == "massé").expect("a massé");
    assert_eq!(curved.route.words(&hidden), "around 8, 1");
    assert!(curved.chance.share() > 0.5, "{curved:?}");
    // A massé is hit low on the side to which it curves and starts to the other side.
    let left = curved.strike.azimuth - core::f64::consts::FRAC_PI_2;
    assert!(left * curved.strike.side > 0.0 && curved.strike.height < 0.0, "{curved:?}");
}

#[test]
fn a_largest_elevation_of_zero_gives_the_same_solutions_as_none() {
    let few = Search { samples: 512, ..search() };
    let goal = pot(1, TOP_RIGHT);
    let own = solutions(&blocked(), goal, &few);
    let least = Search { elevation: Some(0.0), ..few };
    assert_eq!(own, solutions(&blocked(), goal, &least));
}
