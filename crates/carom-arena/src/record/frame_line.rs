//! The line of a frame in a record.

use carom::error::InputError;
use carom::format::{Node, Reader};
use carom::shot::Cling;
use carom::{Error, ErrorKind};
use carom_mind::{Answer, Decision, Spent};
use carom_rules::{Choice, Frame};

use super::values::{
    bits, cling, number, place, play, read_number, read_place, read_play, read_strike, read_whole,
    strike, two, whole,
};
use crate::arena_frame::ArenaFrame;
use crate::clock::Cost;
use crate::luck::ShotLuck;
use crate::moves::{ArenaMove, Effect, EndReason, Execution, FrameEnd};
use crate::score::FramePoints;
use crate::secret::PairSeeds;
use crate::settings::PlayerIndex;

/// The line of `frame`.
pub(crate) fn frame_line(frame: &ArenaFrame) -> Node {
    let players = frame.players();
    let has_luck = frame.of().settings().luck.is_some();
    Node::object([
        ("frame", whole(frame.number())),
        ("seats", Node::list(players.map(|player| player as i64))),
        ("seeds", seeds(frame.seeds(), has_luck)),
        ("moves", Node::list(frame.moves().iter().map(|m| move_node(frame.frame(), m)))),
        ("scores", Node::list(frame.frame().scores().map(i64::from))),
        ("end", frame.end().map(|end| end_node(end, players)).into()),
    ])
}

/// The seeds of a frame; those of fresh errors if the luck of its shots is measured.
fn seeds(seeds: &PairSeeds, has_luck: bool) -> Node {
    let two = |words: [u64; 2]| Node::list(words.map(bits));
    let mut node = Node::object([
        ("rack", bits(seeds.rack)),
        ("errors", two(seeds.errors)),
        ("sight", two(seeds.sight)),
        ("decisions", two(seeds.decisions)),
    ]);
    if has_luck {
        node.set("luck", two(seeds.luck));
    }
    node
}

fn end_node(end: &FrameEnd, players: [PlayerIndex; 2]) -> Node {
    let of_player_0 = |of_seat_0: f64| if players[0] == 0 { of_seat_0 } else { 1.0 - of_seat_0 };
    let points =
        end.points().map(|of_seat_0| [of_player_0(of_seat_0), 1.0 - of_player_0(of_seat_0)]);
    Node::object([
        ("winner", end.winner.map(|seat| players[seat] as i64).into()),
        ("points", points.map(Node::from).into()),
        ("reason", end.reason.name().into()),
        ("why", end.why.clone().into()),
    ])
}

fn move_node(frame: &Frame, arena_move: &ArenaMove) -> Node {
    let ArenaMove { seat, answer, is_given, win_chance, info, cost, effect } = arena_move;
    let mut node = Node::object([("seat", (*seat as i64).into())]);
    match answer {
        Some(Answer::Play(intended)) => node.set("play", play(frame, intended)),
        Some(Answer::Choice(choice)) => node.set("choice", choice.name()),
        Some(Answer::Concede) => node.set("concede", true),
        None => {}
    }
    if *is_given {
        node.set("given", true);
    } else {
        node.set("cost", cost_node(cost));
    }
    if let Some(chance) = win_chance {
        node.set("win_chance", number(*chance));
    }
    if let Some(info) = info {
        node.set("info", info.clone());
    }
    match effect {
        Effect::Played { execution, ruling, trace, luck } => {
            node.set("executed", execution_node(execution));
            node.set("ruling", frame.ruling_node(ruling));
            node.set("trace", bits(*trace));
            if let Some(ShotLuck { before, expected, after }) = *luck {
                let keys = [("before", before), ("expected", expected), ("after", after)];
                node.set("luck", Node::object(keys.map(|(key, chance)| (key, number(chance)))));
            }
        }
        Effect::Capped { execution } => {
            node.set("executed", execution_node(execution));
            node.set("capped", true);
        }
        Effect::Chosen { ruling } => node.set("ruling", frame.ruling_node(ruling)),
        Effect::Conceded => {}
        Effect::Refused(InputError { place, what, remedy, .. }) => {
            let keys = [("place", place), ("what", what), ("remedy", remedy)];
            node.set("refused", Node::object(keys.map(|(key, text)| (key, Node::from(text)))));
        }
        Effect::Late => node.set("late", true),
        Effect::Failed { reason, why } => {
            let keys = [("reason", Node::from(reason.name())), ("why", Node::from(why))];
            node.set("failed", Node::object(keys));
        }
    }
    node
}

fn execution_node(execution: &Execution) -> Node {
    let mut node = Node::object([("strike", strike(&execution.strike))]);
    if let Some(at) = execution.cue_ball {
        node.set("cue_ball", place(at));
    }
    if !execution.cling.is_empty() {
        node.set("cling", cling(&execution.cling));
    }
    node
}

/// An execution that [`frame_line`] wrote.
pub(crate) fn read_execution(at: &Reader<'_>) -> Result<Execution, Error> {
    at.keys(&["strike", "cue_ball", "cling"])?;
    let cling = at.get("cling").map_or(Ok(Cling::NONE), |at| {
        Cling::from_node(at.node()).map_err(|error| error.inside(at.place()))
    });
    Ok(Execution {
        strike: read_strike(&at.require("strike", "the strike, an object")?)?,
        cue_ball: at.get("cue_ball").map(|at| read_place(&at)).transpose()?,
        cling: cling?,
    })
}

fn cost_node(cost: &Cost) -> Node {
    let Cost { spent: Spent { simulations, rounds }, seconds } = *cost;
    let mut node = Node::object([("simulations", whole(simulations)), ("rounds", rounds.into())]);
    if seconds != 0.0 {
        node.set("seconds", number(seconds));
    }
    node
}

/// What a move of a record repeats in a frame.
pub(crate) enum Recorded {
    /// A decision, what the player said of it, and the time that it took, s.
    Decision(Decision, Option<Node>, f64),
    /// An answer that could not be read, and its cost.
    Unread(InputError, Cost),
    /// A failure of the player: why the frame ended, the same in words, and its cost.
    Failure(EndReason, String, Cost),
}

/// The moves of the line `at` that were not given by the settings, with their index. `frame` is the
/// frame with which the match begins.
pub(crate) fn read_moves(frame: &Frame, at: &Reader<'_>) -> Result<Vec<Recorded>, Error> {
    let moves = at.require("moves", "the list of moves")?.items("the list of moves")?;
    let asked = moves.iter().filter(|at| at.get("given").is_none());
    asked.map(|at| read_move(frame, at)).collect()
}

fn read_move(frame: &Frame, at: &Reader<'_>) -> Result<Recorded, Error> {
    let cost = read_cost(&at.require("cost", "what the decision cost, an object")?)?;
    let answer = if let Some(play) = at.get("play") {
        Answer::Play(read_play(frame, &play)?)
    } else if let Some(choice) = at.get("choice") {
        let name = choice.text("the name of a choice")?;
        let known = Choice::ALL.map(Choice::name);
        let found = Choice::named(name);
        Answer::Choice(found.ok_or_else(|| choice.unknown_word(name, "choice", &known))?)
    } else if at.get("concede").is_some() {
        Answer::Concede
    } else if let Some(failed) = at.get("failed") {
        let why = failed.require("why", "a text")?.text("a text")?;
        return Ok(Recorded::Failure(read_reason(&failed)?, why.into(), cost));
    } else if let Some(fault) = at.get("refused") {
        let text = |key| Ok(fault.require(key, "a text")?.text("a text")?.to_owned());
        let (place, what, remedy) = (text("place")?, text("what")?, text("remedy")?);
        return Ok(Recorded::Unread(unread(place, what, remedy), cost));
    } else if at.get("late").is_some() {
        let fault = unread(String::new(), String::new(), String::new());
        return Ok(Recorded::Unread(fault, cost));
    } else {
        return Err(at.refuse(
            ErrorKind::Missing,
            "it has no answer",
            "write play, choice, concede, failed, refused or late",
        ));
    };
    let win_chance = at.get("win_chance").map(|at| read_number(&at)).transpose()?;
    let Cost { spent, seconds } = cost;
    let info = at.get("info").map(|info| info.node().clone());
    Ok(Recorded::Decision(Decision { answer, win_chance, spent }, info, seconds))
}

/// The fault of an answer that could not be read. A record keeps its words and not its kind.
const fn unread(place: String, what: String, remedy: String) -> InputError {
    InputError { kind: ErrorKind::Syntax, place, what, remedy, details: Vec::new() }
}

fn read_cost(at: &Reader<'_>) -> Result<Cost, Error> {
    at.keys(&["simulations", "rounds", "seconds"])?;
    let simulations = read_whole(&at.require("simulations", "a whole number")?)?;
    let rounds = at.require("rounds", "a whole number")?.whole(0, u32::MAX.into())? as u32;
    let seconds = at.get("seconds").map_or(Ok(0.0), |at| at.exact_number())?;
    Ok(Cost { spent: Spent { simulations, rounds }, seconds })
}

fn read_reason(at: &Reader<'_>) -> Result<EndReason, Error> {
    let reason = at.require("reason", "the reason of the end")?;
    let name = reason.text("the reason of the end")?;
    let known = EndReason::ALL.map(EndReason::name);
    EndReason::named(name).ok_or_else(|| reason.unknown_word(name, "reason", &known))
}

/// The number of the frame whose line is `node`.
pub(crate) fn frame_number(node: &Node) -> Result<u64, Error> {
    read_whole(&Reader::new(node, "").require("frame", "the number of the frame")?)
}

/// The result of the frame whose line is `node`.
pub(crate) fn frame_points(node: &Node) -> Result<FramePoints, Error> {
    let end = Reader::new(node, "").require("end", "the end of the frame, an object")?;
    let reason = read_reason(&end)?;
    let points = match end.get("points") {
        None => None,
        Some(points) => match points.items("a list of two numbers")?.first() {
            Some(first) => Some(first.exact_number()?),
            None => return Err(points.wrong_type("a list of two numbers")),
        },
    };
    if points.is_some_and(|points| ![0.0, 0.5, 1.0].contains(&points)) {
        return Err(end.refuse(
            ErrorKind::OutOfRange,
            "a frame has other points",
            "write 0.0, 0.5 or 1.0",
        ));
    }
    Ok(FramePoints { points, reason, luck: frame_luck(node)? })
}

/// The luck of player 0 in the frame whose line is `node`, as [`ArenaFrame::luck`].
fn frame_luck(node: &Node) -> Result<Option<f64>, Error> {
    let line = Reader::new(node, "");
    let seeds = line.require("seeds", "the seeds of the frame, an object")?;
    if seeds.get("luck").is_none() {
        return Ok(None);
    }
    let seats = two(&line.require("seats", "the players at the seats")?, read_whole)?;
    let mut sum = 0.0;
    for played in line.require("moves", "the list of moves")?.items("the list of moves")? {
        let Some(luck) = played.get("luck") else { continue };
        let chance = |key| luck.require(key, "a chance")?.exact_number();
        let seat = played.require("seat", "0 or 1")?.whole(0, 1)? as usize;
        let luck = chance("after")? - chance("expected")?;
        sum += if seats[seat] == 0 { luck } else { -luck };
    }
    Ok(Some(sum))
}
