//! Chances of a strike that a player intends, on the shot's table or on drawn ones.

use carom::format::{Node, repaired};
use carom::noise::Perception;
use carom::{Error, Noise};
use carom_plan::{
    Chance, ChanceByTable, DrawnTables, ErrorModel, Evaluation, Moments, Progress, Referee,
    ResultCounts, Watched, check_level,
};
use carom_rules::Call;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::batch::read_json;
use crate::error::to_exception;
use crate::rules::Frame;
use crate::shot::Shot;

/// A shot file, JSON, with balls apart that overlap by at most `tolerance`, m.
#[wasm_bindgen(js_name = repairedFile)]
pub fn repaired_file(json: &str, tolerance: f64) -> Result<String, JsValue> {
    let found = Node::from_json(json).and_then(|file| repaired(&file, tolerance));
    found.map(|(file, _)| file.to_json()).map_err(|e| to_exception(&e))
}

/// The chance of a result, JSON as `Chance.to_dict` of Python, from pairs of the number of variants in
/// which it happened and the number of all, one for each table.
#[wasm_bindgen(js_name = chanceOf)]
pub fn chance_of(pairs: &[f64], level: f64) -> Result<String, JsValue> {
    check_level(level).map_err(|e| to_exception(&e))?;
    let (pairs, _) = pairs.as_chunks::<2>();
    let one = |&[met, variants]: &[f64; 2]| Chance { met: met as u64, variants: variants as u64 };
    let chance = ChanceByTable(pairs.iter().map(one).collect());
    let interval = chance.interval(level);
    let mut node = Node::object([
        ("probability", number(chance.total().share())),
        ("low", interval.low.into()),
        ("high", interval.high.into()),
    ]);
    let spread = chance.spread();
    if !spread.is_nan() {
        node.set("spread", spread);
    }
    Ok(node.to_json())
}

/// A question about the strike of a shot.
#[wasm_bindgen]
pub struct Question {
    model: ErrorModel,
    watched: Option<(String, Option<String>)>,
    tables: Vec<carom::Shot>,
    referee: Option<(carom_rules::Frame, Call)>,
}

#[wasm_bindgen]
impl Question {
    /// The errors, JSON; the seed and the largest number of variants; the level of the intervals, and
    /// half the width at which counting stops.
    #[wasm_bindgen(constructor)]
    pub fn new(
        noise: &str,
        perception: Option<String>,
        seed: u64,
        variants: u64,
        level: f64,
        half_width: Option<f64>,
    ) -> Result<Self, JsValue> {
        let read = || {
            let noise = read_json(noise, "noise", Noise::read)?;
            let perception = match &perception {
                Some(json) => read_json(json, "perception", Perception::read)?,
                None => Perception::default(),
            };
            let model = ErrorModel { noise, perception, seed, variants, half_width, level };
            Ok(Self { model, watched: None, tables: Vec::new(), referee: None })
        };
        read().map_err(|e: Error| to_exception(&e))
    }

    /// The chance whose precision ends the count: a ball, a ball and a pocket, `scratch` or `legal`.
    pub fn watch(&mut self, name: String, pocket: Option<String>) {
        self.watched = Some((name, pocket));
    }

    /// Adds the shot on a table that may be the true one.
    pub fn push(&mut self, shot: &Shot) {
        self.tables.push(carom::Shot::clone(inner(shot)));
    }

    /// Sets the game in which the shot is played, and the call.
    pub fn referee(
        &mut self,
        frame: &Frame,
        kind: &str,
        ball: Option<String>,
        pocket: Option<String>,
    ) -> Result<(), JsValue> {
        let call = frame.0.call(kind, ball.as_deref(), pocket.as_deref());
        self.referee = Some((frame.0.clone(), call.map_err(|e| to_exception(&e))?));
        Ok(())
    }
}

fn inner(shot: &Shot) -> &carom::Shot {
    shot.0.shot()
}

#[wasm_bindgen]
impl Frame {
    /// A shot on the frame's table with its physics; its balls are not those of the frame.
    pub fn base(&self) -> Shot {
        self.0.base().clone().into()
    }
}

#[wasm_bindgen]
impl Shot {
    /// Whether both are the same shot, however their files are written.
    pub fn equals(&self, other: &Shot) -> bool {
        inner(self) == inner(other)
    }

    /// The counts of the variants of the strike, JSON.
    pub fn evaluate(&self, question: &Question) -> Result<String, JsValue> {
        evaluate(inner(self), question).map(|node| node.to_json()).map_err(|e| to_exception(&e))
    }
}

fn evaluate(shot: &carom::Shot, question: &Question) -> Result<Node, Error> {
    let Question { model, watched, tables, referee } = question;
    let watched =
        watched.as_ref().map(|(name, pocket)| Watched::read(shot, name, pocket.as_deref()));
    let tables = match tables.as_slice() {
        [] => DrawnTables::default(),
        drawn => DrawnTables::new(drawn.to_vec())?,
    };
    let question = carom_plan::Question {
        model: model.clone(),
        tables,
        watched: watched.transpose()?.unwrap_or_default(),
        referee: referee.as_ref().map(|(frame, call)| Referee { frame, call: *call }),
        ..Default::default()
    };
    carom_plan::evaluate(shot, &question, &Progress::default()).map(|found| node_of(&found))
}

fn node_of(found: &Evaluation) -> Node {
    let mut node = counts_node(&found.counts);
    let row = |row: [f64; 2]| Node::list(row.map(number));
    let covariance = |ends: &Moments| {
        let [xx, xy, yy] = ends.covariance();
        Node::List(vec![row([xx, xy]), row([xy, yy])])
    };
    let failure = found.first_failure.as_ref();
    node.set("first_failure", failure.map_or(Node::Null, |error| error.to_string().into()));
    node.set("cue_ball", found.cue_ball as f64);
    node.set("at_rest", Node::list(found.ends.iter().map(|ends| count(ends.count()))));
    node.set("end_mean", Node::list(found.ends.iter().map(|ends| row(ends.mean()))));
    node.set("end_covariance", Node::list(found.ends.iter().map(covariance)));
    node.set("by_table", Node::list(found.by_table.iter().map(counts_node)));
    node
}

fn counts_node(counts: &ResultCounts) -> Node {
    let pockets = counts.pockets;
    let row = |ball| counts.potted[ball * pockets..][..pockets].iter().copied().map(count);
    let rows = (0..counts.off_table.len()).map(|ball| Node::list(row(ball)));
    Node::object([
        ("n", count(counts.variants)),
        ("failed", count(counts.failed)),
        ("potted", Node::list(rows)),
        ("off_table", Node::list(counts.off_table.iter().copied().map(count))),
        ("legal", counts.legal.map_or(Node::Null, count)),
        ("turn_kept", counts.turn_kept.map_or(Node::Null, count)),
    ])
}

fn count(count: u64) -> Node {
    (count as f64).into()
}

/// A number; null for NaN, which JSON does not have.
fn number(x: f64) -> Node {
    if x.is_nan() { Node::Null } else { x.into() }
}
