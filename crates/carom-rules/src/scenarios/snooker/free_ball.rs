//! WPBSA, section 3, rule 12: the free ball, and who is snookered by it.

use super::{
    BLACK, BLUE, GREEN, NOTHING, PINK, RED, YELLOW, after_a_red, game, on_the_colors, snookered,
};
use crate::games::snooker::On;
use crate::scenarios::{CORNER, SIDE, Scenario, assert_fouls, hit};
use crate::{Call, Choice, Foul, Rules};

#[test]
fn who_is_snookered_after_a_foul_has_a_free_ball() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    assert!(game(&scenario).has_free_ball());
    assert!(scenario.asks(0).calls.nominate);
    let ruling = scenario.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([1, 0], &[BLUE][..]), "it counts as a red");
    assert_eq!(game(&scenario).on(), On::Color);
}

#[test]
fn a_free_ball_must_be_hit_first_and_a_ball_on_is_none() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    let mut red = Scenario(scenario.0.clone());
    let ruling = scenario.play(Call::On(BLUE), hit(&[RED]).potting(RED, SIDE));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(ruling.points, [0, 4]);
    assert_eq!(red.play(Call::On(RED), hit(&[RED]).potting(RED, SIDE)).points, [1, 0]);
}

#[test]
fn a_free_ball_and_a_red_that_fall_count_one_each() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    let happened = hit(&[BLUE]).potting(RED, SIDE).potting(BLUE, CORNER);
    let ruling = scenario.play(Call::On(BLUE), happened);
    assert!(ruling.is_legal(), "nobody is left behind the free ball: {ruling:?}");
    assert_eq!((ruling.points, &ruling.spotted[..]), ([2, 0], &[BLUE][..]));
    assert_eq!(game(&scenario).on(), On::Color);
}

/// Seat 1 on the yellow with a free ball: the blue lies between.
fn free_ball_on_the_colors() -> Scenario {
    let mut scenario = on_the_colors();
    scenario.0.put(0, Some([0.889, 0.9]));
    scenario.0.put(BLUE, Some([0.889, 1.0]));
    scenario.0.put(YELLOW, Some([0.889, 2.4]));
    scenario.play(NOTHING, hit(&[GREEN]));
    scenario.choose(Choice::PlayOn);
    assert!(game(&scenario).has_free_ball());
    scenario
}

#[test]
fn a_free_ball_in_the_sequence_has_the_value_of_the_ball_on_and_comes_back() {
    let mut scenario = free_ball_on_the_colors();
    let ruling = scenario.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 2], &[BLUE][..]));
    assert_eq!(scenario.asks(1).on, [YELLOW]);

    let mut scenario = free_ball_on_the_colors();
    let happened = hit(&[BLUE]).potting(BLUE, SIDE).potting(YELLOW, CORNER);
    let ruling = scenario.play(Call::On(BLUE), happened);
    assert_eq!(
        (ruling.points, &ruling.spotted[..]),
        ([0, 2], &[BLUE][..]),
        "only the ball on counts"
    );
    assert_eq!(scenario.asks(1).on, [GREEN]);
}

#[test]
fn the_pink_may_be_left_in_front_of_the_black_as_a_free_ball() {
    let mut scenario = on_the_colors().without(YELLOW..BLUE).without([BLUE]);
    scenario.0.put(0, Some([0.889, 0.9]));
    scenario.0.put(BLACK, Some([0.889, 1.0]));
    scenario.0.put(PINK, Some([0.889, 2.4]));
    scenario.play(NOTHING, hit(&[BLACK]));
    scenario.choose(Choice::PlayOn);
    assert!(game(&scenario).has_free_ball());
    assert!(scenario.play(Call::On(BLACK), hit(&[BLACK])).is_legal());
}

#[test]
fn who_is_passed_the_shot_back_has_no_free_ball() {
    let mut scenario = snookered();
    scenario.choose(Choice::PassBack);
    assert!(!game(&scenario).has_free_ball());
    assert_eq!(scenario.asks(1).on, [RED]);
}

#[test]
fn to_leave_the_other_behind_the_free_ball_is_a_foul() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    // The blue stays where it hides the red.
    assert_fouls(&scenario.play(Call::On(BLUE), hit(&[BLUE])), &[Foul::SnookeredByFreeBall]);
}

#[test]
fn the_nearest_ball_in_the_way_is_the_one_that_snookers() {
    let behind = |nearer| {
        let mut scenario = snookered();
        scenario.choose(Choice::PlayOn);
        // The blue hides the red, and so does the pink: before or behind it.
        scenario.0.put(BLUE, Some([0.889, 1.2]));
        scenario.0.put(PINK, Some([0.889, if nearer { 1.05 } else { 1.5 }]));
        scenario.play(Call::On(BLUE), hit(&[BLUE]))
    };
    assert_fouls(&behind(false), &[Foul::SnookeredByFreeBall]);
    assert!(behind(true).is_legal(), "the pink is the effective snookering ball");
}

#[test]
fn behind_different_balls_for_different_reds_nobody_is_snookered_by_the_free_ball() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    scenario.0.put(2, Some([0.3, 0.9]));
    scenario.0.put(PINK, Some([0.6, 0.9]));
    let mut alone = Scenario(scenario.0.clone());
    assert!(scenario.play(Call::On(BLUE), hit(&[BLUE])).is_legal());
    alone.0.put(2, None);
    assert_fouls(&alone.play(Call::On(BLUE), hit(&[BLUE])), &[Foul::SnookeredByFreeBall]);
}

#[test]
fn a_snooker_made_with_another_ball_than_the_free_ball_is_allowed() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    assert!(scenario.play(Call::On(PINK), hit(&[PINK])).is_legal(), "the blue hides the red");
    assert!(!game(&scenario).has_free_ball(), "a free ball follows on a foul alone");
    scenario.asks(1);
}

#[test]
fn a_ball_that_hides_one_edge_gives_a_free_ball() {
    let with_blue_at = |x: f64| {
        let mut scenario = Scenario::of(Rules::Snooker).without(2..=15);
        scenario.play(NOTHING, hit(&[RED]));
        scenario.0.put(0, Some([0.889, 0.9]));
        scenario.0.put(RED, Some([0.889, 2.4]));
        scenario.0.put(BLUE, Some([x, 1.6]));
        scenario.play(NOTHING, hit(&[YELLOW]));
        scenario.choose(Choice::PlayOn);
        game(&scenario).has_free_ball()
    };
    let diameter = 2.0 * Scenario::of(Rules::Snooker).0.base().physics().ball.radius;
    assert!(with_blue_at(0.889 + diameter), "one edge is hidden");
    // The way to the extreme edge is a diameter off the middle at the red, and half of that here.
    assert!(!with_blue_at(0.889 + 1.6 * diameter));
}

#[test]
fn the_free_ball_for_the_last_red_is_followed_by_a_color_and_the_red_stays() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    scenario.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE));
    scenario.play(Call::On(BLACK), hit(&[BLACK]).potting(BLACK, SIDE));
    assert_eq!((scenario.asks(0).on.clone(), game(&scenario).break_points()), (vec![RED], 8));
}

#[test]
fn with_the_balls_put_back_another_color_may_be_nominated_and_a_free_ball_is_one_again() {
    let mut scenario = after_a_red();
    scenario.play(Call::On(BLUE), hit(&[2]));
    scenario.choose(Choice::Replace);
    assert!(scenario.play(Call::On(PINK), hit(&[PINK])).is_legal());

    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    scenario.play(Call::On(BLUE), hit(&[YELLOW]));
    scenario.choose(Choice::Replace);
    assert!(game(&scenario).has_free_ball());
    assert!(scenario.play(Call::On(GREEN), hit(&[GREEN])).is_legal());
}
