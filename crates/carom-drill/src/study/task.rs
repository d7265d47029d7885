//! Tasks: what a shot must do, in the terms of drills and puzzles.

use carom::format::Reader;
use carom::{Error, ErrorKind, Shot, ShotFile};

use crate::goal::DrillCondition;
use crate::goal_file::read_needs;

/// A task of a chapter. The shot must meet all conditions, and keep the cue ball on the table.
#[derive(Clone, Debug)]
pub struct ChapterTask {
    /// One or more conditions.
    pub goal: Vec<DrillCondition>,
    /// The chapter's shot with a strike that meets the goal.
    pub solution: Option<ShotFile>,
}

/// The goal of a task about `shot`.
///
/// # Errors
/// [`Error::Input`] for an empty or long list, an unknown kind, ball or pocket, and a number out of range.
pub fn goal_from_node(at: &Reader<'_>, shot: &Shot) -> Result<Vec<DrillCondition>, Error> {
    let goal = read_needs(at)?;
    if goal.is_empty() {
        let remedy = "name what the shot must do, such as {\"kind\": \"pot-any\"}";
        return Err(at.refuse(ErrorKind::Missing, "the goal is empty", remedy));
    }
    for (k, condition) in goal.iter().enumerate() {
        condition.check(&format!("{}[{k}]", at.place()), shot)?;
    }
    Ok(goal)
}
