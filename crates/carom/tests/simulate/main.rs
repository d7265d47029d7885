//! Whole shots: the event loop, traces, outcomes and goldens.
#![cfg(feature = "json")]

mod cling;
mod device;
mod end_time;
mod goldens;
mod hard_cases;
mod impacts;
mod many_balls;
mod no_allocation;
mod noise;
mod off_the_cloth;
mod order_of_balls;
mod orientations_and_polylines;
mod outcome_of_flight;
mod preset_cushions;
mod speed_bands;
mod strike_network;
mod support;
mod trace_file;
mod trace_outcome;
