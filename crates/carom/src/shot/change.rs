//! A shot made from another: struck otherwise, or with its balls elsewhere. Nothing is written or read
//! anew, so that programs can ask many such questions of one table.

use alloc::borrow::Cow;
use alloc::format;
use alloc::string::String;
use alloc::sync::Arc;
use alloc::vec::Vec;

use super::{Node, PlacedBall, Shot, balls, strike};
use crate::error::Error;
use crate::math::{Vec3, degrees, radians};
use crate::resolve::cue_ball::Strike;

/// Where the file of a shot comes from.
#[derive(Clone, Debug)]
pub(super) enum File {
    /// It was read: number for number.
    Read(Arc<Node>),
    /// From that of another shot, of which `strike` is changed, and `balls` too if so marked.
    Changed { from: Arc<Node>, balls: bool },
}

impl File {
    fn changed(&self, balls_too: bool) -> Self {
        match self {
            Self::Read(from) => Self::Changed { from: from.clone(), balls: balls_too },
            Self::Changed { from, balls } => {
                Self::Changed { from: from.clone(), balls: *balls || balls_too }
            }
        }
    }
}

impl Shot {
    /// The shot file as a tree of values.
    pub fn to_node(&self) -> Cow<'_, Node> {
        let (from, balls) = match &self.file {
            File::Read(node) => return Cow::Borrowed(node),
            File::Changed { from, balls } => (from, *balls),
        };
        let mut file = Node::clone(from);
        if balls {
            file.set("balls", Node::list(self.balls.iter().map(|ball| self.write_ball(ball))));
        }
        if let Some((struck, strike)) = &self.strike {
            let mut node = from.get("strike").cloned().unwrap_or_else(|| Node::object([]));
            node.set("ball", &self.balls[*struck].id);
            node.set("speed", strike.speed);
            node.set("azimuth_deg", degrees(strike.azimuth));
            node.set("elevation_deg", degrees(strike.elevation));
            node.set("side", strike.side);
            node.set("height", strike.height);
            file.set("strike", node);
        } else {
            file.remove("strike");
        }
        Cow::Owned(file)
    }

    /// The same shot struck otherwise. Angles are kept as the degrees that a file can hold, which
    /// moves some by one rounding.
    ///
    /// # Errors
    /// As [`Self::resolve_strike`].
    pub fn with_strike(&self, strike: &Strike) -> Result<Self, Error> {
        self.resolve_strike(strike)?;
        let struck = self.strike.map(|(ball, _)| (ball, as_in_a_file(strike)));
        let file = self.file.changed(false);
        Ok(Self { strike: struck, file, ..self.clone() })
    }

    /// Other balls on the same table, under the same physics; `strike` is the struck ball's index and
    /// the strike (angles as in [`Self::with_strike`]). States are in the file's frame; what each ball's
    /// motion state is follows from the rest.
    ///
    /// # Errors
    /// [`Error::Input`] for what a shot file with such `balls` and `strike` would be refused for:
    /// overlaps, balls outside the table, ids that are not unique, a strike that cannot be played.
    pub fn with_balls(
        &self,
        mut balls: Vec<PlacedBall>,
        strike: Option<(usize, Strike)>,
    ) -> Result<Self, Error> {
        balls::check_count(balls.len())?;
        for (i, PlacedBall { ball, state, .. }) in balls.iter_mut().enumerate() {
            let place = || format!("balls[{i}].position");
            state.position.z = balls::height(place, state.position.z, ball.radius)?;
            balls::check_speeds(i, state)?;
            state.motion = balls::motion(state, ball.radius);
        }
        balls::check(&balls, &self.table)?;
        let shot = Self {
            table: self.table.clone(),
            physics: self.physics.clone(),
            strike: strike.as_ref().map(|(ball, strike)| (*ball, as_in_a_file(strike))),
            balls: balls.into(),
            max_events: self.max_events,
            policy: self.policy,
            tip_friction: self.tip_friction,
            file: self.file.changed(true),
        };
        if let Some((ball, strike)) = &shot.strike {
            strike::check_ranges("strike", strike)?;
            strike::check("strike", *ball, strike, &shot.balls, &shot.physics)?;
            shot.refuse_obstruction(*ball, strike)?;
        }
        Ok(shot)
    }

    fn write_ball(&self, placed: &PlacedBall) -> Node {
        let (usual, PlacedBall { id, ball, state }) = (&self.physics.ball, placed);
        let [x, y, z] = state.position.to_array();
        let position = if z == ball.radius { Node::from([x, y]) } else { Node::list([x, y, z]) };
        let mut node = Node::object([("id", id.into()), ("position", position)]);
        for (key, value) in
            [("velocity", state.velocity), ("angular_velocity", state.angular_velocity)]
        {
            if value != Vec3::ZERO {
                node.set(key, Node::list(value.to_array()));
            }
        }
        for (key, value, usual) in
            [("mass", ball.mass, usual.mass), ("radius", ball.radius, usual.radius)]
        {
            if value != usual {
                node.set(key, value);
            }
        }
        node
    }

    /// The shot file, JSON: what was read, number for number.
    pub fn to_json(&self) -> String {
        self.to_node().to_json()
    }
}

/// The strike with the angles that come back from the degrees of a file.
fn as_in_a_file(strike: &Strike) -> Strike {
    let written = |angle: f64| radians(degrees(angle));
    Strike { azimuth: written(strike.azimuth), elevation: written(strike.elevation), ..*strike }
}
