//! How a frame ends that nobody wins at the table.

use super::{CORNER, SIDE, Scene, hit};
use crate::{Call, Choice, Options, Request, Rules};

#[test]
fn who_concedes_loses_whether_a_shot_or_a_choice_is_asked() {
    for rules in Rules::ALL {
        let mut scene = Scene::of(rules);
        scene.0.concede().expect("a shot is asked");
        scene.is_won_by(1);
        assert!(scene.0.concede().is_err(), "it is over");
    }
    let mut scene = Scene::of(Rules::EightBall);
    scene.play(Call::Nothing, hit(&[1]).driving(&[1]));
    scene.0.concede().expect("player 1 has a choice");
    scene.is_won_by(0);
}

/// Nobody pockets anything, with the reds or the first ball hit each time.
fn idle(scene: &mut Scene, shots: u32) -> bool {
    let mut racked = false;
    for _ in 0..shots {
        let turn = scene.turn().clone();
        let first = turn.on.first().copied().unwrap_or(2);
        let call = if turn.calls.required { Call::Safety } else { Call::Nothing };
        racked = scene.play(call, hit(&[first]).driving(&[1, 2, 3, 4])).racked;
    }
    racked
}

#[test]
fn a_stalemate_is_racked_again_for_the_first_breaker_and_the_second_ends_the_frame() {
    let options = Options { patience: 5, ..Options::default() };
    for rules in
        [Rules::EightBall, Rules::NineBall, Rules::TenBall, Rules::StraightPool, Rules::Snooker]
    {
        let mut scene = Scene::with(rules, options);
        assert!(!idle(&mut scene, 4), "{}", rules.name());
        assert!(idle(&mut scene, 1), "{}", rules.name());
        assert!(scene.asks(0).hand.is_some(), "player 0 breaks");
        idle(&mut scene, 5);
        assert!(matches!(scene.0.request(), Request::Over { winner: None, .. }));
    }
    let mut scene = Scene::with(Rules::ThreeCushion, options);
    idle(&mut scene, 5);
    assert!(matches!(scene.0.request(), Request::Over { winner: None, .. }));
}

#[test]
fn a_stalemate_takes_the_points_of_snooker_but_not_of_straight_pool() {
    let options = Options { patience: 5, ..Options::default() };
    let mut scene = Scene::with(Rules::Snooker, options);
    scene.0.set_scores([12, 7]);
    idle(&mut scene, 4);
    let ruling = scene.play(Call::Nothing, hit(&[1]));
    assert!(ruling.racked);
    assert_eq!((ruling.points, scene.0.scores()), ([-12, -7], [0, 0]));

    let mut scene = Scene::with(Rules::StraightPool, options);
    scene.play(Call::Safety, hit(&[1]).no_rail());
    assert_eq!(scene.0.scores(), [-2, 0]);
    scene.choose(Choice::PlayOn);
    assert!(!idle(&mut scene, 3), "a choice is no shot");
    assert!(idle(&mut scene, 1));
    assert_eq!(scene.0.scores(), [-2, 0]);
}

#[test]
fn balls_that_were_racked_again_can_be_progress_again() {
    let mut scene = Scene::with(Rules::EightBall, Options { patience: 3, ..Options::default() });
    let happened = hit(&[1]).potting(8, SIDE).potting(1, CORNER).potting(2, CORNER);
    scene.play(Call::Nothing, happened);
    scene.choose(Choice::Rebreak);
    idle(&mut scene, 2);
    scene.play(Call::Safety, hit(&[1]).potting(1, CORNER));
    assert!(!idle(&mut scene, 2), "the 1 fell: that is progress");
    assert!(idle(&mut scene, 1));
}
