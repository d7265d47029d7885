//! Layouts in which a ball falls in one kind of way: that is found, named, and comes first.

use carom::Shot;
use carom_plan::{Disc, Errs, Goal, Search, Solution, solve};

const TOP_RIGHT: usize = 5;
/// Less than this is luck.
const LUCK: f64 = 0.1;
/// How far the cue may be raised for jumps and massés, rad.
const RAISED: f64 = 1.2;

fn shot(balls: &[(&str, [f64; 2])]) -> Shot {
    let balls: Vec<String> = balls
        .iter()
        .map(|(id, [x, y])| format!(r#"{{"id": "{id}", "position": [{x}, {y}]}}"#))
        .collect();
    let text = format!(
        r#"{{"format": "carom-shot/1", "table": "wpa-9ft", "balls": [{}],
            "strike": {{"ball": "cue", "speed": 2.0, "azimuth_deg": 90.0, "obstruction": "report"}}}}"#,
        balls.join(", ")
    );
    Shot::from_json(&text).expect("a shot")
}

fn search() -> Search {
    let errs = Errs { variants: 200, ..Errs::default() };
    Search { errs, samples: 2048, wanted: 40, of_a_way: 1, ..Search::default() }
}

/// All that is found.
fn found(shot: &Shot, goal: Goal) -> Vec<Solution> {
    solutions(shot, goal, &search())
}

/// The same with jumps and massés.
fn found_raised(shot: &Shot, goal: Goal) -> Vec<Solution> {
    solutions(shot, goal, &Search { elevation: Some(RAISED), ..search() })
}

/// What a search finds, each played once more: it does what it says.
fn solutions(shot: &Shot, goal: Goal, search: &Search) -> Vec<Solution> {
    let solutions = solve(shot, &goal, search, &mut |_, _, _| true).expect("solutions");
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
    solution.way.kind().split('+').any(|name| name == kind)
}

fn without_cushions(solution: &Solution) -> bool {
    !is_of(solution, "kick") && !is_of(solution, "bank")
}

#[test]
fn where_all_is_open_the_direct_way_comes_first() {
    let open = shot(&[("cue", [0.5, 1.2]), ("1", [0.9, 1.9])]);
    let solutions = found(&open, pot(1, TOP_RIGHT));
    assert_eq!(solutions[0].way.kind(), "direct");
    for kind in ["bank", "kick"] {
        assert!(solutions.iter().any(|s| s.way.kind() == kind), "no {kind}");
    }
}

#[test]
fn where_the_pocket_is_hidden_from_the_ball_only_banks_pot_it() {
    let hidden = shot(&[("cue", [0.45, 1.3]), ("1", [0.635, 1.75]), ("2", [0.93, 2.18])]);
    let solutions = found(&hidden, Goal { first: Some(1), ..pot(1, TOP_RIGHT) });
    assert_eq!(solutions[0].way.kind(), "bank");
    for solution in solutions.iter().filter(|s| s.chance.share() > LUCK) {
        assert!(is_of(solution, "bank") || is_of(solution, "kiss"), "{solution:?}");
        assert!(!is_of(solution, "direct"), "{solution:?}");
    }
}

#[test]
fn where_the_ball_is_hidden_from_the_cue_ball_only_kicks_pot_it() {
    let hidden = shot(&[("cue", [0.3, 0.9]), ("1", [1.21, 2.48]), ("2", [0.345, 0.98])]);
    let solutions = found(&hidden, Goal { first: Some(1), ..pot(1, TOP_RIGHT) });
    assert_eq!(solutions[0].way.kind(), "kick");
    for solution in &solutions {
        assert!(is_of(solution, "kick"), "{solution:?}");
    }
}

#[test]
fn where_another_ball_must_be_hit_first_it_drives_the_ball_in() {
    let behind = shot(&[("cue", [0.6, 1.8]), ("1", [1.2, 2.47]), ("2", [1.08, 2.35])]);
    let solutions = found(&behind, Goal { first: Some(2), ..pot(1, TOP_RIGHT) });
    assert_eq!(solutions[0].way.kind(), "combination");
    for solution in solutions.iter().filter(|s| without_cushions(s)) {
        assert!(is_of(solution, "combination"), "{solution:?}");
    }
}

#[test]
fn where_that_ball_cannot_come_to_it_the_cue_ball_goes_on_by_itself() {
    // Seen from the cue ball, ball 1 lies behind ball 2, which only goes forward.
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
fn a_pot_and_a_place_for_the_cue_ball_are_had_together() {
    let open = shot(&[("cue", [0.5, 1.2]), ("1", [0.9, 1.9])]);
    let area = Disc { center: [0.9, 1.2], radius: 0.2 };
    let both = found(&open, Goal { leave: Some(area), ..pot(1, TOP_RIGHT) });
    let alone = found(&open, pot(1, TOP_RIGHT));
    assert!(both.len() >= 3);
    for solution in &both {
        let [x, y] = solution.cue_ball_end;
        let (dx, dy) = (x - area.center[0], y - area.center[1]);
        assert!(dx * dx + dy * dy <= area.radius * area.radius, "{solution:?}");
    }
    assert!(both[0].chance.share() < alone[0].chance.share(), "two wishes are harder than one");
}

#[test]
fn a_snooker_is_escaped_to_where_the_cue_ball_is_wanted() {
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

/// Blocked by a ball: the straight way to the pot, and that to the ball.
fn blocked() -> Shot {
    shot(&[("cue", [0.4, 0.75]), ("1", [0.9, 1.9]), ("2", [0.57, 1.13])])
}

#[test]
fn where_a_ball_blocks_the_line_the_cue_ball_jumps_over_it_if_the_cue_may_be_raised() {
    let goal = Goal { first: Some(1), ..pot(1, TOP_RIGHT) };
    for solution in found(&blocked(), goal) {
        assert!(is_of(&solution, "kick"), "{solution:?}");
    }
    let solutions = found_raised(&blocked(), goal);
    let jump = solutions.iter().find(|s| s.way.kind() == "jump").expect("a jump");
    assert_eq!(jump.way.words(&blocked()), "over 2, 1");
    assert!(jump.chance.share() > LUCK, "{jump:?}");
    assert!((0.2..=RAISED).contains(&jump.strike.elevation), "{jump:?}");
}

#[test]
fn what_is_called_a_jump_has_jumped_and_what_is_called_a_masse_has_curved() {
    let hidden = shot(&[("cue", [0.5, 0.5]), ("1", [0.5, 1.2]), ("8", [0.5, 0.8])]);
    let solutions = found_raised(&hidden, Goal { first: Some(1), ..Goal::default() });
    for solution in &solutions {
        let played = hidden.with_strike(&solution.strike).and_then(|shot| shot.simulate());
        let trace = played.expect("a trace");
        let jumped = trace.outcome().jumped.contains(&(0, 2));
        assert!(!is_of(solution, "jump") || jumped, "{solution:?}");
        assert!(is_of(solution, "massé") || jumped || is_of(solution, "kick"), "{solution:?}");
    }
    let curved = solutions.iter().find(|s| s.way.kind() == "massé").expect("a massé");
    assert_eq!(curved.way.words(&hidden), "around 8, 1");
    assert!(curved.chance.share() > 0.5, "{curved:?}");
    // Hit low on the side to which it curves, and sent off to the other.
    let left = curved.strike.azimuth - core::f64::consts::FRAC_PI_2;
    assert!(left * curved.strike.side > 0.0 && curved.strike.height < 0.0, "{curved:?}");
}

#[test]
fn a_cue_that_may_not_be_raised_changes_nothing() {
    let few = Search { samples: 512, ..search() };
    let goal = pot(1, TOP_RIGHT);
    let own = solutions(&blocked(), goal, &few);
    let least = Search { elevation: Some(0.0), ..few };
    assert_eq!(own, solutions(&blocked(), goal, &least));
}
