//! Opening shots as players play them. Every value has its source, and was chosen before the breaks
//! were counted (docs/breaks.md).

use alloc::format;
use alloc::vec::Vec;

use super::{Game, USUAL_GAP};
use crate::error::{Error, ErrorKind};
use crate::format::Node;
use crate::physics::Evidence;

/// Where the cue ball is on the head string. In snooker and three-cushion it is where the rack puts it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CueBallPlace {
    /// Where the rack has it: in the middle, in the D, or on the starting spot.
    AsRacked,
    /// This far to the left of the long string, m.
    LeftOfMiddle(f64),
    /// This far from the nose of the left rail to the ball's centre, m.
    FromLeftRail(f64),
}

/// An opening shot as players play it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BreakPreset {
    /// The name, unique within the game.
    pub name: &'static str,
    /// The game.
    pub game: Game,
    /// The place of the cue ball.
    pub place: CueBallPlace,
    /// The cue's speed, m/s.
    pub speed: f64,
    /// The ball aimed at, by its number in the rack, and the aim's offset to the right of its centre,
    /// ball radii.
    pub aim: (usize, f64),
    /// Tip offset to the right, ball radii.
    pub side: f64,
    /// Tip offset upwards, ball radii.
    pub height: f64,
    /// Mean gap between the balls, m.
    pub gap: f64,
    /// Whether the middle ball of the rack, not the apex, is on the foot spot.
    pub middle_on_spot: bool,
    /// Key, evidence and source of each value.
    pub sources: &'static [(&'static str, Evidence, &'static str)],
}

use Evidence::{Estimate, Measured, Specified};

/// In full breaks the cue ball has 24 mph; a cue of 20 oz gives it 1.33 of its own speed.
const FULL_SPEED: f64 = 8.0;

/// A template holds the balls in contact.
const TEMPLATE_GAP: f64 = 0.0;

/// A quarter of the width of a 13 mm tip, over the radius of a pool ball. Two thirds of the tip that
/// players count English in.
const QUARTER_WIDTH: f64 = 0.11;

/// Half the width of the box from which professionals must break: 8 in, m.
const BREAK_BOX: f64 = 0.2032;

/// "Three to four inches from the rail": 3.5 in, m.
const BESIDE_RAIL: f64 = 0.0889;

const SPEED: (&str, Evidence, &str) =
    ("speed", Measured, "Onoda 1989, video: 22 to 26 mph of the cue ball, 24 on average");
const FOLLOW: (&str, Evidence, &str) = (
    "height",
    Specified,
    "Meador: up to a quarter of the tip's width above centre; Alciatore: slight follow",
);
const ELEVATION: (&str, Evidence, &str) =
    ("elevation", Specified, "the least that clears the rail; Alciatore: slightly raised for that");
const SQUARE: (&str, Evidence, &str) =
    ("aim", Specified, "full on the first ball: Alciatore, Hall, White");
const TEMPLATE: (&str, Evidence, &str) = ("gap", Specified, "template: the balls touch");
const TRIANGLE: (&str, Evidence, &str) = ("gap", Estimate, "triangle: the thickness of paper");

const EIGHT_BALL: BreakPreset = BreakPreset {
    name: "head",
    game: Game::EightBall,
    place: CueBallPlace::AsRacked,
    speed: FULL_SPEED,
    aim: (1, 0.0),
    side: 0.0,
    height: QUARTER_WIDTH,
    gap: USUAL_GAP,
    middle_on_spot: false,
    sources: &[
        ("place", Specified, "billiardsprofessor.com/archives/431: the middle of the head string"),
        SPEED,
        SQUARE,
        FOLLOW,
        ELEVATION,
        TRIANGLE,
    ],
};

const NINE_BALL_RAIL: BreakPreset = BreakPreset {
    name: "rail",
    game: Game::NineBall,
    place: CueBallPlace::FromLeftRail(BESIDE_RAIL),
    gap: TEMPLATE_GAP,
    middle_on_spot: true,
    sources: &[
        ("place", Specified, "three to four inches from the long rail, on the head string"),
        SPEED,
        SQUARE,
        FOLLOW,
        ELEVATION,
        TEMPLATE,
        ("rack", Specified, "the 9 on the foot spot: world championship 2016"),
    ],
    ..EIGHT_BALL
};

const NINE_BALL_BOX: BreakPreset = BreakPreset {
    name: "box",
    place: CueBallPlace::LeftOfMiddle(BREAK_BOX),
    sources: &[
        ("place", Specified, "the edge of the box, 8 in beside the long string: US Open 2022"),
        SPEED,
        SQUARE,
        FOLLOW,
        ELEVATION,
        TEMPLATE,
        ("rack", Specified, "the 9 on the foot spot: US Open 2022"),
    ],
    ..NINE_BALL_RAIL
};

const NINE_BALL_TRIANGLE: BreakPreset = BreakPreset {
    name: "rail-triangle",
    gap: USUAL_GAP,
    middle_on_spot: false,
    sources: &[
        ("place", Specified, "three to four inches from the long rail, on the head string"),
        SPEED,
        SQUARE,
        FOLLOW,
        ELEVATION,
        TRIANGLE,
        ("rack", Specified, "the 1 on the foot spot: WPA rules"),
    ],
    ..NINE_BALL_RAIL
};

const TEN_BALL: BreakPreset = BreakPreset {
    name: "head",
    game: Game::TenBall,
    gap: TEMPLATE_GAP,
    sources: &[
        ("place", Estimate, "as in eight-ball; no source found"),
        SPEED,
        SQUARE,
        FOLLOW,
        ELEVATION,
        TEMPLATE,
    ],
    ..EIGHT_BALL
};

const STRAIGHT_POOL: BreakPreset = BreakPreset {
    name: "safety",
    game: Game::StraightPool,
    speed: 2.5,
    aim: (15, 1.3),
    height: 0.0,
    sources: &[
        ("place", Estimate, "the middle of the head string"),
        ("speed", Estimate, "the cue ball comes back to the head rail"),
        ("aim", Estimate, "the right back corner ball, thin"),
        ("side", Estimate, "none; no source with numbers found"),
        ELEVATION,
        TRIANGLE,
    ],
    ..EIGHT_BALL
};

const SNOOKER: BreakPreset = BreakPreset {
    name: "baulk",
    game: Game::Snooker,
    speed: 3.5,
    aim: (15, 1.5),
    side: 0.3,
    height: 0.0,
    sources: &[
        ("place", Estimate, "in the D between brown and yellow, as most players break"),
        ("speed", Estimate, "the cue ball comes back to the baulk cushion"),
        ("aim", Estimate, "a quarter of the end red, from memory"),
        ("side", Estimate, "sportsdefinitions.com: heavy side, without a number"),
        ELEVATION,
        TRIANGLE,
    ],
    ..EIGHT_BALL
};

const SIX_RED: BreakPreset = BreakPreset {
    game: Game::SixRed,
    aim: (6, 1.5),
    sources: &[
        ("place", Estimate, "as in snooker; no source found"),
        ("speed", Estimate, "as in snooker; no source found"),
        ("aim", Estimate, "a quarter of the end red, as in snooker; no source found"),
        ("side", Estimate, "as in snooker; no source found"),
        ELEVATION,
        TRIANGLE,
    ],
    ..SNOOKER
};

const THREE_CUSHION: BreakPreset = BreakPreset {
    name: "opening",
    game: Game::ThreeCushion,
    speed: 3.0,
    // 5/12 of the red, between a third and a half, on the side away from the cue ball.
    aim: (2, -7.0 / 6.0),
    side: 0.3,
    height: 0.3,
    sources: &[
        ("place", Specified, "UMB: beside the head spot"),
        ("speed", Estimate, "no source found"),
        ("aim", Specified, "basicbilliards.com: a third to a half of the far side of the red"),
        ("side", Estimate, "basicbilliards.com: high and inside, without numbers"),
        ("height", Estimate, "basicbilliards.com: high and inside, without numbers"),
        ELEVATION,
    ],
    ..EIGHT_BALL
};

const FOUR_BALL: BreakPreset = BreakPreset {
    name: "opening",
    game: Game::FourBall,
    speed: 2.5,
    aim: (3, 1.0),
    side: 0.0,
    height: 0.0,
    sources: &[
        ("place", Specified, "beside the red on the head spot: Wikipedia, Four-ball billiards"),
        ("speed", Estimate, "no source found"),
        ("aim", Estimate, "half of the red at the other end; no source found"),
        ("side", Estimate, "none; no source found"),
        ("height", Estimate, "none; no source found"),
        ELEVATION,
    ],
    ..EIGHT_BALL
};

/// Every preset as a tree of values: `game`, `name`, `place` (`as-racked`, or the key `left_of_middle`
/// or `from_left_rail` with m), `speed`, `aim_ball`, `aim_offset`, `side`, `height`, `gap`,
/// `middle_on_spot`, and `sources` (`key`, `evidence`, `source`).
pub fn break_presets() -> Node {
    Node::list(BreakPreset::ALL.iter().map(|preset| {
        let place = match preset.place {
            CueBallPlace::AsRacked => "as-racked".into(),
            CueBallPlace::LeftOfMiddle(x) => Node::object([("left_of_middle", x.into())]),
            CueBallPlace::FromLeftRail(x) => Node::object([("from_left_rail", x.into())]),
        };
        let source = |&(key, evidence, source): &(&str, Evidence, &str)| {
            Node::object([
                ("key", key.into()),
                ("evidence", evidence.name().into()),
                ("source", source.into()),
            ])
        };
        Node::object([
            ("game", preset.game.name().into()),
            ("name", preset.name.into()),
            ("place", place),
            ("speed", preset.speed.into()),
            ("aim_ball", (preset.aim.0 as u32).into()),
            ("aim_offset", preset.aim.1.into()),
            ("side", preset.side.into()),
            ("height", preset.height.into()),
            ("gap", preset.gap.into()),
            ("middle_on_spot", Node::Bool(preset.middle_on_spot)),
            ("sources", Node::list(preset.sources.iter().map(source))),
        ])
    }))
}

impl BreakPreset {
    /// Every preset, by game. The first of a game is its most usual one.
    pub const ALL: [Self; 10] = [
        EIGHT_BALL,
        NINE_BALL_RAIL,
        NINE_BALL_BOX,
        NINE_BALL_TRIANGLE,
        TEN_BALL,
        STRAIGHT_POOL,
        SNOOKER,
        THREE_CUSHION,
        FOUR_BALL,
        SIX_RED,
    ];

    /// The preset of that name.
    ///
    /// # Errors
    /// [`Error::Input`] that lists the presets of the game, if there is none.
    pub fn of(game: Game, name: &str) -> Result<&'static Self, Error> {
        static ALL: [BreakPreset; 10] = BreakPreset::ALL;
        let of_game = || ALL.iter().filter(move |preset| preset.game == game.opened_as());
        of_game().find(|preset| preset.name == name).ok_or_else(|| {
            let known: Vec<&str> = of_game().map(|preset| preset.name).collect();
            ErrorKind::UnknownName
                .at(
                    "preset",
                    format!("{} has no break preset \"{name}\"", game.name()),
                    format!("write one of {}, or leave it out", known.join(", ")),
                )
                .with("name", name)
        })
    }
}
