//! An opening shot in the terms of a player.

use carom::math::{Vec2, asin, atan2, sqrt};
use carom::resolve::cue_ball::Strike;
use carom::{Error, ErrorKind, Table};
use carom_rules::{Frame, Play, Region, Turn};

use crate::scene::{Scene, SceneBall};
use crate::targets::{Targets, call_of};
use carom_plan::Prepared;

/// Distance that the cue ball keeps from the lines of its region and from the rails, m: rounding
/// must not move it over a line.
const SPARE: f64 = 1e-6;

/// Places of the cue ball across its region that [`BreakShot::usual`] tries, the first one first.
const BESIDE: [f64; 4] = [0.0, 0.25, 0.5, 1.0];

/// An opening shot: the place of the cue ball, the hit of the first ball, and the stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BreakShot {
    /// The place of a cue ball in hand across its region: −1 at the left end, 0 in the middle, 1 at
    /// the right end. Not used if the cue ball is not in hand.
    pub across: f64,
    /// The place of a cue ball in hand along the table: 0 at the line that bounds the region, 1 at
    /// its other end. Not used if the cue ball is not in hand.
    pub behind: f64,
    /// How far to the right of the first ball's centre the line of aim passes, in ball radii; 0 is
    /// a full hit. The first ball is the one of the balls on that is nearest to the middle of the
    /// region's line: the apex of a rack, and in carom games a red.
    pub aim: f64,
    /// Speed of the cue, m/s.
    pub speed: f64,
    /// Tip offset to the right, ball radii.
    pub side: f64,
    /// Tip offset upwards, ball radii.
    pub height: f64,
}

impl BreakShot {
    /// A full hit from the middle of the region's line at `speed` (m/s), without side and height.
    pub const fn center(speed: f64) -> Self {
        Self { across: 0.0, behind: 0.0, aim: 0.0, speed, side: 0.0, height: 0.0 }
    }

    /// The usual opening shot of `frame`: [`Self::center`] at the game's speed, or beside a ball that
    /// stands in the middle, as the brown does in the D of snooker.
    pub fn usual(frame: &Frame) -> Self {
        let center = Self::center(frame.game().break_speed());
        let beside = BESIDE.map(|across| Self { across, ..center });
        let can_be_played = |shot: &Self| shot.play(frame).is_ok();
        beside.into_iter().find(can_be_played).unwrap_or(center)
    }

    /// The same shot seen in a mirror along the table.
    #[must_use]
    pub const fn mirrored(&self) -> Self {
        Self { across: -self.across, aim: -self.aim, side: -self.side, ..*self }
    }

    /// Rejects numbers out of range.
    ///
    /// # Errors
    /// [`Error::Input`] at the name of the number.
    pub fn check(&self) -> Result<(), Error> {
        for (name, value, [low, high]) in [
            ("across", self.across, [-1.0, 1.0]),
            ("behind", self.behind, [0.0, 1.0]),
            ("aim", self.aim, [-50.0, 50.0]),
        ] {
            if !(low..=high).contains(&value) {
                let what = format!("{value:?} is out of range");
                return Err(ErrorKind::OutOfRange.at(name, what, format!("write {low} to {high}")));
            }
        }
        Ok(())
    }

    /// Where the shot puts the cue ball of `turn`, a shot of `frame`; none if it is not in hand.
    /// File coordinates, m.
    pub fn cue_ball(&self, frame: &Frame, turn: &Turn) -> Option<[f64; 2]> {
        let region = turn.hand?;
        let table = frame.base().table();
        let radius = frame.layout().balls()[usize::from(turn.cue)].ball.radius;
        Some(place_in(region, table, radius, [self.across, self.behind]))
    }

    /// The play, with the call that the rules ask for, at the least elevation that clears rails and
    /// balls.
    ///
    /// # Errors
    /// [`Error::Input`] if `frame` does not ask for a shot, as [`Self::check`], if another ball
    /// is where the cue ball should be, and if the strike cannot be played.
    pub fn play(&self, frame: &Frame) -> Result<Play, Error> {
        self.check()?;
        let place = frame.turn().and_then(|turn| self.cue_ball(frame, turn));
        let prepared = Prepared::new(frame, place)?;
        let play = self.play_of(&prepared)?;
        prepared.shot().resolve_strike(&play.strike)?;
        Ok(play)
    }

    /// The play of a prepared shot, whose cue ball is where [`Self::cue_ball`] puts it.
    ///
    /// # Errors
    /// [`Error::Input`] if there is no ball to aim at.
    pub(crate) fn play_of(&self, prepared: &Prepared<'_>) -> Result<Play, Error> {
        let (scene, turn) = (Scene::of(prepared), prepared.turn());
        let aimed = scene.ball(turn.cue).zip(first_ball(&scene, prepared));
        let Some((cue, first)) = aimed else {
            let what = "there is no ball to break";
            return Err(ErrorKind::WrongState.at(
                "frame",
                what,
                "give a frame that asks for an opening shot",
            ));
        };
        let way = first.center - cue.center;
        // To the right of the way: the azimuth grows to the left.
        let beside = (self.aim * first.radius / way.length()).clamp(-1.0, 1.0);
        let azimuth = atan2(way.y, way.x) - asin(beside);
        let Self { speed, side, height, .. } = *self;
        let strike = Strike { speed, azimuth, elevation: 0.0, side, height };
        let strike = Strike { elevation: prepared.shot().default_elevation(&strike), ..strike };
        let call = call_of(turn, first.index, None);
        Ok(Play { cue_ball: prepared.cue_ball(), call, ..Play::new(strike) })
    }
}

/// The ball on that is nearest to the middle of the line of the cue ball's region; without a
/// region, nearest to the cue ball.
fn first_ball(scene: &Scene<'_>, prepared: &Prepared<'_>) -> Option<SceneBall> {
    let turn = prepared.turn();
    let from = match turn.hand {
        Some(region) => {
            let [low, high] = region.bounds(scene.table);
            Vec2::new(0.5 * (low[0] + high[0]), high[1]) - scene.table.center()
        }
        None => scene.ball(turn.cue)?.center,
    };
    let targets = Targets::of(prepared.frame(), turn);
    let balls = targets.first.iter().filter_map(|ball| scene.ball(*ball));
    let gap = |ball: &SceneBall| (ball.center - from).length_squared();
    balls.min_by(|a, b| gap(a).total_cmp(&gap(b)))
}

/// The place of a ball of `radius` (m) at these shares of the region (file coordinates, m).
fn place_in(region: Region, table: &Table, radius: f64, [across, behind]: [f64; 2]) -> [f64; 2] {
    let [low, high] = region.bounds(table);
    let rail = table.reach(radius) + SPARE;
    let middle = 0.5 * (low[0] + high[0]);
    let bottom = low[1].max(rail);
    let top = (high[1] - SPARE).min(table.size.y - rail);
    let y = top - behind * (top - bottom);
    let half = match region {
        // The chord of the D at this depth.
        Region::TheD => {
            let (radius, below) = (middle - low[0], high[1] - y);
            sqrt((radius * radius - below * below).max(0.0)) - SPARE
        }
        Region::Anywhere | Region::BehindHeadString => 0.5 * table.size.x - rail,
    };
    [middle + across * half.max(0.0), y]
}

#[cfg(test)]
mod tests {
    use carom::math::degrees;
    use carom_rules::{Frame, Game, Options};

    use super::BreakShot;

    fn new_frame(game: Game) -> Frame {
        Frame::new(game, Options::default(), None, None, 0).unwrap()
    }

    #[test]
    fn the_usual_opening_can_be_played_in_every_game() {
        // Seen: in snooker the brown stands in the middle of the D's line.
        for game in Game::ALL {
            let frame = new_frame(game);
            let shot = BreakShot::usual(&frame);
            let played = shot.play(&frame);
            assert!(played.is_ok(), "{}: {played:?}", game.name());
            let is_aside = matches!(game, Game::Snooker | Game::SixRed);
            assert_eq!(shot.across != 0.0, is_aside, "{}", game.name());
        }
    }

    #[test]
    fn every_share_of_the_region_is_a_place_where_the_rules_allow_the_cue_ball() {
        for game in Game::ALL {
            let frame = new_frame(game);
            for across in [-1.0, -0.3, 0.02, 0.6, 1.0] {
                for behind in [0.25, 0.6, 1.0] {
                    let shot = BreakShot { across, behind, ..BreakShot::center(4.0) };
                    let played = shot.play(&frame).and_then(|play| frame.shot(&play));
                    assert!(played.is_ok(), "{} {across} {behind}: {played:?}", game.name());
                }
            }
        }
    }

    #[test]
    fn a_full_hit_from_the_middle_goes_straight_up_the_table() {
        for game in [Game::EightBall, Game::NineBall, Game::TenBall, Game::StraightPool] {
            let play = BreakShot::center(8.0).play(&new_frame(game)).unwrap();
            assert!((degrees(play.strike.azimuth) - 90.0).abs() < 0.01, "{play:?}");
            assert!(play.strike.elevation > 0.0);
        }
    }

    #[test]
    fn the_mirror_image_of_a_shot_has_its_place_and_its_aim_on_the_other_side() {
        let frame = new_frame(Game::EightBall);
        let shot = BreakShot { across: 0.7, aim: 0.3, side: 0.1, ..BreakShot::center(8.0) };
        let [right, left] = [shot, shot.mirrored()].map(|shot| shot.play(&frame).unwrap());
        let [a, b] = [right, left].map(|play| play.cue_ball.unwrap());
        let width = frame.base().table().size.x;
        assert!((a[0] + b[0] - width).abs() < 1e-9 && a[0] > 0.8 * width);
        // The gaps of the rack are not symmetric.
        assert!((degrees(right.strike.azimuth + left.strike.azimuth) - 180.0).abs() < 0.01);
        assert_eq!(shot.mirrored().mirrored(), shot);
    }

    #[test]
    fn numbers_out_of_range_are_refused_at_their_names() {
        let frame = new_frame(Game::NineBall);
        let center = BreakShot::center(8.0);
        for (shot, place) in [
            (BreakShot { across: 1.5, ..center }, "across: "),
            (BreakShot { behind: -0.1, ..center }, "behind: "),
            (BreakShot { aim: f64::NAN, ..center }, "aim: "),
            (BreakShot { side: 0.9, ..center }, "strike"),
            (BreakShot { speed: -1.0, ..center }, "strike"),
        ] {
            let error = shot.play(&frame).unwrap_err().to_string();
            assert!(error.starts_with(place), "{error}");
        }
    }
}
