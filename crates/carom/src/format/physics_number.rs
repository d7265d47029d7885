//! Single numbers of the physics by their keys, for programs that vary many of them.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::angle::STROKE_ELEVATION;
use super::node::Node;
use super::physics::{check_restitution, check_slip_friction, check_tip_loss};
use super::read::Reader;
use crate::error::{Error, ErrorKind};
use crate::physics::quantities::{BAND_END, FRACTION, FRICTION, QUANTITIES, QuantityShape};
use crate::physics::{Physics, RollingBand, RollingFriction};
use crate::range::Range;

/// The key of rolling resistance, whose bands have keys such as `cloth.rolling_friction[2].friction`.
const BANDS: &str = "cloth.rolling_friction";

/// A number of [`Physics`] by its key in a shot file, such as `cloth.sliding_friction` or
/// `cushion.restitution.b`; those of a speed band are `cloth.rolling_friction[2].friction` and
/// `cloth.rolling_friction[2].up_to`. A key that a file may also have as a formula, such as
/// `cushion.restitution`, makes the coefficient constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct PhysicsNumber(Place);

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    /// An index of [`QUANTITIES`].
    Quantity(usize),
    /// The end of a band, and its coefficient.
    BandEnd(usize),
    BandFriction(usize),
}

impl PhysicsNumber {
    /// The number with this key.
    ///
    /// # Errors
    /// [`Error::Input`] at the key if there is no such number. The names of models are not numbers;
    /// `ball.mass` and `ball.radius` are defaults of shot files, and a shot has a mass and a radius
    /// for each ball.
    pub fn find(key: &str) -> Result<Self, Error> {
        if let Some(place) = band(key) {
            return Ok(Self(place));
        }
        let index = QUANTITIES.iter().position(|quantity| quantity.path == key);
        match index {
            Some(index) if is_number(index) => Ok(Self(Place::Quantity(index))),
            Some(_) => {
                let what = "is not a number of the physics that may differ between candidates";
                let remedy = "give the shots different models or balls";
                Err(ErrorKind::Unsupported.at(key, what, remedy))
            }
            None => {
                let known: Vec<&str> = (0..QUANTITIES.len())
                    .filter(|i| is_number(*i))
                    .map(|i| QUANTITIES[i].path)
                    .collect();
                Err(Reader::new(&Node::Null, key).unknown_word(
                    key,
                    "number of the physics",
                    &known,
                ))
            }
        }
    }

    /// Its key.
    pub fn key(self) -> String {
        match self.0 {
            Place::Quantity(index) => QUANTITIES[index].path.into(),
            Place::BandEnd(i) => format!("{BANDS}[{i}].up_to"),
            Place::BandFriction(i) => format!("{BANDS}[{i}].friction"),
        }
    }
}

impl Physics {
    /// Sets numbers to values, as a shot file would. They are set in the order of a shot file, those
    /// of speed bands last, whatever their order here.
    ///
    /// # Errors
    /// [`Error::Input`] at the key of a number that is out of range, or of a formula whose numbers
    /// do not fit together.
    pub fn set_numbers(&mut self, numbers: &[(PhysicsNumber, f64)]) -> Result<(), Error> {
        if numbers.is_sorted_by_key(|(number, _)| *number) {
            return set_in_order(self, numbers);
        }
        let mut sorted = numbers.to_vec();
        sorted.sort_by_key(|(number, _)| *number);
        set_in_order(self, &sorted)
    }
}

/// The place of a key such as `cloth.rolling_friction[2].friction`.
fn band(key: &str) -> Option<Place> {
    let (index, field) = key.strip_prefix(BANDS)?.strip_prefix('[')?.split_once("].")?;
    let index = index.parse().ok()?;
    match field {
        "up_to" => Some(Place::BandEnd(index)),
        "friction" => Some(Place::BandFriction(index)),
        _ => None,
    }
}

fn is_number(index: usize) -> bool {
    let quantity = &QUANTITIES[index];
    !quantity.path.starts_with("ball.") && !matches!(quantity.shape, QuantityShape::Model(..))
}

fn set_in_order(physics: &mut Physics, numbers: &[(PhysicsNumber, f64)]) -> Result<(), Error> {
    let mut bands: Option<Vec<RollingBand>> = None;
    for &(number, value) in numbers {
        let check = |range: &Range| range.check(|| number.key(), value);
        match number.0 {
            Place::Quantity(index) => set(physics, index, value, check)?,
            Place::BandEnd(i) => {
                check(&BAND_END)?;
                band_of(&mut bands, physics, number, i)?.up_to = value;
            }
            Place::BandFriction(i) => {
                check(&FRICTION)?;
                band_of(&mut bands, physics, number, i)?.friction = value;
            }
        }
    }
    if let Some(bands) = bands {
        let friction = RollingFriction::from_bands(&bands).map_err(|e| e.inside(BANDS))?;
        physics.cloth.rolling_friction = friction;
    }
    check_slip_friction(physics).map_err(|e| e.inside("ball_ball.friction"))?;
    check_restitution(physics, "lowest").map_err(|e| e.inside("cushion.restitution"))?;
    check_tip_loss(physics).map_err(|e| e.inside("cue.tip_off_centre_loss"))
}

fn set(
    physics: &mut Physics,
    index: usize,
    value: f64,
    check: impl Fn(&Range) -> Result<(), Error>,
) -> Result<(), Error> {
    let quantity = &QUANTITIES[index];
    match &quantity.shape {
        QuantityShape::Number(number) => {
            check(&number.range)?;
            *(number.place)(physics) = value;
        }
        QuantityShape::Angle(angle) => {
            let [radians, _] = STROKE_ELEVATION.ranges();
            check(&radians)?;
            *(angle.place)(physics) = value;
        }
        QuantityShape::Formula(formula) => {
            check(&formula.constant)?;
            quantity.set_constant(physics, value);
        }
        QuantityShape::Bands => {
            check(&FRICTION)?;
            physics.cloth.rolling_friction = RollingFriction::constant(value);
        }
        QuantityShape::Tip(tip) => {
            check(&FRACTION)?;
            physics.cue.tip = tip(value);
            physics.cue.tip_off_centre_loss = 0.0;
        }
        QuantityShape::Model(..) => {}
    }
    Ok(())
}

/// Band `i` of those that are changed, which are first those of `physics`.
fn band_of<'a>(
    bands: &'a mut Option<Vec<RollingBand>>,
    physics: &Physics,
    number: PhysicsNumber,
    i: usize,
) -> Result<&'a mut RollingBand, Error> {
    let bands = bands.get_or_insert_with(|| physics.cloth.rolling_friction.bands().collect());
    let count = bands.len();
    bands.get_mut(i).ok_or_else(|| {
        let what = format!("the cloth has {count} speed bands, counted from 0");
        ErrorKind::OutOfRange.at(number.key(), what, "give the shot's physics more bands")
    })
}

#[cfg(test)]
mod tests {
    use super::{PhysicsNumber, QUANTITIES, is_number};
    use crate::Physics;
    use crate::error::Error;
    use crate::physics::{CushionRestitution, Tip};

    fn physics() -> Physics {
        Physics::preset("carom").expect("a preset")
    }

    fn set(numbers: &[(&str, f64)]) -> Result<Physics, Error> {
        let mut physics = physics();
        let found: Result<alloc::vec::Vec<_>, Error> =
            numbers.iter().map(|(key, x)| Ok((PhysicsNumber::find(key)?, *x))).collect();
        physics.set_numbers(&found?)?;
        Ok(physics)
    }

    fn refusal(numbers: &[(&str, f64)]) -> (alloc::string::String, alloc::string::String) {
        match set(numbers) {
            Err(Error::Input(e)) => (e.place, e.what),
            other => panic!("expected a refusal, got {other:?}"),
        }
    }

    #[test]
    fn every_number_is_found_by_its_key_and_set_as_a_file_sets_it() {
        for index in (0..QUANTITIES.len()).filter(|i| is_number(*i)) {
            let key = QUANTITIES[index].path;
            assert_eq!(PhysicsNumber::find(key).expect(key).key(), key);
        }
        let changed = set(&[
            ("cloth.sliding_friction", 0.21),
            ("cushion.restitution.b", -0.05),
            ("ball_ball.friction", 0.07),
            ("cue.tip_restitution", 0.8),
            ("cue.tip_off_centre_loss", 0.3),
        ])
        .expect("valid numbers");
        let old = physics();
        assert_eq!(changed.cloth.sliding_friction, 0.21);
        assert_eq!(
            changed.cushion.restitution,
            CushionRestitution { b: -0.05, ..old.cushion.restitution }
        );
        assert_eq!((changed.ball_ball.friction.a, changed.ball_ball.friction.b), (0.07, 0.0));
        assert_eq!(
            (changed.cue.tip, changed.cue.tip_off_centre_loss),
            (Tip::Restitution(0.8), 0.3)
        );
        assert_eq!(changed.cloth.rolling_friction, old.cloth.rolling_friction);
    }

    #[test]
    fn the_order_of_the_numbers_does_not_matter() {
        let one = set(&[("cushion.restitution", 0.8), ("cushion.restitution.b", -0.01)]);
        let other = set(&[("cushion.restitution.b", -0.01), ("cushion.restitution", 0.8)]);
        assert_eq!(one, other);
        assert_eq!(one.expect("valid numbers").cushion.restitution.b, -0.01);
    }

    #[test]
    fn speed_bands_have_their_own_keys() {
        let changed = set(&[
            ("cloth.rolling_friction[1].up_to", 0.5),
            ("cloth.rolling_friction[0].friction", 0.0042),
            ("cloth.rolling_friction[0].up_to", 0.25),
        ])
        .expect("valid bands");
        let bands: alloc::vec::Vec<_> = changed.cloth.rolling_friction.bands().collect();
        assert_eq!((bands[0].up_to, bands[0].friction, bands[1].up_to), (0.25, 0.0042, 0.5));
        let constant = set(&[("cloth.rolling_friction", 0.01)]).expect("a valid number");
        assert_eq!(constant.cloth.rolling_friction.as_constant(), Some(0.01));
    }

    #[test]
    fn a_refusal_names_the_key() {
        for (numbers, place) in [
            (&[("cloth.sliding_friction", -0.1)][..], "cloth.sliding_friction"),
            (&[("gravity", f64::NAN)], "gravity"),
            (&[("cue.stroke_elevation", 2.0)], "cue.stroke_elevation"),
            (&[("cushion.restitution.lowest", 0.99)], "cushion.restitution"),
            (
                &[("cushion.restitution.lowest", 0.9), ("cushion.restitution.highest", 0.8)],
                "cushion.restitution.lowest",
            ),
            (&[("ball_ball.friction.b", -0.5)], "ball_ball.friction"),
            (
                &[("cue.tip_efficiency", 0.9), ("cue.tip_off_centre_loss", 0.1)],
                "cue.tip_off_centre_loss",
            ),
            (&[("cloth.rolling_friction[0].up_to", 1e3)], "cloth.rolling_friction[1].up_to"),
            (
                &[("cloth.rolling_friction[15].friction", 0.1)],
                "cloth.rolling_friction[15].friction",
            ),
            (&[("cushion.model", 1.0)], "cushion.model"),
            (&[("ball.radius", 0.03)], "ball.radius"),
            (&[("cloth.slidingfriction", 0.2)], "cloth.slidingfriction"),
        ] {
            assert_eq!(refusal(numbers).0, place, "{numbers:?}");
        }
    }
}
