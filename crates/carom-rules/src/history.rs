//! A frame with its start and its moves, which a record keeps and which is played again from it.

use carom::format::{DefaultElevation, Node, PresetNames, Reader};
use carom::rack::Game;
use carom::shot::{Cling, StrikePolicy};
use carom::trace::ENGINE;
use carom::{Error, ErrorKind, ShotFile, Trace};

use crate::frame::{Frame, recorded_setup};
use crate::options::Options;
use crate::play::Play;
use crate::record::{FRAME_FORMAT, check_record};
use crate::region::Region;
use crate::request::{Choice, Turn};
use crate::ruling::Ruling;
use crate::seat::Seat;

/// The first whole number that JavaScript does not tell from its neighbour. Seeds from there on are
/// written in hexadecimal.
const SAFE: u64 = 1 << 53;

/// What to do with a record that cannot be read.
const REMEDY: &str = "give a record of a frame, as it was written";

/// A frame that keeps its start and its moves.
#[derive(Clone, Debug)]
pub struct FrameHistory {
    frame: Frame,
    setup: Node,
    moves: Vec<Node>,
}

impl FrameHistory {
    /// A new frame, as [`Frame::new`].
    ///
    /// # Errors
    /// As [`Frame::new`].
    pub fn new(
        game: Game,
        options: Options,
        table: Option<Node>,
        physics: Option<Node>,
        seed: u64,
    ) -> Result<Self, Error> {
        let frame = Frame::new(game, options, table.clone(), physics.clone(), seed)?;
        let mut setup = Node::object([("game", game.name().into())]);
        add(&mut setup, recorded_setup(game, table, physics));
        match i64::try_from(seed) {
            Ok(small) if seed < SAFE => setup.set("seed", small),
            _ => setup.set("seed", format!("{seed:016x}")),
        }
        add(&mut setup, options.to_node());
        Ok(Self { frame, setup, moves: Vec::new() })
    }

    /// A frame that starts from the balls of `shot`, as [`Frame::of_shot`].
    ///
    /// # Errors
    /// As [`Frame::of_shot`].
    pub fn of_shot(
        game: Game,
        options: Options,
        shot: &ShotFile,
        player: Option<Seat>,
    ) -> Result<Self, Error> {
        let frame = Frame::of_shot(game, options, shot, player)?;
        let file = shot.written(DefaultElevation::Written, PresetNames::Dated).into_owned();
        let mut setup = Node::object([("game", game.name().into()), ("shot", file)]);
        if frame.player() == Some(1) {
            setup.set("player", 1_u32);
        }
        add(&mut setup, options.to_node());
        Ok(Self { frame, setup, moves: Vec::new() })
    }

    /// The frame of a record, with every move repeated. The same version of the engine gives the same
    /// frame, to the bit. With another version a shot may end differently, and a later move may then
    /// be refused.
    ///
    /// # Errors
    /// [`Error::Input`] if it is not a record, and with the place of a move that is not allowed.
    pub fn replay(record: &Node) -> Result<Self, Error> {
        check_record(record)?;
        let root = Reader::new(record, "");
        let setup = root.require("setup", "the start of the frame")?;
        let mut history = Self::start(&setup)?;
        let moves = root.require("moves", "a list of moves")?.items("a list of moves")?;
        for (index, made) in moves.iter().enumerate() {
            if history.is_applied(made, index.checked_sub(1).and_then(|before| moves.get(before))) {
                continue;
            }
            history.make(made.node()).map_err(|error| {
                let place = format!("moves[{index}]");
                with_engine(error.inside(&place), root.get("engine").as_ref())
            })?;
        }
        Ok(history)
    }

    /// The frame at the start that `setup` describes.
    fn start(setup: &Reader<'_>) -> Result<Self, Error> {
        let game = setup.require("game", "\"nine-ball\"")?.text("the name of a game")?;
        let game = Game::read(game).map_err(|error| error.inside("setup"))?;
        let usual = Options::default();
        let whole = |key: &str, high: u32| {
            let value = setup.get(key).map(|value| value.whole(0, high.into()));
            Ok::<_, Error>(value.transpose()?.map(|value| value as u32))
        };
        let points = whole("points", i32::MAX as u32)?.or(whole("target", i32::MAX as u32)?);
        let options = Options {
            points: points.map_or(usual.points, |points| points as i32),
            miss: setup.get("miss").map_or(Ok(usual.miss), |miss| miss.flag())?,
            patience: whole("patience", u32::MAX)?.unwrap_or(usual.patience),
        };
        if let Some(shot) = setup.get("shot") {
            let shot = ShotFile::from_node(shot.node().clone());
            let player = whole("player", 1)?.unwrap_or_default() as Seat;
            let shot = shot.map_err(|e| e.inside("setup.shot"))?;
            return Self::of_shot(game, options, &shot, Some(player));
        }
        let part = |key: &str| {
            let value = setup.get(key).filter(|value| *value.node() != Node::Null);
            value.map(|value| value.node().clone())
        };
        Self::new(game, options, part("table"), part("physics"), read_seed(setup)?)
    }

    /// Whether the frame has already applied this choice of an old record. After a scratch on the
    /// break of eight-ball, frames used to ask for a choice with this one option.
    fn is_applied(&self, made: &Reader<'_>, before: Option<&Reader<'_>>) -> bool {
        let is_old = made.get("choice").is_some_and(|choice| {
            matches!(choice.node(), Node::Text(name) if name.as_str() == Choice::PlayFromHand.name())
        });
        let hand = self.frame.turn().and_then(|turn: &Turn| turn.hand);
        is_old
            && self.frame.game() == Game::EightBall
            && before.is_some_and(|before| before.get("play").is_some())
            && hand == Some(Region::BehindHeadString)
    }

    /// The frame as it stands.
    pub const fn frame(&self) -> &Frame {
        &self.frame
    }

    /// The moves so far, each with `play`, `choice` or `concede`.
    pub fn moves(&self) -> &[Node] {
        &self.moves
    }

    /// The record, `carom-frame/1`: the engine, the start of the frame and all its moves.
    pub fn record(&self) -> Node {
        Node::object([
            ("format", FRAME_FORMAT.into()),
            ("engine", ENGINE.into()),
            ("setup", self.setup.clone()),
            ("moves", Node::List(self.moves.clone())),
        ])
    }

    /// Plays a shot and rules on it.
    ///
    /// # Errors
    /// As [`Frame::play`]; the frame stays as it was.
    pub fn play(&mut self, play: &Play) -> Result<(Ruling, Trace), Error> {
        let made = Node::object([("play", self.frame.play_node(play))]);
        let trace = self.frame.shot(play)?.simulate()?;
        let ruling = self.frame.apply(play, &trace)?;
        self.moves.push(made);
        Ok((ruling, trace))
    }

    /// Answers the choice that the frame asks for.
    ///
    /// # Errors
    /// As [`Frame::choose`].
    pub fn choose(&mut self, choice: Choice) -> Result<Ruling, Error> {
        let ruling = self.frame.choose(choice)?;
        self.moves.push(Node::object([("choice", choice.name().into())]));
        Ok(ruling)
    }

    /// The player whose turn it is concedes.
    ///
    /// # Errors
    /// As [`Frame::concede`].
    pub fn concede(&mut self) -> Result<Ruling, Error> {
        let ruling = self.frame.concede()?;
        self.moves.push(Node::object([("concede", true.into())]));
        Ok(ruling)
    }

    /// Makes a move in the form of a record: `{"play": {"strike": …}}`, `{"choice": …}` or
    /// `{"concede": true}`. Returns the ruling, and the trace of a play.
    ///
    /// # Errors
    /// [`Error::Input`] with the place in the move; the frame stays as it was.
    pub fn make(&mut self, made: &Node) -> Result<(Ruling, Option<Trace>), Error> {
        let at = Reader::new(made, "");
        if let Some(play) = at.get("play") {
            at.keys(&["play", "variations"])?;
            let play = self.read_recorded(&Reader::new(play.node(), ""))?;
            return self.play(&play).map(|(ruling, trace)| (ruling, Some(trace)));
        }
        if let Some(choice) = at.get("choice") {
            at.keys(&["choice"])?;
            let choice = Choice::read(choice.text("the name of a choice")?)?;
            return self.choose(choice).map(|ruling| (ruling, None));
        }
        if at.get("concede").is_some_and(|concede| *concede.node() == Node::Bool(true)) {
            at.keys(&["concede"])?;
            return self.concede().map(|ruling| (ruling, None));
        }
        let what = "not a play, a choice or a concession";
        Err(ErrorKind::NotAMove.at("", what, "write {\"play\": {\"strike\": {...}}}"))
    }

    /// A play with the policies and the cling that a record has beside the strike.
    fn read_recorded(&self, at: &Reader<'_>) -> Result<Play, Error> {
        at.keys(&["strike", "cue_ball", "call", "cling"])?;
        let strike = at.require("strike", "an object with speed and azimuth")?;
        let word = |key: &str| {
            let value = strike.get(key).filter(|value| *value.node() != Node::Null);
            value.map(|value| value.text("report or refuse")).transpose()
        };
        let policy = StrikePolicy::from_names(
            word("obstruction")?.unwrap_or("report"),
            word("miscue")?.unwrap_or("refuse"),
        )?;
        let cling = at.get("cling").filter(|value| *value.node() != Node::Null);
        let cling = cling.map_or(Ok(Cling::NONE), |cling| Cling::from_node(cling.node()))?;
        Ok(Play { policy, cling, ..self.frame.read_play(at)? })
    }
}

/// Adds the fields of `more`, an object, to `node`.
fn add(node: &mut Node, more: Node) {
    if let Node::Object(fields) = more {
        for (key, value) in fields {
            node.set(&key, value);
        }
    }
}

/// The seed of the racks: a whole number, or 16 hexadecimal digits.
fn read_seed(setup: &Reader<'_>) -> Result<u64, Error> {
    let Some(seed) = setup.get("seed") else { return Ok(0) };
    let Node::Text(digits) = seed.node() else {
        return seed.whole(0, i64::MAX).map(i64::unsigned_abs);
    };
    let is_hex = |digit: u8| matches!(digit, b'0'..=b'9' | b'a'..=b'f');
    let read = Some(digits).filter(|digits| digits.len() == 16 && digits.bytes().all(is_hex));
    read.and_then(|digits| u64::from_str_radix(digits, 16).ok()).ok_or_else(|| {
        let what = format!("\"{digits}\" is not a seed");
        seed.refuse(ErrorKind::Syntax, what, "write 16 hexadecimal digits or a whole number")
    })
}

/// The error with the engine that made a record, if it is another one.
fn with_engine(error: Error, made: Option<&Reader<'_>>) -> Error {
    let (Error::Input(mut input), Some(Node::Text(made))) = (error.clone(), made.map(Reader::node))
    else {
        return error;
    };
    if made.as_str() != ENGINE {
        let remedy = if input.remedy.is_empty() { REMEDY } else { &input.remedy };
        input.remedy = format!("{remedy} (the record was made by {made}, and this is {ENGINE})");
    }
    Error::Input(input)
}
