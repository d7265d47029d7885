//! Nine-ball and ten-ball (WPA, sections 2 and 9).

use carom::resolve::cue_ball::Strike;

use super::{CORNER, SIDE, Scenario, assert_fouls, hit};
use crate::{Call, Choice, Foul, Game, Play, Region};

/// After a legal break that pocketed the 5: player 0 shoots again.
fn after_break(game: Game) -> Scenario {
    let mut scenario = Scenario::of(game);
    scenario.play(Call::Nothing, hit(&[1]).potting(5, CORNER));
    assert_eq!(scenario.asks(0).on, [1]);
    scenario
}

fn past_the_push(game: Game) -> Scenario {
    let mut scenario = after_break(game);
    let call = if game == Game::TenBall { Call::Safety } else { Call::Nothing };
    scenario.play(call, hit(&[1]));
    scenario.asks(1);
    scenario
}

#[test]
fn the_break_must_hit_the_one_first() {
    let mut scenario = Scenario::of(Game::NineBall);
    let ruling = scenario.play(Call::Nothing, hit(&[2]).potting(5, CORNER));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
    assert!(!scenario.turn().calls.push_out, "a push-out needs a break without a foul (2.4)");
}

#[test]
fn a_soft_break_is_a_foul() {
    let mut scenario = Scenario::of(Game::NineBall);
    let ruling = scenario.play(Call::Nothing, hit(&[1]).driving(&[1, 2, 3]));
    assert_fouls(&ruling, &[Foul::SoftBreak]);
}

#[test]
fn the_nine_wins_whenever_it_is_pocketed_legally() {
    let mut scenario = Scenario::of(Game::NineBall);
    scenario.play(Call::Nothing, hit(&[1]).potting(9, CORNER));
    scenario.is_won_by(0);
    let mut scenario = past_the_push(Game::NineBall);
    scenario.play(Call::Nothing, hit(&[1, 9]).potting(9, SIDE));
    scenario.is_won_by(1);
}

#[test]
fn the_nine_is_spotted_after_a_foul_and_other_balls_are_not() {
    let mut scenario = past_the_push(Game::NineBall);
    let ruling = scenario.play(Call::Nothing, hit(&[2]).potting(9, SIDE).potting(3, SIDE));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(ruling.spotted, [9]);
    assert!(scenario.is_down(3) && !scenario.is_down(9));
    assert_eq!(scenario.asks(0).hand, Some(Region::Anywhere));
}

#[test]
fn a_push_out_needs_no_contact_and_no_rail_and_gives_the_other_player_the_choice() {
    let mut scenario = after_break(Game::NineBall);
    assert!(scenario.turn().calls.push_out);
    assert!(scenario.play(Call::PushOut, hit(&[]).no_rail()).is_legal());
    scenario.offers(1, &[Choice::PlayOn, Choice::PassBack]);
    scenario.choose(Choice::PassBack);
    assert!(!scenario.asks(0).calls.push_out, "one push-out a rack");
}

#[test]
fn a_scratch_is_a_foul_in_a_push_out_too_and_the_nine_is_spotted() {
    let mut scenario = after_break(Game::NineBall);
    let ruling = scenario.play(Call::PushOut, hit(&[9]).potting(0, SIDE));
    assert_fouls(&ruling, &[Foul::Scratch]);
    assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
    let mut scenario = after_break(Game::NineBall);
    let ruling = scenario.play(Call::PushOut, hit(&[9]).potting(9, SIDE));
    assert_eq!(ruling.spotted, [9]);
    scenario.offers(1, &[Choice::PlayOn, Choice::PassBack]);
}

#[test]
fn a_push_out_is_allowed_only_in_the_shot_after_the_break() {
    let mut scenario = after_break(Game::NineBall);
    scenario.play(Call::Nothing, hit(&[1]).potting(1, CORNER));
    assert!(!scenario.asks(0).calls.push_out);
    let mut scenario = Scenario::of(Game::NineBall);
    scenario.play(Call::Nothing, hit(&[1]).driving(&[1, 2, 3, 4]));
    assert!(scenario.asks(1).calls.push_out, "no ball was pocketed, so the other player shoots");
}

#[test]
fn three_consecutive_fouls_lose_the_rack_and_a_legal_shot_resets_the_count() {
    let mut scenario = past_the_push(Game::NineBall);
    for _ in 0..2 {
        scenario.play(Call::Nothing, hit(&[2]));
        scenario.play(Call::Nothing, hit(&[1]));
    }
    assert_eq!(scenario.0.fouls_in_a_row(), [0, 2]);
    let mut forgiven = Scenario(scenario.0.clone());
    scenario.play(Call::Nothing, hit(&[2]));
    scenario.is_won_by(0);
    forgiven.play(Call::Nothing, hit(&[1]));
    assert_eq!(forgiven.0.fouls_in_a_row(), [0, 0]);
}

#[test]
fn a_ball_driven_off_the_table_is_a_foul_and_stays_off() {
    let mut scenario = past_the_push(Game::NineBall);
    let ruling = scenario.play(Call::Nothing, hit(&[1]).losing(4));
    assert_fouls(&ruling, &[Foul::BallOffTable]);
    assert!(scenario.is_down(4));
    assert_eq!(scenario.turn().on, [1]);
}

#[test]
fn in_ten_ball_an_uncalled_pocketed_ball_gives_the_other_player_the_choice() {
    let mut scenario = past_the_push(Game::TenBall);
    assert!(scenario.turn().calls.required);
    assert!(scenario.play(Call::Pocket(1, CORNER), hit(&[1]).potting(1, SIDE)).is_legal());
    scenario.offers(0, &[Choice::PlayOn, Choice::PassBack]);
    let mut scenario = past_the_push(Game::TenBall);
    scenario.play(Call::Pocket(1, CORNER), hit(&[1]).potting(1, CORNER).potting(3, SIDE));
    scenario.asks(1);
}

#[test]
fn a_called_ten_with_other_balls_left_is_spotted_and_the_shooter_continues() {
    let mut scenario = past_the_push(Game::TenBall);
    let ruling = scenario.play(Call::Pocket(10, SIDE), hit(&[1, 10]).potting(10, SIDE));
    assert_eq!(ruling.spotted, [10]);
    scenario.asks(1);
    let mut scenario = past_the_push(Game::TenBall);
    let happened = hit(&[1]).potting(1, CORNER).potting(10, SIDE);
    assert_eq!(scenario.play(Call::Pocket(1, CORNER), happened).spotted, [10]);
    assert_eq!(scenario.asks(1).on, [2]);
}

#[test]
fn a_safety_that_pockets_a_ball_gives_the_other_player_the_choice() {
    let mut scenario = past_the_push(Game::TenBall);
    assert!(scenario.play(Call::Safety, hit(&[1]).potting(1, SIDE)).is_legal());
    scenario.offers(0, &[Choice::PlayOn, Choice::PassBack]);
    scenario.choose(Choice::PassBack);
    assert_eq!(scenario.asks(1).on, [2]);
    let mut scenario = past_the_push(Game::TenBall);
    scenario.play(Call::Safety, hit(&[1]));
    scenario.asks(0);
}

#[test]
fn the_last_ball_is_spotted_after_a_foul_on_the_break_and_after_leaving_the_table() {
    for (game, last) in [(Game::NineBall, 9), (Game::TenBall, 10)] {
        let mut scenario = Scenario::of(game);
        let happened = hit(&[1]).potting(last, SIDE).potting(0, CORNER);
        assert_eq!(scenario.play(Call::Nothing, happened).spotted, [last]);
        assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
        let mut scenario = past_the_push(game);
        let call = if game == Game::TenBall { Call::Safety } else { Call::Nothing };
        let ruling = scenario.play(call, hit(&[1]).losing(last));
        assert_fouls(&ruling, &[Foul::BallOffTable]);
        assert_eq!(ruling.spotted, [last]);
    }
}

#[test]
fn after_a_push_out_the_other_player_may_shoot() {
    for game in [Game::NineBall, Game::TenBall] {
        let mut scenario = after_break(game);
        scenario.play(Call::PushOut, hit(&[3]).no_rail().potting(3, SIDE));
        scenario.choose(Choice::PlayOn);
        assert!(!scenario.asks(1).calls.push_out, "one push-out a rack");
        assert!(scenario.is_down(3));
    }
}

#[test]
fn the_ten_wins_only_if_called_and_not_on_the_break() {
    let mut scenario = Scenario::of(Game::TenBall);
    assert_eq!(scenario.play(Call::Nothing, hit(&[1]).potting(10, SIDE)).spotted, [10]);
    scenario.asks(0);
    let mut scenario = past_the_push(Game::TenBall).without(1..=9);
    scenario.play(Call::Safety, hit(&[10]));
    assert_eq!(scenario.asks(0).on, [10]);
    scenario.play(Call::Pocket(10, SIDE), hit(&[10]).potting(10, SIDE));
    scenario.is_won_by(0);
    let mut scenario = past_the_push(Game::TenBall);
    let ruling = scenario.play(Call::Pocket(1, SIDE), hit(&[1, 10]).potting(10, SIDE));
    assert_eq!(ruling.spotted, [10]);
    scenario.offers(0, &[Choice::PlayOn, Choice::PassBack]);
}

#[test]
fn after_a_foul_on_the_break_no_push_out_is_allowed() {
    for game in [Game::NineBall, Game::TenBall] {
        for happened in [hit(&[1]).potting(3, SIDE).losing(4), hit(&[1]).driving(&[1]), hit(&[])] {
            let mut scenario = Scenario::of(game);
            assert!(!scenario.play(Call::Nothing, happened).is_legal());
            let turn = scenario.asks(1);
            assert_eq!((turn.hand, turn.calls.push_out), (Some(Region::Anywhere), false));
        }
    }
}

#[test]
fn after_a_push_out_the_next_player_may_not_push_out() {
    let mut scenario = after_break(Game::NineBall);
    scenario.play(Call::PushOut, hit(&[]).no_rail());
    scenario.choose(Choice::PlayOn);
    scenario.play(Call::Nothing, hit(&[1]));
    assert!(!scenario.asks(0).calls.push_out);
}

#[test]
fn a_ball_driven_off_the_table_in_a_push_out_is_a_foul() {
    let mut scenario = after_break(Game::NineBall);
    let ruling = scenario.play(Call::PushOut, hit(&[2]).losing(2));
    assert_fouls(&ruling, &[Foul::BallOffTable]);
    assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
}

#[test]
fn a_third_foul_loses_even_if_the_nine_is_pocketed() {
    let mut scenario = past_the_push(Game::NineBall);
    for _ in 0..2 {
        scenario.play(Call::Nothing, hit(&[2]));
        scenario.play(Call::Nothing, hit(&[1]));
    }
    assert_eq!(scenario.play(Call::Nothing, hit(&[2]).potting(9, SIDE)).spotted, [9]);
    scenario.is_won_by(0);
}

#[test]
fn a_foul_on_the_break_is_the_first_of_three() {
    let mut scenario = Scenario::of(Game::NineBall);
    scenario.play(Call::Nothing, hit(&[1]).potting(0, SIDE));
    for _ in 0..2 {
        scenario.play(Call::Nothing, hit(&[1]));
        scenario.play(Call::Nothing, hit(&[1]).no_rail());
    }
    scenario.is_won_by(1);
}

#[test]
fn any_ball_keeps_the_turn_in_nine_ball_and_the_lowest_left_is_on() {
    let mut scenario = past_the_push(Game::NineBall);
    assert!(scenario.play(Call::Nothing, hit(&[1, 6]).potting(6, SIDE)).is_legal());
    assert_eq!(scenario.asks(1).on, [1]);
    scenario.play(Call::Nothing, hit(&[1, 2]).potting(2, SIDE).potting(1, CORNER));
    assert_eq!(scenario.asks(1).on, [3]);
}

#[test]
fn the_nine_is_spotted_behind_a_ball_on_the_foot_spot() {
    let mut scenario = past_the_push(Game::NineBall).without([1, 2, 4, 6, 7, 8]);
    let foot = [0.635, 1.905];
    scenario.0.put(3, Some(foot));
    scenario.0.put(9, Some([0.3, 1.0]));
    let ruling = scenario.play(Call::Nothing, hit(&[3]).potting(9, SIDE));
    assert_eq!(ruling.spotted, [9]);
    let diameter = 2.0 * scenario.0.base().physics().ball.radius;
    scenario.lies_at(9, [foot[0], foot[1] + diameter]);
}

#[test]
fn in_ten_ball_a_foul_takes_precedence_over_an_uncalled_ball() {
    let mut scenario = past_the_push(Game::TenBall);
    let ruling = scenario.play(Call::Pocket(1, CORNER), hit(&[2]).potting(3, SIDE));
    assert_fouls(&ruling, &[Foul::WrongBallFirst]);
    assert_eq!(scenario.asks(0).hand, Some(Region::Anywhere));
}

#[test]
fn in_ten_ball_any_ball_may_be_called_if_the_lowest_is_hit_first() {
    let mut scenario = past_the_push(Game::TenBall);
    scenario.play(Call::Pocket(4, SIDE), hit(&[1, 4]).potting(4, SIDE));
    assert_eq!(scenario.asks(1).on, [1]);
}

#[test]
fn a_last_ten_in_an_uncalled_pocket_is_spotted_and_gives_the_other_player_the_choice() {
    let mut scenario = past_the_push(Game::TenBall).without(1..=9);
    scenario.play(Call::Safety, hit(&[10]));
    let ruling = scenario.play(Call::Pocket(10, SIDE), hit(&[10]).potting(10, CORNER));
    assert_eq!(ruling.spotted, [10]);
    scenario.offers(1, &[Choice::PlayOn, Choice::PassBack]);
    scenario.choose(Choice::PassBack);
    assert_eq!(scenario.asks(0).on, [10]);
}

#[test]
fn the_ten_in_a_push_out_or_with_a_foul_is_spotted() {
    let mut scenario = after_break(Game::TenBall);
    assert_eq!(scenario.play(Call::PushOut, hit(&[10]).potting(10, SIDE)).spotted, [10]);
    scenario.offers(1, &[Choice::PlayOn, Choice::PassBack]);
    let mut scenario = past_the_push(Game::TenBall).without(1..=9);
    scenario.play(Call::Safety, hit(&[10]));
    let happened = hit(&[10]).potting(10, SIDE).potting(0, CORNER);
    assert_eq!(scenario.play(Call::Pocket(10, SIDE), happened).spotted, [10]);
    assert_eq!(scenario.asks(1).hand, Some(Region::Anywhere));
}

#[test]
fn a_cue_ball_in_hand_may_stay_where_it_lies_even_touching_another_ball() {
    let mut scenario = past_the_push(Game::NineBall);
    scenario.play(Call::Nothing, hit(&[2]));
    assert_eq!(scenario.asks(0).hand, Some(Region::Anywhere));
    let diameter = 2.0 * scenario.0.base().physics().ball.radius;
    // An overlap within the tolerance of a shot file.
    let against = [0.3 + (1.0 - 1e-12) * diameter, 1.0];
    scenario.0.put(9, Some([0.3, 1.0]));
    scenario.0.put(0, Some(against));
    let strike = Strike { speed: 1.0, azimuth: 0.0, elevation: 0.0, side: 0.0, height: 0.0 };
    assert!(scenario.0.shot(&Play::new(strike)).is_ok());
    let refused = scenario.0.shot(&Play::new(strike).from(against)).expect_err("it is put there");
    assert!(refused.to_string().starts_with("cue_ball: it would touch"));
}
