//! Studies: chapters of a position, a text, shots with their variations, and a task (`carom-study/1`,
//! docs/studies.md).
//!
//! A study may come from anybody. Its reader bounds every text and list, and nothing is simulated before
//! [`Study::check`].

mod check;
mod judge;
mod read;
mod task;

use carom::format::Node;
use carom::{Error, ErrorKind, ShotFile};

pub use check::ChapterReport;
pub use judge::{TaskVerdict, judge};
pub use task::{ChapterTask, goal_from_node};

/// The value of `format` in the file of a study.
pub const STUDY_FORMAT: &str = "carom-study/1";

/// The JSON Schema of the file of a study.
pub const STUDY_SCHEMA: &str = include_str!("../../schemas/carom-study-1.json");

/// The most chapters of a study.
pub const MOST_CHAPTERS: usize = 200;

/// The most shots of a chapter's tree, as in an analysis on the page.
pub const MOST_SHOTS: usize = 500;

/// The largest file that is read, bytes: a hundred times a study of twenty chapters.
pub const LARGEST_FILE: usize = 4_000_000;

/// A study whose parts were read. Its shots are valid, but not simulated.
#[derive(Clone, Debug)]
pub struct Study {
    source: Node,
    /// Its title.
    pub title: String,
    /// Who made it.
    pub author: Option<String>,
    /// The language of its texts, a tag such as `en`.
    pub language: Option<String>,
    /// One or more.
    pub chapters: Vec<Chapter>,
}

/// A part of a study.
#[derive(Clone, Debug)]
pub struct Chapter {
    /// Its title.
    pub title: String,
    /// What it says; lines end with LF.
    pub text: String,
    /// Its position; with a strike, if the chapter shows one.
    pub shot: ShotFile,
    /// Shots from the position, and those that follow them.
    pub tree: Vec<TreeShot>,
    /// What the reader of the study shall do.
    pub task: Option<ChapterTask>,
}

/// A shot of a chapter's tree.
#[derive(Clone, Debug)]
pub struct TreeShot {
    /// The shot from whose end it is played, an earlier one of the tree; none: from the chapter's position.
    pub after: Option<usize>,
    /// The strike as a shot file has it. Only its simulation shows whether it can be played.
    pub strike: Node,
    /// What is said about it.
    pub comment: String,
}

impl Study {
    /// Reads the file of a study.
    ///
    /// # Errors
    /// [`Error::Input`] for a text that is too long or not JSON, and as [`Self::from_node`].
    pub fn from_json(text: &str) -> Result<Self, Error> {
        check_size(text)?;
        Self::from_node(Node::from_json(text)?)
    }

    /// Reads a study from a tree of values.
    ///
    /// # Errors
    /// [`Error::Input`] with the place, such as `chapters[3].shot.balls[0].position`, what is wrong there, and
    /// the remedy.
    pub fn from_node(node: Node) -> Result<Self, Error> {
        read::study(node)
    }

    /// The file, as it was read.
    pub const fn to_node(&self) -> &Node {
        &self.source
    }
}

/// Refuses a text that is too long for the file of a study.
///
/// # Errors
/// [`Error::Input`].
pub fn check_size(text: &str) -> Result<(), Error> {
    if text.len() <= LARGEST_FILE {
        return Ok(());
    }
    let what = format!("the file has {} bytes", text.len());
    let remedy = format!("at most {LARGEST_FILE} are read; divide the study");
    Err(ErrorKind::WrongCount.at("", what, remedy).with("count", text.len() as f64))
}
