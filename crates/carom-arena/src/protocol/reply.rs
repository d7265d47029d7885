//! Reading the lines of a program.

use carom::error::InputError;
use carom::format::{Node, Reader};
use carom::{Error, ErrorKind};
use carom_mind::{Answer, Decision, Spent};
use carom_rules::{Choice, Frame};

use super::menu::Menu;

/// The types of an answer.
const ANSWERS: [&str; 4] = ["play", "choose", "concede", "pick"];

/// Longest `info` of an answer as JSON, bytes: room for the thoughts of a language model. A record
/// keeps it.
const LONGEST_INFO: usize = 1 << 16;

/// An answer, and what the program says of it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Reply {
    pub(super) decision: Decision,
    pub(super) info: Option<Node>,
}

/// Why a line is refused, and the number of the request that it answers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Refusal {
    pub(super) id: i64,
    pub(super) fault: Error,
}

/// The object on a line.
pub(super) fn message(line: &str) -> Result<Node, Error> {
    let node = Node::from_json(line).map_err(at_line)?;
    match node {
        Node::Object(_) => Ok(node),
        _ => Err(Reader::new(&node, "line").wrong_type("an object {...}")),
    }
}

/// The fault of a line that is not UTF-8.
pub(super) fn not_utf8() -> Error {
    ErrorKind::Syntax.at("line", "it is not UTF-8", "write JSON in UTF-8, an object on each line")
}

/// The answer on `line` to request `id` of `frame`.
pub(super) fn read(line: &str, id: i64, frame: &Frame, menu: &Menu) -> Result<Reply, Refusal> {
    let refuse = |fault| Refusal { id, fault };
    let node = message(line).map_err(refuse)?;
    let at = Reader::new(&node, "");
    let kind = read_type(&at).map_err(refuse)?;
    let found = read_id(&at).map_err(refuse)?;
    if found != id {
        let what = format!("{found} is not the number of the present request");
        let remedy = format!("answer request {id}, and each request once");
        let fault = ErrorKind::Mismatch.at("id", what, remedy);
        return Err(Refusal { id: found, fault });
    }
    let answer = match kind {
        "play" => frame.read_play(&at).map(Answer::Play),
        "choose" => read_choice(&at).map(Answer::Choice),
        "pick" => menu.read_pick(&at),
        _ => Ok(Answer::Concede),
    };
    let answer = answer.map_err(refuse)?;
    let said = read_info(&at).map_err(refuse)?;
    let Said { win_chance, simulations, info } = said;
    let spent = Spent { simulations, rounds: 0 };
    Ok(Reply { decision: Decision { answer, win_chance, spent }, info })
}

fn read_type<'a>(at: &Reader<'a>) -> Result<&'a str, Error> {
    let kind = at.require("type", "\"type\": \"play\"")?;
    let found = kind.text("\"play\"")?;
    if ANSWERS.contains(&found) {
        return Ok(found);
    }
    Err(kind.unknown_word(found, "answer", &ANSWERS))
}

fn read_id(at: &Reader<'_>) -> Result<i64, Error> {
    at.require("id", "the id of the request")?.whole(i64::MIN, i64::MAX)
}

fn read_choice(at: &Reader<'_>) -> Result<Choice, Error> {
    Choice::read(at.require("choice", "one of the choices")?.text("the name of a choice")?)
}

/// What a program says of its answer.
struct Said {
    win_chance: Option<f64>,
    simulations: u64,
    info: Option<Node>,
}

fn read_info(at: &Reader<'_>) -> Result<Said, Error> {
    let Some(info) = at.get("info") else {
        return Ok(Said { win_chance: None, simulations: 0, info: None });
    };
    let length = info.node().to_json_line().len();
    if length > LONGEST_INFO {
        let what = format!("it has {length} bytes");
        let remedy = format!("write at most {LONGEST_INFO} bytes");
        return Err(info.refuse(ErrorKind::OutOfRange, what, remedy));
    }
    let chance = info.get("win_chance").map(|chance| chance.exact_number()).transpose()?;
    let simulations = info.get("simulations").map_or(Ok(0), |n| n.whole(0, i64::MAX))?;
    Ok(Said {
        win_chance: chance.filter(|chance| (0.0..=1.0).contains(chance)),
        simulations: simulations.unsigned_abs(),
        info: Some(info.node().clone()),
    })
}

/// The error at `line` if it has no place or the line is not JSON, and without the number of the only
/// line.
fn at_line(error: Error) -> Error {
    match error {
        Error::Input(mut fault) => {
            if fault.place.is_empty() || fault.kind == ErrorKind::Syntax {
                fault.place = "line".into();
            }
            fault.what = fault.what.replace("(line 1, column", "(column");
            Error::Input(fault)
        }
        other => other,
    }
}

/// The fault of an error; another error than bad input is one of the whole line.
pub(super) fn fault_of(error: Error) -> InputError {
    match error {
        Error::Input(fault) => *fault,
        other => InputError {
            kind: ErrorKind::Syntax,
            place: "line".into(),
            what: other.to_string(),
            remedy: "write another answer".into(),
            details: Vec::new(),
        },
    }
}
