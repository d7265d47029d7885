//! What the referee tells the supervisor to start.

use std::path::PathBuf;
use std::time::Duration;

use carom::Error;
use carom::format::{Node, Reader};

use super::confinement::Confinement;
use super::control_group::ControlGroup;
use super::limits::ProgramLimits;

/// How long a program may take to end after its input is closed, and again after SIGTERM.
const GRACE: Duration = Duration::from_millis(200);

/// A program to start, and what is enforced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramOrder {
    /// The program and its arguments.
    pub words: Vec<String>,
    /// What it may use.
    pub limits: ProgramLimits,
    /// What separates it from the rest of the machine.
    pub confinement: Confinement,
    /// Files that it must not read, if the confinement covers files: the secret of the match.
    pub hidden: Vec<PathBuf>,
    /// How long it may take to end after its input is closed, and again after SIGTERM.
    pub grace: Duration,
    /// Whether a control group limits it.
    pub grouped: bool,
}

impl ProgramOrder {
    /// A program with the default limits and this confinement, in a control group where these work.
    pub fn new(words: Vec<String>, confinement: Confinement) -> Self {
        let limits = ProgramLimits::default();
        let grouped = ControlGroup::works();
        Self { words, limits, confinement, hidden: Vec::new(), grace: GRACE, grouped }
    }

    /// The order as the supervisor gets it.
    pub(super) fn to_node(&self) -> Node {
        let hidden = self.hidden.iter().map(|path| path.display().to_string());
        Node::object([
            ("words", Node::list(&self.words)),
            ("limits", self.limits.to_node()),
            ("confinement", self.confinement.name().into()),
            ("hidden", Node::list(hidden)),
            ("grace", self.grace.as_secs_f64().into()),
            ("grouped", self.grouped.into()),
        ])
    }

    /// Reads what [`Self::to_node`] wrote.
    pub(super) fn read(node: &Node) -> Result<Self, Error> {
        let reader = Reader::new(node, "");
        let texts = |key| -> Result<Vec<String>, Error> {
            let items = reader.require(key, "a list")?.items("a list")?;
            items.iter().map(|item| item.text("a text").map(String::from)).collect()
        };
        let confinement = reader.require("confinement", "a name")?;
        let name = confinement.text("a name")?;
        let known = Confinement::ALL.map(Confinement::name);
        let Some(named) = Confinement::ALL.into_iter().find(|each| each.name() == name) else {
            return Err(confinement.unknown_word(name, "confinement", &known));
        };
        let grace = reader.require("grace", "a number")?.number()?;
        Ok(Self {
            words: texts("words")?,
            limits: ProgramLimits::read(&reader.require("limits", "an object")?)?,
            confinement: named,
            hidden: texts("hidden")?.into_iter().map(PathBuf::from).collect(),
            grace: Duration::try_from_secs_f64(grace).unwrap_or(GRACE),
            grouped: reader.require("grouped", "true or false")?.flag()?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_reads_back() {
        let mut order =
            ProgramOrder::new(vec!["a b".into(), "é\n".into()], Confinement::Bubblewrap);
        order.hidden = vec!["/a/secret".into()];
        for address_space in [None, Some(1 << 40)] {
            order.limits.address_space = address_space;
            order.grouped = address_space.is_some();
            let line = order.to_node().to_json_line();
            assert_eq!(ProgramOrder::read(&Node::from_json(&line).unwrap()).unwrap(), order);
        }
    }
}
