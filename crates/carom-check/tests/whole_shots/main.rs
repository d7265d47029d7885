//! Whole shots before the judge: random ones, those that once never ended or had impossible events,
//! and the symmetries of mechanics, which no engine keeps by accident.

mod judge_notices;
mod judge_notices_flight;
mod laws;
mod log;
mod long_pushes;
mod misplaced;
mod plan;
mod random_shots;
mod sampled;
mod symmetries;
