//! The tables: their figures and pictures, the features that a ball meets, and the positions that
//! it may have.

mod drawing;
mod flight;
mod meeting;
mod oracle;
mod place;
mod preset_goldens;
mod presets;
mod rail_top;
mod solid;
