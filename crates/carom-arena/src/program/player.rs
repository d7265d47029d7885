//! A program as a player of a match.

use std::path::PathBuf;
use std::sync::Arc;

use carom_mind::Budget;

use super::channel::{ProgramChannel, StopCheck, SupervisorCommand};
use super::command::ProgramCommand;
use super::confinement::Confinement;
use super::order::ProgramOrder;
use crate::arena_frame::{ArenaFrame, Ask};
use crate::match_player::{MatchPlayer, Response};
use crate::moves::EndReason;
use crate::protocol::{ChannelFault, ProtocolPlayer, ProtocolSettings};

/// How the programs of a match are run.
pub struct ProgramSite {
    /// How to start a supervisor.
    pub supervisor: SupervisorCommand,
    /// What separates a program from the rest of the machine.
    pub confinement: Confinement,
    /// Files that a program must not read, if the confinement covers files: the secret of the match.
    pub hidden: Vec<PathBuf>,
    /// Gets what a program wrote to stderr in a frame, under a heading.
    pub log: Option<Box<dyn Fn(String) + Send + Sync>>,
}

/// A program as the player of one frame. It is started at the first request, and ended with this
/// value.
pub struct ProgramPlayer<'s> {
    command: Arc<ProgramCommand>,
    site: Arc<ProgramSite>,
    is_stopped: StopCheck<'s>,
    protocol: ProtocolSettings,
    player: Option<ProtocolPlayer<ProgramChannel<'s>>>,
}

impl<'s> ProgramPlayer<'s> {
    /// The program, which is not started yet. `is_stopped` says whether the match was stopped.
    pub fn new(
        command: Arc<ProgramCommand>,
        site: Arc<ProgramSite>,
        is_stopped: StopCheck<'s>,
    ) -> Self {
        let protocol = command.protocol();
        Self { command, site, is_stopped, protocol, player: None }
    }

    /// The same program, asked as `protocol` says.
    #[must_use]
    pub fn asked(self, protocol: ProtocolSettings) -> Self {
        Self { protocol, ..self }
    }

    fn start(&self, ask: &Ask<'_>) -> Result<ProtocolPlayer<ProgramChannel<'s>>, ChannelFault> {
        let order = ProgramOrder {
            limits: self.command.limits(),
            hidden: self.site.hidden.clone(),
            ..ProgramOrder::new(self.command.words().to_vec(), self.site.confinement)
        };
        let is_stopped = Arc::clone(&self.is_stopped);
        let mut channel = ProgramChannel::start(&order, &self.site.supervisor, is_stopped)?;
        if self.site.log.is_some() {
            let site = Arc::clone(&self.site);
            let name = self.command.name();
            let heading = format!("frame {}, player {name} at seat {}", ask.frame_number, ask.seat);
            channel.keep_log(Box::new(move |found| {
                if let (Some(log), Some(block)) = (&site.log, found.block(&heading)) {
                    log(block);
                }
            }));
        }
        // The settings were checked when the command was read.
        ProtocolPlayer::new(channel, self.protocol)
            .map_err(|error| ChannelFault::Crash(error.to_string()))
    }
}

impl MatchPlayer for ProgramPlayer<'_> {
    fn respond(&mut self, ask: &Ask<'_>, budget: &Budget<'_>) -> Response {
        let player = match self.player.take().map_or_else(|| self.start(ask), Ok) {
            Ok(started) => self.player.insert(started),
            Err(ChannelFault::Stopped) => return Response::Stop,
            Err(fault) => {
                let no_start = (EndReason::Crash, String::from("the program could not be started"));
                let (reason, why) = fault.loss().unwrap_or(no_start);
                return Response::Failed(reason, why);
            }
        };
        player.respond(ask, budget)
    }

    fn seconds(&self) -> Option<f64> {
        // The start is off the clock.
        Some(self.player.as_ref().and_then(MatchPlayer::seconds).unwrap_or(0.0))
    }

    fn frame_over(&mut self, frame: &ArenaFrame) {
        if let Some(player) = &mut self.player {
            player.frame_over(frame);
        }
    }
}
