//! Parts of the cloth. Lengths in m; places in the file's coordinates, origin at the bottom left corner.

use carom::format::{Node, Reader};
use carom::math::Vec2;
use carom::{Error, ErrorKind, Table};

use crate::lanes::distance_to_segment;

/// The most corners of an outline, as of an area that is drawn on the table.
const MOST_CORNERS: usize = 64;

/// A part of the cloth; a ball is in it if its centre is.
#[derive(Clone, Debug, PartialEq)]
pub enum DrillArea {
    /// A disc: its centre and radius, m.
    Disc([f64; 2], f64),
    /// A rectangle: its lower left and upper right corner, m.
    Box([f64; 2], [f64; 2]),
    /// A polygon: its 3 to 64 corners, m.
    Outline(Vec<[f64; 2]>),
    /// The D of a snooker table.
    D,
}

impl DrillArea {
    /// How far (m) a place is outside the area; 0 inside. Infinite for the D of a table without one.
    pub fn distance(&self, table: &Table, [x, y]: [f64; 2]) -> f64 {
        match self {
            Self::Disc([cx, cy], radius) => (Vec2::new(x - cx, y - cy).length() - radius).max(0.0),
            Self::Box([left, low], [right, high]) => {
                let aside = (left - x).max(x - right).max(0.0);
                Vec2::new(aside, (low - y).max(y - high).max(0.0)).length()
            }
            Self::Outline(corners) => {
                if is_inside(corners, [x, y]) {
                    return 0.0;
                }
                let point = Vec2::new(x, y);
                let outside = |[a, b]: [Vec2; 2]| distance_to_segment(point, a, b);
                edges(corners).map(outside).fold(f64::INFINITY, f64::min)
            }
            Self::D => {
                let markings = table.description.as_ref().map(|known| &known.markings);
                let lines = markings.and_then(|known| known.head_string.zip(known.d_radius));
                lines.map_or(f64::INFINITY, |(line, radius)| {
                    let disc = Self::Disc([0.5 * table.size.x, line], radius);
                    disc.distance(table, [x, y]).max(y - line)
                })
            }
        }
    }

    /// The area with these plain values.
    ///
    /// # Errors
    /// [`Error::Input`] with the place of what is wrong.
    pub fn read(at: &Reader<'_>) -> Result<Self, Error> {
        if at.get("center").is_some() {
            at.keys(&["center", "radius"])?;
            let radius = at.require("radius", "0.2")?;
            return Ok(Self::Disc(point(&at.require("center", "[0.6, 1.2]")?)?, length(&radius)?));
        }
        if at.get("outline").is_some() {
            at.keys(&["outline"])?;
            return outline(&at.require("outline", "a list of [x, y]")?).map(Self::Outline);
        }
        if at.get("marking").is_some() {
            at.keys(&["marking"])?;
            let marking = at.require("marking", "\"d\"")?;
            let word = marking.text("\"d\"")?;
            return if word == "d" {
                Ok(Self::D)
            } else {
                Err(marking.unknown_word(word, "marking", &["d"]))
            };
        }
        at.keys(&["from", "to"])?;
        let (from, to) = (at.require("from", "[0.2, 0.2]")?, at.require("to", "[0.8, 0.6]")?);
        let corners = [point(&from)?, point(&to)?];
        if corners[0][0] >= corners[1][0] || corners[0][1] >= corners[1][1] {
            let remedy = "write a corner to the right of and above \"from\"";
            return Err(to.refuse(ErrorKind::OutOfRange, "the rectangle is empty", remedy));
        }
        Ok(Self::Box(corners[0], corners[1]))
    }

    /// The area under the key `area`.
    pub(crate) fn required(at: &Reader<'_>) -> Result<Self, Error> {
        Self::read(&at.require("area", "{\"center\": [0.6, 1.2], \"radius\": 0.2}")?)
    }

    /// Refuses an area at `place` that the table lacks.
    pub(crate) fn check(&self, place: &str, table: &Table) -> Result<(), Error> {
        if *self == Self::D && self.distance(table, [0.0, 0.0]).is_infinite() {
            let remedy = "write a disc with a center and a radius";
            return Err(ErrorKind::Unsupported.at(place, "the table has no D", remedy));
        }
        Ok(())
    }

    /// The plain values.
    pub fn to_node(&self) -> Node {
        let point = |place: &[f64; 2]| Node::list(*place);
        match self {
            Self::Disc(center, radius) => {
                Node::object([("center", point(center)), ("radius", (*radius).into())])
            }
            Self::Box(from, to) => Node::object([("from", point(from)), ("to", point(to))]),
            Self::Outline(corners) => {
                Node::object([("outline", Node::list(corners.iter().map(point)))])
            }
            Self::D => Node::object([("marking", "d".into())]),
        }
    }
}

/// Two numbers, m.
pub(crate) fn point(at: &Reader<'_>) -> Result<[f64; 2], Error> {
    let items = at.items("two numbers, m")?;
    let [x, y] = &items[..] else { return Err(at.wrong_type("two numbers, m")) };
    Ok([x.number()?, y.number()?])
}

/// A length above 0, m.
pub(crate) fn length(at: &Reader<'_>) -> Result<f64, Error> {
    let length = at.number()?;
    if length <= 0.0 {
        let what = format!("{length} m is out of range");
        return Err(at.refuse(ErrorKind::OutOfRange, what, "write a length above 0 m"));
    }
    Ok(length)
}

fn outline(at: &Reader<'_>) -> Result<Vec<[f64; 2]>, Error> {
    let corners = at.items("a list of [x, y]")?;
    if !(3..=MOST_CORNERS).contains(&corners.len()) {
        let what = format!("found {} corners", corners.len());
        let error = at.refuse(ErrorKind::WrongCount, what, format!("write 3 to {MOST_CORNERS}"));
        return Err(error.with("count", corners.len() as f64));
    }
    corners.iter().map(point).collect()
}

fn edges(corners: &[[f64; 2]]) -> impl Iterator<Item = [Vec2; 2]> + '_ {
    let vector = |[x, y]: &[f64; 2]| Vec2::new(*x, *y);
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(move |(a, b)| [vector(a), vector(b)])
}

/// Whether a ray to the right crosses the outline an odd number of times.
fn is_inside(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let crosses = |[a, b]: &[Vec2; 2]| {
        (a.y > y) != (b.y > y) && x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)
    };
    edges(corners).filter(crosses).count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use carom::Table;

    use super::DrillArea;

    #[test]
    fn the_distance_from_a_disc_and_from_an_outline_is_zero_inside() {
        let table = Table::preset("wpa-9ft").unwrap();
        let disc = DrillArea::Disc([1.0, 1.0], 0.5);
        assert_eq!(disc.distance(&table, [1.2, 1.3]), 0.0);
        assert!((disc.distance(&table, [1.0, 2.0]) - 0.5).abs() < 1e-15);
        // A concave outline: an L.
        let l = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        let l = DrillArea::Outline(l.to_vec());
        assert_eq!(l.distance(&table, [0.5, 1.5]), 0.0);
        assert!((l.distance(&table, [1.5, 1.25]) - 0.25).abs() < 1e-15);
        assert!((l.distance(&table, [-3.0, -4.0]) - 5.0).abs() < 1e-15);
    }
}
