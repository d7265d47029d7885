//! Three-cushion (UMB).

use super::{Scenario, assert_fouls, hit};
use crate::{Call, Choice, Foul, Frame, Game, Options, Request};

const NOTHING: Call = Call::Nothing;

/// A shot that scores for the player to shoot: three cushions between the two object balls.
fn carom(scenario: &Scenario) -> super::DescribedShot {
    let other = 1 - i32::from(scenario.turn().cue);
    hit(&[]).touching(&[2, -1, -1, -1, other])
}

fn played(order: &[i32]) -> i32 {
    let mut scenario = Scenario::of(Game::ThreeCushion);
    let point = carom(&scenario);
    scenario.play(NOTHING, point);
    scenario.play(NOTHING, hit(&[]).touching(order)).points[0]
}

#[test]
fn a_carom_needs_three_cushions_before_the_second_ball() {
    assert_eq!(played(&[2, -1, -1, -1, 1]), 1);
    assert_eq!(played(&[-1, -1, -1, 2, 1]), 1);
    assert_eq!(played(&[-1, 2, -1, 2, -1, 1]), 1, "the first ball may be hit again");
    assert_eq!(played(&[1, -1, -1, 1, -1, 2, 1]), 1, "a kiss after the third cushion");
    assert_eq!(
        played(&[1, 2, -1, -1, -1, 2]),
        0,
        "the second ball was touched before the third cushion"
    );
    assert_eq!(played(&[2, -1, -1, -1, -1, -1, 1]), 1, "more than three");
    assert_eq!(played(&[2, -1, -1, 1, -1]), 0);
    assert_eq!(played(&[2, -1, -1, -1]), 0);
    assert_eq!(played(&[-1, -1, -1]), 0);
}

#[test]
fn the_ruling_counts_balls_and_cushions() {
    for (order, counted) in
        [(&[2, -1, -1, 1, -1][..], (2, 2)), (&[-1, 2, -1, -1, -1], (1, 4)), (&[-1], (0, 1))]
    {
        let mut scenario = Scenario::of(Game::ThreeCushion);
        let point = carom(&scenario);
        scenario.play(NOTHING, point);
        let ruling = scenario.play(NOTHING, hit(&[]).touching(order));
        let count = ruling.carom.expect("a count");
        assert_eq!((count.balls, count.cushions), counted, "{order:?}");
        assert_eq!((count.needed, count.stayed), (3, false));
    }
    assert_eq!(Scenario::of(Game::NineBall).play(NOTHING, hit(&[1])).carom, None);
}

#[test]
fn a_point_keeps_the_turn_and_a_miss_passes_it_with_the_other_cue_ball() {
    let mut scenario = Scenario::of(Game::ThreeCushion);
    let point = carom(&scenario);
    scenario.play(NOTHING, point);
    assert_eq!(scenario.asks(0).cue, 0);
    scenario.play(NOTHING, hit(&[2]));
    assert_eq!(scenario.asks(1).cue, 1);
}

#[test]
fn the_starting_shot_must_hit_the_red_first() {
    let mut scenario = Scenario::of(Game::ThreeCushion);
    let ruling = scenario.play(NOTHING, hit(&[]).touching(&[1, -1, -1, -1, 2]));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(ruling.points, [0, 0]);
    scenario.asks(1);
}

#[test]
fn the_starting_shot_must_hit_the_red_without_a_cushion() {
    let mut scenario = Scenario::of(Game::ThreeCushion);
    let ruling = scenario.play(NOTHING, hit(&[]).touching(&[-1, -1, -1, 2, 1]));
    assert_fouls(&ruling, &[Foul::IndirectStart]);
    assert_eq!((ruling.points, scenario.0.facts().rule(Foul::IndirectStart)), ([0, 0], "UMB 23"));
    scenario.asks(1);
    assert!(
        scenario.play(NOTHING, hit(&[]).touching(&[-1, 2])).is_legal(),
        "it is not a starting shot"
    );
}

#[test]
fn balls_off_the_table_are_spotted_and_the_shot_scores_nothing() {
    let mut scenario = Scenario::of(Game::ThreeCushion);
    let happened = carom(&scenario).losing(2).losing(0);
    let ruling = scenario.play(NOTHING, happened);
    assert_fouls(&ruling, &[Foul::CueBallOffTable, Foul::BallOffTable]);
    assert_eq!((ruling.points, ruling.spotted.len()), ([0, 0], 2));
    assert!(!scenario.is_down(2) && !scenario.is_down(0));
}

const FOOT: [f64; 2] = [0.71, 2.13];
const HEAD: [f64; 2] = [0.71, 0.71];
const CENTER: [f64; 2] = [0.71, 1.42];

#[test]
fn a_ball_off_the_table_goes_to_its_spot_for_the_next_player() {
    for (ball, spot) in [(2, FOOT), (0, CENTER), (1, HEAD)] {
        let mut scenario = Scenario::of(Game::ThreeCushion);
        for (other, place) in [(0, [0.3, 0.3]), (1, [1.0, 1.0]), (2, [0.3, 2.5])] {
            scenario.0.put(other, Some(place));
        }
        let ruling = scenario.play(NOTHING, hit(&[2]).losing(ball));
        assert_eq!(ruling.spotted, [ball]);
        scenario.lies_at(ball, spot);
        scenario.asks(1);
    }
}

#[test]
fn a_ball_with_an_occupied_spot_goes_to_the_spot_of_the_occupying_ball() {
    let mut scenario = Scenario::of(Game::ThreeCushion);
    scenario.0.put(0, Some([0.3, 0.3]));
    scenario.0.put(2, Some([0.3, 1.0]));
    scenario.0.put(1, Some([FOOT[0] + 0.02, FOOT[1]]));
    scenario.play(NOTHING, hit(&[2]).losing(2));
    scenario.lies_at(2, HEAD);

    let mut scenario = Scenario::of(Game::ThreeCushion);
    for (ball, place) in [(2, [0.3, 1.0]), (1, FOOT), (0, HEAD)] {
        scenario.0.put(ball, Some(place));
    }
    scenario.play(NOTHING, hit(&[2]).losing(2));
    scenario.lies_at(2, CENTER);
}

#[test]
fn playing_at_a_frozen_ball_is_a_foul_and_playing_away_is_not() {
    let frozen = || {
        let mut scenario = Scenario::of(Game::ThreeCushion);
        let radius = scenario.0.base().physics().ball.radius;
        scenario.0.put(1, Some([0.7, 1.0]));
        scenario.0.put(2, Some([0.7 + 2.0 * radius, 1.0]));
        scenario.play(NOTHING, hit(&[2]));
        scenario.choose(Choice::PlayOn);
        scenario.asks(1);
        scenario
    };
    let mut scenario = frozen();
    let ruling = scenario.play(NOTHING, hit(&[]).touching(&[2, -1, -1, -1, 0]));
    assert_fouls(&ruling, &[Foul::Push]);
    assert_eq!(ruling.points, [0, 0]);
    let mut scenario = frozen();
    let ruling = scenario.play(NOTHING, hit(&[]).touching(&[-1, -1, -1, 2, 0]));
    assert!(ruling.is_legal());
    assert_eq!(ruling.points, [0, 1]);
}

#[test]
fn a_cushion_to_which_the_cue_ball_is_frozen_does_not_count() {
    let from_the_top = |order: &[i32]| {
        let mut scenario = Scenario::of(Game::ThreeCushion);
        scenario.play(NOTHING, hit(&[2]));
        let table = scenario.0.base().table();
        let reach = table.reach(scenario.0.base().physics().ball.radius);
        // A hair from the cushion, as balls come to rest.
        let place = [0.5, table.size.y - reach - 5e-5];
        scenario.0.put(1, Some(place));
        scenario.play(NOTHING, hit(&[]).touching(order)).points[1]
    };
    assert_eq!(from_the_top(&[-1, -1, -1, 2, 0]), 0);
    assert_eq!(from_the_top(&[-1, 2, -1, -1, 0]), 0);
    assert_eq!(from_the_top(&[-1, -1, -1, -1, 2, 0]), 1);
    assert_eq!(from_the_top(&[2, -1, -1, -1, 0]), 1);
}

#[test]
fn frozen_balls_may_be_spotted() {
    let mut scenario = Scenario::of(Game::ThreeCushion);
    let radius = scenario.0.base().physics().ball.radius;
    scenario.0.put(1, Some([0.7, 1.0]));
    scenario.0.put(2, Some([0.7 + 2.0 * radius, 1.0]));
    scenario.play(NOTHING, hit(&[2]));
    scenario.offers(1, &[Choice::PlayOn, Choice::SpotFrozen]);
    let third = scenario.0.layout().place(0);
    assert_eq!(scenario.choose(Choice::SpotFrozen).spotted, [2, 1]);
    scenario.lies_at(2, FOOT);
    scenario.lies_at(1, HEAD);
    assert_eq!(scenario.0.layout().place(0), third, "the third ball stays");
    scenario.asks(1);
}

#[test]
fn balls_that_come_to_rest_a_hair_apart_are_frozen_and_may_be_spotted() {
    // Balls never stop within rounding of each other, so exact contact would never offer the
    // choice.
    let stopped = |gap: f64| {
        let mut scenario = Scenario::of(Game::ThreeCushion);
        let radius = scenario.0.base().physics().ball.radius;
        scenario.0.put(1, Some([0.7, 1.0]));
        scenario.0.put(2, Some([0.7 + 2.0 * radius + gap, 1.0]));
        scenario.play(NOTHING, hit(&[2]));
        scenario
    };
    stopped(5e-5).offers(1, &[Choice::PlayOn, Choice::SpotFrozen]);
    let mut apart = stopped(2e-4);
    apart.asks(1);
    assert!(apart.play(NOTHING, hit(&[]).touching(&[2, -1, -1, -1, 0])).is_legal());
}

#[test]
fn a_cue_ball_frozen_to_both_others_has_all_three_spotted() {
    let mut scenario = Scenario::of(Game::ThreeCushion);
    let diameter = 2.0 * scenario.0.base().physics().ball.radius;
    for (ball, x) in [(0, 0.7 - diameter), (1, 0.7), (2, 0.7 + diameter)] {
        scenario.0.put(ball, Some([x, 1.0]));
    }
    scenario.play(NOTHING, hit(&[2]));
    scenario.choose(Choice::SpotFrozen);
    for (ball, spot) in [(0, CENTER), (1, HEAD), (2, FOOT)] {
        scenario.lies_at(ball, spot);
    }
}

#[test]
fn balls_frozen_to_each_other_but_not_to_the_cue_ball_stay() {
    let mut scenario = Scenario::of(Game::ThreeCushion);
    let diameter = 2.0 * scenario.0.base().physics().ball.radius;
    scenario.0.put(0, Some([0.7 - diameter, 1.0]));
    scenario.0.put(2, Some([0.7, 1.0]));
    scenario.play(NOTHING, hit(&[2]));
    scenario.asks(1);
}

#[test]
fn a_table_with_pockets_is_refused() {
    let table = Some("wpa-9ft".into());
    let refused = Frame::new(Game::ThreeCushion, Options::default(), table, None, 1);
    let message = refused.expect_err("a ball could fall").to_string();
    assert!(message.starts_with("table: three-cushion is played on a table without pockets"));
}

#[test]
fn a_player_who_reaches_the_points_with_equal_innings_wins() {
    let options = Options { points: 1, ..Options::default() };
    let mut scenario = Scenario::with(Game::ThreeCushion, options);
    scenario.play(NOTHING, hit(&[2]));
    let point = carom(&scenario);
    scenario.play(NOTHING, point);
    scenario.is_won_by(1);
}

#[test]
fn in_a_match_started_by_player_1_player_0_has_the_last_inning() {
    let options = Options { points: 1, ..Options::default() };
    let mut scenario = Scenario::with(Game::ThreeCushion, options);
    let start = scenario.0.layout().clone();
    let places: Vec<_> = (0..3).map(|ball| start.place(ball)).collect();
    scenario.0.resume_at(&places, 1).expect("three balls");
    let point = carom(&scenario);
    scenario.play(NOTHING, point);
    assert_eq!(scenario.asks(0).on, [2], "it is a starting shot");
    assert_eq!(*scenario.0.layout(), start);
    scenario.play(NOTHING, hit(&[2]));
    scenario.is_won_by(1);
}

#[test]
fn the_second_player_has_a_last_inning_from_the_starting_position() {
    let mut scenario =
        Scenario::with(Game::ThreeCushion, Options { points: 2, ..Options::default() });
    let start = scenario.0.layout().clone();
    for _ in 0..2 {
        let point = carom(&scenario);
        scenario.play(NOTHING, point);
    }
    assert_eq!(scenario.asks(1).on, [2], "it is a starting shot");
    let place = |ball| scenario.0.layout().place(ball);
    assert_eq!([place(1), place(0), place(2)], [0, 1, 2].map(|ball| start.place(ball)));
    let mut drawn = Scenario(scenario.0.clone());
    scenario.play(NOTHING, hit(&[2]));
    scenario.is_won_by(0);
    for _ in 0..2 {
        let point = carom(&drawn);
        drawn.play(NOTHING, point);
    }
    assert!(matches!(drawn.0.request(), Request::Over { winner: None, .. }), "a draw");
}
