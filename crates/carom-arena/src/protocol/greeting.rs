//! What a program says of itself before the first request.

use carom::format::{Node, Reader};
use carom::{Error, ErrorKind};
use carom_rules::Game;

/// The protocol's name, with its version.
pub const PROTOCOL: &str = "carom-arena/1";

/// The name and the version of a program, and its wishes: its `hello`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Greeting {
    /// Its name.
    pub name: String,
    /// Its version.
    pub version: String,
    pub(super) wishes: Wishes,
}

/// What a program wishes that requests have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Wishes {
    /// The table in words.
    pub(super) text: bool,
    /// The JSON Schema of the answer.
    pub(super) schema: bool,
}

impl Wishes {
    /// The keys of `options` in the `hello` of a program.
    pub(super) const KEYS: [&str; 2] = ["text", "schema"];
}

/// The `hello` of a program that is to play `game`.
pub(super) fn read(message: &Reader<'_>, game: Game) -> Result<Greeting, Error> {
    expect(message, "hello")?;
    if let Some(protocol) = message.get("protocol") {
        let found = protocol.text(PROTOCOL)?;
        if found != PROTOCOL {
            let remedy = format!("speak \"{PROTOCOL}\"");
            let what = format!("this referee does not speak \"{found}\"");
            return Err(protocol.refuse(ErrorKind::Format, what, remedy));
        }
    }
    if let Some(games) = message.get("games") {
        let names = games.items("a list of games")?;
        if !names.iter().any(|name| matches!(name.node(), Node::Text(text) if text == game.name()))
        {
            let what = format!("the program does not play {}", game.name());
            let remedy = "play a game that it has, or leave the key out";
            return Err(games.refuse(ErrorKind::Unsupported, what, remedy));
        }
    }
    let text = |key: &str, example: &str| {
        let known = message.get(key).map(|value| value.text(example).map(str::to_owned));
        known.unwrap_or_else(|| Ok(String::new()))
    };
    let options = message.get("options");
    let wish = |key: &str| {
        let option = options.as_ref().and_then(|options| options.get(key));
        option.map_or(Ok(false), |option| option.flag())
    };
    let [in_words, schema] = Wishes::KEYS;
    let wishes = Wishes { text: wish(in_words)?, schema: wish(schema)? };
    Ok(Greeting { name: text("name", "a name")?, version: text("version", "a version")?, wishes })
}

/// Checks the type of a message.
pub(super) fn expect(message: &Reader<'_>, wanted: &'static str) -> Result<(), Error> {
    let kind = message.require("type", &format!("\"type\": \"{wanted}\""))?;
    let found = kind.text(&format!("\"{wanted}\""))?;
    if found == wanted {
        return Ok(());
    }
    let what = format!("found \"{found}\" before \"{wanted}\"");
    Err(kind.refuse(ErrorKind::WrongState, what, format!("write \"{wanted}\" first")))
}
