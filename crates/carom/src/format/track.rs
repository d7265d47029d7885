//! The `track` of a shot file: where a camera saw the balls. It changes nothing in the shot; programs
//! show it beside the simulation.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::node::Node;
use super::read::At;
use crate::error::{Error, ErrorKind};
use crate::range::Range;
use crate::shot::PlacedBall;

/// The most samples of a ball: 100 s at 100 pictures a second. It bounds the size of a file.
pub const MOST_SAMPLES: usize = 10_000;

const TIME: Range = Range::any(" s");
const PLACE: Range = Range::any(" m");

/// Where a camera saw a ball.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmedBall {
    /// The ball's id.
    pub ball: String,
    /// Time since the strike (s), x and y (m) in the coordinates of the file. The times increase.
    pub samples: Vec<[f64; 3]>,
}

/// Reads `track`: for each filmed ball its id and its samples.
pub(super) fn read(at: &At<'_>, balls: &[PlacedBall]) -> Result<Vec<FilmedBall>, Error> {
    let mut track: Vec<FilmedBall> = Vec::new();
    for item in at.items("a list of filmed balls")? {
        let fields = item.fields(&["ball", "samples"])?;
        let id = fields.require("ball", "the id of a ball")?;
        let ball = id.text("the id of a ball")?;
        if !balls.iter().any(|placed| placed.id == ball) {
            let what = format!("no ball has the id \"{ball}\"");
            let remedy = "write the id of one of `balls`, or remove its samples";
            return Err(id.refuse(ErrorKind::UnknownBall, what, remedy).with("ball", ball));
        }
        if track.iter().any(|other| other.ball == ball) {
            let what = format!("ball \"{ball}\" is listed twice");
            return Err(id.refuse(ErrorKind::Duplicate, what, "join the samples"));
        }
        let samples = samples(&fields.require("samples", "a list of [t, x, y]")?)?;
        track.push(FilmedBall { ball: ball.into(), samples });
    }
    Ok(track)
}

fn samples(at: &At<'_>) -> Result<Vec<[f64; 3]>, Error> {
    let items = at.items("a list of [t, x, y]")?;
    if !(1..=MOST_SAMPLES).contains(&items.len()) {
        let what = format!("found {} samples", items.len());
        let remedy = format!("write 1 to {MOST_SAMPLES}");
        return Err(at
            .refuse(ErrorKind::WrongCount, what, remedy)
            .with("count", items.len() as f64));
    }
    let mut samples: Vec<[f64; 3]> = Vec::with_capacity(items.len());
    for item in items {
        let sample = sample(&item)?;
        if samples.last().is_some_and(|before| before[0] >= sample[0]) {
            let what = format!("{:?} s is not after the sample before it", sample[0]);
            return Err(item.refuse(
                ErrorKind::OutOfRange,
                what,
                "write samples in the order of time, one for each time",
            ));
        }
        samples.push(sample);
    }
    Ok(samples)
}

fn sample(at: &At<'_>) -> Result<[f64; 3], Error> {
    let parts = at.items("[t, x, y]")?;
    let [time, x, y] = parts.as_slice() else {
        let what = format!("found a list of {}", parts.len());
        return Err(at
            .refuse(ErrorKind::WrongCount, what, "write [t, x, y]")
            .with("count", parts.len() as f64));
    };
    Ok([time.number(&TIME)?, x.number(&PLACE)?, y.number(&PLACE)?])
}

/// `track` as a shot file has it.
pub(super) fn write(track: &[FilmedBall]) -> Node {
    Node::list(track.iter().map(|FilmedBall { ball, samples }| {
        let samples = Node::list(samples.iter().copied());
        Node::object([("ball", ball.into()), ("samples", samples)])
    }))
}
