//! Whole shots before the judge: random ones, those that once never ended or had impossible events,
//! and the symmetries of mechanics, which no engine keeps by accident.

mod detected_faults;
mod detected_flight_faults;
mod laws;
mod long_pushes;
mod misplaced;
mod owned_event;
mod plan;
mod random_shots;
mod sampled;
mod symmetries;
