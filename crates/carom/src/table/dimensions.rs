//! The dimensions of a table as a list, with their sources.

use alloc::string::String;
use alloc::vec::Vec;

use super::presets::sheet;
use super::{PocketLayout, Source, Table, TableDescription};

/// One line of the list that `carom tables` prints.
#[derive(Clone, Debug, PartialEq)]
pub struct Dimension {
    /// Its key in the description: `corner_pocket.mouth`.
    pub key: String,
    /// Its value in `unit`.
    pub value: f64,
    /// `m` or `deg`.
    pub unit: &'static str,
    /// The source of a preset's figure; `None` for a user's own table.
    pub source: Option<Source>,
}

impl TableDescription {
    /// The dimensions in a fixed order, without sources.
    pub fn dimensions(&self) -> Vec<Dimension> {
        let mut list = Vec::new();
        let mut add = |key: String, value: f64| {
            let unit = if key.ends_with("_deg") { "deg" } else { "m" };
            list.push(Dimension { key, value, unit, source: None });
        };
        add("length".into(), self.length);
        add("width".into(), self.width);
        add("cushion_height".into(), self.cushion_height);
        add("cushion_width".into(), self.cushion_width);
        add("rail_width".into(), self.rail_width);
        if self.pockets == PocketLayout::Six {
            let pockets =
                [("corner_pocket", self.corner_pocket), ("side_pocket", self.side_pocket)];
            for (name, pocket) in pockets {
                let Some(p) = pocket else { continue };
                let mut of = |key: &str, value: f64| add(alloc::format!("{name}.{key}"), value);
                of("mouth", p.mouth);
                of("cut_angle_deg", p.cut_angle_deg);
                of("shelf", p.shelf);
                of("hole_radius", p.hole_radius);
                of("point_radius", p.point_radius);
                if let Some(throat) = p.throat {
                    of("throat", throat);
                }
            }
        }
        if let Some(sights) = self.sights {
            add("sights.setback".into(), sights.setback);
        }
        if let Some(head_string) = self.markings.head_string {
            add("markings.head_string".into(), head_string);
        }
        if let Some(d_radius) = self.markings.d_radius {
            add("markings.d_radius".into(), d_radius);
        }
        list
    }
}

impl Table {
    /// The dimensions in a fixed order, with the source of each figure if the table is an unchanged
    /// preset; empty for unbounded cloth.
    pub fn dimensions(&self) -> Vec<Dimension> {
        let Some(description) = &self.description else { return Vec::new() };
        let sheet = self.name.as_deref().and_then(sheet);
        let mut list = description.dimensions();
        for dimension in &mut list {
            dimension.source = sheet.and_then(|s| s.source(&dimension.key));
        }
        list
    }
}
