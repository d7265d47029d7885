//! Every rule in a scene of its own: what happened in a shot is told, not simulated.

mod eight_ball;
mod endings;
mod rotation;
mod snooker;
mod straight_pool;
mod three_cushion;

use carom::resolve::cue_ball::Strike;
use carom::table::{PocketName, Rail};

use crate::facts::Touch;
use crate::layout::distance;
use crate::{
    BallIndex, Call, Choice, Facts, Foul, Frame, Options, Play, Player, Request, Rules, Ruling,
    Turn,
};

/// A ball so near to a spot, m, is on it.
const SPOTTED: f64 = 1e-6;

const CORNER: PocketName = PocketName::TopLeft;
const SIDE: PocketName = PocketName::Right;

/// A frame in the middle of a test.
struct Scene(Frame);

impl Scene {
    fn of(rules: Rules) -> Self {
        Self::with(rules, Options::default())
    }

    fn with(rules: Rules, options: Options) -> Self {
        Self(Frame::new(rules, options, None, None, 1).expect("the game's own table"))
    }

    fn turn(&self) -> &Turn {
        self.0.turn().unwrap_or_else(|| panic!("a shot is asked, not {:?}", self.0.request()))
    }

    /// Plays a shot in which `happened` is what came of it, with the cue ball placed if it is in hand.
    fn play(&mut self, call: Call, happened: Shot) -> Ruling {
        let turn = self.turn().clone();
        let strike = Strike { speed: 1.0, azimuth: 0.0, elevation: 0.0, side: 0.0, height: 0.0 };
        let mut play = Play { strike, cue_ball: None, call };
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
        for ball in happened.0.pocketed.iter().map(|(b, _)| b).chain(&happened.0.off_table) {
            self.0.put(*ball, None);
        }
        let facts = Facts { cue: turn.cue, ..happened.0 };
        self.0.decide(&turn, &play, &facts, &before)
    }

    fn choose(&mut self, choice: Choice) -> Ruling {
        self.0.choose(choice).unwrap_or_else(|e| panic!("{e}"))
    }

    /// Takes balls off the table before a scene.
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
    fn asks(&self, player: Player) -> &Turn {
        let turn = self.turn();
        assert_eq!(turn.player, player, "another player is to shoot");
        turn
    }

    #[track_caller]
    fn offers(&self, to: Player, expected: &[Choice]) {
        let Request::Choice { player, choices, .. } = self.0.request() else {
            panic!("a choice is asked, not {:?}", self.0.request());
        };
        assert_eq!((*player, &choices[..]), (to, expected));
    }

    #[track_caller]
    fn is_won_by(&self, player: Player) {
        let Request::Over { winner, .. } = self.0.request() else {
            panic!("the frame is over, not {:?}", self.0.request());
        };
        assert_eq!(*winner, Some(player));
    }
}

/// What happened in a shot.
struct Shot(Facts);

/// The cue ball touched `balls`, in this order, then a rail.
fn hit(balls: &[BallIndex]) -> Shot {
    let balls = balls.iter().map(|ball| Touch::Ball(*ball));
    Shot(Facts {
        touched: balls.chain([Touch::Rail(Rail::Top)]).collect(),
        driven: vec![0],
        rail_after_contact: true,
        cue_reached: 10.0,
        cue_farthest: 10.0,
        ..Facts::default()
    })
}

impl Shot {
    /// Nothing was driven to a rail.
    fn no_rail(mut self) -> Self {
        self.0.driven.clear();
        self.0.touched.retain(|touch| matches!(touch, Touch::Ball(_)));
        self.0.rail_after_contact = false;
        self
    }

    fn potting(mut self, ball: BallIndex, pocket: PocketName) -> Self {
        self.0.pocketed.push((ball, pocket));
        self
    }

    fn losing(mut self, ball: BallIndex) -> Self {
        self.0.off_table.push(ball);
        self
    }

    /// These object balls, and the cue ball, were driven to a rail.
    fn driving(mut self, balls: &[BallIndex]) -> Self {
        self.0.driven = balls.to_vec();
        self.0.driven.push(0);
        self
    }

    /// The cue ball jumped over a ball before it touched one, or (`first` is false) after that.
    fn jumping(mut self, first: bool) -> Self {
        self.0.jumped = true;
        self.0.jumped_first = first;
        self
    }

    /// The cue ball never came farther up the table.
    fn staying_below(mut self, y: f64) -> Self {
        (self.0.cue_reached, self.0.cue_farthest) = (y, y);
        self
    }

    /// How far up the table the cue ball came before it touched a ball.
    fn reaching(mut self, y: f64) -> Self {
        self.0.cue_reached = y;
        self
    }

    /// Instead of what was said: balls (by number) and cushions (negative) in the order touched.
    fn touching(mut self, order: &[i32]) -> Self {
        let touch = |n: &i32| match u8::try_from(*n) {
            Ok(ball) => Touch::Ball(ball),
            Err(_) => Touch::Rail(Rail::Top),
        };
        self.0.touched = order.iter().map(touch).collect();
        self
    }
}

#[track_caller]
fn assert_fouls(ruling: &Ruling, expected: &[Foul]) {
    let fouls: Vec<Foul> = ruling.fouls.iter().collect();
    assert_eq!(fouls, expected);
}

#[test]
fn every_pool_foul_names_its_rule_and_says_what_it_is() {
    for rules in [Rules::EightBall, Rules::NineBall, Rules::TenBall, Rules::StraightPool] {
        for foul in [
            Foul::Scratch,
            Foul::CueBallOffTable,
            Foul::NoContact,
            Foul::WrongBallFirst,
            Foul::NoRailAfterContact,
            Foul::BallOffTable,
            Foul::BehindHeadString,
            Foul::SoftBreak,
        ] {
            assert!(rules.rule(foul).starts_with("WPA "), "{foul:?} in {}", rules.name());
            assert!(!foul.words().is_empty());
        }
    }
}

#[test]
fn names_of_games_and_choices_are_read_back() {
    assert!(Rules::ALL.into_iter().all(|rules| Rules::named(rules.name()) == Some(rules)));
    assert!(Choice::ALL.into_iter().all(|choice| Choice::named(choice.name()) == Some(choice)));
    assert_eq!(Rules::named("nine ball"), None);
}
