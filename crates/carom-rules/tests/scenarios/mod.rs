//! Tests of the rules, one scenario for each. The shots are written by hand, not simulated.

mod chinese_eight_ball;
mod eight_ball;
mod endings;
mod four_ball;
mod near_balls;
mod rotation;
mod six_red;
mod snooker;
mod straight_pool;
mod straight_rail;
mod three_cushion;

use carom::outcome::{Outcome, Touched};
use carom::resolve::cue_ball::Strike;
use carom::table::{PocketName, Rail};

use crate::markings::distance;
use crate::referee::{CueBallTravel, NearHit};
use crate::{
    BallIndex, Call, Choice, Foul, Frame, Game, Options, Play, Request, Ruling, Seat, Turn,
};

/// A ball within this distance of a spot is on it, m.
const SPOTTED: f64 = 1e-6;

const CORNER: PocketName = PocketName::TopLeft;
const SIDE: PocketName = PocketName::Right;

/// A frame in the middle of a test.
struct Scenario(Frame);

impl Scenario {
    fn of(game: Game) -> Self {
        Self::with(game, Options::default())
    }

    fn with(game: Game, options: Options) -> Self {
        Self(Frame::new(game, options, None, None, 1).expect("the game's own table"))
    }

    fn turn(&self) -> &Turn {
        let request = self.0.request();
        self.0.turn().unwrap_or_else(|| panic!("the frame asks for {request:?}, not for a shot"))
    }

    /// Plays a shot with the outcome `shot`. A cue ball in hand is placed where there is room.
    fn play(&mut self, call: Call, shot: DescribedShot) -> Ruling {
        let turn = *self.turn();
        let strike = Strike { speed: 1.0, azimuth: 0.0, elevation: 0.0, side: 0.0, height: 0.0 };
        let mut play = Play { call, ..Play::new(strike) };
        if let Some(region) = turn.hand {
            let (table, layout) = (self.0.base().table(), self.0.layout());
            let free =
                |place: &[f64; 2]| region.holds(table, *place) && layout.is_free(turn.cue, *place);
            let places = (1..400).map(|k| {
                let (row, column) = (f64::from(k / 20), f64::from(k % 20));
                [table.size.x * (column + 0.5) / 20.0, table.size.y * (row + 0.5) / 20.0]
            });
            play.cue_ball = places.into_iter().find(free);
        }
        self.0.shot(&play).unwrap_or_else(|e| panic!("{e}"));
        self.0.put(turn.cue, play.cue_ball.or(self.0.layout().place(turn.cue)));
        let before = self.0.layout().clone();
        let DescribedShot { mut outcome, travel } = shot;
        for ball in outcome.pocketed.iter().map(|(b, _)| b).chain(&outcome.off_table) {
            self.0.put(*ball, None);
        }
        outcome.cue_ball = Some(turn.cue);
        self.0.decide(&turn, play.call, &outcome, &travel, &before)
    }

    fn choose(&mut self, choice: Choice) -> Ruling {
        self.0.choose(choice).unwrap_or_else(|e| panic!("{e}"))
    }

    /// The same scenario with `balls` taken off the table.
    fn without(mut self, balls: impl IntoIterator<Item = BallIndex>) -> Self {
        for ball in balls {
            self.0.put(ball, None);
        }
        self
    }

    #[track_caller]
    fn lies_at(&self, ball: BallIndex, expected: [f64; 2]) {
        let place = self.0.layout().place(ball).expect("it is on the table");
        let off = distance(place, expected);
        assert!(off < SPOTTED, "{ball} lies at {place:?}, {off} m from {expected:?}");
    }

    fn is_down(&self, ball: BallIndex) -> bool {
        self.0.layout().is_down(ball)
    }

    #[track_caller]
    fn asks(&self, seat: Seat) -> &Turn {
        let turn = self.turn();
        assert_eq!(turn.player, seat, "the other player shoots");
        assert_eq!([0, 1].map(|one| self.0.keeps_turn(one)), [seat == 0, seat == 1]);
        turn
    }

    #[track_caller]
    fn offers(&self, to: Seat, expected: &[Choice]) {
        let Request::Choice { player, choices, .. } = self.0.request() else {
            panic!("the frame asks for {:?}, not for a choice", self.0.request());
        };
        assert_eq!((*player, &choices[..]), (to, expected));
    }

    #[track_caller]
    fn is_won_by(&self, seat: Seat) {
        let Request::Over { winner, .. } = self.0.request() else {
            panic!("the frame asks for {:?}, but should be over", self.0.request());
        };
        assert_eq!(*winner, Some(seat));
        assert_eq!([0, 1].map(|one| self.0.keeps_turn(one)), [seat == 0, seat == 1]);
    }
}

/// The outcome of a shot, written by hand. Balls are indices of the frame.
struct DescribedShot {
    outcome: Outcome,
    travel: CueBallTravel,
}

/// The cue ball touched `balls`, in this order, then a rail.
fn hit(balls: &[BallIndex]) -> DescribedShot {
    let touched = balls.iter().map(|ball| Touched::Ball(*ball));
    DescribedShot {
        outcome: Outcome {
            first_contact: balls.first().copied(),
            cue_ball_touched: touched.chain([Touched::Rail(Rail::Top)]).collect(),
            driven_to_rail: vec![0],
            rails_after_first_contact: vec![(0, Rail::Top)],
            ..Outcome::default()
        },
        travel: CueBallTravel {
            jumped_before_contact: false,
            reached_before_contact: 10.0,
            reached: 10.0,
            near_hit: NearHit::Nothing,
        },
    }
}

impl DescribedShot {
    /// No ball was driven to a rail.
    fn no_rail(mut self) -> Self {
        self.outcome.driven_to_rail.clear();
        self.outcome.rails_after_first_contact.clear();
        self.outcome.cue_ball_touched.retain(|touched| matches!(touched, Touched::Ball(_)));
        self
    }

    fn potting(mut self, ball: BallIndex, pocket: PocketName) -> Self {
        self.outcome.pocketed.push((ball, pocket));
        self
    }

    fn losing(mut self, ball: BallIndex) -> Self {
        self.outcome.off_table.push(ball);
        self
    }

    /// These object balls and the cue ball were driven to a rail.
    fn driving(mut self, balls: &[BallIndex]) -> Self {
        self.outcome.driven_to_rail = balls.to_vec();
        self.outcome.driven_to_rail.push(0);
        self
    }

    /// The cue ball jumped over a ball: before its first contact, or later.
    fn jumping(mut self, before_contact: bool) -> Self {
        self.travel.jumped_before_contact = before_contact;
        self
    }

    /// The cue ball's centre never came farther up the table than `y`.
    fn staying_below(mut self, y: f64) -> Self {
        (self.travel.reached_before_contact, self.travel.reached) = (y, y);
        self
    }

    /// The cue ball's centre came up to `y` before its first contact.
    fn reaching(mut self, y: f64) -> Self {
        self.travel.reached_before_contact = y;
        self
    }

    /// The tip met the cue ball `contacts` times. The cue ball met `ball` while the tip was on it;
    /// `hit` tells how full, if the ball was not frozen to the cue ball.
    fn meeting(mut self, ball: BallIndex, contacts: u8, hit: NearHit) -> Self {
        self.outcome.met_during_strike = vec![ball];
        self.outcome.tip_contacts = contacts;
        self.outcome.pushed = hit != NearHit::Nothing;
        self.travel.near_hit = hit;
        self
    }

    /// The cue ball touched balls (by index) and cushions (negative) in this order, instead of the
    /// order given before.
    fn touching(mut self, order: &[i32]) -> Self {
        let touched = |n: &i32| match BallIndex::try_from(*n) {
            Ok(ball) => Touched::Ball(ball),
            Err(_) => Touched::Rail(Rail::Top),
        };
        self.outcome.first_contact = order.iter().find_map(|n| BallIndex::try_from(*n).ok());
        self.outcome.cue_ball_touched = order.iter().map(touched).collect();
        self
    }
}

#[track_caller]
fn assert_fouls(ruling: &Ruling, expected: &[Foul]) {
    let fouls: Vec<Foul> = ruling.fouls.iter().collect();
    assert_eq!(fouls, expected);
}

#[test]
fn every_pool_foul_has_a_rule_number_and_a_description() {
    for game in [Game::EightBall, Game::NineBall, Game::TenBall, Game::StraightPool] {
        for foul in [
            Foul::Scratch,
            Foul::CueBallOffTable,
            Foul::NoContact,
            Foul::WrongBallFirst,
            Foul::NoRailAfterContact,
            Foul::BallOffTable,
            Foul::BehindHeadString,
            Foul::SoftBreak,
            Foul::DoubleHit,
            Foul::PushShot,
        ] {
            assert!(
                crate::GameFacts::of(game).rule(foul).starts_with("WPA "),
                "{foul:?} in {}",
                game.name()
            );
            assert!(!foul.words().is_empty());
        }
    }
}

#[test]
fn every_rack_has_the_balls_of_its_games_facts() {
    for game in Game::ALL {
        let (frame, facts) = (Scenario::of(game).0, crate::GameFacts::of(game));
        assert_eq!(frame.layout().len(), facts.balls, "{}", game.name());
        if let Some(start) = facts.random_start {
            let racked = start.racked.map_or(0, |[first, last]| usize::from(last - first) + 1);
            let most = start.count[1] + racked + 1;
            assert_eq!(most, facts.balls, "{}: all balls can be on the table", game.name());
        }
    }
}

#[test]
fn names_of_games_and_choices_are_read_back() {
    assert!(Game::ALL.into_iter().all(|game| Game::named(game.name()) == Some(game)));
    assert!(Choice::ALL.into_iter().all(|choice| Choice::named(choice.name()) == Some(choice)));
    assert_eq!(Game::named("nine ball"), None);
}
