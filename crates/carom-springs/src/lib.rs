//! Impacts of bodies that touch: every contact is a spring, and the motion is integrated in time.
//!
//! This is a judge of the engine's impacts. It shares the physical model (docs/many-balls.md) with
//! the engine, but no code, no table and no arithmetic: an adaptive Runge–Kutta method of the crate
//! `differential-equations` integrates positions and velocities of all bodies. The engine is used
//! only to play the shots that are judged.
//!
//! * [`law`]: stiffness, restitution and friction of a contact;
//! * [`network`]: bodies and the contacts between them;
//! * [`motion`]: the equations of motion;
//! * [`impact`]: their integration, from the first contact until the bodies are apart;
//! * [`build`]: the network of a shot file;
//! * [`clusters`], [`strikes`], [`rails`]: random shots whose first impact is a network;
//! * [`judge`]: the differences between the engine and the springs;
//! * [`breaks`]: breaks whose first milliseconds are integrated here.

pub mod breaks;
pub mod build;
pub mod clusters;
pub mod impact;
pub mod judge;
pub mod law;
pub mod motion;
pub mod network;
pub mod rails;
pub mod random;
pub mod strikes;

/// A vector in space.
pub type Vector = nalgebra::Vector3<f64>;
