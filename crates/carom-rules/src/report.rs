//! Frames and rulings as trees of values with the balls' ids, for the bindings; and balls, pockets
//! and calls by their names.

use carom::format::Node;
use carom::table::PocketName;
use carom::{Error, ErrorKind};

use crate::carom_way::CaromCount;
use crate::frame::Frame;
use crate::layout::BallIndex;
use crate::play::Call;
use crate::request::{Request, Turn};
use crate::ruling::Ruling;

fn carom_node(count: CaromCount) -> Node {
    let number = |count: u8| Node::from(u32::from(count));
    Node::object([
        ("balls", number(count.balls)),
        ("cushions", number(count.cushions)),
        ("needed", number(count.needed)),
        ("stayed", count.stayed.into()),
    ])
}

/// The keys of a frame's plain values, in their order.
const KEYS: [&str; 7] = ["game", "request", "scores", "fouls_in_a_row", "shots", "balls", "state"];

impl Frame {
    /// The frame: game, request, scores, balls.
    pub fn to_node(&self) -> Node {
        let entries = KEYS.into_iter().filter_map(|key| Some((key.to_owned(), self.entry(key)?)));
        Node::Object(entries.collect())
    }

    /// The value under one of the keys of [`Self::to_node`]; `None` for another key.
    pub fn entry(&self, key: &str) -> Option<Node> {
        Some(match key {
            "game" => self.game().name().into(),
            "request" => self.request_node(),
            "scores" => Node::list(self.scores().map(i64::from)),
            "fouls_in_a_row" => Node::list(self.fouls_in_a_row().map(i64::from)),
            "shots" => i64::from(self.shots()).into(),
            "balls" => {
                let balls = self.layout().on_table().filter_map(|ball| {
                    Some((self.id(ball).to_owned(), Node::from(self.layout().place(ball)?)))
                });
                Node::Object(balls.collect())
            }
            "state" => self.game_state_node(),
            _ => return None,
        })
    }

    /// A ruling of this frame; `carom` only in games without pockets.
    pub fn ruling_node(&self, ruling: &Ruling) -> Node {
        let fouls = ruling.fouls.iter().map(|foul| {
            Node::object([("what", foul.words().into()), ("rule", self.facts().rule(foul).into())])
        });
        let mut node = Node::object([
            ("legal", ruling.is_legal().into()),
            ("fouls", Node::list(fouls)),
            ("points", Node::list(ruling.points.map(i64::from))),
            ("spotted", self.ids(&ruling.spotted)),
            ("racked", ruling.racked.into()),
        ]);
        if let Some(count) = ruling.carom {
            node.set("carom", carom_node(count));
        }
        node
    }

    /// The ball with this id.
    ///
    /// # Errors
    /// [`Error::Input`] at `place` if the frame has none.
    pub fn ball(&self, id: &str, place: &str) -> Result<BallIndex, Error> {
        let known = (0..).zip(self.layout().balls()).find(|(_, ball)| ball.id == id);
        known.map(|(i, _)| i).ok_or_else(|| {
            let ids: Vec<&str> = self.layout().balls().iter().map(|p| p.id.as_str()).collect();
            ErrorKind::UnknownBall
                .at(
                    place,
                    format!("no ball has the id \"{id}\""),
                    format!("write one of {}", ids.join(", ")),
                )
                .with("ball", id)
        })
    }

    /// The pocket with this name.
    ///
    /// # Errors
    /// [`Error::Input`] at `place` if the table has none.
    pub fn pocket(&self, name: &str, place: &str) -> Result<PocketName, Error> {
        let pockets = &self.base().table().pockets;
        let known = pockets.iter().map(|pocket| pocket.name).find(|pocket| pocket.name() == name);
        known.ok_or_else(|| {
            let names: Vec<&str> = pockets.iter().map(|pocket| pocket.name.name()).collect();
            ErrorKind::UnknownName
                .at(
                    place,
                    format!("there is no pocket \"{name}\""),
                    format!("write one of {}", names.join(", ")),
                )
                .with("name", name)
        })
    }

    /// The call named `kind`: `nothing`, `safety`, `push-out`, `pocket` (`ball` in `pocket`) or
    /// `on` (`ball`).
    ///
    /// # Errors
    /// [`Error::Input`] for another name, and for a ball or pocket that is missing or unknown.
    pub fn call(
        &self,
        kind: &str,
        ball: Option<&str>,
        pocket: Option<&str>,
    ) -> Result<Call, Error> {
        let ball = || self.ball(ball.unwrap_or_default(), "call.ball");
        match kind {
            "nothing" => Ok(Call::Nothing),
            "safety" => Ok(Call::Safety),
            "push-out" => Ok(Call::PushOut),
            "on" => Ok(Call::On(ball()?)),
            "pocket" => {
                Ok(Call::Pocket(ball()?, self.pocket(pocket.unwrap_or_default(), "call.into")?))
            }
            _ => Err(ErrorKind::UnknownName
                .at(
                    "call",
                    format!("\"{kind}\" is not a call"),
                    "write nothing, safety, push-out, pocket or on",
                )
                .with("name", kind)),
        }
    }

    pub(crate) fn id(&self, ball: BallIndex) -> &str {
        &self.layout().balls()[usize::from(ball)].id
    }

    pub(crate) fn ids(&self, balls: &[BallIndex]) -> Node {
        Node::list(balls.iter().map(|ball| self.id(*ball)))
    }

    fn request_node(&self) -> Node {
        match self.request() {
            Request::Shot(turn) => self.turn_node(turn),
            Request::Choice { player, choices, why } => Node::object([
                ("kind", "choice".into()),
                ("player", (*player as i64).into()),
                ("choices", Node::list(choices.iter().map(|choice| choice.name()))),
                ("why", (*why).into()),
            ]),
            Request::Over { winner, why } => Node::object([
                ("kind", "over".into()),
                ("winner", winner.map(|player| player as i64).into()),
                ("why", (*why).into()),
            ]),
        }
    }

    fn turn_node(&self, turn: &Turn) -> Node {
        Node::object([
            ("kind", "shot".into()),
            ("player", (turn.player as i64).into()),
            ("cue_ball", self.id(turn.cue).into()),
            ("in_hand", turn.hand.map(|region| region.name()).into()),
            ("on", self.ids(&turn.on)),
            ("calls", Node::list(turn.calls.names())),
        ])
    }
}
