//! `Trace`.

use std::cell::OnceCell;
use std::sync::Arc;

use carom::ShotFile;
use carom::format::Node;
use carom::outcome::Touched;
use carom::trace::Orientations;
use carom_plan::{CaromRoute, DiamondReading, counted_touches};
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::error::to_exception;

/// Numbers per ball in [`Trace::states_at`].
const STRIDE: usize = 14;

/// A simulated shot with all its events; immutable.
#[wasm_bindgen]
pub struct Trace {
    trace: carom::Trace,
    shot: Arc<ShotFile>,
    orientations: OnceCell<Orientations>,
}

impl From<carom::Trace> for Trace {
    fn from(trace: carom::Trace) -> Self {
        let shot = ShotFile::from(trace.shot().clone());
        Self::new(trace, shot.into())
    }
}

impl Trace {
    /// A trace of `shot`.
    pub(crate) fn new(trace: carom::Trace, shot: Arc<ShotFile>) -> Self {
        Self { trace, shot, orientations: OnceCell::new() }
    }

    /// The trace itself.
    pub(crate) const fn trace(&self) -> &carom::Trace {
        &self.trace
    }

    /// The file of the shot that was simulated.
    pub(crate) const fn file(&self) -> &Arc<ShotFile> {
        &self.shot
    }
}

#[wasm_bindgen]
impl Trace {
    /// Reads a saved trace.
    #[wasm_bindgen(js_name = fromJson)]
    pub fn from_json(text: &str) -> Result<Self, JsValue> {
        let read = Node::from_json(text).and_then(|node| carom::Trace::from_node_with_file(&node));
        let (trace, shot) = read.map_err(|e| to_exception(&e))?;
        Ok(Self::new(trace, shot.into()))
    }

    /// The trace as JSON.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> String {
        self.trace.to_node_with(self.shot.to_node().into_owned()).to_json()
    }

    /// The outcome, for a referee, JSON.
    pub fn outcome(&self) -> String {
        self.trace.outcome().to_node(self.trace.shot()).to_json()
    }

    /// Time from the strike to the end, s.
    pub fn duration(&self) -> f64 {
        self.trace.duration()
    }

    /// What ended the shot: `rest`, `until` or `cap`.
    pub fn end(&self) -> String {
        self.trace.end().name().into()
    }

    /// Sixteen hexadecimal digits over the exact bits of events and final states.
    pub fn hash(&self) -> String {
        format!("{:016x}", self.trace.hash())
    }

    /// Writes all balls' states at `time` (s): position, velocity, spin, orientation, motion code.
    /// `out` has [`STRIDE`] numbers for each ball.
    #[wasm_bindgen(js_name = statesAt)]
    pub fn states_at(&self, time: f64, out: &mut [f64]) -> Result<(), JsValue> {
        let wanted = STRIDE * self.trace.shot().balls().len();
        if out.len() != wanted {
            let what = format!("out has {} numbers; it needs {wanted}", out.len());
            return Err(js_sys::RangeError::new(&what).into());
        }
        let states = self.trace.at(time).map_err(|e| to_exception(&e))?;
        let orientations = self.orientations.get_or_init(|| self.trace.orientations());
        for (ball, (state, row)) in states.iter().zip(out.as_chunks_mut::<STRIDE>().0).enumerate() {
            row[..3].copy_from_slice(&state.position.to_array());
            row[3..6].copy_from_slice(&state.velocity.to_array());
            row[6..9].copy_from_slice(&state.angular_velocity.to_array());
            row[9..13].copy_from_slice(&orientations.at(ball, time));
            row[13] = f64::from(state.motion as u8);
        }
        Ok(())
    }

    /// What a diamond system says of the way of ball `ball` behind event `from`, or from the beginning, JSON; none if no
    /// system fits. Numbers are doubles, as in [`Self::polyline`].
    #[wasm_bindgen(js_name = diamondReading)]
    pub fn diamond_reading(&self, ball: f64, from: Option<f64>) -> Option<String> {
        let from = from.map(|event| event as usize);
        DiamondReading::new(&self.trace, ball as u16, from).map(|found| found.to_node().to_json())
    }

    /// The route of the cue ball to its second object ball, JSON; none if it meets fewer than two.
    #[wasm_bindgen(js_name = caromRoute)]
    pub fn carom_route(&self) -> Option<String> {
        let balls = self.trace.shot().balls();
        let route = CaromRoute::new(&self.trace)?;
        Some(route.to_node(|ball| &balls[usize::from(ball)].id).to_json())
    }

    /// What the cue ball touches up to its second object ball, as a referee of carom counts it, JSON: the number of each
    /// event with the ball, or null for a cushion.
    #[wasm_bindgen(js_name = countedTouches)]
    pub fn counted_touches(&self) -> String {
        let balls = self.trace.shot().balls();
        let touches = counted_touches(&self.trace).into_iter().map(|(event, touched)| {
            let ball = match touched {
                Touched::Ball(ball) => Node::from(&balls[usize::from(ball)].id),
                Touched::Rail(_) => Node::Null,
            };
            Node::List(vec![(event as u32).into(), ball])
        });
        Node::list(touches).to_json()
    }

    /// The path of ball `ball` as x, y, z (m), t (s) per point; its chords stay within `tolerance` (m) of
    /// the exact path.
    ///
    /// `ball` is a double, because WebAssembly would truncate the index 1.7 to 1.
    pub fn polyline(&self, ball: f64, tolerance: f64) -> Result<Vec<f64>, JsValue> {
        let balls = self.trace.shot().balls().len();
        let Some(ball) = (0..balls).find(|index| *index as f64 == ball) else {
            let what = format!("there is no ball {ball}; write an index from 0 to {}", balls - 1);
            return Err(js_sys::RangeError::new(&what).into());
        };
        let points = self.trace.polyline(ball, tolerance);
        let numbers = |p: &carom::trace::Waypoint| {
            let [x, y, z] = p.position.to_array();
            [x, y, z, p.time]
        };
        Ok(points.iter().flat_map(numbers).collect())
    }
}
