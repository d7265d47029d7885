//! The dimensions from which the judge constructs a table.

use carom::Table;
use carom::table::{PocketDescription, PocketLayout, PocketModel};

use super::rule_books::{Figure, sheet};

/// The dimensions of a table, see docs/tables.md.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Figures {
    pub(crate) width: f64,
    pub(crate) length: f64,
    pub(crate) nose_height: f64,
    /// From the nose line to the deep ends of the facings, m.
    pub(crate) cushion_width: f64,
    pub(crate) rail_width: f64,
    /// Corner and side pocket, if there are pockets.
    pub(crate) pockets: Option<[PocketFigures; 2]>,
    /// Whether a ball is captured when it crosses the line between the tips.
    pub(crate) has_mouth_lines: bool,
    /// Keys of dimensions that differ from the published ones.
    pub(crate) unlike: Vec<String>,
}

/// The dimensions of a pocket, m and degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PocketFigures {
    pub(crate) mouth: f64,
    pub(crate) cut_angle_deg: f64,
    pub(crate) shelf: f64,
    pub(crate) hole_radius: f64,
    pub(crate) point_radius: f64,
    pub(crate) throat: Option<f64>,
}

/// Relative rounding error of a dimension.
const ROUNDING: f64 = 1e-12;

/// Chooses between the dimension of a shot and that of a source.
struct Chooser {
    sheet: super::rule_books::Sheet,
    unlike: Vec<String>,
}

impl Chooser {
    /// The dimension `key`, which is `given` in the shot.
    fn choose(&mut self, key: &str, given: f64) -> f64 {
        let published = self.sheet.iter().find(|(name, _)| *name == key);
        let (chosen, agrees) = match published {
            None => (given, true),
            Some((_, Figure::Is(value))) => {
                (*value, (given - value).abs() <= ROUNDING * (1.0 + value.abs()))
            }
            Some((_, Figure::Within(low, high))) => {
                let slack = ROUNDING * (1.0 + high.abs());
                (given, (low - slack..=high + slack).contains(&given))
            }
        };
        if !agrees {
            self.unlike.push(key.into());
        }
        chosen
    }

    fn pocket(&mut self, name: &str, given: &PocketDescription) -> PocketFigures {
        let mut choose = |key: &str, value: f64| self.choose(&format!("{name}.{key}"), value);
        PocketFigures {
            mouth: choose("mouth", given.mouth),
            cut_angle_deg: choose("cut_angle_deg", given.cut_angle_deg),
            shelf: choose("shelf", given.shelf),
            hole_radius: choose("hole_radius", given.hole_radius),
            point_radius: choose("point_radius", given.point_radius),
            throat: given.throat.map(|throat| choose("throat", throat)),
        }
    }
}

impl Figures {
    /// The figures of `table`: of a preset, the published ones first; the rest, and all those of
    /// another table, from its description. `None` for unbounded cloth.
    pub(crate) fn of(table: &Table) -> Option<Self> {
        let given = table.description.as_ref()?;
        let sheet = table.name.as_deref().map_or(&[][..], sheet);
        let mut chooser = Chooser { sheet, unlike: Vec::new() };
        let pockets = match (given.pockets, given.corner_pocket, given.side_pocket) {
            (PocketLayout::Six, Some(corner), Some(side)) => {
                Some([("corner_pocket", corner), ("side_pocket", side)])
            }
            _ => None,
        };
        Some(Self {
            width: chooser.choose("width", given.width),
            length: chooser.choose("length", given.length),
            nose_height: chooser.choose("cushion_height", given.cushion_height),
            cushion_width: chooser.choose("cushion_width", given.cushion_width),
            rail_width: chooser.choose("rail_width", given.rail_width),
            pockets: pockets
                .map(|pockets| pockets.map(|(name, pocket)| chooser.pocket(name, &pocket))),
            has_mouth_lines: given.pocket_model == PocketModel::MouthLine,
            unlike: chooser.unlike,
        })
    }
}

#[cfg(test)]
mod tests {
    use carom::table::{PRESETS, Source};

    use super::*;

    #[test]
    fn every_preset_has_the_published_figures() {
        for name in PRESETS {
            let table = Table::preset(name).expect("a preset");
            let figures = Figures::of(&table).expect("a table with rails");
            assert_eq!(figures.unlike, Vec::<String>::new(), "{name}");
        }
    }

    #[test]
    fn every_figure_for_which_the_engine_names_a_publication_is_listed() {
        for name in PRESETS {
            let table = Table::preset(name).expect("a preset");
            for dimension in table.dimensions() {
                let key = dimension.key;
                let published =
                    matches!(dimension.source, Some(Source::RuleBook(_) | Source::Published(_)));
                let drawn = key.starts_with("markings") || key.starts_with("sights");
                let listed = sheet(name).iter().any(|(listed, _)| *listed == key);
                assert_eq!(listed, published && !drawn, "{name} {key}");
            }
        }
    }

    #[test]
    fn a_preset_that_departs_from_its_source_is_reported_and_not_followed() {
        let mut table = Table::preset("wpa-9ft").expect("a preset");
        let description = table.description.as_mut().expect("rails");
        description.width += 1e-6;
        description.corner_pocket.as_mut().expect("a pocket").mouth = 0.125;
        let figures = Figures::of(&table).expect("rails");
        assert_eq!(figures.unlike, ["width", "corner_pocket.mouth"]);
        assert_eq!(figures.width, 1.27);
    }
}
