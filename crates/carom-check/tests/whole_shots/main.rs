//! Whole shots before the judge: random ones, those that once never ended, and the symmetries of
//! mechanics.

mod random_shots;
