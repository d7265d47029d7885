//! Frames that end by concession or stalemate.

use super::{CORNER, SIDE, Scenario, hit};
use crate::{Call, Choice, Game, Options, Request};

#[test]
fn a_player_who_concedes_a_shot_or_a_choice_loses() {
    for game in Game::ALL {
        let mut scenario = Scenario::of(game);
        scenario.0.concede().expect("a shot is asked");
        scenario.is_won_by(1);
        assert!(scenario.0.concede().is_err(), "the frame is over");
    }
    let mut scenario = Scenario::of(Game::EightBall);
    scenario.play(Call::Nothing, hit(&[1]).driving(&[1]));
    scenario.0.concede().expect("player 1 has a choice");
    scenario.is_won_by(0);
}

/// Plays `shots` legal shots that pocket nothing. Returns whether the last one led to a new rack.
fn idle(scenario: &mut Scenario, shots: u32) -> bool {
    let mut racked = false;
    for _ in 0..shots {
        let turn = *scenario.turn();
        let first = turn.on.first().copied().unwrap_or(2);
        let call = if turn.calls.required { Call::Safety } else { Call::Nothing };
        racked = scenario.play(call, hit(&[first]).driving(&[1, 2, 3, 4])).racked;
    }
    racked
}

#[test]
fn after_a_stalemate_the_first_breaker_breaks_again_and_a_second_one_ends_the_frame() {
    let options = Options { patience: 5, ..Options::default() };
    for game in [Game::EightBall, Game::NineBall, Game::TenBall, Game::StraightPool, Game::Snooker]
    {
        let mut scenario = Scenario::with(game, options);
        assert!(!idle(&mut scenario, 4), "{}", game.name());
        assert!(idle(&mut scenario, 1), "{}", game.name());
        assert!(scenario.asks(0).hand.is_some(), "player 0 breaks");
        idle(&mut scenario, 5);
        assert!(matches!(scenario.0.request(), Request::Over { winner: None, .. }));
    }
    let mut scenario = Scenario::with(Game::ThreeCushion, options);
    idle(&mut scenario, 5);
    assert!(matches!(scenario.0.request(), Request::Over { winner: None, .. }));
}

#[test]
fn a_stalemate_resets_the_scores_of_snooker_but_not_of_straight_pool() {
    let options = Options { patience: 5, ..Options::default() };
    let mut scenario = Scenario::with(Game::Snooker, options);
    scenario.0.set_scores([12, 7]);
    idle(&mut scenario, 4);
    let ruling = scenario.play(Call::Nothing, hit(&[1]));
    assert!(ruling.racked);
    assert_eq!((ruling.points, scenario.0.scores()), ([-12, -7], [0, 0]));

    let mut scenario = Scenario::with(Game::StraightPool, options);
    scenario.play(Call::Safety, hit(&[1]).no_rail());
    assert_eq!(scenario.0.scores(), [-2, 0]);
    scenario.choose(Choice::PlayOn);
    assert!(!idle(&mut scenario, 3), "a choice does not count as a shot");
    assert!(idle(&mut scenario, 1));
    assert_eq!(scenario.0.scores(), [-2, 0]);
}

#[test]
fn after_a_new_rack_pocketed_balls_count_as_progress_again() {
    let mut scenario =
        Scenario::with(Game::EightBall, Options { patience: 3, ..Options::default() });
    let happened = hit(&[1]).potting(8, SIDE).potting(1, CORNER).potting(2, CORNER);
    scenario.play(Call::Nothing, happened);
    scenario.choose(Choice::Rebreak);
    idle(&mut scenario, 2);
    scenario.play(Call::Safety, hit(&[1]).potting(1, CORNER));
    assert!(!idle(&mut scenario, 2), "pocketing the 1 was progress");
    assert!(idle(&mut scenario, 1));
}
