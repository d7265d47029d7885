//! First contact of two bodies on quadratic paths.
//!
//! A contact is **the first t ≥ 0 with f(t) ≤ 0 and f′(t) < 0**, where f is the gap: the bodies
//! touch while approaching. [`first_contact`] is for two balls, in a plane or in space, and for a
//! ball and a straight edge; [`first_ring_contact`] for a ball and a round edge, a circle in space;
//! [`first_crossing`] for a ball and a plane. [`cannot_touch`] and [`Row`] prove for most pairs, at
//! little cost, that there is no contact.
#![no_std]
#![cfg_attr(target_arch = "nvptx64", feature(core_float_math))]
#[cfg(feature = "std")]
extern crate std;

mod contact;
mod crossing;
mod fast;
mod motion;
mod reject;
mod ring;
mod robust;
mod root;
mod row;

pub use contact::first_contact;
pub use crossing::first_crossing;
pub use motion::Motion;
pub use reject::cannot_touch;
pub use ring::first_ring_contact;
pub use row::Row;
