//! `carom-shot/1`: the shot file as a tree of values and as JSON.

use alloc::borrow::Cow;
use alloc::format;
use alloc::string::String;
use alloc::sync::Arc;
use alloc::vec::Vec;
use core::ops::Deref;

use super::dated::{with_dated_names, with_named_dated};
use super::key_path::KeyPath;
use super::marks::{self, TableMark};
use super::node::Node;
use super::read::At;
use super::track::{self, FilmedBall};
use super::{angle, balls, cling, physics, strike, table};
use crate::error::Error;
use crate::limits::MOST_EVENTS;
#[cfg(feature = "json")]
use crate::limits::MOST_SHOT_BYTES;
use crate::resolve::cue_ball::Strike;
use crate::shot::{
    Cling, DEFAULT_MAX_EVENTS, MovedBall, Parts, Shot, StrikePolicy, UNTIL, checked_balls,
};

/// The value of `format` in a shot file.
pub const SHOT_FORMAT: &str = "carom-shot/1";

/// A place inside every table (file coordinates, m).
const INSIDE: [f64; 2] = [0.25, 0.25];

const KEYS: &[&str] = &[
    "format",
    "table",
    "physics",
    "balls",
    "strike",
    "cling",
    "until",
    "max_events",
    "track",
    "marks",
];

/// What a written file says of an elevation that is the default.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DefaultElevation {
    /// Its value.
    Written,
    /// Nothing: what is read from the file has the default elevation again, also with other values.
    Omitted,
}

/// The names of presets in a written file ([`crate::edition`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PresetNames {
    /// As in the file that was read.
    AsRead,
    /// With dates, and the physics that belongs to the table is named: what a record keeps, so that it
    /// replays to the same bits when the presets have other values.
    Dated,
    /// With dates where the file has names. The physics that belongs to the table is not added: it
    /// follows if the table changes.
    DatedWhereNamed,
}

/// A shot with the file that it was read from. The file is written back unchanged, except that an
/// omitted elevation is written.
///
/// A [`Shot`] alone is written from its data. The result describes the same shot, but default
/// values are left out and presets are named.
#[derive(Clone, Debug)]
pub struct ShotFile {
    shot: Shot,
    /// The tree that was read; `None` if the file is written from the shot's data.
    source: Option<Arc<Node>>,
}

impl ShotFile {
    /// Reads a shot file.
    ///
    /// # Errors
    /// [`Error::Input`] for text that is not JSON and for everything that [`Self::from_node`]
    /// refuses.
    #[cfg(feature = "json")]
    pub fn from_json(text: &str) -> Result<Self, Error> {
        Self::from_node(Node::from_json_within(text, MOST_SHOT_BYTES)?)
    }

    /// Reads a shot from a tree of values.
    ///
    /// # Errors
    /// [`Error::Input`] with one sentence: the place, what is wrong there, and the remedy.
    pub fn from_node(node: Node) -> Result<Self, Error> {
        Ok(Self { shot: read(&node)?, source: Some(node.into()) })
    }

    /// The shot that the file describes.
    pub const fn shot(&self) -> &Shot {
        &self.shot
    }

    /// The file as a tree of values, as it was read, and with the elevation that is used.
    pub fn to_node(&self) -> Cow<'_, Node> {
        self.written(DefaultElevation::Written, PresetNames::AsRead)
    }

    /// The file as a tree of values.
    pub fn written(&self, elevation: DefaultElevation, names: PresetNames) -> Cow<'_, Node> {
        let mut node = match &self.source {
            Some(source) => Cow::Borrowed(&**source),
            None => Cow::Owned(self.shot.to_node()),
        };
        if self.shot.has_default_elevation()
            && let Some((_, strike)) = self.shot.strike()
            && let Some(written) = node.to_mut().get_mut("strike")
        {
            match elevation {
                DefaultElevation::Written => strike::write_elevation_into(written, &strike),
                DefaultElevation::Omitted => strike::remove_elevation(written),
            }
        }
        match names {
            PresetNames::AsRead => node,
            PresetNames::Dated => Cow::Owned(with_dated_names(&node)),
            PresetNames::DatedWhereNamed => Cow::Owned(with_named_dated(&node)),
        }
    }

    /// All values of the physics, merged over its base. A coefficient that the file gives as a formula
    /// or by the name of a surface keeps this form.
    pub fn physics_node(&self) -> Node {
        let own = self.source.as_ref().and_then(|source| source.get("physics"));
        physics::write_as_given(self.shot.physics(), own.unwrap_or(&Node::Null))
    }

    /// The name of the physics preset that belongs to the table: that of a file without `physics`.
    pub fn physics_of_table(&self) -> String {
        table::write(self.shot.table()).1
    }

    /// The file as JSON: what was read, number for number, and the elevation that is used.
    pub fn to_json(&self) -> String {
        self.to_node().to_json()
    }

    /// The same file with another strike on the same ball.
    ///
    /// # Errors
    /// As [`Shot::resolve_strike`].
    pub fn with_strike(&self, strike: &Strike) -> Result<Self, Error> {
        self.with_strike_of(self.shot.with_strike(strike)?)
    }

    /// The same file with another strike on the same ball, at the default elevation. The elevation
    /// of `strike` is not used.
    ///
    /// # Errors
    /// As [`Shot::resolve_strike`].
    pub fn with_default_elevation(&self, strike: &Strike) -> Result<Self, Error> {
        self.with_strike_of(self.shot.with_default_elevation(strike)?)
    }

    /// This file with the strike of `shot`, which is the same in everything else.
    fn with_strike_of(&self, shot: Shot) -> Result<Self, Error> {
        let Some(source) = &self.source else { return Ok(shot.into()) };
        let mut node = Node::clone(source);
        let mut written = node.get("strike").cloned().unwrap_or_else(|| Node::object([]));
        if let Some((ball, strike)) = shot.strike() {
            strike::write_into(&mut written, &shot.balls()[ball].id, &strike);
        }
        if shot.has_default_elevation() {
            strike::remove_elevation(&mut written);
        }
        node.set("strike", written);
        Ok(Self { shot, source: Some(node.into()) })
    }

    /// The same file in which other contacts cling.
    #[must_use]
    pub fn with_cling(&self, cling: Cling) -> Self {
        let shot = self.shot.with_cling(cling);
        let Some(source) = &self.source else { return shot.into() };
        let mut node = Node::clone(source);
        node.set("cling", cling::write(shot.cling()));
        Self { shot, source: Some(node.into()) }
    }

    /// Where a camera saw the balls; empty for a file without `track`.
    pub fn track(&self) -> Vec<FilmedBall> {
        let written = self.source.as_ref().and_then(|source| source.get("track"));
        // The file was checked when it was read.
        written.map_or_else(Vec::new, |node| {
            track::read(&At::root(node), self.shot.balls()).unwrap_or_default()
        })
    }

    /// The same file with another `track`; without one if `track` is empty.
    ///
    /// # Errors
    /// [`Error::Input`] for a track that a shot file could not have.
    pub fn with_track(&self, track: &[FilmedBall]) -> Result<Self, Error> {
        let mut node = self.written(DefaultElevation::Omitted, PresetNames::AsRead).into_owned();
        if track.is_empty() {
            node.remove("track");
        } else {
            node.set("track", track::write(track));
        }
        Self::from_node(node)
    }

    /// What is drawn on the table; empty for a file without `marks`.
    pub fn marks(&self) -> Vec<TableMark> {
        let written = self.source.as_ref().and_then(|source| source.get("marks"));
        // The file was checked when it was read.
        written.map_or_else(Vec::new, |node| marks::read(&At::root(node)).unwrap_or_default())
    }

    /// The same file with other `marks`; without the key if `marks` is empty.
    ///
    /// # Errors
    /// [`Error::Input`] for marks that a shot file could not have.
    pub fn with_marks(&self, marks: &[TableMark]) -> Result<Self, Error> {
        let mut node = self.written(DefaultElevation::Omitted, PresetNames::AsRead).into_owned();
        if marks.is_empty() {
            node.remove("marks");
        } else {
            node.set("marks", marks::write(marks));
        }
        Self::from_node(node)
    }

    /// The same file with another end time, s since the strike; `None` for an end at rest.
    ///
    /// # Errors
    /// As [`Shot::with_until`].
    pub fn with_until(&self, until: Option<f64>) -> Result<Self, Error> {
        let shot = self.shot.with_until(until)?;
        let Some(source) = &self.source else { return Ok(shot.into()) };
        let mut node = Node::clone(source);
        match until {
            Some(time) => node.set("until", time),
            None => node.remove("until"),
        }
        Ok(Self { shot, source: Some(node.into()) })
    }

    /// The same file with other values at the given paths; later values replace earlier ones. A
    /// missing key is added, and a preset's name becomes the base of an object. An omitted elevation
    /// is the default of the new file.
    ///
    /// # Errors
    /// [`Error::Input`] for a path that leads nowhere, and for everything for which a shot file
    /// with these values would be refused.
    pub fn with_values<'a>(
        &self,
        values: impl IntoIterator<Item = (&'a KeyPath, Node)>,
    ) -> Result<Self, Error> {
        let mut node = self.written(DefaultElevation::Omitted, PresetNames::AsRead).into_owned();
        for (path, value) in values {
            path.set(&mut node, value)?;
            angle::remove_other_unit(&mut node, path);
        }
        Self::from_node(node)
    }
}

impl Deref for ShotFile {
    type Target = Shot;

    fn deref(&self) -> &Shot {
        &self.shot
    }
}

impl AsRef<Shot> for ShotFile {
    fn as_ref(&self) -> &Shot {
        &self.shot
    }
}

/// Two files are equal if their shots are equal; their text may differ.
impl PartialEq for ShotFile {
    fn eq(&self, other: &Self) -> bool {
        self.shot == other.shot
    }
}

/// A file that is written from the shot's data.
impl From<Shot> for ShotFile {
    fn from(shot: Shot) -> Self {
        Self { shot, source: None }
    }
}

impl Shot {
    /// Reads a shot file. [`ShotFile`] also keeps the file itself.
    ///
    /// # Errors
    /// As [`ShotFile::from_json`].
    #[cfg(feature = "json")]
    pub fn from_json(text: &str) -> Result<Self, Error> {
        read(&Node::from_json_within(text, MOST_SHOT_BYTES)?)
    }

    /// Reads a shot from a tree of values.
    ///
    /// # Errors
    /// As [`ShotFile::from_node`].
    pub fn from_node(file: &Node) -> Result<Self, Error> {
        read(file)
    }

    /// A shot of one resting ball on a table, for questions that need only the table and its physics.
    /// Both have the form of these keys in a shot file; without `physics` it is the table's own.
    ///
    /// # Errors
    /// As [`ShotFile::from_node`].
    pub fn bare(table: Node, physics: Option<Node>) -> Result<Self, Error> {
        let ball = Node::object([("id", "cue".into()), ("position", INSIDE.into())]);
        let mut file = Node::object([
            ("format", SHOT_FORMAT.into()),
            ("table", table),
            ("balls", Node::list([ball])),
        ]);
        if let Some(physics) = physics {
            file.set("physics", physics);
        }
        read(&file)
    }

    /// The shot as a shot file, written from its data. It reads back to the same bits. Default
    /// values are left out, and presets are named.
    pub fn to_node(&self) -> Node {
        let (table, default_physics) = table::write(&self.table);
        let mut file = Node::object([("format", SHOT_FORMAT.into()), ("table", table)]);
        let mut physics = crate::Physics::clone(&self.physics);
        physics.cue.tip_friction = self.tip_friction();
        if let Some(node) = physics::write_over(&physics, &default_physics) {
            file.set("physics", node);
        }
        let default = &self.physics.ball;
        file.set("balls", Node::list(self.balls.iter().map(|ball| balls::write(ball, default))));
        if let Some((ball, strike)) = &self.strike {
            let id = &self.balls[*ball].id;
            file.set("strike", strike::write(id, strike, self.strike_policy()));
        }
        if !self.cling().is_empty() {
            file.set("cling", cling::write(self.cling()));
        }
        if let Some(until) = self.until {
            file.set("until", until);
        }
        if self.max_events != DEFAULT_MAX_EVENTS {
            file.set("max_events", self.max_events);
        }
        file
    }

    /// [`Self::to_node`] as JSON.
    pub fn to_json(&self) -> String {
        self.to_node().to_json()
    }
}

/// The tree of a shot file whose balls overlap each other or the cushions by at most `tolerance` (m),
/// with the balls apart ([`crate::shot::repair`]), and the balls that moved. Only their positions change.
///
/// # Errors
/// [`Error::Input`] for a table, a physics or balls that a shot file could not have, and as
/// [`crate::shot::repair`].
pub fn repaired(file: &Node, tolerance: f64) -> Result<(Node, Vec<MovedBall>), Error> {
    let fields = At::root(file).known_fields()?;
    let at = fields.require("table", "a table preset's name, or an object {...}")?;
    let (table, default_physics) = table::read(&at)?;
    let physics = physics::read(fields.get("physics").as_ref(), &default_physics)?;
    let mut balls = balls::read(&fields.require("balls", "a list of balls")?, &physics.ball)?;
    let moved = crate::shot::repair(&mut balls, &table, tolerance)?;
    let mut file = file.clone();
    if let Some(Node::List(written)) = file.get_mut("balls") {
        for (node, placed) in written.iter_mut().zip(&balls) {
            let [x, y, z] = placed.state.position.to_array();
            let lies = z == placed.ball.radius;
            node.set("position", if lies { Node::from([x, y]) } else { Node::list([x, y, z]) });
        }
    }
    Ok((file, moved))
}

fn read(file: &Node) -> Result<Shot, Error> {
    let root = At::root(file);
    // Checked before the keys: those of a trace or of a later format are not typing errors.
    root.known_fields()?.require("format", &format!("\"{SHOT_FORMAT}\""))?.format(SHOT_FORMAT)?;
    let fields = root.fields(KEYS)?;
    let at = fields.require("table", "a table preset's name, or an object {...}")?;
    let (table, default_physics) = table::read(&at)?;
    let physics = physics::read(fields.get("physics").as_ref(), &default_physics)?;
    let balls = balls::read(&fields.require("balls", "a list of balls")?, &physics.ball)?;
    let balls = checked_balls(balls, &table)?;
    let (mut policy, mut struck, mut has_default_elevation) =
        (StrikePolicy::default(), None, false);
    if let Some(at) = fields.get("strike") {
        policy = strike::read_policy(&at)?;
        let read = strike::read(&at, &balls)?;
        struck = Some((read.ball, read.strike));
        has_default_elevation = !read.has_elevation;
    }
    let until = fields.get("until").map(|at| at.number(&UNTIL)).transpose()?;
    let max_events = match fields.get("max_events") {
        Some(at) => at.whole(1, MOST_EVENTS)?,
        None => DEFAULT_MAX_EVENTS,
    };
    let cling = fields.get("cling").map_or(Ok(Cling::NONE), |at| cling::read(&at))?;
    if let Some(at) = fields.get("track") {
        track::read(&at, &balls)?;
    }
    if let Some(at) = fields.get("marks") {
        marks::read(&at)?;
    }
    let strike = struck;
    Shot::new(Parts {
        table,
        physics,
        balls,
        strike,
        policy,
        max_events,
        until,
        has_default_elevation,
        cling,
    })
}
