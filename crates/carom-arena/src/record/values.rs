//! Values of records that occur in several places: plays, strikes and seeds.

use carom::format::{Node, Reader};
use carom::resolve::cue_ball::Strike;
use carom::shot::Cling;
use carom::table::PocketName;
use carom::{Error, ErrorKind};
use carom_rules::{BallIndex, Call, Frame, Play};

/// What to write for a place of the cue ball.
const PLACE: &str = "a list of two numbers, m";

/// A number to the bit. NaN and infinities, which JSON does not have, become texts: a refused
/// answer may contain them.
pub(super) fn number(x: f64) -> Node {
    if x.is_finite() { x.into() } else { x.to_string().into() }
}

/// A number that [`number`] wrote.
pub(super) fn read_number(at: &Reader<'_>) -> Result<f64, Error> {
    match at.node() {
        Node::Text(text) => match text.as_str() {
            "NaN" => Ok(f64::NAN),
            "inf" => Ok(f64::INFINITY),
            "-inf" => Ok(f64::NEG_INFINITY),
            _ => Err(at.wrong_type("a number")),
        },
        _ => at.exact_number(),
    }
}

/// 64 bits as 16 hexadecimal digits: a double cannot hold them.
pub(super) fn bits(word: u64) -> Node {
    format!("{word:016x}").into()
}

/// A whole number.
pub(super) fn whole(n: u64) -> Node {
    Node::Integer(i64::try_from(n).unwrap_or(i64::MAX))
}

/// A whole number from 0.
pub(super) fn read_whole(at: &Reader<'_>) -> Result<u64, Error> {
    Ok(at.whole(0, i64::MAX)?.unsigned_abs())
}

/// A value for each of the two players or seats.
pub(super) fn two<T>(
    at: &Reader<'_>,
    read: impl Fn(&Reader<'_>) -> Result<T, Error>,
) -> Result<[T; 2], Error> {
    let wanted = "a list of two values";
    match at.items(wanted)?.as_slice() {
        [one, other] => Ok([read(one)?, read(other)?]),
        items => Err(at.refuse(
            ErrorKind::WrongCount,
            format!("found a list of {}", items.len()),
            format!("write {wanted}"),
        )),
    }
}

/// A strike with all its numbers.
pub(crate) fn strike(strike: &Strike) -> Node {
    Node::object([
        ("speed", number(strike.speed)),
        ("azimuth", number(strike.azimuth)),
        ("elevation", number(strike.elevation)),
        ("side", number(strike.side)),
        ("height", number(strike.height)),
    ])
}

pub(super) fn read_strike(at: &Reader<'_>) -> Result<Strike, Error> {
    let key = |key| read_number(&at.require(key, "a number")?);
    Ok(Strike {
        speed: key("speed")?,
        azimuth: key("azimuth")?,
        elevation: key("elevation")?,
        side: key("side")?,
        height: key("height")?,
    })
}

/// A place of the cue ball (file coordinates, m).
pub(crate) fn place([x, y]: [f64; 2]) -> Node {
    Node::List(vec![number(x), number(y)])
}

/// A place that [`place`] wrote.
pub(super) fn read_place(at: &Reader<'_>) -> Result<[f64; 2], Error> {
    match at.items(PLACE)?.as_slice() {
        [x, y] => Ok([read_number(x)?, read_number(y)?]),
        _ => Err(at.wrong_type(PLACE)),
    }
}

/// A play in `frame`: `strike`, and if they exist `cue_ball` and `call`.
pub(super) fn play(frame: &Frame, play: &Play) -> Node {
    let mut node = Node::object([("strike", strike(&play.strike))]);
    if let Some(at) = play.cue_ball {
        node.set("cue_ball", place(at));
    }
    // A refused call may name a ball that does not exist.
    let id = |ball: BallIndex| match frame.layout().balls().get(usize::from(ball)) {
        Some(known) => Node::from(&known.id),
        None => u32::from(ball).into(),
    };
    let kind = |kind: &str| ("kind", Node::from(kind));
    match play.call {
        Call::Nothing => {}
        Call::Safety => node.set("call", Node::object([kind("safety")])),
        Call::PushOut => node.set("call", Node::object([kind("push-out")])),
        Call::On(ball) => node.set("call", Node::object([kind("on"), ("ball", id(ball))])),
        Call::Pocket(ball, pocket) => {
            let pocket = ("pocket", Node::from(pocket.name()));
            node.set("call", Node::object([kind("pocket"), ("ball", id(ball)), pocket]));
        }
    }
    node
}

/// A play that [`play`] wrote.
pub(crate) fn read_play(frame: &Frame, at: &Reader<'_>) -> Result<Play, Error> {
    at.keys(&["strike", "cue_ball", "call"])?;
    let strike = read_strike(&at.require("strike", "the strike, an object")?)?;
    let cue_ball = at.get("cue_ball").map(|at| read_place(&at)).transpose()?;
    let call = at.get("call").map_or(Ok(Call::Nothing), |call| read_call(frame, &call))?;
    Ok(Play { cue_ball, call, ..Play::new(strike) })
}

fn read_call(frame: &Frame, at: &Reader<'_>) -> Result<Call, Error> {
    at.keys(&["kind", "ball", "pocket"])?;
    let ball = || {
        let ball = at.require("ball", "the id of a ball")?;
        match ball.node() {
            Node::Integer(_) => Ok(ball.whole(0, BallIndex::MAX.into())? as BallIndex),
            _ => frame.ball(ball.text("the id of a ball")?, ball.place()),
        }
    };
    let kind = at.require("kind", "the kind of the call")?;
    Ok(match kind.text("the kind of the call")? {
        "safety" => Call::Safety,
        "push-out" => Call::PushOut,
        "on" => Call::On(ball()?),
        "pocket" => {
            let pocket = at.require("pocket", "the name of a pocket")?;
            let name = pocket.text("the name of a pocket")?;
            let known = PocketName::ALL.map(PocketName::name);
            let found = PocketName::ALL.into_iter().find(|pocket| pocket.name() == name);
            let name = found.ok_or_else(|| pocket.unknown_word(name, "pocket", &known))?;
            Call::Pocket(ball()?, name)
        }
        other => {
            let known = ["safety", "push-out", "on", "pocket"];
            return Err(kind.unknown_word(other, "kind of call", &known));
        }
    })
}

pub(super) fn cling(cling: &Cling) -> Node {
    let contacts = Node::list(cling.contacts());
    Node::object([("contacts", contacts), ("friction", cling.friction().into())])
}
