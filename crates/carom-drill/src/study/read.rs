//! Reads the file of a study strictly, with bounds on everything.

use std::collections::HashSet;

use carom::format::{Node, Reader};
use carom::shot::DEFAULT_MAX_EVENTS;
use carom::{Error, ErrorKind, ShotFile};

use super::task::{ChapterTask, goal_from_node};
use super::{Chapter, MOST_CHAPTERS, MOST_SHOTS, STUDY_FORMAT, Study, TreeShot};

/// The most characters of a title and of an author's name: a line.
const LONGEST_TITLE: usize = 100;
/// The most characters of a language's tag (RFC 5646 recommends room for 35).
const LONGEST_TAG: usize = 35;
/// The most characters of a chapter's text: a printed page.
const LONGEST_TEXT: usize = 4000;
/// The most characters of a comment, as in an analysis on the page.
const LONGEST_COMMENT: usize = 1000;

pub(super) fn study(source: Node) -> Result<Study, Error> {
    let at = Reader::new(&source, "");
    // Checked before the keys: those of another file are not typing errors.
    at.require("format", &format!("\"{STUDY_FORMAT}\""))?.format(STUDY_FORMAT)?;
    at.keys(&["format", "title", "author", "language", "chapters"])?;
    let title = line(&at.require("title", "a title")?, LONGEST_TITLE)?;
    let author = at.get("author").map(|at| line(&at, LONGEST_TITLE)).transpose()?;
    let language = at.get("language").map(|at| tag(&at)).transpose()?;
    let items = at.require("chapters", "a list of chapters")?;
    let chapters = bounded(&items, "a list of chapters", 1, MOST_CHAPTERS)?
        .iter()
        .map(chapter)
        .collect::<Result<_, _>>()?;
    Ok(Study { title, author, language, chapters, source })
}

fn chapter(at: &Reader<'_>) -> Result<Chapter, Error> {
    at.keys(&["title", "text", "shot", "tree", "task"])?;
    let title = line(&at.require("title", "a title")?, LONGEST_TITLE)?;
    let text = at.get("text").map_or(Ok(String::new()), |at| passage(&at, LONGEST_TEXT))?;
    let shot = shot(&at.require("shot", "a shot file {...}")?)?;
    let tree = at.get("tree").map_or(Ok(Vec::new()), |at| tree(&at))?;
    let task = at.get("task").map(|at| task(&at, &shot)).transpose()?;
    Ok(Chapter { title, text, shot, tree, task })
}

fn shot(at: &Reader<'_>) -> Result<ShotFile, Error> {
    if let Some(cap) = at.get("max_events") {
        // A study of a stranger must not keep its reader waiting.
        cap.whole(1, DEFAULT_MAX_EVENTS.into())?;
    }
    ShotFile::from_node(at.node().clone()).map_err(|error| error.inside(at.place()))
}

fn tree(at: &Reader<'_>) -> Result<Vec<TreeShot>, Error> {
    let mut shots = Vec::new();
    let mut seen = HashSet::new();
    for item in bounded(at, "a list of shots", 0, MOST_SHOTS)? {
        item.keys(&["after", "strike", "comment"])?;
        let after = match item.get("after") {
            None => None,
            Some(_) if shots.is_empty() => {
                let place = format!("{}.after", item.place());
                let remedy = "the first shot is played from the chapter's position: remove the key";
                return Err(ErrorKind::Conflict.at(place, "there is no earlier shot", remedy));
            }
            Some(after) => Some(after.whole(0, shots.len() as i64 - 1)? as usize),
        };
        let strike = item.require("strike", "a strike {...}")?;
        strike.require("ball", "the id of a ball")?.text("the id of a ball")?;
        let strike = strike.node().clone();
        if !seen.insert((after, strike.to_json_line())) {
            let what = "the same shot is there already";
            return Err(item.refuse(ErrorKind::Duplicate, what, "remove one of the two"));
        }
        let comment =
            item.get("comment").map_or(Ok(String::new()), |at| passage(&at, LONGEST_COMMENT))?;
        shots.push(TreeShot { after, strike, comment });
    }
    Ok(shots)
}

fn task(at: &Reader<'_>, shot: &ShotFile) -> Result<ChapterTask, Error> {
    at.keys(&["goal", "solution"])?;
    let goal = goal_from_node(&at.require("goal", "a list of conditions")?, shot)?;
    let solution = at.get("solution").map(|at| struck(shot, &at)).transpose()?;
    Ok(ChapterTask { goal, solution })
}

/// The shot with another strike.
fn struck(shot: &ShotFile, strike: &Reader<'_>) -> Result<ShotFile, Error> {
    let file = with_strike(&shot.to_node(), strike.node());
    ShotFile::from_node(file).map_err(|error| error.moved("strike", strike.place()))
}

/// The file of a shot with another strike.
pub(super) fn with_strike(file: &Node, strike: &Node) -> Node {
    let mut file = file.clone();
    file.set("strike", strike.clone());
    file
}

fn bounded<'a>(
    at: &Reader<'a>,
    wanted: &str,
    least: usize,
    most: usize,
) -> Result<Vec<Reader<'a>>, Error> {
    let items = at.items(wanted)?;
    if (least..=most).contains(&items.len()) {
        return Ok(items);
    }
    let what = format!("found a list of {}", items.len());
    let error = at.refuse(ErrorKind::WrongCount, what, format!("write {least} to {most}"));
    Err(error.with("count", items.len() as f64))
}

/// One line of text that is not empty.
fn line(at: &Reader<'_>, longest: usize) -> Result<String, Error> {
    let text = at.text("a line of text")?;
    long(at, text, 1, longest)?;
    if text.chars().any(char::is_control) {
        let what = "the text has a control character";
        return Err(at.refuse(ErrorKind::WrongType, what, "write one line of text"));
    }
    Ok(text.into())
}

/// Lines of text.
fn passage(at: &Reader<'_>, longest: usize) -> Result<String, Error> {
    let text = at.text("a text")?;
    long(at, text, 0, longest)?;
    if text.chars().any(|one| one.is_control() && one != '\n') {
        let what = "the text has a control character other than the end of a line";
        return Err(at.refuse(ErrorKind::WrongType, what, "remove it"));
    }
    Ok(text.into())
}

fn long(at: &Reader<'_>, text: &str, least: usize, most: usize) -> Result<(), Error> {
    let length = text.chars().count();
    if (least..=most).contains(&length) {
        return Ok(());
    }
    let what = format!("found {length} characters");
    let error = at.refuse(ErrorKind::WrongCount, what, format!("write {least} to {most}"));
    Err(error.with("count", length as f64))
}

/// The tag of a language, such as `en` or `zh-Hans`.
fn tag(at: &Reader<'_>) -> Result<String, Error> {
    let text = at.text("the tag of a language, such as \"en\"")?;
    let is_part = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_alphanumeric());
    if text.len() <= LONGEST_TAG && text.split('-').all(is_part) {
        return Ok(text.into());
    }
    let remedy = "write the tag of a language, such as \"en\" or \"zh-Hans\"";
    Err(at.refuse(ErrorKind::WrongType, "it is not the tag of a language", remedy))
}
