//! The figures of a preset, each with its source.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::{
    Markings, PocketDescription, PocketLayout, PocketModel, Sights, Spot, TableDescription,
};

/// The source of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A rule book; where it allows a range, a value inside it.
    RuleBook(&'static str),
    /// A publication or another engine.
    Published(&'static str),
    /// From memory: not verified.
    Memory,
    /// No source: estimated, so that the table plays like a real one.
    Estimated(&'static str),
}

impl Source {
    /// The source as text.
    pub fn text(self) -> String {
        match self {
            Self::RuleBook(s) | Self::Published(s) => s.to_string(),
            Self::Memory => "from memory, not verified".to_string(),
            Self::Estimated(why) => alloc::format!("estimated: {why}"),
        }
    }
}

/// A figure and its source.
#[derive(Clone, Copy, Debug)]
pub(super) struct Figure {
    pub(super) value: f64,
    pub(super) source: Source,
}

pub(super) const fn figure(value: f64, source: Source) -> Figure {
    Figure { value, source }
}

/// The figures of a pocket, see [`PocketDescription`].
#[derive(Clone, Copy, Debug)]
pub(super) struct PocketSheet {
    pub(super) mouth: Figure,
    pub(super) cut_angle_deg: Figure,
    pub(super) shelf: Figure,
    pub(super) hole_radius: Figure,
    pub(super) point_radius: Figure,
    pub(super) throat: Option<Figure>,
}

/// The spots of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SpotPattern {
    /// Head and foot spot a quarter of the length from the ends, and the centre.
    Quarters,
    /// The six spots of snooker.
    Snooker,
    /// The spot of the black, centred on the other half of the table.
    EnglishPool,
}

/// The figures of a preset, see [`TableDescription`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheet {
    pub(super) length: Figure,
    pub(super) width: Figure,
    pub(super) cushion_height: Figure,
    pub(super) cushion_width: Figure,
    pub(super) rail_width: Figure,
    pub(super) pocket_model: PocketModel,
    /// Corner and side.
    pub(super) pockets: Option<[PocketSheet; 2]>,
    pub(super) sight_setback: Option<Figure>,
    pub(super) head_string: Option<Figure>,
    pub(super) d_radius: Option<Figure>,
    /// Snooker's black spot, from the top nose line.
    pub(super) black_spot: Option<Figure>,
    pub(super) spots: SpotPattern,
    pub(super) physics: &'static str,
}

impl PocketSheet {
    fn description(&self) -> PocketDescription {
        PocketDescription {
            mouth: self.mouth.value,
            cut_angle_deg: self.cut_angle_deg.value,
            shelf: self.shelf.value,
            hole_radius: self.hole_radius.value,
            point_radius: self.point_radius.value,
            throat: self.throat.map(|f| f.value),
        }
    }
}

impl Sheet {
    pub(super) fn description(&self) -> TableDescription {
        let pocket = |i: usize| self.pockets.map(|pockets| pockets[i].description());
        TableDescription {
            length: self.length.value,
            width: self.width.value,
            cushion_height: self.cushion_height.value,
            cushion_width: self.cushion_width.value,
            rail_width: self.rail_width.value,
            pockets: if self.pockets.is_some() { PocketLayout::Six } else { PocketLayout::None },
            pocket_model: self.pocket_model,
            corner_pocket: pocket(0),
            side_pocket: pocket(1),
            sights: self.sight_setback.map(|setback| Sights {
                along_length: 8,
                along_width: 4,
                setback: setback.value,
            }),
            markings: Markings {
                head_string: self.head_string.map(|f| f.value),
                d_radius: self.d_radius.map(|f| f.value),
                spots: self.spots(),
            },
            physics: self.physics.to_string(),
        }
    }

    fn spots(&self) -> Vec<Spot> {
        let (width, length) = (self.width.value, self.length.value);
        let spot = |name: &str, x: f64, y: f64| Spot { name: name.to_string(), position: [x, y] };
        let middle = 0.5 * width;
        match self.spots {
            SpotPattern::Quarters => [
                spot("head", middle, 0.25 * length),
                spot("center", middle, 0.5 * length),
                spot("foot", middle, 0.75 * length),
            ]
            .to_vec(),
            SpotPattern::EnglishPool => [spot("black", middle, 0.75 * length)].to_vec(),
            SpotPattern::Snooker => {
                let baulk = self.head_string.map_or(0.0, |f| f.value);
                let d = self.d_radius.map_or(0.0, |f| f.value);
                let black = self.black_spot.map_or(0.0, |f| f.value);
                // Seen from the baulk end, yellow is on the right.
                [
                    spot("yellow", middle + d, baulk),
                    spot("green", middle - d, baulk),
                    spot("brown", middle, baulk),
                    spot("blue", middle, 0.5 * length),
                    spot("pink", middle, 0.75 * length),
                    spot("black", middle, length - black),
                ]
                .to_vec()
            }
        }
    }

    /// The source of the figure at `key`.
    pub(super) fn source(&self, key: &str) -> Option<Source> {
        let of_pocket = |p: &PocketSheet, key: &str| match key {
            "mouth" => Some(p.mouth),
            "cut_angle_deg" => Some(p.cut_angle_deg),
            "shelf" => Some(p.shelf),
            "hole_radius" => Some(p.hole_radius),
            "point_radius" => Some(p.point_radius),
            "throat" => p.throat,
            _ => None,
        };
        let found = match key.split_once('.') {
            Some(("corner_pocket", key)) => self.pockets.and_then(|p| of_pocket(&p[0], key)),
            Some(("side_pocket", key)) => self.pockets.and_then(|p| of_pocket(&p[1], key)),
            Some(("sights", "setback")) => self.sight_setback,
            Some(("markings", "head_string")) => self.head_string,
            Some(("markings", "d_radius")) => self.d_radius,
            Some(_) => None,
            None => match key {
                "length" => Some(self.length),
                "width" => Some(self.width),
                "cushion_height" => Some(self.cushion_height),
                "cushion_width" => Some(self.cushion_width),
                "rail_width" => Some(self.rail_width),
                _ => None,
            },
        };
        found.map(|f| f.source)
    }
}
