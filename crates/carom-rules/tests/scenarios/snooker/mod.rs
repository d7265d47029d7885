//! Snooker (WPBSA, section 3).

mod free_ball;

use super::{CORNER, SIDE, Scenario, assert_fouls, hit};
use crate::games::GameState;
use crate::games::snooker::{On, Snooker};
use crate::{BallIndex, Call, Choice, Foul, Frame, Game, Options, Region};

const RED: BallIndex = 1;
const YELLOW: BallIndex = 16;
const GREEN: BallIndex = 17;
const BLUE: BallIndex = 19;
const PINK: BallIndex = 20;
const BLACK: BallIndex = 21;
const NOTHING: Call = Call::Nothing;
const BLACK_SPOT: [f64; 2] = [0.889, 3.569 - 0.324];

fn game(scenario: &Scenario) -> &Snooker {
    match scenario.0.game_state() {
        GameState::Snooker(game) => game,
        other => panic!("{other:?}"),
    }
}

/// Player 0 has pocketed a red, so a colour is on.
fn after_a_red() -> Scenario {
    let mut scenario = Scenario::of(Game::Snooker);
    let ruling = scenario.play(NOTHING, hit(&[RED]).potting(RED, CORNER));
    assert_eq!(ruling.points, [1, 0]);
    assert_eq!(scenario.0.kind_on(), Some(On::Color));
    scenario.asks(0);
    scenario
}

/// Player 0 has the yellow on, with all reds down.
fn on_the_colors() -> Scenario {
    let mut scenario = after_a_red().without(2..=15);
    let ruling = scenario.play(Call::On(BLACK), hit(&[BLACK]).potting(BLACK, CORNER));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([7, 0], &[BLACK][..]));
    assert_eq!(scenario.0.kind_on(), Some(On::Sequence));
    assert_eq!(scenario.asks(0).on, [YELLOW]);
    scenario
}

#[test]
fn the_first_shot_is_played_from_the_d_at_the_reds() {
    let scenario = Scenario::of(Game::Snooker);
    assert_eq!(scenario.asks(0).hand, Some(Region::TheD));
    assert_eq!(scenario.turn().on.len(), 15);
}

#[test]
fn reds_and_colors_alternate_and_colors_are_spotted() {
    let mut scenario = after_a_red();
    assert!(scenario.turn().calls.nominate);
    let ruling = scenario.play(Call::On(PINK), hit(&[PINK]).potting(PINK, SIDE));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([6, 0], &[PINK][..]));
    assert_eq!((scenario.0.kind_on(), game(&scenario).break_points()), (Some(On::Red), 7));
    assert_eq!(scenario.asks(0).on.len(), 14);
}

#[test]
fn several_reds_in_one_stroke_count_one_each() {
    let mut scenario = Scenario::of(Game::Snooker);
    let happened = hit(&[RED]).potting(RED, CORNER).potting(5, SIDE);
    assert_eq!(scenario.play(NOTHING, happened).points, [2, 0]);
}

#[test]
fn after_the_reds_colors_are_on_in_ascending_order_and_stay_down() {
    let mut scenario = on_the_colors();
    assert_eq!(scenario.play(NOTHING, hit(&[YELLOW]).potting(YELLOW, SIDE)).points, [2, 0]);
    assert!(scenario.is_down(YELLOW));
    assert_eq!(scenario.asks(0).on, [GREEN]);
}

#[test]
fn a_miss_of_the_pot_passes_the_turn() {
    let mut scenario = after_a_red();
    assert!(scenario.play(Call::On(BLUE), hit(&[BLUE])).is_legal());
    assert_eq!((scenario.asks(1).on.len(), game(&scenario).break_points()), (14, 0));
}

#[test]
fn a_foul_costs_four_or_the_value_of_the_ball_concerned() {
    let foul = |scenario: &mut Scenario, call, happened| scenario.play(call, happened).points;
    let mut scenario = Scenario::of(Game::Snooker);
    assert_eq!(foul(&mut scenario, NOTHING, hit(&[])), [0, 4]);
    let mut scenario = Scenario::of(Game::Snooker);
    assert_eq!(foul(&mut scenario, NOTHING, hit(&[BLUE])), [0, 5]);
    let mut scenario = Scenario::of(Game::Snooker);
    assert_eq!(foul(&mut scenario, NOTHING, hit(&[RED]).potting(PINK, SIDE)), [0, 6]);
    let mut scenario = after_a_red();
    assert_eq!(
        foul(&mut scenario, Call::On(BLACK), hit(&[YELLOW])),
        [0, 7],
        "the ball on counts too"
    );
    let mut scenario = after_a_red();
    assert_eq!(foul(&mut scenario, Call::On(YELLOW), hit(&[YELLOW]).potting(2, SIDE)), [0, 4]);
    let mut scenario = Scenario::of(Game::Snooker);
    assert_eq!(foul(&mut scenario, NOTHING, hit(&[RED]).losing(BLACK)), [0, 7]);
}

#[test]
fn a_scratch_gives_the_cue_ball_in_the_d() {
    let mut scenario = Scenario::of(Game::Snooker);
    let ruling = scenario.play(NOTHING, hit(&[RED]).potting(0, SIDE));
    assert_fouls(&ruling, &[Foul::Scratch]);
    scenario.choose(Choice::PlayOn);
    assert_eq!(scenario.asks(1).hand, Some(Region::TheD));
}

#[test]
fn a_jump_over_a_ball_is_a_foul() {
    let mut scenario = Scenario::of(Game::Snooker);
    assert_fouls(&scenario.play(NOTHING, hit(&[RED]).jumping(true)), &[Foul::Jump]);
    let mut scenario = Scenario::of(Game::Snooker);
    assert!(
        scenario.play(NOTHING, hit(&[RED]).jumping(false)).is_legal(),
        "after a contact it is not a foul"
    );
}

#[test]
fn a_red_pocketed_with_a_foul_stays_down_and_a_color_is_spotted() {
    let mut scenario = after_a_red();
    let happened = hit(&[BLUE]).potting(2, SIDE).potting(BLUE, SIDE);
    let ruling = scenario.play(Call::On(BLUE), happened);
    assert_fouls(&ruling, &[Foul::WrongBallPocketed]);
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 5], &[BLUE][..]));
    assert!(scenario.is_down(2));
}

#[test]
fn after_a_foul_and_a_miss_the_balls_may_be_replaced() {
    let mut scenario = after_a_red();
    let before = scenario.0.layout().clone();
    scenario.play(Call::On(BLUE), hit(&[2]).potting(2, SIDE));
    scenario.offers(1, &[Choice::PlayOn, Choice::PassBack, Choice::Replace]);
    scenario.choose(Choice::Replace);
    assert_eq!(*scenario.0.layout(), before);
    assert_eq!(scenario.0.kind_on(), Some(On::Color));
    assert!(scenario.asks(0).calls.nominate);
    assert_eq!(scenario.0.scores(), [1, 5], "the points are kept");
}

#[test]
fn no_miss_is_called_when_the_ball_on_was_hit_first() {
    let mut scenario = Scenario::of(Game::Snooker);
    scenario.play(NOTHING, hit(&[RED]).potting(0, SIDE));
    scenario.offers(1, &[Choice::PlayOn, Choice::PassBack]);
}

/// Whether a foul of player 0 that hits no ball on is called a miss at these scores.
fn is_miss_at(scores: [i32; 2], options: Options) -> bool {
    let mut scenario = Scenario::with(Game::Snooker, options).without(2..=15);
    scenario.0.set_scores(scores);
    scenario.play(NOTHING, hit(&[]));
    match scenario.0.request() {
        crate::Request::Choice { choices, .. } => choices.contains(&Choice::Replace),
        other => panic!("{other:?}"),
    }
}

#[test]
fn no_miss_is_called_when_a_player_needs_penalty_points_or_could_only_tie() {
    // The red and the colours left are worth 35 points.
    let game = Options::default();
    assert!(is_miss_at([0, 0], game));
    assert!(is_miss_at([0, 30], game), "34 behind after the foul");
    assert!(!is_miss_at([0, 31], game), "35 behind after the foul");
    assert!(!is_miss_at([0, 36], game), "36 behind before it");
    assert!(is_miss_at([34, 0], game));
    assert!(!is_miss_at([35, 0], game), "the other player could tie");
    assert!(!is_miss_at([0, 0], Options { miss: false, ..game }), "the option excludes misses");
}

#[test]
fn after_a_miss_with_a_full_ball_in_sight_the_next_miss_is_called_at_any_score() {
    let mut scenario = Scenario::of(Game::Snooker).without(2..=15);
    scenario.0.put(RED, Some([0.5, 2.4]));
    scenario.0.set_scores([0, 30]);
    for _ in 0..2 {
        scenario.play(NOTHING, hit(&[]));
        scenario.choose(Choice::Replace);
        assert_eq!(scenario.asks(0).hand, None, "it is where it was played from");
    }
    assert_eq!(scenario.0.scores(), [0, 38]);
    scenario.play(NOTHING, hit(&[]));
    scenario.is_won_by(1);
}

#[test]
fn the_count_of_misses_restarts_when_the_balls_are_not_replaced() {
    let mut scenario = Scenario::of(Game::Snooker);
    for choice in [Choice::Replace, Choice::PassBack, Choice::Replace, Choice::Replace] {
        scenario.play(NOTHING, hit(&[BLACK]));
        scenario.choose(choice);
        scenario.asks(0);
    }
    scenario.play(NOTHING, hit(&[BLACK]));
    scenario.is_won_by(1);
}

#[test]
fn misses_without_a_full_ball_in_sight_never_lose_the_frame() {
    let mut scenario = snookered();
    scenario.choose(Choice::PassBack);
    for _ in 0..4 {
        scenario.play(NOTHING, hit(&[YELLOW]));
        scenario.choose(Choice::Replace);
    }
    scenario.asks(1);
}

#[test]
fn points_left_are_a_black_with_every_red_and_the_colors() {
    let left = |scenario: &Scenario| match scenario.0.game_state_node().get("points_left") {
        Some(carom::format::Node::Integer(points)) => *points,
        other => panic!("{other:?}"),
    };
    assert_eq!(left(&Scenario::of(Game::Snooker)), 147);
    assert_eq!(left(&after_a_red()), 146);
    assert_eq!(left(&on_the_colors()), 27);
}

#[test]
fn three_misses_in_a_row_with_a_ball_in_sight_lose_the_frame() {
    let mut scenario = Scenario::of(Game::Snooker);
    for _ in 0..2 {
        scenario.play(NOTHING, hit(&[BLACK]));
        scenario.choose(Choice::Replace);
    }
    scenario.play(NOTHING, hit(&[BLACK]));
    scenario.is_won_by(1);
}

/// Player 0 is snookered after a foul: the blue is between the cue ball and the only red.
fn snookered() -> Scenario {
    let mut scenario = Scenario::of(Game::Snooker).without(2..=15);
    scenario.play(NOTHING, hit(&[RED]));
    scenario.0.put(0, Some([0.889, 0.9]));
    scenario.0.put(BLUE, Some([0.889, 1.0]));
    scenario.0.put(RED, Some([0.889, 2.4]));
    scenario.play(NOTHING, hit(&[YELLOW]));
    scenario
}

#[test]
fn a_color_whose_spot_is_occupied_goes_to_the_highest_free_spot() {
    let mut scenario = after_a_red();
    let blue = scenario.0.layout().place(BLUE);
    scenario.0.put(BLUE, Some([1.4, 1.2]));
    scenario.0.put(2, blue);
    scenario.0.put(BLACK, Some([0.3, 1.2]));
    let ruling = scenario.play(Call::On(BLUE), hit(&[BLUE]).potting(BLUE, SIDE));
    assert_eq!(ruling.spotted, [BLUE]);
    scenario.lies_at(BLUE, BLACK_SPOT);
}

#[test]
fn colors_go_to_their_own_spots_first_and_then_the_highest_to_the_highest_free_spot() {
    let mut scenario = after_a_red();
    let own = scenario.0.layout().clone();
    // A red is on the black's spot; the highest free spot is the pink's, unless the pink takes it.
    scenario.0.put(BLACK, Some([0.3, 1.2]));
    scenario.0.put(2, Some(BLACK_SPOT));
    let happened = hit(&[BLACK]).potting(BLACK, SIDE).potting(PINK, SIDE).potting(GREEN, SIDE);
    let ruling = scenario.play(Call::On(BLACK), happened);
    assert_fouls(&ruling, &[Foul::WrongBallPocketed]);
    assert_eq!(ruling.points, [0, 7]);
    for ball in [PINK, GREEN] {
        assert_eq!(scenario.0.layout().place(ball), own.place(ball));
    }
    let lies = scenario.0.layout().place(BLACK).expect("it is spotted");
    assert!(
        lies[0] == BLACK_SPOT[0] && lies[1] > BLACK_SPOT[1],
        "all spots are occupied: {lies:?}"
    );
    let gap = lies[1] - BLACK_SPOT[1] - 2.0 * scenario.0.base().physics().ball.radius;
    assert!(gap > 0.0 && gap < 1e-3, "near its own, touching no ball: {gap}");
}

#[test]
fn a_color_without_room_above_its_spot_goes_below_it() {
    let mut scenario = after_a_red();
    let diameter = 2.0 * scenario.0.base().physics().ball.radius;
    scenario.0.put(BLACK, Some([0.3, 1.2]));
    for (ball, up) in [(2, 0.0), (3, 1.1), (4, 2.2), (5, 3.3), (6, 4.4), (7, 5.4)] {
        scenario.0.put(ball, Some([BLACK_SPOT[0], BLACK_SPOT[1] + up * diameter]));
    }
    scenario.play(Call::On(BLACK), hit(&[BLACK]).potting(BLACK, SIDE));
    let lies = scenario.0.layout().place(BLACK).expect("it is spotted");
    assert!(lies[0] == BLACK_SPOT[0] && lies[1] < BLACK_SPOT[1], "{lies:?}");
}

#[test]
fn colors_off_the_table_are_spotted_and_the_cue_ball_is_in_hand_in_the_d() {
    let mut scenario = Scenario::of(Game::Snooker);
    let own = scenario.0.layout().place(BLUE);
    let ruling = scenario.play(NOTHING, hit(&[RED]).losing(RED).losing(BLUE).losing(0));
    assert_fouls(&ruling, &[Foul::CueBallOffTable, Foul::BallOffTable]);
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 5], &[BLUE][..]));
    assert!(scenario.is_down(RED));
    assert_eq!(scenario.0.layout().place(BLUE), own);
    scenario.choose(Choice::PassBack);
    assert_eq!(
        scenario.asks(0).hand,
        Some(Region::TheD),
        "a player asked to play again plays from the D"
    );
}

/// The cue ball touches `ball`: the gap is a hair, as when balls come to rest. A red is elsewhere.
fn touching(ball: BallIndex) -> Scenario {
    let mut scenario = Scenario::of(Game::Snooker);
    scenario.play(NOTHING, hit(&[RED]));
    let diameter = 2.0 * scenario.0.base().physics().ball.radius;
    scenario.0.put(0, Some([0.5, 1.0]));
    scenario.0.put(ball, Some([0.5 + diameter + 5e-5, 1.0]));
    scenario
}

#[test]
fn playing_away_from_a_touching_ball_that_is_on_counts_as_hitting_it() {
    assert!(touching(2).play(NOTHING, hit(&[]).touching(&[-1])).is_legal());
    assert!(
        touching(2).play(NOTHING, hit(&[]).touching(&[-1, 19])).is_legal(),
        "any ball may be hit next"
    );
    assert!(touching(2).play(NOTHING, hit(&[]).touching(&[-1, 2])).is_legal());
}

#[test]
fn moving_a_touching_ball_is_a_push() {
    let ruling = touching(2).play(NOTHING, hit(&[2]));
    assert_fouls(&ruling, &[Foul::Push]);
    assert_eq!(ruling.points, [4, 0]);
    let ruling = touching(PINK).play(NOTHING, hit(&[PINK]));
    assert_fouls(&ruling, &[Foul::WrongBallFirst, Foul::Push]);
    assert_eq!(ruling.points, [6, 0]);
}

#[test]
fn playing_away_from_a_touching_ball_that_is_not_on_must_hit_a_ball_on() {
    assert!(touching(BLUE).play(NOTHING, hit(&[3])).is_legal());
    assert_fouls(&touching(BLUE).play(NOTHING, hit(&[])), &[Foul::NoContact]);
}

/// Only the black is left; player 0 shoots and has `lead` points more than the other.
fn black_ball(lead: i32) -> Scenario {
    let mut scenario = on_the_colors().without(YELLOW..PINK);
    scenario.0.set_scores([20 + lead - 6, 20]);
    scenario.play(NOTHING, hit(&[PINK]).potting(PINK, SIDE));
    assert_eq!(scenario.asks(0).on, [BLACK]);
    scenario
}

#[test]
fn with_only_the_black_left_the_first_score_or_foul_ends_the_frame() {
    let mut scenario = black_ball(-3);
    scenario.play(NOTHING, hit(&[BLACK]).potting(BLACK, SIDE));
    scenario.is_won_by(0);
    let mut scenario = black_ball(3);
    scenario.play(NOTHING, hit(&[]));
    scenario.is_won_by(1);
}

#[test]
fn a_tie_is_decided_by_a_respotted_black() {
    let mut scenario = black_ball(-7);
    scenario.play(NOTHING, hit(&[BLACK]).potting(BLACK, SIDE));
    assert_eq!(scenario.0.scores(), [20, 20]);
    scenario.lies_at(BLACK, BLACK_SPOT);
    let lot = scenario.0.player().expect("a player drawn by lot chooses");
    scenario.offers(lot, &[Choice::PlayOn, Choice::PassBack]);
    for (choice, player) in [(Choice::PlayOn, lot), (Choice::PassBack, 1 - lot)] {
        let mut chosen = Scenario(scenario.0.clone());
        chosen.choose(choice);
        let turn = chosen.asks(player);
        assert_eq!((turn.hand, &turn.on[..]), (Some(Region::TheD), &[BLACK][..]));
        let mut fouled = Scenario(chosen.0.clone());
        chosen.play(NOTHING, hit(&[BLACK]));
        chosen.asks(1 - player);
        chosen.play(NOTHING, hit(&[BLACK]).potting(BLACK, SIDE));
        chosen.is_won_by(1 - player);
        fouled.play(NOTHING, hit(&[]));
        fouled.is_won_by(1 - player);
    }
}

#[test]
fn after_the_color_that_follows_the_last_red_the_yellow_is_on() {
    let mut scenario = Scenario::of(Game::Snooker).without(2..=15);
    scenario.play(NOTHING, hit(&[RED]).potting(RED, SIDE));
    assert_eq!(scenario.turn().on.len(), 6, "any colour");
    assert!(scenario.play(Call::On(GREEN), hit(&[GREEN])).is_legal());
    assert_eq!(scenario.asks(1).on, [YELLOW]);
    let mut scenario = Scenario::of(Game::Snooker).without(2..=15);
    scenario.play(NOTHING, hit(&[RED]).potting(RED, SIDE));
    let ruling = scenario.play(Call::On(GREEN), hit(&[GREEN]).potting(GREEN, SIDE));
    assert_eq!((ruling.points, &ruling.spotted[..]), ([3, 0], &[GREEN][..]));
    assert_eq!(scenario.asks(0).on, [YELLOW]);
}

#[test]
fn the_last_red_with_a_foul_leaves_the_yellow_on() {
    let mut scenario = Scenario::of(Game::Snooker).without(2..=15);
    let ruling = scenario.play(NOTHING, hit(&[RED]).potting(RED, SIDE).potting(0, CORNER));
    assert_eq!(ruling.points, [0, 4], "the red does not count");
    scenario.choose(Choice::PlayOn);
    assert_eq!(scenario.asks(1).on, [YELLOW]);
}

#[test]
fn only_the_highest_penalty_of_several_fouls_is_paid() {
    let paid = |happened| Scenario::of(Game::Snooker).play(NOTHING, happened).points;
    assert_eq!(paid(hit(&[BLUE]).potting(PINK, SIDE).potting(0, CORNER)), [0, 6]);
    assert_eq!(paid(hit(&[YELLOW]).potting(GREEN, SIDE)), [0, 4]);
    assert_eq!(paid(hit(&[RED]).potting(RED, SIDE).potting(BLACK, CORNER).losing(BLUE)), [0, 7]);
    let mut scenario = after_a_red();
    assert_eq!(scenario.play(Call::On(PINK), hit(&[])).points, [0, 6], "the color nominated");
    let mut scenario = after_a_red();
    let ruling = scenario.play(Call::On(BLACK), hit(&[2]).potting(0, SIDE));
    assert_fouls(&ruling, &[Foul::Scratch, Foul::WrongBallFirst]);
    assert_eq!(ruling.points, [0, 7]);
}

#[test]
fn pocketing_the_next_color_too_is_a_foul_and_both_are_spotted() {
    let mut scenario = on_the_colors();
    scenario.0.put(0, Some([1.5, 0.5]));
    let happened = hit(&[YELLOW]).potting(YELLOW, SIDE).potting(GREEN, CORNER);
    let ruling = scenario.play(NOTHING, happened);
    assert_fouls(&ruling, &[Foul::WrongBallPocketed]);
    assert_eq!((ruling.points, &ruling.spotted[..]), ([0, 4], &[YELLOW, GREEN][..]));
    scenario.choose(Choice::PlayOn);
    assert_eq!(scenario.asks(1).on, [YELLOW]);
}

#[test]
fn after_a_foul_on_a_color_the_reds_are_on_for_a_player_asked_to_play_again() {
    let mut scenario = after_a_red();
    scenario.play(Call::On(BLUE), hit(&[BLUE]).potting(0, SIDE));
    scenario.choose(Choice::PassBack);
    let turn = scenario.asks(0);
    assert_eq!((turn.hand, turn.on.len(), turn.calls.nominate), (Some(Region::TheD), 14, false));
}

#[test]
fn after_a_miss_a_cue_ball_from_hand_is_replaced_where_it_was_played_from() {
    let mut scenario = Scenario::of(Game::Snooker);
    scenario.play(NOTHING, hit(&[BLACK]));
    scenario.choose(Choice::Replace);
    let turn = scenario.asks(0);
    assert_eq!(turn.hand, None);
    assert!(!scenario.is_down(0) && turn.on.len() == 15);
}

#[test]
fn with_all_spots_occupied_colors_line_up_above_their_own_spots_the_highest_first() {
    let mut scenario = after_a_red();
    let table = scenario.0.layout().clone();
    let colors = [YELLOW, GREEN, 18, BLUE, PINK, BLACK];
    for (red, color) in (2..).zip(colors) {
        scenario.0.put(red, table.place(color));
        scenario.0.put(color, Some([0.2 + 0.1 * f64::from(red), 1.2]));
    }
    let happened = hit(&[PINK]).potting(PINK, SIDE).potting(BLUE, SIDE);
    let ruling = scenario.play(Call::On(PINK), happened);
    assert_eq!((ruling.points, ruling.fouls.has(Foul::WrongBallPocketed)), ([0, 6], true));
    for color in [BLUE, PINK] {
        let (spot, lies) = (table.place(color), scenario.0.layout().place(color));
        let (spot, lies) = (spot.expect("a spot"), lies.expect("it is spotted"));
        assert!(lies[0] == spot[0] && lies[1] > spot[1], "{color}: {lies:?}");
        assert!(scenario.0.layout().is_free(color, lies), "it touches nothing");
    }
}

#[test]
fn a_cue_ball_in_the_d_does_not_occupy_a_spot() {
    let mut scenario = on_the_colors();
    scenario.0.put(0, Some([0.889, 1.0]));
    let own = scenario.0.layout().place(YELLOW);
    let ruling = scenario.play(NOTHING, hit(&[GREEN]).potting(YELLOW, SIDE).potting(0, CORNER));
    assert_eq!(ruling.spotted, [YELLOW]);
    assert_eq!(scenario.0.layout().place(YELLOW), own);
}

#[test]
fn pocketing_the_last_black_and_the_cue_ball_costs_seven_and_ends_the_frame() {
    let mut scenario = black_ball(7);
    let ruling = scenario.play(NOTHING, hit(&[BLACK]).potting(BLACK, SIDE).potting(0, CORNER));
    assert_eq!(ruling.points, [0, 7]);
    assert!(matches!(scenario.0.request(), crate::Request::Choice { .. }), "the scores are equal");
    let mut scenario = black_ball(6);
    scenario.play(NOTHING, hit(&[BLACK]).potting(BLACK, SIDE).potting(0, CORNER));
    scenario.is_won_by(1);
}

#[test]
fn a_legal_shot_at_the_last_black_without_a_score_does_not_end_the_frame() {
    let mut scenario = black_ball(30);
    scenario.play(NOTHING, hit(&[BLACK]));
    assert_eq!(scenario.asks(1).on, [BLACK]);
}

#[test]
fn playing_away_from_a_touching_color_hits_it_only_if_it_is_nominated() {
    let nominating = |color, order: &[i32]| {
        let mut scenario = after_a_red();
        let diameter = 2.0 * scenario.0.base().physics().ball.radius;
        scenario.0.put(0, Some([0.5, 1.0]));
        scenario.0.put(BLUE, Some([0.5 + diameter, 1.0]));
        scenario.play(Call::On(color), hit(&[]).touching(order))
    };
    assert!(nominating(BLUE, &[-1]).is_legal());
    assert!(nominating(PINK, &[20]).is_legal());
    let ruling = nominating(PINK, &[-1]);
    assert_fouls(&ruling, &[Foul::NoContact]);
    assert_eq!(ruling.points, [0, 6]);
    assert_fouls(&nominating(PINK, &[19, 20]), &[Foul::WrongBallFirst, Foul::Push]);
}

fn on(table: &str) -> Result<Frame, carom::Error> {
    Frame::new(Game::Snooker, Options::default(), Some(table.into()), None, 1)
}

#[test]
fn a_rack_that_does_not_fit_on_the_table_is_refused() {
    let refused = on("bar-7ft").expect_err("the black would stand among the reds").to_string();
    assert!(refused.starts_with("table: snooker has a rack that does not fit"), "{refused}");
}

#[test]
fn colors_are_spotted_where_they_were_racked_on_every_table_with_pockets() {
    for table in ["wpa-9ft", "english-7ft", "snooker-12ft", "poolfiz"] {
        let begun = Scenario(on(table).unwrap_or_else(|e| panic!("{table}: {e}")));
        let own = begun.0.layout().clone();
        for color in YELLOW..=BLACK {
            let mut scenario = Scenario(begun.0.clone());
            scenario.play(NOTHING, hit(&[RED]).potting(RED, CORNER));
            scenario.play(Call::On(color), hit(&[color]).potting(color, SIDE));
            assert_eq!(scenario.0.layout().place(color), own.place(color), "{color} on {table}");
        }
        let brown = own.place(18).expect("it stands on its spot");
        let radius = begun.0.base().physics().ball.radius;
        let behind = [brown[0], brown[1] - 3.0 * radius];
        let (turn, on) = (begun.asks(0), begun.0.base().table());
        let region = turn.hand.expect("the first shot is from the D");
        assert!(region.holds(on, behind) && !region.holds(on, [brown[0], brown[1] + radius]));
    }
}
