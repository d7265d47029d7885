//! Plays shots on a CUDA device, with the bits that the engine has on this machine.
//!
//! [`CudaDevice`] is a [`Device`](carom::device::Device): a [`Runner`](carom::runner::Runner) that has one
//! plays the shots of batches on it. The program of the device, the kernel, is PTX that
//! `scripts/cuda_kernel.sh` builds from the engine's source. NVIDIA's driver is loaded when a device is
//! opened, and compiles the kernel for the card; nothing of CUDA is needed to build this crate
//! (docs/gpu.md).

mod device;
mod driver;
mod memory;
mod proof;

pub use device::{CudaDevice, Occupancy};
