//! Root finders by others in the event loop, to measure them in whole shots
//! (validation/leckie_greenspan_2006). Only the feature `peers` compiles this module, and only
//! `carom-peers` asks for it. Without it the engine has its own root finder and no other.

use std::cell::Cell;

use carom_roots::Motion;

use super::Simulation;
use super::row::PossiblePartners;

std::thread_local! {
    static CHOSEN: Cell<Option<PeerFinder>> = const { Cell::new(None) };
}

/// A root finder in place of the engine's own.
#[derive(Clone, Copy, Debug)]
pub struct PeerFinder {
    /// First time in [0, horizon] (s) at which the relative path of two balls on the cloth comes
    /// within a distance (m) while they approach. The arguments are path, distance and horizon.
    pub first_contact: fn(&Motion<2>, f64, f64) -> Option<f64>,
    /// Whether the engine's proofs of no contact come before the finder. Without them it gets every
    /// pair, as in the paper.
    pub has_proofs: bool,
}

impl PeerFinder {
    /// Runs `job`. All shots that this thread simulates in it use this finder.
    pub fn run<T>(self, job: impl FnOnce() -> T) -> T {
        // The earlier choice comes back even if `job` panics.
        struct Restored(Option<PeerFinder>);
        impl Drop for Restored {
            fn drop(&mut self) {
                CHOSEN.set(self.0);
            }
        }
        let _restored = Restored(CHOSEN.replace(Some(self)));
        job()
    }

    /// The finder of the innermost [`PeerFinder::run`] of this thread.
    pub(super) fn chosen() -> Option<Self> {
        CHOSEN.get()
    }
}

impl<const N: usize> Simulation<N> {
    /// As `find_contacts`, by a peer.
    #[cold]
    pub(super) fn find_contacts_by(&mut self, peer: PeerFinder, i: usize, time: f64) {
        let mut possible = PossiblePartners::NONE;
        if peer.has_proofs {
            possible.search(&self.lanes, i, self.valid_until(i), self.n, time, self.wide);
        } else {
            possible.take_all(&self.lanes, self.n);
        }
        self.add_contacts(i, &possible, time, peer.first_contact);
    }
}
