//! The memory with which one thread simulates shots and rules on them.

use carom_plan::Sampler;
use carom_rules::Frame;

/// The memory of one thread.
#[derive(Debug)]
pub(crate) struct Workbench {
    pub(crate) sampler: Sampler,
    /// The frame after the last ruled simulation.
    pub(crate) successor: Frame,
    /// Number of simulations so far, where they are counted.
    pub(crate) plays: u64,
}

impl Workbench {
    pub(crate) fn new(frame: &Frame) -> Self {
        Self { sampler: Sampler::new(), successor: frame.clone(), plays: 0 }
    }
}
