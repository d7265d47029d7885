//! Checks of whole shots: random ones, shots that once never ended or had impossible events, and
//! the symmetries of mechanics.

mod detected_faults;
mod detected_flight_faults;
mod detected_law_faults;
mod detected_network_faults;
mod detected_rail_faults;
mod detected_spin_faults;
mod found_by_stress;
mod jammed_balls;
mod laws;
mod long_pushes;
mod misplaced;
mod openings;
mod owned_event;
mod plan;
mod random_shots;
mod sampled;
mod speed_bands;
mod symmetries;
