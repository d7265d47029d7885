//! What a thread needs to step environments.

use carom_arena::BuiltInPlayer;
use carom_mind::{Answer, Budget, Player, Situation};
use carom_rules::{Frame, FrameSimulator, Seat};

use crate::config::Config;
use crate::modes::{Opponent, simulations_of};

/// What a thread needs to step environments, and uses again for the next one.
pub(crate) struct Worker {
    pub(crate) simulator: FrameSimulator,
    /// The opponent and its simulated shots, if it is a built-in player. A decision does not depend on
    /// those before it.
    player: Option<(Box<dyn Player>, u64)>,
}

impl Worker {
    pub(crate) fn new(config: &Config) -> Self {
        let of = |player: &BuiltInPlayer| Some((player.make().ok()?, simulations_of(player)));
        let player = match &config.opponent {
            Opponent::Player(player) => of(player),
            _ => None,
        };
        Self { simulator: FrameSimulator::new(), player }
    }

    /// The opponent's answer to the request of `frame`, on this thread alone; none if it finds none.
    pub(crate) fn decide(
        &mut self,
        config: &Config,
        frame: &Frame,
        agent: Seat,
        seed: u64,
    ) -> Option<Answer> {
        let (player, simulations) = self.player.as_mut()?;
        let noise = [0, 1].map(|seat| config.noise_of(seat == agent));
        let situation = Situation { noise, ..Situation::new(frame, config.noise.clone(), seed) };
        let decision = player.decide(&situation, &Budget::simulations(*simulations));
        Some(decision.ok()?.answer)
    }
}
