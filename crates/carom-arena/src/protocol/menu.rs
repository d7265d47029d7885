//! Menu mode: numbered plays with their chances, to test strategy apart from aim.
//!
//! The plays are found by the searching player with a small budget, from what the player may know. The
//! clock of the program does not run meanwhile.

use carom::format::{Node, Reader};
use carom::math::sqrt;
use carom::{Error, ErrorKind, Simulator};
use carom_mind::search::PlayKind;
use carom_mind::{Answer, Budget, Recommendation, Searcher, Situation};
use carom_rules::{BallIndex, Choice, Frame, Play, Request};

use super::plays::play_node;

/// Simulated shots with which the plays of a menu are found: as many as level 3 has for a decision,
/// about 30 ms.
const SIMULATIONS: u32 = 600;

/// Most plays of a menu: more would have too few samples.
pub(crate) const MOST_PLAYS: u32 = 20;

/// The numbered answers of a request.
#[derive(Clone, Debug, Default)]
pub(super) struct Menu {
    /// The largest number of plays; 0 without a menu.
    plays: u32,
    items: Vec<Item>,
}

/// A numbered answer.
#[derive(Clone, Debug)]
enum Item {
    Play { name: String, of: Box<Recommendation> },
    Choice(Choice),
}

impl Menu {
    pub(super) const fn new(plays: u32) -> Self {
        Self { plays, items: Vec::new() }
    }

    pub(super) const fn is_wanted(&self) -> bool {
        self.plays > 0
    }

    /// Finds the items of a situation.
    ///
    /// # Errors
    /// As [`Searcher::analyse`].
    pub(super) fn fill(&mut self, situation: &Situation<'_>) -> Result<(), Error> {
        self.items.clear();
        if !self.is_wanted() {
            return Ok(());
        }
        match situation.frame.request() {
            Request::Shot(_) => {
                let budget = Budget::simulations(SIMULATIONS.into());
                let searcher = Searcher::default();
                let found = searcher.analyse(situation, &budget, self.plays as usize)?;
                self.items.extend(
                    found.plays.into_iter().map(|of| Item::Play {
                        name: name(situation.frame, &of),
                        of: Box::new(of),
                    }),
                );
            }
            Request::Choice { choices, .. } => {
                self.items.extend(choices.iter().copied().map(Item::Choice));
            }
            Request::Over { .. } => {}
        }
        Ok(())
    }

    /// The mode as a `match` message has it.
    pub(super) fn settings_node(&self) -> Node {
        Node::object([("plays", self.plays.into()), ("simulations", SIMULATIONS.into())])
    }

    /// The items as a request has them.
    pub(super) fn to_node(&self, frame: &Frame) -> Node {
        let items = (1_i64..).zip(&self.items);
        Node::list(items.map(|(number, item)| match item {
            Item::Play { name, of } => play_item(frame, number, name, of),
            Item::Choice(choice) => Node::object([
                ("item", number.into()),
                ("name", choice.words().into()),
                ("choice", choice.name().into()),
            ]),
        }))
    }

    /// The items as numbered lines.
    pub(super) fn lines(&self) -> impl Iterator<Item = String> {
        (1..).zip(&self.items).map(|(number, item)| match item {
            Item::Play { name, of } => format!("{number}. {}", in_words(name, of)),
            Item::Choice(choice) => format!("{number}. {}: {}", choice.name(), choice.words()),
        })
    }

    /// The answer that a `pick` names.
    ///
    /// # Errors
    /// [`Error::Input`] at `item`, or at `type` if the request has no menu.
    pub(super) fn read_pick(&self, at: &Reader<'_>) -> Result<Answer, Error> {
        let count = self.items.len();
        if count == 0 {
            let what = "the request has no menu";
            return Err(ErrorKind::WrongState.at("type", what, "answer with play or choose"));
        }
        let item = at.require("item", "the number of an item")?.whole(1, count as i64)?;
        Ok(match &self.items[item as usize - 1] {
            Item::Play { of, .. } => Answer::Play(of.play),
            Item::Choice(choice) => Answer::Choice(*choice),
        })
    }
}

fn play_item(frame: &Frame, number: i64, name: &str, of: &Recommendation) -> Node {
    let id = |ball: BallIndex| frame.layout().balls()[usize::from(ball)].id.as_str();
    let mut node = Node::object([
        ("item", number.into()),
        ("name", name.into()),
        ("kind", of.kind.name().into()),
        ("ball", of.pot.map(|(ball, _)| id(ball)).into()),
        ("pocket", of.pot.map(|(_, pocket)| pocket.name()).into()),
        ("win_chance", of.win.into()),
        ("kept", of.kept.share().into()),
        ("foul", of.foul.share().into()),
        ("samples", Node::Integer(of.kept.variants as i64)),
        ("play", play_node(frame, &of.play)),
    ]);
    let leave = (of.leave.count() > 0)
        .then(|| Node::object([("mean", of.leave.mean().into()), ("spread", spread(of).into())]));
    node.set("leave", leave);
    node
}

/// Root mean square distance of the cue ball from its mean place of rest, m; 0 for a single sample.
fn spread(of: &Recommendation) -> f64 {
    if of.leave.count() < 2 {
        return 0.0;
    }
    let [xx, _, yy] = of.leave.covariance();
    sqrt(xx + yy)
}

/// What is played, such as `bank: 3 into top-left`.
fn name(frame: &Frame, of: &Recommendation) -> String {
    let kind = of.kind.name();
    match of.pot {
        Some((ball, pocket)) => {
            let pot =
                format!("{} into {}", frame.layout().balls()[usize::from(ball)].id, pocket.name());
            if kind == "direct" { pot } else { format!("{kind}: {pot}") }
        }
        None if matches!(of.kind, PlayKind::Safety | PlayKind::Carom) => {
            match first_contact(frame, &of.play) {
                Some(id) => format!("{kind} off {id}"),
                None => kind.into(),
            }
        }
        None => kind.into(),
    }
}

/// The first ball that the cue ball meets without errors.
fn first_contact(frame: &Frame, play: &Play) -> Option<String> {
    let shot = frame.shot(play).ok()?;
    let trace = Simulator::new().record(&shot).ok()?;
    let ball = trace.outcome().first_contact?;
    shot.balls().get(usize::from(ball)).map(|ball| ball.id.clone())
}

fn in_words(name: &str, of: &Recommendation) -> String {
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    let strike = &of.play.strike;
    let mut words = format!(
        "{name}: win {}, turn kept {}, foul {}; cue {:.1} m/s, tip {:+.2} side, {:+.2} height",
        percent(of.win),
        percent(of.kept.share()),
        percent(of.foul.share()),
        strike.speed,
        strike.side,
        strike.height
    );
    if let Some([x, y]) = of.play.cue_ball {
        words += &format!("; cue ball placed at ({x:.3}, {y:.3})");
    }
    if of.leave.count() > 0 {
        let [x, y] = of.leave.mean();
        words += &format!("; cue ball comes to rest at ({x:.2}, {y:.2}) ± {:.2} m", spread(of));
    }
    words
}
