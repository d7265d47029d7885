//! `_core.Shot`.

use std::sync::Arc;

use carom::format::{DefaultElevation, PresetNames, check_balls, check_physics, check_table};
use carom::limits::MOST_SHOT_BYTES;
use carom::math::Vec3;
use carom::resolve::cue_ball::Strike;
use carom::shot::{CuePose, Touched};
use carom::{ErrorKind, ShotFile};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::error::to_exception;
use crate::json;
use crate::node::{from_python, to_python};

pub(crate) fn strike_of([speed, azimuth, elevation, side, height]: [f64; 5]) -> Strike {
    Strike { speed, azimuth, elevation, side, height }
}

/// Speed, azimuth, elevation, side, height. None stands for the default elevation.
pub(crate) type StrikeArguments = (f64, f64, Option<f64>, f64, f64);

/// The strike, and whether it has an elevation.
pub(crate) fn strike_or_default(
    (speed, azimuth, elevation, side, height): StrikeArguments,
) -> (Strike, bool) {
    let strike = Strike { speed, azimuth, elevation: elevation.unwrap_or(0.0), side, height };
    (strike, elevation.is_some())
}

/// Tip, direction, butt, and the clearance with the name of what is nearest.
type CuePoseFields = ([f64; 3], [f64; 3], [f64; 3], Option<(f64, String)>);

/// A validated shot; immutable, shared, never copied.
#[pyclass(frozen, module = "carom._core")]
pub(crate) struct Shot(pub(crate) Arc<ShotFile>);

/// Checks one part of a shot file by itself: `table`, `physics` or `balls`.
#[pyfunction]
pub(crate) fn check_part(key: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
    let node = from_python(value)?;
    let checked = match key {
        "table" => check_table(&node),
        "physics" => check_physics(&node),
        _ => check_balls(&node),
    };
    checked.map_err(|error| to_exception(value.py(), &error))
}

impl From<carom::Shot> for Shot {
    fn from(shot: carom::Shot) -> Self {
        Self(ShotFile::from(shot).into())
    }
}

#[pymethods]
impl Shot {
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str, file: Option<&str>) -> PyResult<Self> {
        let node = json::read(py, text, file, MOST_SHOT_BYTES)?;
        let shot = ShotFile::from_node(node).map_err(|e| to_exception(py, &e))?;
        Ok(Self(shot.into()))
    }

    #[staticmethod]
    fn from_object(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        let shot =
            ShotFile::from_node(from_python(value)?).map_err(|e| to_exception(value.py(), &e))?;
        Ok(Self(shot.into()))
    }

    /// The shot file. `elevation` is whether one that is the default is written. `dated` are the names
    /// of presets that get their dates: none, `"all"` with that of the table's physics, or `"named"`.
    #[pyo3(signature = (*, elevation = true, dated = None))]
    fn to_object<'py>(
        &self,
        py: Python<'py>,
        elevation: bool,
        dated: Option<&str>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let elevation =
            if elevation { DefaultElevation::Written } else { DefaultElevation::Omitted };
        let names = match dated {
            None => PresetNames::AsRead,
            Some("all") => PresetNames::Dated,
            Some("named") => PresetNames::DatedWhereNamed,
            Some(other) => return Err(PyValueError::new_err(other.to_owned())),
        };
        to_python(py, &self.0.written(elevation, names))
    }

    fn to_json(&self) -> String {
        self.0.to_json()
    }

    /// The name of the physics preset that belongs to the table.
    #[getter]
    fn physics_of_table(&self) -> String {
        self.0.physics_of_table()
    }

    /// Whether both describe the same shot; their text may differ.
    fn equals(&self, other: &Self) -> bool {
        self.0 == other.0
    }

    fn geometry<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.0.table().to_node())
    }

    #[getter]
    fn ids(&self) -> Vec<&str> {
        self.0.balls().iter().map(|b| b.id.as_str()).collect()
    }

    #[getter]
    fn radius(&self) -> Vec<f64> {
        self.0.balls().iter().map(|b| b.ball.radius).collect()
    }

    #[getter]
    fn mass(&self) -> Vec<f64> {
        self.0.balls().iter().map(|b| b.ball.mass).collect()
    }

    /// Speed, azimuth, elevation, side, height.
    #[getter]
    fn strike(&self) -> Option<(f64, f64, f64, f64, f64)> {
        let (_, s) = self.0.strike()?;
        Some((s.speed, s.azimuth, s.elevation, s.side, s.height))
    }

    /// The cue: tip, direction and butt (m), and its clearance (m) over the nearest ball or rail.
    fn cue_pose(&self) -> Option<CuePoseFields> {
        let pose = self.0.cue_pose()?;
        let clearance = self.0.cue_clearance();
        let name = |touched| match touched {
            Touched::Ball(ball) => self.0.balls()[usize::from(ball)].id.clone(),
            Touched::Rail(rail) => rail.name().into(),
        };
        let [tip, direction, butt] = [pose.tip, pose.direction, pose.butt()].map(Vec3::to_array);
        let clearance = clearance.map(|found| (found.distance, name(found.nearest)));
        Some((tip, direction, butt, clearance))
    }

    /// Speed, azimuth, elevation, side, height of a cue in this pose on the ball with this id.
    fn strike_of_pose(
        &self,
        py: Python<'_>,
        tip: [f64; 3],
        direction: [f64; 3],
        speed: f64,
        ball: &str,
    ) -> PyResult<(f64, f64, f64, f64, f64)> {
        let vector = |[x, y, z]: [f64; 3]| Vec3::new(x, y, z);
        let pose = CuePose { tip: vector(tip), direction: vector(direction) };
        let index = self.0.balls().iter().position(|placed| placed.id == ball);
        let strike = index
            .ok_or_else(|| {
                let what = format!("there is no ball \"{ball}\"");
                ErrorKind::UnknownBall.at("ball", what, "give the id of a ball of the shot")
            })
            .and_then(|index| self.0.strike_of_pose(&pose, speed, index))
            .map_err(|e| to_exception(py, &e))?;
        Ok((strike.speed, strike.azimuth, strike.elevation, strike.side, strike.height))
    }

    #[getter]
    fn has_default_elevation(&self) -> bool {
        self.0.has_default_elevation()
    }

    /// The same shot with another strike; without an elevation, at the default one.
    fn with_strike(&self, py: Python<'_>, strike: StrikeArguments) -> PyResult<Self> {
        let (strike, has_elevation) = strike_or_default(strike);
        let shot = if has_elevation {
            self.0.with_strike(&strike)
        } else {
            self.0.with_default_elevation(&strike)
        };
        Ok(Self(shot.map_err(|e| to_exception(py, &e))?.into()))
    }

    #[getter]
    fn until(&self) -> Option<f64> {
        self.0.until()
    }

    fn with_until(&self, py: Python<'_>, until: Option<f64>) -> PyResult<Self> {
        let shot = self.0.with_until(until).map_err(|e| to_exception(py, &e))?;
        Ok(Self(shot.into()))
    }

    fn __len__(&self) -> usize {
        self.0.balls().len()
    }
}
