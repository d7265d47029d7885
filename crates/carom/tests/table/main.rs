//! The tables: their figures, their pictures, what a ball meets on and above them and where it may stand.

mod drawing;
mod flight;
mod meeting;
mod oracle;
mod place;
mod presets;
mod rail_top;
mod solid;
