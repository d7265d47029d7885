//! WPBSA, section 3, rule 12: the free ball, and who is snookered by it.

use super::{
    BLACK, BLUE, GREEN, NOTHING, PINK, RED, YELLOW, after_a_red, game, on_the_colors, snookered,
};
use crate::games::snooker::On;
use crate::scenarios::{CORNER, SIDE, Scene, assert_fouls, hit};
use crate::{Call, Choice, Foul, Rules};

#[test]
fn who_is_snookered_after_a_foul_has_a_free_ball() {
    let mut scene = snookered();
    scene.choose(Choice::PlayOn);
    assert!(game(&scene).has_free_ball());
    assert!(scene.asks(0).calls.nominate);
    let ruling = scene.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([1, 0], &[BLUE][..]), "it counts as a red");
    assert_eq!(game(&scene).on(), On::Color);
}

#[test]
fn a_free_ball_must_be_hit_first_and_a_ball_on_is_none() {
    let mut scene = snookered();
    scene.choose(Choice::PlayOn);
    let mut red = Scene(scene.0.clone());
    let ruling = scene.play(Call::On(BLUE), hit(&[RED]).potting(RED, SIDE));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(ruling.points, [0, 4]);
    assert_eq!(red.play(Call::On(RED), hit(&[RED]).potting(RED, SIDE)).points, [1, 0]);
}

#[test]
fn a_free_ball_and_a_red_that_fall_count_one_each() {
    let mut scene = snookered();
    scene.choose(Choice::PlayOn);
    let happened = hit(&[BLUE]).potting(RED, SIDE).potting(BLUE, CORNER);
    let ruling = scene.play(Call::On(BLUE), happened);
    assert!(ruling.is_legal(), "nobody is left behind the free ball: {ruling:?}");
    assert_eq!((ruling.points, &ruling.spotted[..]), ([2, 0], &[BLUE][..]));
    assert_eq!(game(&scene).on(), On::Color);
}

/// Player 1 on the yellow with a free ball: the blue lies between.
fn free_ball_on_the_colors() -> Scene {
    let mut scene = on_the_colors();
    scene.0.put(0, Some([0.889, 0.9]));
    scene.0.put(BLUE, Some([0.889, 1.0]));
    scene.0.put(YELLOW, Some([0.889, 2.4]));
    scene.play(NOTHING, hit(&[GREEN]));
    scene.choose(Choice::PlayOn);
    assert!(game(&scene).has_free_ball());
    scene
}

#[test]
fn a_free_ball_in_the_sequence_has_the_value_of_the_ball_on_and_comes_back() {
    let mut scene = free_ball_on_the_colors();
    let ruling = scene.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 2], &[BLUE][..]));
    assert_eq!(scene.asks(1).on, [YELLOW]);

    let mut scene = free_ball_on_the_colors();
    let happened = hit(&[BLUE]).potting(BLUE, SIDE).potting(YELLOW, CORNER);
    let ruling = scene.play(Call::On(BLUE), happened);
    assert_eq!(
        (ruling.points, &ruling.spotted[..]),
        ([0, 2], &[BLUE][..]),
        "only the ball on counts"
    );
    assert_eq!(scene.asks(1).on, [GREEN]);
}

#[test]
fn the_pink_may_be_left_in_front_of_the_black_as_a_free_ball() {
    let mut scene = on_the_colors().without(YELLOW..BLUE).without([BLUE]);
    scene.0.put(0, Some([0.889, 0.9]));
    scene.0.put(BLACK, Some([0.889, 1.0]));
    scene.0.put(PINK, Some([0.889, 2.4]));
    scene.play(NOTHING, hit(&[BLACK]));
    scene.choose(Choice::PlayOn);
    assert!(game(&scene).has_free_ball());
    assert!(scene.play(Call::On(BLACK), hit(&[BLACK])).is_legal());
}

#[test]
fn who_is_passed_the_shot_back_has_no_free_ball() {
    let mut scene = snookered();
    scene.choose(Choice::PassBack);
    assert!(!game(&scene).has_free_ball());
    assert_eq!(scene.asks(1).on, [RED]);
}

#[test]
fn to_leave_the_other_behind_the_free_ball_is_a_foul() {
    let mut scene = snookered();
    scene.choose(Choice::PlayOn);
    // The blue stays where it hides the red.
    assert_fouls(&scene.play(Call::On(BLUE), hit(&[BLUE])), &[Foul::SnookeredByFreeBall]);
}

#[test]
fn the_nearest_ball_in_the_way_is_the_one_that_snookers() {
    let behind = |nearer| {
        let mut scene = snookered();
        scene.choose(Choice::PlayOn);
        // The blue hides the red, and so does the pink: before or behind it.
        scene.0.put(BLUE, Some([0.889, 1.2]));
        scene.0.put(PINK, Some([0.889, if nearer { 1.05 } else { 1.5 }]));
        scene.play(Call::On(BLUE), hit(&[BLUE]))
    };
    assert_fouls(&behind(false), &[Foul::SnookeredByFreeBall]);
    assert!(behind(true).is_legal(), "the pink is the effective snookering ball");
}

#[test]
fn behind_different_balls_for_different_reds_nobody_is_snookered_by_the_free_ball() {
    let mut scene = snookered();
    scene.choose(Choice::PlayOn);
    scene.0.put(2, Some([0.3, 0.9]));
    scene.0.put(PINK, Some([0.6, 0.9]));
    let mut alone = Scene(scene.0.clone());
    assert!(scene.play(Call::On(BLUE), hit(&[BLUE])).is_legal());
    alone.0.put(2, None);
    assert_fouls(&alone.play(Call::On(BLUE), hit(&[BLUE])), &[Foul::SnookeredByFreeBall]);
}

#[test]
fn a_snooker_made_with_another_ball_than_the_free_ball_is_allowed() {
    let mut scene = snookered();
    scene.choose(Choice::PlayOn);
    assert!(scene.play(Call::On(PINK), hit(&[PINK])).is_legal(), "the blue hides the red");
    assert!(!game(&scene).has_free_ball(), "a free ball follows on a foul alone");
    scene.asks(1);
}

#[test]
fn a_ball_that_hides_one_edge_gives_a_free_ball() {
    let with_blue_at = |x: f64| {
        let mut scene = Scene::of(Rules::Snooker).without(2..=15);
        scene.play(NOTHING, hit(&[RED]));
        scene.0.put(0, Some([0.889, 0.9]));
        scene.0.put(RED, Some([0.889, 2.4]));
        scene.0.put(BLUE, Some([x, 1.6]));
        scene.play(NOTHING, hit(&[YELLOW]));
        scene.choose(Choice::PlayOn);
        game(&scene).has_free_ball()
    };
    let diameter = 2.0 * Scene::of(Rules::Snooker).0.base().physics().ball.radius;
    assert!(with_blue_at(0.889 + diameter), "one edge is hidden");
    // The way to the extreme edge is a diameter off the middle at the red, and half of that here.
    assert!(!with_blue_at(0.889 + 1.6 * diameter));
}

#[test]
fn the_free_ball_for_the_last_red_is_followed_by_a_color_and_the_red_stays() {
    let mut scene = snookered();
    scene.choose(Choice::PlayOn);
    scene.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE));
    scene.play(Call::On(BLACK), hit(&[BLACK]).potting(BLACK, SIDE));
    assert_eq!((scene.asks(0).on.clone(), game(&scene).run()), (vec![RED], 8));
}

#[test]
fn with_the_balls_put_back_another_color_may_be_nominated_and_a_free_ball_is_one_again() {
    let mut scene = after_a_red();
    scene.play(Call::On(BLUE), hit(&[2]));
    scene.choose(Choice::Replace);
    assert!(scene.play(Call::On(PINK), hit(&[PINK])).is_legal());

    let mut scene = snookered();
    scene.choose(Choice::PlayOn);
    scene.play(Call::On(BLUE), hit(&[YELLOW]));
    scene.choose(Choice::Replace);
    assert!(game(&scene).has_free_ball());
    assert!(scene.play(Call::On(GREEN), hit(&[GREEN])).is_legal());
}
