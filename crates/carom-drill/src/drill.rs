//! Drill files, `carom-drill/1`: steps with layouts and goals, and how they score.

use carom::format::{Node, Reader};
use carom::math::{atan2, degrees};
use carom::{Error, ErrorKind, Shot, Table};

use crate::area::{DrillArea, point};
use crate::goal::DrillGoal;
use crate::goal_file::bounded;

/// The value of `format` in a drill file.
pub const DRILL_FORMAT: &str = "carom-drill/1";

/// The most bytes, steps, balls of a step, and attempts of a file; characters of its name and of a text.
const LARGEST: usize = 256 * 1024;
const MOST_STEPS: usize = 30;
const MOST_BALLS: usize = 32;
const MOST_ATTEMPTS: i64 = 100;
const LONGEST_NAME: usize = 100;
const LONGEST_TEXT: usize = 2000;

/// Speed of the cue with which the aim begins if the file gives none, m/s.
const SPEED: f64 = 1.6;

/// Which step the next attempt has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DrillOrder {
    /// Always the first one.
    Same,
    /// The next one after success, the one before after a failure.
    Ladder,
    /// One step after another.
    Turns,
}

impl DrillOrder {
    /// Every order.
    pub const ALL: [Self; 3] = [Self::Same, Self::Ladder, Self::Turns];

    /// Its name in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Same => "same",
            Self::Ladder => "ladder",
            Self::Turns => "turns",
        }
    }

    /// The step of the next attempt, after one at `step` of `steps` that was made or missed.
    pub const fn next(self, step: usize, steps: usize, made: bool) -> usize {
        match self {
            Self::Same => step,
            Self::Turns => (step + 1) % steps,
            Self::Ladder if made && step + 1 < steps => step + 1,
            Self::Ladder if made => step,
            Self::Ladder => step.saturating_sub(1),
        }
    }
}

/// A layout with its goal.
#[derive(Clone, Debug)]
pub struct DrillStep {
    /// The layout, with a strike at the first object ball.
    pub shot: Shot,
    /// Where the cue ball may be placed before the first shot; by default it stays where it is.
    pub hand: Option<DrillArea>,
    /// What an attempt must do.
    pub goal: DrillGoal,
}

/// A drill.
#[derive(Clone, Debug)]
pub struct Drill {
    /// Its name.
    pub name: String,
    /// What to do, for players; may be empty.
    pub text: String,
    /// The name of the table's preset.
    pub table: String,
    /// Number of attempts.
    pub attempts: u32,
    /// After this number of misses the drill ends early.
    pub misses: Option<u32>,
    /// Which step comes next.
    pub order: DrillOrder,
    /// The steps.
    pub steps: Vec<DrillStep>,
}

impl Drill {
    /// Reads a drill file.
    ///
    /// # Errors
    /// [`Error::Input`] with the place of what is wrong; and for a file larger than 256 kB.
    pub fn from_json(text: &str) -> Result<Self, Error> {
        if text.len() > LARGEST {
            let what = format!("the file has {} bytes", text.len());
            let remedy = format!("write at most {LARGEST} bytes");
            return Err(ErrorKind::WrongCount.at("", what, remedy));
        }
        Self::from_node(&Node::from_json(text)?)
    }

    /// The drill with these plain values.
    ///
    /// # Errors
    /// [`Error::Input`] with the place of what is wrong.
    pub fn from_node(node: &Node) -> Result<Self, Error> {
        let at = Reader::new(node, "");
        at.keys(&[
            "format", "name", "text", "table", "cue", "attempts", "misses", "order", "steps",
        ])?;
        let format = at.require("format", "\"carom-drill/1\"")?;
        if format.text("\"carom-drill/1\"")? != DRILL_FORMAT {
            let remedy = format!("take a file with the format \"{DRILL_FORMAT}\"");
            return Err(format.refuse(ErrorKind::Format, "this version does not read it", remedy));
        }
        let name = text_of(&at.require("name", "\"My drill\"")?, LONGEST_NAME)?;
        let text = at.get("text").map_or(Ok(String::new()), |text| text_of(&text, LONGEST_TEXT))?;
        let table_at = at.require("table", "\"wpa-9ft\"")?;
        let table = table_at.text("the name of a table")?;
        if Table::preset(table).is_none() {
            return Err(table_at.unknown_word(table, "table", &carom::table::PRESETS));
        }
        let cue = at.get("cue").map_or(Ok("cue"), |cue| cue.text("the id of the cue ball"))?;
        let attempts = at.require("attempts", "10")?.whole(1, MOST_ATTEMPTS)? as u32;
        let misses = at.get("misses").map(|misses| misses.whole(1, MOST_ATTEMPTS)).transpose()?;
        let order = at.get("order").map_or(Ok(DrillOrder::Same), |order| read_order(&order))?;
        let list = at.require("steps", "a list of steps")?;
        let steps = bounded(&list, MOST_STEPS)?;
        if steps.is_empty() {
            let remedy = "write at least one step";
            return Err(list.refuse(ErrorKind::Missing, "the drill has no steps", remedy));
        }
        let steps =
            steps.iter().map(|step| read_step(step, table, cue)).collect::<Result<_, _>>()?;
        let misses = misses.map(|misses| misses as u32);
        Ok(Self { name, text, table: table.into(), attempts, misses, order, steps })
    }

    /// The plain values; they read back to the same drill.
    pub fn to_node(&self) -> Node {
        let mut node =
            Node::object([("format", DRILL_FORMAT.into()), ("name", (&self.name).into())]);
        if !self.text.is_empty() {
            node.set("text", &self.text);
        }
        node.set("table", &self.table);
        node.set("cue", self.steps[0].cue());
        node.set("attempts", self.attempts);
        if let Some(misses) = self.misses {
            node.set("misses", misses);
        }
        node.set("order", self.order.name());
        node.set("steps", Node::list(self.steps.iter().map(DrillStep::to_node)));
        node
    }
}

impl DrillStep {
    /// The id of the cue ball.
    pub fn cue(&self) -> &str {
        self.shot.strike().map_or("", |(ball, _)| &self.shot.balls()[ball].id)
    }

    fn to_node(&self) -> Node {
        let file = self.shot.to_node();
        let balls = file.get("balls").cloned().unwrap_or(Node::Null);
        let mut node = Node::object([("balls", balls)]);
        if let Some(hand) = &self.hand {
            node.set("hand", hand.to_node());
        }
        if let Some((_, strike)) = self.shot.strike()
            && strike.speed != SPEED
        {
            node.set("speed", strike.speed);
        }
        node.set("goal", self.goal.to_node());
        node
    }
}

fn text_of(at: &Reader<'_>, longest: usize) -> Result<String, Error> {
    let text = at.text("a text")?;
    let count = text.chars().count();
    if count > longest {
        let what = format!("the text has {count} characters");
        return Err(at.refuse(ErrorKind::WrongCount, what, format!("write at most {longest}")));
    }
    Ok(text.into())
}

fn read_order(at: &Reader<'_>) -> Result<DrillOrder, Error> {
    let word = at.text("the order of the steps")?;
    let known = DrillOrder::ALL.map(DrillOrder::name);
    let order = DrillOrder::ALL.into_iter().find(|order| order.name() == word);
    order.ok_or_else(|| at.unknown_word(word, "order", &known))
}

fn read_step(at: &Reader<'_>, table: &str, cue: &str) -> Result<DrillStep, Error> {
    at.keys(&["balls", "hand", "speed", "goal"])?;
    let shot = read_layout(at, table, cue)?;
    let hand = at.get("hand").map(|hand| DrillArea::read(&hand)).transpose()?;
    let goal_at =
        at.require("goal", "{\"kind\": \"shot\", \"needs\": [{\"kind\": \"pot-any\"}]}")?;
    let goal = DrillGoal::read(&goal_at)?;
    goal.check(goal_at.place(), &shot)?;
    Ok(DrillStep { shot, hand, goal })
}

/// The balls of a step, with a strike at the first object ball.
fn read_layout(at: &Reader<'_>, table: &str, cue: &str) -> Result<Shot, Error> {
    let balls = at.require("balls", "[{\"id\": \"cue\", \"position\": [0.6, 0.6]}]")?;
    for ball in bounded(&balls, MOST_BALLS)? {
        // Balls at rest on the cloth, of the table's usual size.
        ball.keys(&["id", "position"])?;
        point(&ball.require("position", "[0.6, 0.6]")?)?;
    }
    let speed = at.get("speed").map_or(Ok(SPEED), |speed| speed.number())?;
    let strike = |azimuth: f64| {
        Node::object([
            ("ball", cue.into()),
            ("speed", speed.into()),
            ("azimuth_deg", azimuth.into()),
        ])
    };
    let mut file = Node::object([
        ("format", carom::format::SHOT_FORMAT.into()),
        ("table", table.into()),
        ("balls", balls.node().clone()),
        ("strike", strike(90.0)),
    ]);
    let place = |part: &str| format!("{}.{part}", at.place());
    let moved = |error: Error| {
        error
            .moved("balls", &place("balls"))
            .moved("strike.speed", &place("speed"))
            .moved("strike.ball", "cue")
    };
    let shot = Shot::from_node(&file).map_err(moved)?;
    let center = |ball: usize| shot.balls()[ball].state.position.xy();
    let first = (0..shot.balls().len()).find(|ball| Some(*ball) != shot.cue_ball());
    let (Some(cue), Some(first)) = (shot.cue_ball(), first) else { return Ok(shot) };
    let way = center(first) - center(cue);
    file.set("strike", strike((10.0 * degrees(atan2(way.y, way.x)) + 0.5).floor() / 10.0));
    Shot::from_node(&file).map_err(moved)
}
