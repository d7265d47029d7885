//! The free ball (WPBSA, section 3, rule 12).

use super::{
    BLACK, BLUE, GREEN, NOTHING, PINK, RED, YELLOW, after_a_red, game, on_the_colors, snookered,
};
use crate::games::snooker::On;
use crate::layout::BallList;
use crate::scenarios::{CORNER, SIDE, Scenario, assert_fouls, hit};
use crate::{Call, Choice, Foul, Game};

#[test]
fn a_player_snookered_after_a_foul_has_a_free_ball() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    assert!(game(&scenario).has_free_ball());
    assert!(scenario.asks(0).calls.nominate);
    let ruling = scenario.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([1, 0], &[BLUE][..]), "it counts as a red");
    assert_eq!(scenario.0.kind_on(), Some(On::Color));
}

#[test]
fn a_free_ball_must_be_hit_first_and_cannot_be_a_ball_on() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    let mut red = Scenario(scenario.0.clone());
    let ruling = scenario.play(Call::On(BLUE), hit(&[RED]).potting(RED, SIDE));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(ruling.points, [0, 4]);
    assert_eq!(red.play(Call::On(RED), hit(&[RED]).potting(RED, SIDE)).points, [1, 0]);
}

#[test]
fn a_free_ball_and_a_red_pocketed_together_count_one_each() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    let happened = hit(&[BLUE]).potting(RED, SIDE).potting(BLUE, CORNER);
    let ruling = scenario.play(Call::On(BLUE), happened);
    assert!(ruling.is_legal(), "the next player is not snookered by the free ball: {ruling:?}");
    assert_eq!((ruling.points, &ruling.spotted[..]), ([2, 0], &[BLUE][..]));
    assert_eq!(scenario.0.kind_on(), Some(On::Color));
}

/// Player 1 has the yellow on and a free ball, since the blue is in the way.
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
fn a_free_ball_after_the_reds_has_the_value_of_the_ball_on_and_is_spotted() {
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
fn a_player_asked_to_play_again_has_no_free_ball() {
    let mut scenario = snookered();
    scenario.choose(Choice::PassBack);
    assert!(!game(&scenario).has_free_ball());
    assert_eq!(scenario.asks(1).on, [RED]);
}

#[test]
fn leaving_the_other_player_snookered_by_the_free_ball_is_a_foul() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    // The blue stays between the cue ball and the red.
    assert_fouls(&scenario.play(Call::On(BLUE), hit(&[BLUE])), &[Foul::SnookeredByFreeBall]);
}

#[test]
fn the_nearest_obstructing_ball_is_the_snookering_ball() {
    let behind = |nearer| {
        let mut scenario = snookered();
        scenario.choose(Choice::PlayOn);
        // The blue hides the red, and so does the pink, which is in front of the blue or behind it.
        scenario.0.put(BLUE, Some([0.889, 1.2]));
        scenario.0.put(PINK, Some([0.889, if nearer { 1.05 } else { 1.5 }]));
        scenario.play(Call::On(BLUE), hit(&[BLUE]))
    };
    assert_fouls(&behind(false), &[Foul::SnookeredByFreeBall]);
    assert!(behind(true).is_legal(), "the pink is the effective snookering ball");
}

#[test]
fn different_obstructing_balls_for_different_reds_are_no_snooker_by_the_free_ball() {
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
    assert!(!game(&scenario).has_free_ball(), "a free ball follows only a foul");
    scenario.asks(1);
}

#[test]
fn a_ball_that_hides_one_edge_gives_a_free_ball() {
    let with_blue_at = |x: f64| {
        let mut scenario = Scenario::of(Game::Snooker).without(2..=15);
        scenario.play(NOTHING, hit(&[RED]));
        scenario.0.put(0, Some([0.889, 0.9]));
        scenario.0.put(RED, Some([0.889, 2.4]));
        scenario.0.put(BLUE, Some([x, 1.6]));
        scenario.play(NOTHING, hit(&[YELLOW]));
        scenario.choose(Choice::PlayOn);
        game(&scenario).has_free_ball()
    };
    let diameter = 2.0 * Scenario::of(Game::Snooker).0.base().physics().ball.radius;
    assert!(with_blue_at(0.889 + diameter), "one edge is hidden");
    // The path to the edge of the red is a diameter off the straight line at the red, and half of
    // that at the blue.
    assert!(!with_blue_at(0.889 + 1.6 * diameter));
}

#[test]
fn after_a_free_ball_for_the_last_red_a_color_is_on_and_the_red_stays() {
    let mut scenario = snookered();
    scenario.choose(Choice::PlayOn);
    scenario.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE));
    scenario.play(Call::On(BLACK), hit(&[BLACK]).potting(BLACK, SIDE));
    assert_eq!(
        (scenario.asks(0).on, game(&scenario).break_points()),
        (BallList::from(&[RED][..]), 8)
    );
}

#[test]
fn after_replacing_the_balls_the_free_ball_remains_and_another_color_may_be_nominated() {
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
