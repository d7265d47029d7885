//! The opening shot of each game.

use alloc::format;
use alloc::vec::Vec;

use super::{BreakPreset, CueBallPlace, Game, RackedBall, USUAL_GAP, rack};
use crate::edition;
use crate::error::{Error, ErrorKind};
use crate::math::{Vec2, Vec3, asin, atan2, degrees, radians, sqrt};
use crate::resolve::cue_ball::Strike;
use crate::shot::{
    Cling, DEFAULT_MAX_EVENTS, Parts, PlacedBall, Shot, StrikePolicy, checked_balls,
};
use crate::{Ball, BallState, Physics, Table};

/// The cue ball on English tables (1⅞ in; from memory, not verified).
const ENGLISH_CUE_BALL: Ball = Ball { mass: 0.094, radius: 0.023_812_5 };

/// The cue ball of `table`, if it differs from the object balls.
pub fn cue_ball_of_its_own(table: &Table) -> Option<Ball> {
    let edition = edition::find(edition::TABLES, table.name.as_deref()?)?;
    (edition.name == "english-7ft").then_some(ENGLISH_CUE_BALL)
}

/// An opening shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Break<'a> {
    /// The game.
    pub game: Game,
    /// The table preset's name; `None` stands for [`Game::table`].
    pub table: Option<&'a str>,
    /// The cue's speed, m/s; `None` stands for [`Game::break_speed`].
    pub speed: Option<f64>,
    /// Seed of the rack.
    pub seed: u64,
    /// Mean gap between the balls of the rack, m; 0 for a frozen rack.
    pub gap: f64,
    /// How players open the game; `None` strikes the cue ball in the middle, from where the rack has
    /// it. Its speed and gap are not used: [`Self::of_preset`] copies them.
    pub preset: Option<&'static BreakPreset>,
}

impl Break<'_> {
    /// The usual opening shot of `game` on its own table, with this seed.
    pub const fn new(game: Game, seed: u64) -> Self {
        Self { game, table: None, speed: None, seed, gap: USUAL_GAP, preset: None }
    }

    /// The opening shot of `preset`, with its speed and its gap.
    pub const fn of_preset(preset: &'static BreakPreset, seed: u64) -> Self {
        let (speed, gap) = (Some(preset.speed), preset.gap);
        Self { speed, gap, preset: Some(preset), ..Self::new(preset.game, seed) }
    }

    /// The opening shot of `game`, of the preset of that name if one is given.
    ///
    /// # Errors
    /// As [`BreakPreset::of`].
    pub fn named(game: Game, preset: Option<&str>, seed: u64) -> Result<Self, Error> {
        Ok(match preset {
            Some(name) => Self { game, ..Self::of_preset(BreakPreset::of(game, name)?, seed) },
            None => Self::new(game, seed),
        })
    }
}

/// The opening shot of a game: its rack, and the cue ball struck at the balls, in the middle or as the
/// preset has it.
///
/// # Errors
/// [`Error::Input`] for a table that does not exist, as [`rack`], and as [`Shot::with_balls`].
pub fn break_shot(opening: &Break<'_>) -> Result<Shot, Error> {
    let game = opening.game;
    let name = opening.table.unwrap_or(game.table());
    let unknown = || {
        let known = edition::names(edition::TABLES).join(", ");
        ErrorKind::UnknownName
            .at(
                "table",
                format!("there is no table preset \"{name}\""),
                format!("write one of {known}"),
            )
            .with("name", name)
    };
    let table = Table::shared_preset(name).ok_or_else(unknown)?;
    let physics = table.description.as_ref().and_then(|d| Physics::preset(&d.physics));
    let physics = physics.unwrap_or_else(Physics::pool);
    let mut balls = rack(game, &table, physics.ball.radius, opening.seed, opening.gap)?;
    if let Some(preset) = opening.preset {
        place_as_players(&mut balls, preset, &table, 2.0 * physics.ball.radius + opening.gap);
    }

    let (target, beside) = opening.preset.map_or(game.equipment().break_aim, |preset| preset.aim);
    let azimuth = aim(balls[0].1, balls[target].1, beside * physics.ball.radius);
    let mut placed: Vec<PlacedBall> = balls.into_iter().map(|b| place(b, physics.ball)).collect();
    if let Some(cue_ball) = cue_ball_of_its_own(&table) {
        placed[0].ball = cue_ball;
        placed[0].state.position.z = cue_ball.radius;
    }
    let strike = Strike {
        speed: opening.speed.unwrap_or(game.break_speed()),
        // A shot file has this angle in degrees, and reading it again must give the same bits.
        azimuth: radians(degrees(azimuth)),
        // Replaced by the default elevation.
        elevation: 0.0,
        side: opening.preset.map_or(0.0, |preset| preset.side),
        height: opening.preset.map_or(0.0, |preset| preset.height),
    };
    Shot::new(Parts {
        balls: checked_balls(placed, &table)?,
        table,
        physics,
        strike: Some((0, strike)),
        policy: StrikePolicy::default(),
        max_events: DEFAULT_MAX_EVENTS,
        until: None,
        cling: Cling::NONE,
        has_default_elevation: true,
    })
}

/// Moves the cue ball, and the rack if its middle ball is on the foot spot. `pitch` is the distance of
/// neighbours in the rack, m.
fn place_as_players(balls: &mut [RackedBall], preset: &BreakPreset, table: &Table, pitch: f64) {
    let cue_ball = &mut balls[0].1;
    match preset.place {
        CueBallPlace::AsRacked => {}
        CueBallPlace::LeftOfMiddle(distance) => cue_ball[0] = 0.5 * table.size.x - distance,
        CueBallPlace::FromLeftRail(distance) => cue_ball[0] = distance,
    }
    if preset.middle_on_spot {
        // The middle ball is two rows behind the apex.
        let two_rows = sqrt(3.0) * pitch;
        for (_, [_, y]) in &mut balls[1..] {
            *y -= two_rows;
        }
    }
}

fn place((id, [x, y]): RackedBall, ball: Ball) -> PlacedBall {
    let state = BallState { position: Vec3::new(x, y, ball.radius), ..BallState::default() };
    PlacedBall { id, ball, state }
}

/// Direction (rad) from `from` to the point `beside` (m) to the right of `to`.
fn aim(from: [f64; 2], to: [f64; 2], beside: f64) -> f64 {
    let way = Vec2::new(to[0] - from[0], to[1] - from[1]);
    atan2(way.y, way.x) - asin(beside / way.length())
}
