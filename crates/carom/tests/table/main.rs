//! The tables: their figures, their pictures, what a ball meets on them and where it may stand.

mod drawing;
mod meeting;
mod oracle;
mod place;
mod presets;
