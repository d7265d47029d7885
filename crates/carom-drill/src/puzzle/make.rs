//! Makes a puzzle: layout, solution, chances, and whether it is a good one.

use carom::{Error, ErrorKind, Shot, Simulator};

use super::layouts;
use super::levels::{CLUB, Measure, Way, rating_of, turned};
use super::search;
use super::task::Task;
use super::theme::Theme;
use crate::goal::DrillGoal;

/// Why a number of a theme gives no puzzle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rejection {
    /// The balls do not make a layout of the theme.
    Layout,
    /// No strike was found.
    Unsolved,
    /// A beginner solves it most of the time, or a plain strike does.
    TooEasy,
    /// A professional rarely solves it.
    TooHard,
    /// Two different lines are about equally good.
    Ambiguous,
}

impl Rejection {
    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Layout => "layout",
            Self::Unsolved => "unsolved",
            Self::TooEasy => "too-easy",
            Self::TooHard => "too-hard",
            Self::Ambiguous => "ambiguous",
        }
    }
}

/// A puzzle.
#[derive(Clone, Debug)]
pub struct Puzzle {
    /// What it is about.
    pub theme: Theme,
    /// Its number among those of the theme.
    pub number: u32,
    /// The layout, with a strike at the first object ball.
    pub shot: Shot,
    /// What the shot must do.
    pub goal: DrillGoal,
    /// Different ways to solve it, each exactly as it is; the first one is the best for a club player.
    pub ways: Vec<Way>,
    /// The chance of each level with the best strike that was found for it.
    pub chances: [f64; 5],
    /// Its difficulty on the scale of the levels' ratings.
    pub rating: f64,
}

/// A beginner who solves a puzzle more often than this finds it too easy; a professional who solves it more
/// rarely than that finds it too hard.
const EASIEST: f64 = 0.9;
const HARDEST: f64 = 0.2;
/// A puzzle is ambiguous if a line at least this far from the best one, rad, is at least this share as good.
const OTHER_LINE: f64 = 0.06;
const AS_GOOD: f64 = 0.85;

impl Puzzle {
    /// The puzzle with a number, or why there is none.
    ///
    /// # Errors
    /// [`Error::Input`] if the engine refuses a layout: a fault of this crate.
    pub fn make(theme: Theme, number: u32) -> Result<Result<Self, Rejection>, Error> {
        let mut simulator = Simulator::new();
        let Some(task) = layouts::task(theme, number, &mut simulator)? else {
            return Ok(Err(Rejection::Layout));
        };
        let mut measure = Measure { simulator, task: &task };
        let strikes = search::strikes(&task, &mut |strike| measure.solves(strike))?;
        let mut ways = measure.ways(&strikes)?;
        ways.sort_by(|a, b| b.chances[CLUB].total_cmp(&a.chances[CLUB]));
        let Some(best) = ways.first() else { return Ok(Err(Rejection::Unsolved)) };
        let is_rival = |way: &&Way| {
            turned(&way.strike, &best.strike) > OTHER_LINE
                && way.chances[CLUB] >= AS_GOOD * best.chances[CLUB]
        };
        let chances = core::array::from_fn(|level| {
            ways.iter().map(|way| way.chances[level]).fold(0.0, f64::max)
        });
        if chances[4] < HARDEST {
            return Ok(Err(Rejection::TooHard));
        }
        if chances[0] > EASIEST || is_plain(&mut measure)? {
            return Ok(Err(Rejection::TooEasy));
        }
        if ways.iter().any(|way| is_rival(&way)) {
            return Ok(Err(Rejection::Ambiguous));
        }
        // With a player's errors, the best strike may miss by a little. It is not shown as a way.
        ways.retain(|way| measure.solves(&way.strike));
        if ways.is_empty() {
            return Ok(Err(Rejection::Unsolved));
        }
        let Task { shot, goal, .. } = task;
        let rating = rating_of(&chances);
        Ok(Ok(Self { theme, number, shot, goal, ways, chances, rating }))
    }

    /// The puzzle with an id, such as `cut-17`.
    ///
    /// # Errors
    /// [`Error::Input`] if the id is not one, or gives no puzzle.
    pub fn read(id: &str) -> Result<Self, Error> {
        let refuse = |what: &str| {
            let remedy = "take an id of the list of puzzles, such as cut-17";
            Err(ErrorKind::UnknownName
                .at("puzzle", format!("\"{id}\" {what}"), remedy)
                .with("name", id))
        };
        let Some((theme, number)) = id.rsplit_once('-') else {
            return refuse("is no id of a puzzle");
        };
        let Ok(number) = number.parse::<u32>() else { return refuse("is no id of a puzzle") };
        let theme = Theme::read(theme)?;
        match Self::make(theme, number)? {
            Ok(puzzle) => Ok(puzzle),
            Err(why) => refuse(&format!("is no puzzle ({})", why.name())),
        }
    }

    /// Its id.
    pub fn id(&self) -> String {
        format!("{}-{}", self.theme.name(), self.number)
    }
}

/// Whether a plain strike solves a puzzle that is about the way of the cue ball.
fn is_plain(measure: &mut Measure<'_>) -> Result<bool, Error> {
    let plain = search::plain(measure.task)?;
    Ok(plain.iter().any(|strike| measure.solves(strike)))
}
