//! What the referee writes: `hello`, `match`, `request`, `refused`, `over`, `bye`.
//!
//! No message has a seed, a record, or what the other player intended.

use carom::error::InputError;
use carom::format::Node;
use carom::noise::Perception;
use carom_rules::{Frame, Game, Seat};

use super::greeting::{PROTOCOL, Wishes};
use super::menu::Menu;
use super::text;
use crate::arena_frame::{ArenaFrame, Ask, LastShot};
use crate::record::{clock_node, disclosure_node, place, strike};
use crate::settings::Disclosure;

/// The parts of a table's geometry with which a program can aim. Pictures need more.
const GEOMETRY: [&str; 5] = ["size", "cushion_height", "cushions", "pockets", "markings"];

/// The first message: the protocol, the referee, its games, and what a program may wish.
pub(super) fn hello() -> Node {
    Node::object([
        ("type", "hello".into()),
        ("protocol", PROTOCOL.into()),
        ("name", "carom".into()),
        ("version", env!("CARGO_PKG_VERSION").into()),
        ("games", Node::list(Game::ALL.map(Game::name))),
        ("options", Node::list(Wishes::KEYS)),
    ])
}

/// What the players of a frame have agreed on, as the player who is asked may know it.
pub(super) fn match_message(ask: &Ask<'_>, menu: &Menu) -> Node {
    let settings = ask.of.settings();
    let frame = ask.situation.frame;
    let setup = ask.of.recorded_setup();
    let table = frame.base().table().to_node();
    let geometry =
        GEOMETRY.into_iter().filter_map(|key| Some((key.to_owned(), table.get(key)?.clone())));
    let balls = frame.layout().balls().iter().map(|known| {
        let sizes = [("radius", known.ball.radius), ("mass", known.ball.mass)];
        (known.id.clone(), Node::object(sizes.map(|(key, value)| (key, value.into()))))
    });
    let perception = match settings.disclosure {
        Disclosure::Nothing => None,
        _ => Some(Perception::to_node(&ask.situation.perception)),
    };
    let mut node = Node::object([
        ("type", "match".into()),
        ("game", settings.game.name().into()),
        ("options", settings.options.to_node()),
        ("table", setup.get("table").cloned().into()),
        ("physics", setup.get("physics").cloned().into()),
        ("geometry", Node::Object(geometry.collect())),
        ("balls", Node::Object(balls.collect())),
        ("frame", whole(ask.frame_number)),
        ("seat", seat_node(ask.seat)),
        ("disclosure", disclosure_node(settings.disclosure)),
        ("noise", noise_node(ask)),
        ("perception", perception.into()),
        ("clocks", clocks_node(ask)),
        ("refusals", crate::REFUSALS.into()),
    ]);
    if menu.is_wanted() {
        node.set("menu", menu.settings_node());
    }
    node
}

/// What is asked, with number `id`.
pub(super) fn request(ask: &Ask<'_>, id: i64, wishes: Wishes, menu: &Menu) -> Node {
    let frame = ask.situation.frame;
    let mut node = Node::object([
        ("type", "request".into()),
        ("id", id.into()),
        ("frame", whole(ask.frame_number)),
        ("seat", seat_node(ask.seat)),
    ]);
    // The keys of the frame's request (kind, choices, cue_ball, in_hand, on, calls) are those of the
    // message.
    if let Some(Node::Object(asked)) = frame.entry("request") {
        for (key, value) in asked.into_iter().filter(|(key, _)| key != "player") {
            node.set(&key, value);
        }
    }
    if let Some(turn) = frame.turn() {
        node.set("opening", frame.is_opening());
        if let Some(region) = turn.hand {
            let table = frame.base().table();
            let bounds = region.bounds(table).map(Node::from);
            node.set(
                "region",
                Node::object([
                    ("name", region.name().into()),
                    ("bounds", Node::list(bounds)),
                    ("limits", region.limits(table).into()),
                ]),
            );
        }
    }
    for key in ["balls", "scores", "fouls_in_a_row", "shots", "state"] {
        node.set(key, frame.entry(key));
    }
    node.set("noise", noise_node(ask));
    node.set("clocks", clocks_node(ask));
    node.set("budget", ask.budget);
    node.set("last", ask.last.as_ref().map(|last| last_node(frame, last)));
    if menu.is_wanted() {
        node.set("menu", menu.to_node(frame));
    }
    if wishes.schema {
        node.set("schema", frame.answer_schema());
    }
    if wishes.text {
        node.set("text", text::describe(ask, menu));
    }
    node
}

/// The refusal of an answer with number `id`.
pub(super) fn refused(id: Option<i64>, fault: &InputError) -> Node {
    Node::object([
        ("type", "refused".into()),
        ("id", id.into()),
        ("place", (&fault.place).into()),
        ("what", (&fault.what).into()),
        ("remedy", (&fault.remedy).into()),
    ])
}

/// The end of a frame; `None` while it goes on.
pub(super) fn over(frame: &ArenaFrame) -> Option<Node> {
    let end = frame.end()?;
    let points = end.points().map(|of_seat_0| [of_seat_0, 1.0 - of_seat_0]);
    let last = LastShot::of(frame.moves());
    Some(Node::object([
        ("type", "over".into()),
        ("frame", whole(frame.number())),
        ("winner", end.winner.map(seat_node).into()),
        ("points", points.map(Node::from).into()),
        ("reason", end.reason.name().into()),
        ("why", (&end.why).into()),
        ("scores", Node::list(frame.frame().scores().map(i64::from))),
        ("last", last.map(|last| last_node(frame.frame(), &last)).into()),
    ]))
}

/// The last message.
pub(super) fn bye() -> Node {
    Node::object([("type", "bye".into())])
}

fn last_node(frame: &Frame, last: &LastShot<'_>) -> Node {
    let mut node =
        Node::object([("seat", seat_node(last.seat)), ("strike", strike(&last.execution.strike))]);
    if let Some(at) = last.execution.cue_ball {
        node.set("cue_ball", place(at));
    }
    if let Some(call) = frame.call_node(last.call) {
        node.set("call", call);
    }
    node.set("ruling", frame.ruling_node(last.ruling));
    node.set("choice", last.choice.map(|choice| choice.name()));
    node
}

/// The errors of the strikes of both seats; null for those that the player may not know.
fn noise_node(ask: &Ask<'_>) -> Node {
    let told = |seat: Seat| match ask.of.settings().disclosure {
        Disclosure::Both => true,
        Disclosure::Own => seat == ask.seat,
        Disclosure::Nothing => false,
    };
    let of = |seat: Seat| told(seat).then(|| ask.situation.noise[seat].to_node());
    Node::list([0, 1].map(of))
}

/// The clocks of both seats, and what is left on those of a frame.
fn clocks_node(ask: &Ask<'_>) -> Node {
    let players = ask.of.seats(ask.frame_number);
    Node::list([0, 1].map(|seat: Seat| {
        let mut node = clock_node(&ask.of.settings().clock[players[seat]]);
        if let Some(left) = ask.left[seat] {
            node.set("left", left);
        }
        node
    }))
}

fn seat_node(seat: Seat) -> Node {
    Node::Integer(seat as i64)
}

fn whole(n: u64) -> Node {
    Node::Integer(i64::try_from(n).unwrap_or(i64::MAX))
}
