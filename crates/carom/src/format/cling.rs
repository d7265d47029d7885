//! The `cling` of a shot file: which contacts of two balls cling.

use alloc::format;

use super::node::Node;
use super::read::At;
use crate::error::{Error, ErrorKind};
use crate::physics::ball_surface::CHALKED;
use crate::physics::quantities::FRICTION;
use crate::shot::{Cling, MOST_CONTACTS};

/// Reads `cling`: the list `contacts`, and optionally `friction`.
pub(super) fn read(at: &At<'_>) -> Result<Cling, Error> {
    let fields = at.fields(&["contacts", "friction"])?;
    let mut friction = CHALKED;
    fields.number_into("friction", &FRICTION, &mut friction)?;
    let wanted = "a list of contacts, such as [0, 3]";
    let mut cling = Cling::NONE;
    for item in fields.require("contacts", wanted)?.items(wanted)? {
        let contact = item.whole(0, MOST_CONTACTS - 1)?;
        if cling.contains(contact) {
            return Err(item.refuse(
                ErrorKind::Duplicate,
                format!("contact {contact} is listed twice"),
                "remove one",
            ));
        }
        cling = Cling::new(cling.contacts().chain([contact]), friction);
    }
    Ok(cling)
}

impl Cling {
    /// Reads the `cling` of a shot file from a tree of values.
    ///
    /// # Errors
    /// [`Error::Input`] for everything that a shot file could not have there.
    pub fn from_node(node: &Node) -> Result<Self, Error> {
        read(&At::root(node)).map_err(|error| error.inside("cling"))
    }

    /// The `cling` of a shot file; it reads back to the same contacts and the same friction.
    pub fn to_node(&self) -> Node {
        write(self)
    }
}

/// `cling` as a shot file has it.
pub(super) fn write(cling: &Cling) -> Node {
    let contacts = Node::list(cling.contacts());
    if cling.is_empty() {
        return Node::object([("contacts", contacts)]);
    }
    Node::object([("contacts", contacts), ("friction", cling.friction().into())])
}
