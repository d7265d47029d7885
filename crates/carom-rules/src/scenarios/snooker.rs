//! WPBSA, section 3.

use super::{CORNER, SIDE, Scene, assert_fouls, hit};
use crate::games::Law;
use crate::games::snooker::{On, Snooker};
use crate::{Call, Choice, Foul, Region, Rules};

const RED: u8 = 1;
const YELLOW: u8 = 16;
const GREEN: u8 = 17;
const BLUE: u8 = 19;
const PINK: u8 = 20;
const BLACK: u8 = 21;
const NOTHING: Call = Call::Nothing;

fn game(scene: &Scene) -> &Snooker {
    match scene.0.law() {
        Law::Snooker(game) => game,
        other => panic!("{other:?}"),
    }
}

/// Player 0 has pocketed a red: a colour is on.
fn after_a_red() -> Scene {
    let mut scene = Scene::of(Rules::Snooker);
    let ruling = scene.play(NOTHING, hit(&[RED]).potting(RED, CORNER));
    assert_eq!(ruling.points, [1, 0]);
    assert_eq!(game(&scene).on(), On::Color);
    scene.asks(0);
    scene
}

/// Player 0 on the yellow, with all reds gone.
fn on_the_colors() -> Scene {
    let mut scene = after_a_red().without(2..=15);
    let ruling = scene.play(Call::On(BLACK), hit(&[BLACK]).potting(BLACK, CORNER));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([7, 0], &[BLACK][..]));
    assert_eq!(game(&scene).on(), On::Sequence);
    assert_eq!(scene.asks(0).on, [YELLOW]);
    scene
}

#[test]
fn the_first_shot_is_from_the_d_at_the_reds() {
    let scene = Scene::of(Rules::Snooker);
    assert_eq!(scene.asks(0).hand, Some(Region::TheD));
    assert_eq!(scene.turn().on.len(), 15);
}

#[test]
fn reds_and_colors_alternate_and_colors_come_back() {
    let mut scene = after_a_red();
    assert!(scene.turn().calls.nominate);
    let ruling = scene.play(Call::On(PINK), hit(&[PINK]).potting(PINK, SIDE));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([6, 0], &[PINK][..]));
    assert_eq!((game(&scene).on(), game(&scene).run()), (On::Red, 7));
    assert_eq!(scene.asks(0).on.len(), 14);
}

#[test]
fn several_reds_count_one_each() {
    let mut scene = Scene::of(Rules::Snooker);
    let happened = hit(&[RED]).potting(RED, CORNER).potting(5, SIDE);
    assert_eq!(scene.play(NOTHING, happened).points, [2, 0]);
}

#[test]
fn the_colors_go_in_ascending_order_and_stay_down() {
    let mut scene = on_the_colors();
    assert_eq!(scene.play(NOTHING, hit(&[YELLOW]).potting(YELLOW, SIDE)).points, [2, 0]);
    assert!(scene.is_down(YELLOW));
    assert_eq!(scene.asks(0).on, [GREEN]);
}

#[test]
fn a_miss_of_the_pot_passes_the_turn() {
    let mut scene = after_a_red();
    assert!(scene.play(Call::On(BLUE), hit(&[BLUE])).is_legal());
    assert_eq!((scene.asks(1).on.len(), game(&scene).run()), (14, 0));
}

#[test]
fn a_foul_costs_four_or_the_value_of_the_ball_concerned() {
    let foul = |scene: &mut Scene, call, happened| scene.play(call, happened).points;
    let mut scene = Scene::of(Rules::Snooker);
    assert_eq!(foul(&mut scene, NOTHING, hit(&[])), [0, 4]);
    let mut scene = Scene::of(Rules::Snooker);
    assert_eq!(foul(&mut scene, NOTHING, hit(&[BLUE])), [0, 5]);
    let mut scene = Scene::of(Rules::Snooker);
    assert_eq!(foul(&mut scene, NOTHING, hit(&[RED]).potting(PINK, SIDE)), [0, 6]);
    let mut scene = after_a_red();
    assert_eq!(foul(&mut scene, Call::On(BLACK), hit(&[YELLOW])), [0, 7], "the ball on counts too");
    let mut scene = after_a_red();
    assert_eq!(foul(&mut scene, Call::On(YELLOW), hit(&[YELLOW]).potting(2, SIDE)), [0, 4]);
    let mut scene = Scene::of(Rules::Snooker);
    assert_eq!(foul(&mut scene, NOTHING, hit(&[RED]).losing(BLACK)), [0, 7]);
}

#[test]
fn a_scratch_gives_the_cue_ball_in_the_d() {
    let mut scene = Scene::of(Rules::Snooker);
    let ruling = scene.play(NOTHING, hit(&[RED]).potting(0, SIDE));
    assert_fouls(&ruling, &[Foul::Scratch]);
    scene.choose(Choice::PlayOn);
    assert_eq!(scene.asks(1).hand, Some(Region::TheD));
}

#[test]
fn to_jump_over_a_ball_is_a_foul() {
    let mut scene = Scene::of(Rules::Snooker);
    assert_fouls(&scene.play(NOTHING, hit(&[RED]).jumping()), &[Foul::Jump]);
}

#[test]
fn a_red_that_falls_with_a_foul_stays_down_and_a_color_comes_back() {
    let mut scene = after_a_red();
    let happened = hit(&[BLUE]).potting(2, SIDE).potting(BLUE, SIDE);
    let ruling = scene.play(Call::On(BLUE), happened);
    assert_fouls(&ruling, &[Foul::WrongBallPocketed]);
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 5], &[BLUE][..]));
    assert!(scene.is_down(2));
}

#[test]
fn after_a_foul_and_a_miss_the_balls_may_be_put_back() {
    let mut scene = after_a_red();
    let before = scene.0.layout().clone();
    scene.play(Call::On(BLUE), hit(&[2]).potting(2, SIDE));
    scene.offers(1, &[Choice::PlayOn, Choice::PassBack, Choice::Replace]);
    scene.choose(Choice::Replace);
    assert_eq!(*scene.0.layout(), before);
    assert_eq!(game(&scene).on(), On::Color);
    assert!(scene.asks(0).calls.nominate);
    assert_eq!(scene.0.scores(), [1, 5], "the points stay");
}

#[test]
fn no_miss_is_called_when_the_ball_on_was_hit_first() {
    let mut scene = Scene::of(Rules::Snooker);
    scene.play(NOTHING, hit(&[RED]).potting(0, SIDE));
    scene.offers(1, &[Choice::PlayOn, Choice::PassBack]);
}

#[test]
fn three_misses_in_a_row_with_a_ball_in_sight_lose_the_frame() {
    let mut scene = Scene::of(Rules::Snooker);
    for _ in 0..2 {
        scene.play(NOTHING, hit(&[BLACK]));
        scene.choose(Choice::Replace);
    }
    scene.play(NOTHING, hit(&[BLACK]));
    scene.is_won_by(1);
}

/// A layout with one red and a blue between it and the cue ball.
fn snookered() -> Scene {
    let mut scene = Scene::of(Rules::Snooker).without(2..=15);
    scene.play(NOTHING, hit(&[RED]));
    scene.0.put(0, Some([0.889, 0.9]));
    scene.0.put(BLUE, Some([0.889, 1.0]));
    scene.0.put(RED, Some([0.889, 2.4]));
    scene.play(NOTHING, hit(&[YELLOW]));
    scene
}

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
fn a_color_whose_spot_is_occupied_goes_to_the_highest_free_spot() {
    let mut scene = after_a_red();
    let blue = scene.0.layout().place(BLUE);
    scene.0.put(BLUE, Some([1.4, 1.2]));
    scene.0.put(2, blue);
    scene.0.put(BLACK, Some([0.3, 1.2]));
    let ruling = scene.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE));
    assert_eq!(ruling.spotted, [BLUE]);
    let black_spot = [0.889, 3.569 - 0.324];
    let there = scene.0.layout().place(BLUE).expect("it is spotted");
    assert!((there[0] - black_spot[0]).abs() < 1e-3 && (there[1] - black_spot[1]).abs() < 1e-3);
}

/// Only the black is left, player 0 to shoot with `lead` points more than the other.
fn black_ball(lead: i32) -> Scene {
    let mut scene = on_the_colors().without(YELLOW..PINK);
    scene.0.set_scores([20 + lead - 6, 20]);
    scene.play(NOTHING, hit(&[PINK]).potting(PINK, SIDE));
    assert_eq!(scene.asks(0).on, [BLACK]);
    scene
}

#[test]
fn with_only_the_black_left_the_first_score_or_foul_ends_the_frame() {
    let mut scene = black_ball(-3);
    scene.play(NOTHING, hit(&[BLACK]).potting(BLACK, SIDE));
    scene.is_won_by(0);
    let mut scene = black_ball(3);
    scene.play(NOTHING, hit(&[]));
    scene.is_won_by(1);
}

#[test]
fn a_tie_is_decided_by_the_black_on_its_spot() {
    let mut scene = black_ball(-7);
    scene.play(NOTHING, hit(&[BLACK]).potting(BLACK, SIDE));
    assert_eq!(scene.0.scores(), [20, 20]);
    assert_eq!((scene.turn().hand, &scene.turn().on[..]), (Some(Region::TheD), &[BLACK][..]));
    let player = scene.turn().player;
    scene.play(NOTHING, hit(&[BLACK]).potting(BLACK, SIDE));
    scene.is_won_by(player);
}
